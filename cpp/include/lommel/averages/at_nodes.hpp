// Averages over pixels from samples at nodes of their window, with the bound of certificate 10, for any aperture.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

#include "lommel/averages/window_nodes.hpp"
#include "lommel/base/once.hpp"
#include "lommel/base/pi.hpp"
#include "lommel/base/reference.hpp"
#include "lommel/chordal/averages.hpp"
#include "lommel/limits.hpp"
#include "lommel/pixels/render.hpp"

namespace lommel {

// What the best placed pixel of pitch `step` in v averages at least, over the peak of I.
//
// f = 2 I - M, M the peak, is of exponential type 2 along a line through it and within M, so f'^2 + 4 f^2 <= 4 M^2 (Duffin and
// Schaeffer, Bull. Amer. Math. Soc. 44, 236, 1938): at a distance s below pi/2 from the peak I >= M cos(s)^2. The pixel around the
// peak holds a disk of half its pitch.
inline double least_average(double step) {
    constexpr double half_pi = 1.5707963267948966;
    const double r = std::min(0.5 * step, half_pi), sine = std::sin(r);
    return half_pi * (r * r + r * std::sin(2.0 * r) - sine * sine) / (step * step);
}

// How averages of a window of pixels are wanted. Errors are over the largest average that a pixel has anywhere, or, where values are
// divided by their largest one, over that in the window.
struct AverageRequest {
    std::size_t height, width;
    double step;   // the pitch in v
    double tol;    // of averages once they are stored
    double scale;  // of the intensity; 0 divides by the largest average
    double storing;
    int threads;
    std::vector<ZernikeTerm> factors;  // by whose coefficients derivatives are wanted

