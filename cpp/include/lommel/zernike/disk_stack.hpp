// Stacks of wavefronts without radial symmetry: phases on the full disk and, with the radius rescaled, on the obscuration.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "lommel/bounds/amplitude.hpp"
#include "lommel/bounds/strips.hpp"
#include "lommel/limits.hpp"
#include "lommel/radial/stack.hpp"
#include "lommel/special/radial_polynomials.hpp"

namespace lommel {

// Window of pixels: pitch `step` in units of lambda / (2 pi NA); optical axis at pixel (row, column), possibly fractional.
struct DiskWindow {
    std::size_t height, width;
    double row, column, step;
};

// Variance of a phase over the full disk (rad^2), without piston and tilt. edge: coefficients of the terms in radians.
inline double phase_variance(const std::vector<ZernikeTerm>& terms, const double* edge) {
    double sum = 0.0;
    for (std::size_t t = 0; t < terms.size(); ++t) {
        const double c = std::clamp(edge[t], -1e6, 1e6);
        sum += terms[t].n > 1 ? c * c / static_cast<double>((terms[t].n + 1) * (terms[t].m == 0 ? 1 : 2)) : 0.0;
    }
    return sum;
}

// Stack of wavefronts in Zernike terms, with conversion between a tilt and a shift of the optical axis.
struct DiskStack {
    std::vector<ZernikeTerm> terms;  // terms that some pupil uses, and terms that rescaling to the obscuration adds
    std::vector<double> outer, inner;  // phases on full disk and obscuration (empty if none): [pupil][term], radians
    std::vector<std::int64_t> rows, columns;  // [pupil]: row and column of the pixel at the axis, set by move_axes()
    std::vector<double> centers;  // [pupil][row, column]: position of the axis in pixels, set by center_axes()
    std::vector<double> lost;  // [pupil]: bound on the error of U from rounding in the conversions below
    std::size_t count;
    double obscuration;
    Amplitude amplitude;
    std::vector<Strip> strips;  // cut out of the aperture

    // Construct from the coefficients edge[pupil][term] (radians at the edge) of the terms `given`; eps: obscuration ratio.
    DiskStack(const std::vector<ZernikeTerm>& given, const double* edge, std::size_t pupils, double eps, const Amplitude& light)
        : terms(given), outer(edge, edge + pupils * given.size()), lost(pupils, 0.0), count(pupils), obscuration(eps),
          amplitude(light) {
        trim();
    }

    // Replace the axis of each pupil, centers[pupil][row, column], by the axis of the window plus a tilt of the wavefront.
    void tilt_to(const double* centers, const DiskWindow& window) {
        const std::size_t at[2] = {place({1, -1}), place({1, 1})};
        for (std::size_t p = 0; p < count; ++p) {
            for (std::size_t axis = 0; axis < 2; ++axis) {
                double& tilt = outer[p * terms.size() + at[axis]];
                const double before = axis == 0 ? window.row : window.column;
                const double way = (centers[2 * p + axis] - before) * window.step;
                // Rounding error of U: the new tilt has a rounded difference, product and sum, and |dU/d(tilt)| < 1/2.
                lost[p] += way == 0.0 ? 0.0 : unit_roundoff * (2.0 * std::abs(way) + std::abs(tilt));
                tilt += way;
            }
        }
        trim();
    }

    // Express tilt as a shift of the axis to the middle of the nearest pixel. The distance from this pixel, a fraction of a pixel,
    // stays a tilt.
    void move_axes(const DiskWindow& window) {
        constexpr double farthest = 1e6;
        const std::size_t at[2] = {place({1, -1}), place({1, 1})};
        rows.resize(count);
        columns.resize(count);
        for (std::size_t p = 0; p < count; ++p) {
            for (std::size_t axis = 0; axis < 2; ++axis) {
                double& tilt = outer[p * terms.size() + at[axis]];
                const double given = axis == 0 ? window.row : window.column, here = given + tilt / window.step;
                if (!(std::abs(here) <= farthest)) {
                    throw LimitExceeded(std::string("tilt and center put the axis at ") + (axis == 0 ? "row " : "column ") +
                                        shortened(here) + ", more than the limit of " + shortened(farthest) + " pixels away");
                }
                const double whole = std::nearbyint(here);
                (axis == 0 ? rows : columns)[p] = static_cast<std::int64_t>(whole);
                if (tilt != 0.0) {
                    lost[p] += rounded(tilt, given, window.step);
                }
                tilt = (here - whole) * window.step;
            }
        }
        trim();
    }

