// Intensities of many planes, and their derivatives, at the radii of one table, by matrix products over pupil angles.
#pragma once

#include <algorithm>
#include <complex>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "lommel/base/parallel.hpp"
#include "lommel/base/reference.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/stratified/planes.hpp"
#include "lommel/stratified/table.hpp"

namespace lommel {

// Sizes of the parts (azimuthal orders) of the field in a plane, or of one of its derivatives. found: largest |part|^2 at the radii
// of the table; most: bound on |part| at any radius.
struct PartSizes {
    double found[most_parts] = {}, most[most_parts] = {};
};

// Fields at the radii of a table, as sums over pupil angles of waves * Bessel functions (tabulated), and their intensities.
class Profiles {
   public:
    static constexpr std::size_t together = 3;  // planes at once: twelve chains of multiply-adds, which sixteen registers hold
    static constexpr std::size_t group = 24;  // planes per task

    Profiles(const Planes& planes, const std::shared_ptr<const Radii>& radii, double step)
        : Profiles(planes, AngleTable::get(radii, step, {planes.angles.rho, planes.angles.rho + planes.angles.count},
                                           planes.angles.parts, planes.slopes())) {}
    // Constructor with a table that is not in the cache.
    Profiles(const Planes& planes, std::shared_ptr<const AngleTable> table) : planes_(planes), table_(std::move(table)) {}

    const Planes& planes() const { return planes_; }
    std::size_t stride() const { return table_->stride(); }
    std::size_t harmonics() const { return planes_.harmonics.size(); }
    // outputs(): number of rows per plane, one for each azimuthal order of each kind; kinds(): number of kinds, which are the
    // intensity and its derivatives.
    std::size_t outputs() const { return harmonics() * kinds(); }
    std::size_t kinds() const { return 1 + planes_.derivatives.size(); }

