// Intensity of one pupil and its derivatives at given radii, refined until the tolerance is met.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/base/parallel.hpp"
#include "lommel/base/reference.hpp"
#include "lommel/bounds/refine.hpp"
#include "lommel/pixels/render.hpp"
#include "lommel/radial/field.hpp"

namespace lommel {

constexpr std::size_t chunk_radii = 4096;  // number of radii per chunk, whose values fit into the first-level cache

// Call take(first, count, values) with the intensities at `places`, for which `field` is prepared; returns the maximum.
using TakeIntensities = Reference<void(std::size_t first, std::size_t count, const double* values)>;
inline double intensities(Field& field, const Places& places, int threads, const TakeIntensities& take) {
    const std::size_t tasks = (places.count + chunk_radii - 1) / chunk_radii;
    const auto work = [&](Field& own, std::size_t task) {
        // Values go to a buffer: whole vectors are stored, which reach past the end of a chunk, where another chunk begins.
        alignas(64) double buffer[chunk_radii + widest_step];
        const std::size_t first = task * chunk_radii, last = std::min(places.count, first + chunk_radii);
        double top = 0.0;
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            own.evaluate(isa, places.radii, first, last, places.step,
                         [&](std::size_t i, auto re, auto im) LOMMEL_INLINE_LAMBDA { store(buffer + i, re * re + im * im); });
            top = largest(buffer, last - first);
        });
        take(first, last - first, buffer);
        return top;
    };
    double top = 0.0;
    if (tasks < 16 || threads == 1) {
        for (std::size_t task = 0; task < tasks; ++task) {
            look();
            top = std::max(top, work(field, task));
        }
        return top;
    }
    // Each thread has a copy of the field, with its own buffers, and its own maximum.
    std::vector<Field> fields(static_cast<std::size_t>(processors()) + 1, field);
    std::vector<double> tops(fields.size(), 0.0);
    parallel_for(tasks, threads, [&](std::size_t worker, std::size_t task) {
        tops[worker] = std::max(tops[worker], work(fields[worker], task));
    });
    return *std::max_element(tops.begin(), tops.end());
}

// Derivative of the intensity I with respect to the phase coefficient c_k of t^k, t: squared pupil radius:
// dI/dc_k = 2 Re(conj(U) i T), where U is the field of the pupil function and T the field of t^k * pupil function.
struct Slopes {
    Doubles values;
    double error = 0.0, size = 0.0, steepest = 0.0;  // error bound of the field T; largest |T|^2; largest |values|

    // Compute `values` = dI/dc_k at `places`, for which `field` must be prepared. k = power: c_k is the coefficient of t^k in the
    // phase; requested: requested error of the field T.
    Slopes(Field& field, const Phase& phase, std::size_t power, double obscuration, const Places& places, double requested)
        : values(places.count) {
        Field derivative;
        error = derivative.prepare(phase, power, obscuration, places, requested);
        // Buffers with room for whole vectors, which may extend past the end of a chunk.
        Doubles re(chunk_radii + widest_step), im(re.size()), a(re.size()), b(re.size()), slope(re.size()), square(re.size());
        for (std::size_t first = 0; first < places.count; first += chunk_radii) {
            look();
            const std::size_t last = std::min(places.count, first + chunk_radii);
            field.values(places.radii, first, last, places.step, re.data(), im.data());
            derivative.values(places.radii, first, last, places.step, a.data(), b.data());
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                using V = typename decltype(isa)::pack;
                for (std::size_t i = 0; i < last - first; i += decltype(isa)::lanes) {
                    const V u = load<V>(&re[i]), w = load<V>(&im[i]), x = load<V>(&a[i]), y = load<V>(&b[i]);
                    store(&slope[i], splat<V>(2.0) * (w * x - u * y));
                    store(&square[i], x * x + y * y);
                }
            });
            for (std::size_t i = 0; i < last - first; ++i) {
                values[first + i] = slope[i];
                size = std::max(size, square[i]);
                steepest = std::max(steepest, std::abs(slope[i]));
            }
        }
    }
};

// Largest intensity on a scan of the radii that rays reach: a window may miss the peak, which need not be on the axis.
inline double scanned_peak(const Phase& phase, double obscuration, double error) {
    const double blur = 4.0 + phase.blur();
    constexpr std::size_t samples = 512;
    Doubles radii(samples + widest_step);
    for (std::size_t i = 0; i < radii.size(); ++i) {
        radii[i] = static_cast<double>(i);
    }
    Field field;
    const Places places(radii.data(), samples, blur / samples);
    field.prepare(phase, 0, obscuration, places, error);
    return intensities(field, places, 1, [](std::size_t, std::size_t, const double*) {});
}

struct Settled {
    double error, bound;  // requested error of the field U; its error bound
    double relative;  // error bound of the stored values, relative to the peak
    double top, peak;  // largest intensity in the window; largest one found, also outside the window
};

// Prepare `field` for `places` with smaller and smaller errors, until values of type T have an error of at most tol * peak.
// `evaluate` computes the window's intensities and returns their maximum, by which they are divided if `normalize`.
template <class T, class Evaluate>
Settled settle_field(Field& field, const Phase& phase, double obscuration, const Places& places, double tol, bool normalize,
                     const Evaluate& evaluate) {
    Settled s{first_error(phase, obscuration, tol), 0.0, 0.0, 0.0, 0.0};
    const auto relative = [&] { return finished_error<T>(relative_error(s.peak, s.bound), normalize, true); };
    const auto attempt = [&] {
        s.bound = field.prepare(phase, 0, obscuration, places, s.error);
        s.top = s.peak = evaluate();
        if (!normalize && !(relative() <= tol)) {
            s.peak = std::max(s.peak, scanned_peak(phase, obscuration, s.error));
        }
        return relative();
    };
    s.relative = settle(tol, attempt, [&](double) {
        const bool more = s.error >= RadialBudget::least;
        s.error *= RadialBudget::retry;
        return more;
    });
    return s;
}

}  // namespace lommel