    std::size_t pixels() const { return height * width; }
    bool divides() const { return scale == 0.0; }
    // What averages may be off by: values divided by their own largest one are off by twice as much.
    double before_storing() const { return (divides() ? 0.4 : 1.0) * (tol - (1.0 + tol) * storing); }
    double once_stored(double relative) const { return stored(divides() ? normalized_error(relative) : relative, storing); }
};

// Averages in double precision and the numbers that go with them.
struct AverageAnswer {
    double *values, *slopes;        // [pupil][pixel]; derivatives [term][pupil][pixel]
    double *errors, *peaks;         // of each pupil, the former over the latter
    double* slope_errors;           // [term][pupil], over the peaks
};

// What is known of the pupils beforehand: estimates, which no bound depends on.
struct PupilLight {
    double strehl;        // the lowest peak over that without aberration
    double transmission;  // over that of a clear aperture
};

// Fields that are wanted at nodes, with their error, and the precision that is enough.
struct NodeQuestion {
    const WindowNodes &rows, &columns;
    double tol;
    bool single;
};

// What is told of each pupil beside its averages.
struct NodeNumbers {
    std::vector<double> error, brightest, largest, together;  // of fields at the nodes; of samples; of averages, and their sum
    std::vector<double> slope_error, steepest;  // [term][pupil], of samples of derivatives, and the largest modulus
    NodeNumbers(std::size_t pupils, std::size_t terms)
        : error(pupils), brightest(pupils), largest(pupils), together(pupils), slope_error(pupils * terms),
          steepest(pupils * terms) {}
};

// Writes averages and derivatives; throws ToleranceNotMet where fields cannot be within the tolerance.
using NodeSample = Reference<void(const NodeQuestion&, const AverageAnswer&, NodeNumbers&)>;

// Averages of some pupils within the tolerance; false where the window has no nodes, or where that fails.
bool average_at_nodes(const AverageRequest& asked, const PupilLight& light, std::size_t pupils, const AverageAnswer& answer,
                      const NodeSample& sample);

// Stores averages as images, and their derivatives [term][pupil][pixel] with bounds, which compute(answer) writes in double precision;
// nothing, and false, where it returns false.
template <class T, class Compute>
bool averaged_images(const AverageRequest& asked, std::size_t pupils, const DiskAnswer<T>& images, T* slopes,
                     double* slope_bounds, const Compute& compute) {
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

#if defined(LOMMEL_DEFINES)
LOMMEL_ONCE bool average_at_nodes(const AverageRequest& asked, const PupilLight& light, std::size_t pupils,
                                  const AverageAnswer& answer, const NodeSample& sample) {
    constexpr double of_samples = 0.8;  // of the tolerance
    constexpr double sharp = 0.87, dim = 0.1;  // of the likely peak, what is reckoned with: estimates of low ones are too high
    constexpr double of_response = 2e-3;  // of the tolerance and the least average
    constexpr double easier = 64.0;  // times that, where it is in the mean and the peak as without aberration
    constexpr double in_single = 2e-7;  // error of fields from which on samples are in single precision
    const double room = asked.before_storing(), step = asked.step;
    if (!(room > 0.0)) {
        return false;
    }
    // Of the largest average of most pupils, between the peak and what a pixel holds without aberration.
    const double lowest = least_average(step), most = std::min(4.0 * lowest, 1.0),
                 guess = light.strehl * (light.strehl > 0.6 ? sharp : dim);
    double err_samples = of_samples * room * most * guess / (most + guess);
    // Rounded, so that pupils with about the same peaks share nodes.
    double err_response = of_response * room * lowest * std::exp2(std::floor(std::log2(easier * light.strehl)));
    NodeNumbers made(pupils, asked.factors.size());
    for (int attempt = 0; attempt < 3; ++attempt) {
        const auto rows = window_nodes(step, asked.height, err_response),
                   columns = window_nodes(step, asked.width, err_response);
        if (rows == nullptr || columns == nullptr) {
            return false;
        }
        const double gain = rows->gain * columns->gain, spread = rows->spread * columns->spread;
        // All light of an aperture is 4 pi; see below.
        const double all = spread * 4.0 * pi * light.transmission / (step * step);
        const double size = std::sqrt(gain * std::min(gain, all));
        const double err_field = err_samples / (size + std::sqrt(size * size + gain * err_samples));
        const bool single = err_field >= in_single;
        try {
            sample({*rows, *columns, err_field, single}, answer, made);
        } catch (const ToleranceNotMet&) {
            return false;
        }
        const double error = std::max(rows->error, columns->error), missed = (2.0 + error) * error;
        // Of squares, weights, products within blocks, and a sum along rows.
        const double longest = static_cast<double>(std::max(rows->places.size(), columns->places.size()));
        const double rounding =
            (single ? (2.0 * static_cast<double>(node_block) + 8.0) * 0x1p-24 : 0.0) + (2.0 * longest + 11.0) * unit_roundoff;
        double worst = 0.0, worst_given = 0.0, worst_own = 0.0;
        for (std::size_t p = 0; p < pupils; ++p) {
            const double off = intensity_error(std::sqrt(made.brightest[p]), made.error[p]);
            const double peak =
                asked.divides() ? made.largest[p] : std::max(made.largest[p], lowest * (made.brightest[p] - off));
            if (!(peak > 0.0)) {
                return false;
            }
            // Samples weighed by moduli of weights: what all pixels together make of them, but for a factor.
            const double weighed = std::min(gain * made.brightest[p], 1.01 * spread * made.together[p]);
            const double given = made.error[p] * (2.0 * std::sqrt(gain * weighed) + gain * made.error[p]) / peak,
                         own = (missed + rounding * weighed) / peak;
            answer.peaks[p] = peak;
            answer.errors[p] = asked.once_stored(given + own);
            worst = std::max(worst, answer.errors[p] <= asked.tol ? answer.errors[p] : 1e300);
            worst_given = std::max(worst_given, given);
            worst_own = std::max(worst_own, own);
        }
        if (worst <= asked.tol) {
            for (std::size_t i = 0; i < made.steepest.size(); ++i) {
                // The transfer function of a derivative is at most twice that of the disk.
                answer.slope_errors[i] =
                    (gain * (made.slope_error[i] + rounding * made.steepest[i]) + 2.0 * missed) / answer.peaks[i % pupils];
            }
            return true;
        }
        err_samples /= std::max(2.0, 2.0 * worst_given / room);
        err_response *= std::min(1.0, 0.2 * room / worst_own);
    }
    return false;
}
#endif

}  // namespace lommel
