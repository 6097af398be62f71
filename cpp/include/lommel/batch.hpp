// Many pupils on one small window: the transforms of the Legendre polynomials at the exact distinct radii, once, and
// one matrix product for the fields of all pupils.
#pragma once

#include <algorithm>
#include <cstddef>
#include <list>
#include <memory>
#include <mutex>
#include <vector>

#include "lommel/bessel.hpp"
#include "lommel/layout.hpp"
#include "lommel/simd.hpp"

namespace lommel {

struct RadiusTable {
    std::shared_ptr<const Layout> layout;  // keeps the key alive
    double step;
    std::size_t terms, stride;
    Doubles rows;  // [n][radius], rows padded to two of the widest vectors

    RadiusTable(const std::shared_ptr<const Layout>& l, double pixel_step, std::size_t n)
        : layout(l), step(pixel_step), terms(n), stride((l->count + 15) / 16 * 16),
          rows(terms * stride) {
        std::vector<double> values(terms), scratch;
        for (std::size_t i = 0; i < l->count; ++i) {
            legendre_transforms(l->radii[i] * step, terms, values.data(), scratch);
            for (std::size_t k = 0; k < terms; ++k) {
                rows[k * stride + i] = values[k];
            }
        }
    }

    // Shared by all calls: the most recent ones, up to 64 MiB.
    static std::shared_ptr<const RadiusTable> get(const std::shared_ptr<const Layout>& layout, double step,
                                                  std::size_t terms) {
        static std::mutex mutex;
        static std::list<std::shared_ptr<const RadiusTable>> recent;
        const std::lock_guard<std::mutex> lock(mutex);
        for (auto at = recent.begin(); at != recent.end(); ++at) {
            if ((*at)->layout == layout && (*at)->step == step) {
                if ((*at)->terms >= terms) {
                    recent.splice(recent.begin(), recent, at);
                    return recent.front();
                }
                recent.erase(at);
                break;
            }
        }
        recent.push_front(std::make_shared<const RadiusTable>(layout, step, (terms + 7) / 8 * 8));
        const std::shared_ptr<const RadiusTable> made = recent.front();
        std::size_t bytes = 0;
        for (auto at = recent.begin(); at != recent.end();) {
            bytes += (*at)->rows.size() * sizeof(double);
            at = bytes > (std::size_t{64} << 20) ? recent.erase(at) : std::next(at);
        }
        return made;
    }
};

constexpr std::size_t block_pupils = 3;  // twelve chains of multiply-adds, as many as sixteen registers hold

// Intensities of `block_pupils` pupils at all radii: out[p * stride + i]. beta_re and beta_im hold the coefficients of
// each pupil at a distance of beta_stride. Bound by multiply-adds as long as the table stays in the second cache.
template <class I>
LOMMEL_INLINE void block_intensities(I, const RadiusTable& table, std::size_t terms, const double* beta_re,
                                     const double* beta_im, std::size_t beta_stride, double* out) {
    using V = typename I::pack;
    for (std::size_t i = 0; i < table.stride; i += 2 * I::lanes) {
        V re[block_pupils][2], im[block_pupils][2];
        for (std::size_t p = 0; p < block_pupils; ++p) {
            for (std::size_t j = 0; j < 2; ++j) {
                re[p][j] = im[p][j] = splat<V>(0.0);
            }
        }
        const double* row = table.rows.data() + i;
        for (std::size_t n = 0; n < terms; ++n, row += table.stride) {
            const V t[2] = {load<V>(row), load<V>(row + I::lanes)};
            for (std::size_t p = 0; p < block_pupils; ++p) {
                const V a = splat<V>(beta_re[p * beta_stride + n]), b = splat<V>(beta_im[p * beta_stride + n]);
                for (std::size_t j = 0; j < 2; ++j) {
                    re[p][j] = re[p][j] + t[j] * a;
                    im[p][j] = im[p][j] + t[j] * b;
                }
            }
        }
        for (std::size_t p = 0; p < block_pupils; ++p) {
            for (std::size_t j = 0; j < 2; ++j) {
                store(out + p * table.stride + i + j * I::lanes, re[p][j] * re[p][j] + im[p][j] * im[p][j]);
            }
        }
    }
}

}  // namespace lommel
