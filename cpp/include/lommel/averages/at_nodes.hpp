// Pixel averages from samples at nodes of the window, for any aperture, with an error bound (certificate, section 10).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <numeric>
#include <vector>

#include "lommel/pixels/window_nodes.hpp"
#include "lommel/base/pi.hpp"
#include "lommel/base/reference.hpp"
#include "lommel/chordal/averages.hpp"
#include "lommel/limits.hpp"
#include "lommel/pixels/render.hpp"
#include "lommel/pixels/taps.hpp"

namespace lommel {

// Request for the pixel averages of a window. Errors are relative to the largest pixel average anywhere in the plane or, if
// values are divided by their maximum, in the window.
struct AverageRequest {
    std::size_t height, width;
    double step;   // pixel pitch, in lambda / (2 pi NA)
    double tol;    // tolerance of the stored averages
    double scale;  // factor of the intensity; 0: divide by the largest average
    double storing;
    int threads;
    std::vector<ZernikeTerm> factors;  // Zernike terms, by whose coefficients averages are differentiated

    std::size_t pixels() const { return height * width; }
    bool divides() const { return scale == 0.0; }
    // Allowed error of averages before they are stored: all that rounding in storage leaves of the tolerance, or 0.4 of it if
    // averages are divided by their maximum, which doubles errors.
    double before_storing() const { return (divides() ? 0.4 : 1.0) * (tol - (1.0 + tol) * storing); }
    double once_stored(double relative) const { return stored(divides() ? normalized_error(relative) : relative, storing); }
};

// Averages and their derivatives in double precision, with error bounds.
struct AverageAnswer {
    double *values, *slopes;        // averages [pupil][pixel], derivatives [term][pupil][pixel]
    double *errors, *peaks;         // [pupil]. errors: error bounds / `peaks`; peaks: largest average or lower bound on it
    double* slope_errors;           // error bounds of derivatives / `peaks`, [term][pupil]
};

// Estimates for a stack of pupils; they affect the speed, and no error bound.
struct PupilLight {
    double strehl;        // lowest peak of the stack, relative to the peak without aberration
    double transmission;  // integral of the squared amplitude, relative to that of a clear aperture
};

// Request for the field U at nodes along rows and columns. tol: allowed error of U; single: single precision suffices, or may;
// pupils: those whose averages are not known yet.
struct NodeQuestion {
    const WindowNodes &rows, &columns;
    double tol;
    bool single;
    const std::vector<std::size_t>& pupils;
};

// Numbers of each pupil, from which the error bounds of its averages follow.
struct NodeNumbers {
    // [pupil]. error, brightest: error of the field and largest intensity at nodes; largest, together: maximum and sum of averages;
    // moduli: bound on the sum of |weight| * |U| in a pixel, if known.
    std::vector<double> error, brightest, largest, together, moduli;
    // [term][pupil]. slope_error, steepest: error and largest modulus of the derivatives of the intensity at nodes.
    std::vector<double> slope_error, steepest;
    NodeNumbers(std::size_t pupils, std::size_t terms)
        : error(pupils), brightest(pupils), largest(pupils), together(pupils),
          moduli(pupils, std::numeric_limits<double>::infinity()), slope_error(pupils * terms), steepest(pupils * terms) {}
};

// Function that computes fields at nodes, and averages and derivatives from them; it throws ToleranceNotMet if fields miss tol.
using NodeSample = Reference<void(const NodeQuestion&, const AverageAnswer&, NodeNumbers&)>;

// Call compute(answer), which writes averages and derivatives in double precision. Store these in `images` and
// slopes[term][pupil][pixel], with error bounds. If compute() returns false, nothing is stored and false is returned.
template <class T, class Compute>
bool averaged_images(const AverageRequest& asked, std::size_t pupils, const Answer<T>& images, T* slopes, double* slope_bounds,
                     const Compute& compute) {
    const std::size_t pixels = asked.pixels(), derivatives = asked.factors.size() * pupils;
    const std::unique_ptr<double[]> values(new double[pupils * pixels]), slope_values(new double[derivatives * pixels]);
    std::vector<double> slope_errors(derivatives);
    if (!compute(AverageAnswer{values.get(), slope_values.get(), images.bounds, images.peaks, slope_errors.data()})) {
        return false;
    }
    for (std::size_t p = 0; p < pupils; ++p) {
        images.scales[p] = asked.divides() ? 1.0 / images.peaks[p] : asked.scale;
        store_scaled(values.get() + p * pixels, images.scales[p], pixels, images.images + p * pixels);
    }
    for (std::size_t i = 0; i < derivatives; ++i) {
        const double* const from = slope_values.get() + i * pixels;
        const auto [least, most] = std::minmax_element(from, from + pixels);
        const double size = std::max(-*least, *most) / images.peaks[i % pupils], off = slope_errors[i];
        slope_bounds[i] = off + (size + off) * asked.storing;
        store_scaled(from, images.scales[i % pupils], pixels, slopes + i * pixels);
    }
    return true;
}

// Compute the averages of `pupils` pupils; returns false if no nodes suit the window, or if averages miss the tolerance. `apart`:
// sample() computes the pupils of a question only; a first attempt may then miss the tolerance of some.
inline bool average_at_nodes(const AverageRequest& asked, const PupilLight& light, std::size_t pupils,
                             const AverageAnswer& answer, const NodeSample& sample, bool apart = false) {
    constexpr double of_samples = 0.8;  // fraction of the tolerance for errors of samples
    // Factors on the estimated Strehl ratio: `sharp` above 0.6, `dim` for lower ratios, whose estimates are often too high.
    constexpr double sharp = 0.87, dim = 0.1;
    constexpr double of_response = 2e-3;  // allowed error of the frequency response / (tolerance * least_average())
    constexpr double easier = 64.0;  // factor on of_response at a Strehl ratio of 1, lowered in proportion to the ratio
    constexpr double in_single = 2e-7;  // if the field may have this error or more, samples are in single precision
    const double room = asked.before_storing(), step = asked.step;
    if (!(room > 0.0)) {
        return false;
    }
    // Estimated largest average: most * guess / (most + guess). `most`: largest average without aberration, approximately; `guess`:
    // cautious estimate of the peak.
    const double lowest = least_average(step), most = std::min(4.0 * lowest, 1.0),
                 guess = light.strehl * (light.strehl > 0.6 ? sharp : dim);
    double err_samples = of_samples * room * most * guess / (most + guess);
    // The factor easier * strehl is rounded down to a power of 2, so that pupils with similar peaks share cached nodes.
    double err_response = of_response * room * lowest * std::exp2(std::floor(std::log2(easier * light.strehl)));
    // Largest sample likely where the largest average is as estimated.
    const double bright = apart ? std::min(1.0, most * guess / ((most + guess) * lowest)) : 1.0;
    NodeNumbers made(pupils, asked.factors.size());
    std::vector<std::size_t> rest(pupils);
    std::iota(rest.begin(), rest.end(), std::size_t{0});
    for (int attempt = 0; attempt < (apart ? 4 : 3); ++attempt) {
        const auto rows = window_nodes(step, asked.height, err_response),
                   columns = window_nodes(step, asked.width, err_response);
        if (rows == nullptr || columns == nullptr) {
            return false;
        }
        const double gain = rows->gain * columns->gain, spread = rows->spread * columns->spread;
        // The intensity of a clear aperture integrates to 4 pi over the plane (Parseval); a pixel has the area step^2.
        const double all = spread * 4.0 * pi * light.transmission / (step * step);
        const double size = std::sqrt(gain * std::min(gain * bright, all));
        const double err_field = err_samples / (size + std::sqrt(size * size + gain * err_samples));
        const bool single = err_field >= in_single && (attempt == 0 || !apart);
        try {
            sample({*rows, *columns, err_field, single, rest}, answer, made);
        } catch (const ToleranceNotMet&) {
            return false;
        }
        const double error = std::max(rows->error, columns->error), missed = (2.0 + error) * error;
        // Rounding of squares, weights, sums within blocks, and sums along rows and columns (certificate, section 10).
        const double longest = static_cast<double>(std::max(rows->places.size(), columns->places.size()));
        const double rounding =
            (single ? (2.0 * static_cast<double>(node_block) + 8.0) * 0x1p-24 : 0.0) + (2.0 * longest + 11.0) * unit_roundoff;
        double worst_given = 0.0, worst_own = 0.0;
        std::vector<std::size_t> missing;
        for (const std::size_t p : rest) {
            const double off = intensity_error(std::sqrt(made.brightest[p]), made.error[p]);
            const double peak =
                asked.divides() ? made.largest[p] : std::max(made.largest[p], lowest * (made.brightest[p] - off));
            if (!(peak > 0.0)) {
                return false;
            }
            // Sum of |weight| * sample (A in certificate, section 10): at most gain * (largest sample), and at most spread * (sum
            // of all averages), with a factor 1.01 for the rounding of that sum.
            const double weighed = std::min(gain * made.brightest[p], 1.01 * spread * made.together[p]);
            const double moduli = std::min(std::sqrt(gain * weighed), made.moduli[p]);
            const auto of_fields = [&](double error) { return error * (2.0 * moduli + gain * error) / peak; };
            const double own = (missed + rounding * weighed) / peak;
            answer.peaks[p] = peak;
            answer.errors[p] = asked.once_stored(of_fields(made.error[p]) + own);
            for (std::size_t i = p; i < made.steepest.size(); i += pupils) {
                // The transfer function of a derivative is at most twice that of a clear disk (certificate, section 8).
                answer.slope_errors[i] = (gain * (made.slope_error[i] + rounding * made.steepest[i]) + 2.0 * missed) / peak;
            }
            if (!(answer.errors[p] <= asked.tol)) {
                missing.push_back(p);
            }
            if (!apart || (!missing.empty() && missing.back() == p)) {
                // Apart, sums in single precision may have missed what was asked; they will be in double precision.
                worst_given = std::max(worst_given, of_fields(apart ? std::min(made.error[p], err_field) : made.error[p]));
                worst_own = std::max(worst_own, own);
            }
        }
        if (missing.empty()) {
            return true;
        }
        if (apart) {
            rest = missing;
        }
        err_samples /= std::max(apart && single ? 1.0 : 2.0, 2.0 * worst_given / room);
        err_response *= std::min(1.0, 0.2 * room / worst_own);
    }
    return false;
}

}  // namespace lommel