    // Call take(first, count, values, sizes) for each group of planes, first .. first + count - 1, with
    // values[(plane * outputs() + row) * stride() + radius] and sizes[plane][kind]; kind 0: field, others: its derivatives.
    using Take = Reference<void(std::size_t first, std::size_t count, const double* values, const PartSizes* sizes)>;
    void run(int threads, const Take& take) const {
        parallel_for((planes_.count + group - 1) / group, threads, [&](std::size_t, std::size_t task) {
            thread_local Doubles re, im, values;
            thread_local std::vector<PartSizes> sizes;
            const std::size_t first = task * group, here = std::min(group, planes_.count - first);
            const std::size_t parts = planes_.angles.parts, plane_stride = kinds() * parts * padded();
            re.assign(group * plane_stride, 0.0);
            im.assign(group * plane_stride, 0.0);
            values.resize((group * outputs() + 1) * stride());
            sizes.assign(group * kinds(), {});
            dispatch_widest([&](auto isa) LOMMEL_INLINE_LAMBDA {
                for (std::size_t p = 0; p < here; ++p) {
                    coefficients(isa, first + p, re.data() + p * plane_stride, im.data() + p * plane_stride,
                                 sizes.data() + p * kinds());
                }
                for (std::size_t t = 0; t < table_->tiles; ++t) {
                    for (std::size_t p = 0; p < here; p += together) {
                        for (std::size_t i = 0; i < AngleTable::tile; i += 2 * decltype(isa)::lanes) {
                            tile(isa, t, i, first + p, std::min(together, here - p), re.data() + p * plane_stride,
                                 im.data() + p * plane_stride, values.data() + p * outputs() * stride(),
                                 sizes.data() + p * kinds());
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

    std::size_t padded() const { return (planes_.angles.count + row_lanes - 1) / row_lanes * row_lanes; }

    template <class I>
    LOMMEL_INLINE void coefficients(I isa, std::size_t plane, double* re, double* im, PartSizes* sizes) const {
        const std::size_t block = planes_.angles.parts * padded();
        const Angles& angles = planes_.angles;
        planes_.waves(isa, plane, angles.part, padded(), re, im, sizes->most);
        for (std::size_t d = 1; d < kinds(); ++d) {
            const By by = planes_.derivatives[d - 1].by;
            if (by == By::radius) {
                // Derivatives by the radius have the waves and bounds of the field itself: |J_m'| <= 1 for Bessel functions.
                std::copy_n(sizes->most, most_parts, sizes[d].most);
                continue;
            }
            planes_.turn(by, padded(), re, im, re + d * block, im + d * block, sizes[d].most);
        }
    }

    // Fields of `together` planes from their waves (re, im), at two vectors of radii: those from i on in tile t of the table. kind:
    // index of the first Bessel function in the table, 0 or, for derivatives by the radius, the number of parts. Multiply-adds
    // limit the speed.
    template <class I, class V>
    LOMMEL_INLINE void fields(I, std::size_t t, std::size_t i, std::size_t kind, const double* re, const double* im,
                              Fields<V>& out) const {
        const std::size_t parts = planes_.angles.parts, angles = padded(), plane_stride = kinds() * parts * angles;
        for (std::size_t m = 0; m < parts; ++m) {
            const double *row = table_->of(t, kind + m) + i, *x = re + m * angles, *y = im + m * angles;
            V a[together][2] = {}, b[together][2] = {};
            for (std::size_t q = 0; q < planes_.angles.count; ++q, row += AngleTable::tile) {
                const V j[2] = {load<V>(row), load<V>(row + I::lanes)};
                for (std::size_t p = 0; p < together; ++p) {
                    const V c = splat<V>(x[p * plane_stride + q]), s = splat<V>(y[p * plane_stride + q]);
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
                            const double* im, double* values, PartSizes* sizes) const {
        using V = typename I::pack;
        const std::size_t block = planes_.angles.parts * padded();
        Fields<V> F, G;
        fields(isa, t, i, 0, re, im, F);
        for (std::size_t d = 0; d < kinds(); ++d) {
            if (d > 0) {
                const bool slope = planes_.derivatives[d - 1].by == By::radius;
                const std::size_t from = slope ? 0 : d * block;
                fields(isa, t, i, slope ? planes_.angles.parts : 0, re + from, im + from, G);
            }
            const Fields<V>& given = d > 0 ? G : F;
            for (std::size_t p = 0; p < here; ++p) {
                measure<I>(given, p, sizes[p * kinds() + d]);
                const V unit = splat<V>((d > 0 ? 2.0 : 1.0) / planes_.power[plane + p]);
                for (std::size_t k = 0; k < harmonics(); ++k) {
                    double* to = values + (p * outputs() + d * harmonics() + k) * stride() + t * AngleTable::tile + i;
                    for (std::size_t u = 0; u < 2; ++u) {
                        store(to + u * I::lanes, unit * formed(planes_.harmonics[k], given, F, p, u));
                    }
                }
            }
        }
    }

    template <class I, class V>
    LOMMEL_INLINE void measure(const Fields<V>& F, std::size_t p, PartSizes& sizes) const {
        for (std::size_t m = 0; m < planes_.angles.parts; ++m) {
            V most = splat<V>(0.0);
            for (std::size_t u = 0; u < 2; ++u) {
                most = larger(most, F.re[m][p][u] * F.re[m][p][u] + F.im[m][p][u] * F.im[m][p][u]);
            }
            for (std::size_t lane = 0; lane < I::lanes; ++lane) {
                sizes.found[m] = std::max(sizes.found[m], double(most[lane]));
            }
        }
    }

    // Real part of the sum over j, l of form[j][l] G_j conj(F_l), for plane p and vector u of radii. F_j, G_j: parts (azimuthal
    // orders) of two fields; form: Hermitian matrix.
    template <class V>
    LOMMEL_INLINE V formed(const Harmonic& harmonic, const Fields<V>& G, const Fields<V>& F, std::size_t p,
                           std::size_t u) const {
        V sum = splat<V>(0.0);
        const auto real = [&](std::size_t j, std::size_t l)
                              LOMMEL_INLINE_LAMBDA { return G.re[j][p][u] * F.re[l][p][u] + G.im[j][p][u] * F.im[l][p][u]; };
        const auto imaginary = [&](std::size_t j, std::size_t l) LOMMEL_INLINE_LAMBDA {
            return G.im[j][p][u] * F.re[l][p][u] - G.re[j][p][u] * F.im[l][p][u];
        };
        for (std::size_t j = 0; j < planes_.angles.parts; ++j) {
            if (const double diagonal = harmonic.form[j][j].real(); diagonal != 0.0) {
                sum = sum + splat<V>(diagonal) * real(j, j);
            }
            for (std::size_t l = j + 1; l < planes_.angles.parts; ++l) {
                const std::complex<double> entry = harmonic.form[j][l];
                if (entry.real() != 0.0) {
                    sum = sum + splat<V>(entry.real()) * (real(j, l) + real(l, j));
                }
                if (entry.imag() != 0.0) {
                    sum = sum - splat<V>(entry.imag()) * (imaginary(j, l) - imaginary(l, j));
                }
            }
        }
        return sum;
    }

    Planes planes_;
    std::shared_ptr<const AngleTable> table_;
};

}  // namespace lommel
