// Intensities of many planes at the radii of one table, by matrix products; and their derivatives.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <vector>

#include "lommel/base/parallel.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/stratified/planes.hpp"
#include "lommel/stratified/table.hpp"

namespace lommel {

// Of a plane: the largest modulus of each part of the field, at the radii and, as a bound, anywhere; of derivatives likewise.
struct PartSizes {
    double found[most_parts] = {}, most[most_parts] = {};
};

class Profiles {
   public:
    static constexpr std::size_t together = 3;  // planes: twelve chains of multiply-adds, as many as sixteen registers hold
    static constexpr std::size_t group = 24;    // planes a task

    Profiles(const Planes& planes, const std::shared_ptr<const Radii>& radii, double step)
        : planes_(planes), table_(AngleTable::get(radii, step, {planes.angles.rho, planes.angles.rho + planes.angles.count},
                                                  planes.angles.parts, false)) {}

    const Planes& planes() const { return planes_; }
    std::size_t stride() const { return table_->stride(); }
    std::size_t harmonics() const { return planes_.harmonics.size(); }

    // Hands the orders of the azimuth at the radii, values[(plane * harmonics + k) * stride + radius], and the sizes of each
    // plane to take(first, count, values, sizes), for each group of planes.
    template <class Take>
    void run(int threads, const Take& take) const {
        parallel_for((planes_.count + group - 1) / group, threads, [&](std::size_t, std::size_t task) {
            thread_local Doubles re, im, values;
            thread_local std::vector<PartSizes> sizes;
            const std::size_t first = task * group, here = std::min(group, planes_.count - first);
            const std::size_t parts = planes_.angles.parts, angles = (planes_.angles.count + row_lanes - 1) / row_lanes * row_lanes;
            re.assign(group * parts * angles, 0.0);
            im.assign(group * parts * angles, 0.0);
            values.resize((group * harmonics() + 1) * stride());
            sizes.assign(group, {});
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                for (std::size_t p = 0; p < here; ++p) {
                    planes_.waves(isa, first + p, angles, re.data() + p * parts * angles, im.data() + p * parts * angles,
                                  sizes[p].most);
                }
                for (std::size_t t = 0; t < table_->tiles; ++t) {
                    for (std::size_t p = 0; p < here; p += together) {
                        for (std::size_t i = 0; i < AngleTable::tile; i += 2 * decltype(isa)::lanes) {
                            tile(isa, t, i, first + p, std::min(together, here - p), re.data() + p * parts * angles,
                                 im.data() + p * parts * angles, angles, values.data() + p * harmonics() * stride(),
                                 sizes.data() + p);
                        }
                    }
                }
            });
            take(first, here, values.data(), sizes.data());
        });
    }

   private:
    template <class V>
    struct Fields {
        V re[most_parts][together][2], im[most_parts][together][2];
    };

    // Fields of some planes at two vectors of radii: bound by multiply-adds.
    template <class I, class V>
    LOMMEL_INLINE void fields(I, std::size_t t, std::size_t i, const double* re, const double* im, std::size_t angles,
                              Fields<V>& out) const {
        const std::size_t parts = planes_.angles.parts, apart = parts * angles;
        for (std::size_t m = 0; m < parts; ++m) {
            const double *row = table_->of(t, m) + i, *x = re + m * angles, *y = im + m * angles;
            V a[together][2] = {}, b[together][2] = {};
            for (std::size_t q = 0; q < planes_.angles.count; ++q, row += AngleTable::tile) {
                const V j[2] = {load<V>(row), load<V>(row + I::lanes)};
                for (std::size_t p = 0; p < together; ++p) {
                    const V c = splat<V>(x[p * apart + q]), s = splat<V>(y[p * apart + q]);
                    for (std::size_t u = 0; u < 2; ++u) {
                        a[p][u] = a[p][u] + j[u] * c;
                        b[p][u] = b[p][u] + j[u] * s;
                    }
                }
            }
            for (std::size_t p = 0; p < together; ++p) {
                for (std::size_t u = 0; u < 2; ++u) {
                    out.re[m][p][u] = a[p][u];
                    out.im[m][p][u] = b[p][u];
                }
            }
        }
    }

    template <class I>
    LOMMEL_INLINE void tile(I isa, std::size_t t, std::size_t i, std::size_t plane, std::size_t here, const double* re,
                            const double* im, std::size_t angles, double* values, PartSizes* sizes) const {
        using V = typename I::pack;
        Fields<V> F;
        fields(isa, t, i, re, im, angles, F);
        for (std::size_t p = 0; p < here; ++p) {
            for (std::size_t m = 0; m < planes_.angles.parts; ++m) {
                V most = splat<V>(0.0);
                for (std::size_t u = 0; u < 2; ++u) {
                    most = larger(most, F.re[m][p][u] * F.re[m][p][u] + F.im[m][p][u] * F.im[m][p][u]);
                }
                for (std::size_t lane = 0; lane < I::lanes; ++lane) {
                    sizes[p].found[m] = std::max(sizes[p].found[m], double(most[lane]));
                }
            }
            for (std::size_t k = 0; k < harmonics(); ++k) {
                for (std::size_t u = 0; u < 2; ++u) {
                    const V sum = formed(planes_.harmonics[k], F, p, u) * splat<V>(1.0 / planes_.power[plane + p]);
                    store(values + (p * harmonics() + k) * stride() + t * AngleTable::tile + i + u * I::lanes, sum);
                }
            }
        }
    }

    // Of a Hermitian form the terms above its diagonal count twice.
    template <class V>
    LOMMEL_INLINE V formed(const Harmonic& harmonic, const Fields<V>& F, std::size_t p, std::size_t u) const {
        V sum = splat<V>(0.0);
        for (std::size_t j = 0; j < planes_.angles.parts; ++j) {
            const V a = F.re[j][p][u], b = F.im[j][p][u];
            if (const double diagonal = harmonic.form[j][j].real(); diagonal != 0.0) {
                sum = sum + splat<V>(diagonal) * (a * a + b * b);
            }
            for (std::size_t l = j + 1; l < planes_.angles.parts; ++l) {
                const V c = F.re[l][p][u], d = F.im[l][p][u];
                const std::complex<double> entry = 2.0 * harmonic.form[j][l];
                if (entry.real() != 0.0) {
                    sum = sum + splat<V>(entry.real()) * (a * c + b * d);
                }
                if (entry.imag() != 0.0) {
                    sum = sum - splat<V>(entry.imag()) * (b * c - a * d);
                }
            }
        }
        return sum;
    }

    Planes planes_;
    std::shared_ptr<const AngleTable> table_;
};

}  // namespace lommel