    // Express the whole tilt as a shift of the axis, which then need not lie in the middle of a pixel.
    void center_axes(const DiskWindow& window) {
        const std::size_t at[2] = {place({1, -1}), place({1, 1})};
        centers.clear();
        for (std::size_t p = 0; p < count; ++p) {
            for (std::size_t axis = 0; axis < 2; ++axis) {
                double& tilt = outer[p * terms.size() + at[axis]];
                const double given = axis == 0 ? window.row : window.column;
                centers.push_back(given + tilt / window.step);
                lost[p] += rounded(tilt, given, window.step);
                tilt = 0.0;
            }
        }
        trim();
    }

    // Compute `inner`: Zernike terms, with piston, of the phase within the obscuration, whose edge becomes rho = 1.
    void shrink() {
        if (obscuration == 0.0) {
            return;
        }
        const std::vector<ZernikeTerm> before = terms;
        for (const ZernikeTerm& term : before) {
            for (std::int32_t k = term.n - 2; k >= std::abs(term.m); k -= 2) {
                place({k, term.m});
            }
        }
        inner.assign(outer.size(), 0.0);
        SmallerDisk smaller;
        for (std::size_t j = 0; j < before.size(); ++j) {
            std::vector<std::size_t> to;  // indices of the terms of degree n, n - 2, ... with the same m
            for (std::int32_t k = before[j].n; k >= std::abs(before[j].m); k -= 2) {
                to.push_back(place({k, before[j].m}));
            }
            const std::size_t n = static_cast<std::size_t>(before[j].n), m = static_cast<std::size_t>(std::abs(before[j].m));
            for (std::size_t p = 0; p < count; ++p) {
                double* const terms_here = inner.data() + p * terms.size();
                lost[p] += obscuration * obscuration *
                           smaller.shrink(n, m, obscuration, outer[p * terms.size() + j], before.size(),
                                          [&](std::size_t k, double c) { terms_here[to[(n - k) / 2]] += c; });
            }
        }
    }

   private:
    // Rounding error of the field U if `tilt` shifts the axis from its position `given`, in pixels of pitch `step`. Shift and
    // position may cancel, so the error is proportional to the sum of their moduli. |dU/dv| < 1/2 for the radius v.
    static double rounded(double tilt, double given, double step) {
        return 3.0 * unit_roundoff * (std::abs(tilt) + std::abs(given) * step);
    }

    // Remove terms that are zero for all pupils.
    void trim() {
        std::vector<std::size_t> used;
        for (std::size_t j = 0; j < terms.size(); ++j) {
            for (std::size_t p = 0; p < count; ++p) {
                if (outer[p * terms.size() + j] != 0.0) {
                    used.push_back(j);
                    break;
                }
            }
        }
        if (used.empty()) {
            used.push_back(0);
        }
        for (std::size_t p = 0; p < count; ++p) {
            for (std::size_t j = 0; j < used.size(); ++j) {
                outer[p * used.size() + j] = outer[p * terms.size() + used[j]];
            }
        }
        for (std::size_t j = 0; j < used.size(); ++j) {
            terms[j] = terms[used[j]];
        }
        terms.resize(used.size());
        outer.resize(count * used.size());
    }

    // Index of a term in `terms`; a missing term is appended with the coefficient 0.
    std::size_t place(const ZernikeTerm& term) {
        const std::size_t j = static_cast<std::size_t>(std::find(terms.begin(), terms.end(), term) - terms.begin());
        if (j == terms.size()) {
            std::vector<double> wider(count * (terms.size() + 1), 0.0);
            for (std::size_t p = 0; p < count; ++p) {
                std::copy_n(&outer[p * terms.size()], terms.size(), &wider[p * (terms.size() + 1)]);
            }
            outer.swap(wider);
            terms.push_back(term);
        }
        return j;
    }
};

// Pupils as passed by callers: coefficients edge[pupil][term] in radians, the window, and optionally an axis for each pupil.
struct DiskPupils {
    std::vector<ZernikeTerm> terms;
    const double* edge;
    std::size_t count;
    double obscuration;
    Amplitude amplitude;
    DiskWindow window;
    const double* centers;  // axis of each pupil: [pupil][row, column]; null: the axis of the window
    std::vector<Strip> strips;

    DiskStack stack() const {
        DiskStack made(terms, edge, count, obscuration, amplitude);
        made.strips = strips;
        if (centers != nullptr) {
            made.tilt_to(centers, window);
        }
        return made;
    }
};

}  // namespace lommel
