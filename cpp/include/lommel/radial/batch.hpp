// Many pupils on one small window: the transforms of the Legendre polynomials at the exact distinct radii, once, and
// one matrix product for the fields of all pupils.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "lommel/special/bessel.hpp"
#include "lommel/base/cache.hpp"
#include "lommel/pixels/layout.hpp"
#include "lommel/base/simd.hpp"

namespace lommel {

struct RadiusTable {
    std::shared_ptr<const Radii> layout;  // keeps the key alive
    double step;
    std::size_t terms, stride;
    Doubles rows;  // [n][radius], rows padded to two of the widest vectors

    RadiusTable(const std::shared_ptr<const Radii>& l, double pixel_step, std::size_t n)
        : layout(l), step(pixel_step), terms(n), stride((l->count + 15) / 16 * 16),
          rows(terms * stride) {
        std::vector<double> values(terms), scratch;
        for (std::size_t i = 0; i < l->count; ++i) {
            look();
            legendre_transforms(l->radii[i] * step, terms, values.data(), scratch);
            for (std::size_t k = 0; k < terms; ++k) {
                rows[k * stride + i] = values[k];
            }
        }
    }

    bool is(const std::shared_ptr<const Radii>& l, double pixel_step, std::size_t n) const {
        return layout == l && step == pixel_step && terms >= n;
    }
    std::size_t bytes() const { return sizeof(double) * rows.size(); }

    static constexpr std::size_t most_bytes = std::size_t{64} << 20;
    // With terms rounded up, so that a little more defocus does not mean a new table.
    static std::shared_ptr<const RadiusTable> get(const std::shared_ptr<const Radii>& layout, double step,
                                                  std::size_t terms) {
        return cache<RadiusTable>.get(layout, step, (terms + 7) / 8 * 8);
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
