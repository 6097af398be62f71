// Many pupils on one small window: Hankel transforms of Legendre polynomials at its radii, and a matrix product for all fields.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/base/parallel.hpp"
#include "lommel/base/reference.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/pixels/layout.hpp"
#include "lommel/radial/disk.hpp"
#include "lommel/special/bessel.hpp"

namespace lommel {

struct RadiusTable {
    std::shared_ptr<const Radii> layout;  // radii in units of `step`; the cache finds the table by these, step and terms
    double step;
    std::size_t terms, stride;
    Doubles rows;  // [n][radius]: transform of the Legendre polynomial P_n; padded to two of the widest vectors

    RadiusTable(const std::shared_ptr<const Radii>& l, double pixel_step, std::size_t n)
        : layout(l), step(pixel_step), terms(n), stride((l->count + 15) / 16 * 16), rows(terms * stride) {
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
        return layout == l && step == pixel_step && terms == n;  // same length, as a longer table rounds differently
    }
    std::size_t bytes() const { return sizeof(double) * rows.size(); }

    static constexpr std::size_t most_bytes = std::size_t{64} << 20;
    // Get a table from the cache, with the number of terms rounded up so that slightly more defocus needs no new table.
    static std::shared_ptr<const RadiusTable> get(const std::shared_ptr<const Radii>& layout, double step, std::size_t terms) {
        return cache<RadiusTable>.get(layout, step, (terms + 7) / 8 * 8);
    }
};

constexpr std::size_t block_pupils = 3;  // number of pupils at once: twelve chains of multiply-adds fit into sixteen registers

// Compute out[p * stride + i], the intensity of pupil p at radius i, for `block_pupils` pupils with the Legendre coefficients
// beta[p * beta_stride + n]. Limited by multiply-adds as long as the table stays in the second-level cache.
template <class I>
LOMMEL_INLINE void block_intensities(I, const RadiusTable& table, std::size_t terms, const double* beta_re,
                                     const double* beta_im, std::size_t beta_stride, double* out) {
    using V = typename I::pack;
    for (std::size_t i = 0; i < table.stride; i += 2 * I::lanes) {
        V re[block_pupils][2] = {}, im[block_pupils][2] = {};
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

// Stack of unobscured pupils that share one RadiusTable.
class Batch {
   public:
    static constexpr std::size_t group = 32;  // number of pupils per parallel task

    static bool fits(const Stack& stack) { return stack.count >= 4 && stack.terms <= 4 && stack.obscuration == 0.0; }

    // Return whether the table, computed once, needs fewer multiply-adds than tabulated pieces (class Field) of each pupil.
    static bool pays(const Stack& stack, const Phase& worst, const Radii& at, double step) {
        const double reach = at.reach() * step, radii = static_cast<double>(at.count);
        const double terms = std::min(worst.size() + 12.0, 0.5 * reach + 12.0);
        const double pieces = 32.0 * (terms * (reach / 8.0 + 1.0) + radii) + 4000.0;
        const double table = 2.0 * terms * radii + 4.0 * radii * (reach + terms + 60.0) / static_cast<double>(stack.count);
        // Exclude large phases: `worst`, the largest coefficients of all pupils, may exceed limits that no single pupil exceeds.
        return table < pieces && terms * radii < 4e6 && worst.size() < 1e3;
    }

    Batch(const Stack& stack, const Box& box, const std::shared_ptr<const Radii>& radii, double step, double error)
        : stack_(stack), plan_(Ellipses(box.least, box.most, stack.amplitude), radii->reach() * step, error),
          table_(RadiusTable::get(radii, step, plan_.terms)),
          rounding_(series_rounding(plan_.terms) + radius_rounding(radii->reach() * step)) {}

    // Error bound of the field U of one pupil.
    double error(std::size_t pupil) const { return plan_.error(stack_[pupil]) + rounding_; }

    // Call take(first, count, values, stride) for each group of pupils, with the intensities values[pupil * stride + radius].
    using Take = Reference<void(std::size_t first, std::size_t count, const double* values, std::size_t stride)>;
    void run(int threads, const Take& take) const {
        const std::size_t room = plan_.room(), stride = table_->stride;
        parallel_for((stack_.count + group - 1) / group, threads, [&](std::size_t, std::size_t task) {
            thread_local SeriesScratch scratch;
            thread_local Doubles re, im, values;
            // Compute the coefficients of the whole group before its fields: the first-level cache then holds one table at a time.
            const std::size_t first = task * group, here = std::min(group, stack_.count - first);
            constexpr std::size_t rounded = (group + block_pupils - 1) / block_pupils * block_pupils;
            re.resize(rounded * room);
            im.resize(rounded * room);
            values.resize(rounded * stride);
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                for (std::size_t p = 0; p < here; ++p) {
                    const Phase phase = stack_[first + p];
                    legendre_coefficients(isa, *plan_.rule, phase.coefficients, phase.terms, *phase.amplitude, 0, plan_.terms,
                                          re.data() + p * room, im.data() + p * room, scratch);
                }
                for (std::size_t p = 0; p < here; p += block_pupils) {
                    block_intensities(isa, *table_, plan_.terms, re.data() + p * room, im.data() + p * room, room,
                                      values.data() + p * stride);
                }
            });
            take(first, here, values.data(), stride);
        });
    }

   private:
    const Stack& stack_;
    Expansion plan_;
    std::shared_ptr<const RadiusTable> table_;
    double rounding_;
};

}  // namespace lommel
