// Images of pupils without radial symmetry, each with its error bound.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lommel/base/tasks.hpp"
#include "lommel/bounds/refine.hpp"
#include "lommel/pixels/render.hpp"
#include "lommel/zernike/disk_stack.hpp"
#include "lommel/zernike/polar_image.hpp"
#include "lommel/zernike/series_cost.hpp"

namespace lommel {

template <class T>
class ZernikeRenderer {
   public:
    // Render a stack after move_axes() and shrink(). answer.peaks receives the largest I, to which error bounds are relative: the
    // maximum of the image or, unless images are divided by their maximum, a larger value outside of it.
    ZernikeRenderer(const DiskStack& stack, const DiskWindow& window, double tol, int threads, const Answer<T>& answer)
        : stack_(stack), height_(window.height), width_(window.width), step_(window.step), tol_(tol), threads_(threads),
          answer_(answer), within_(stack.amplitude.scaled(stack.obscuration * stack.obscuration)), terms_(stack.terms) {}

    void run() {
        for_pupils(stack_.count, threads_, [&](std::size_t pupil, int threads) { render(pupil, threads); });
    }

   private:
    ZernikePhase phase(std::size_t i) const {
        return {terms_, stack_.outer.data() + i * terms_.terms.size(), stack_.amplitude};
    }
    ZernikePhase inner_phase(std::size_t i) const {
        return {terms_, stack_.inner.data() + (stack_.inner.empty() ? 0 : i * terms_.terms.size()), within_};
    }

    void expand(std::size_t pupil, double reach, double error, int threads, ZernikeField& field) const {
        field.expand(phase(pupil), inner_phase(pupil), stack_.obscuration, reach, error, stack_.lost[pupil], threads);
    }

    // Compute a few pixels one by one, so far from the axis that circles up to there are too many; returns the largest I.
    double directly(const ZernikeField& field, const Tiles& tiles, double scale, T* values) const {
        const double coefficients = static_cast<double>(field.outer().degrees * field.outer().orders);
        if (SeriesCost::directly(field.reach(), coefficients, static_cast<double>(height_ * width_)) > 1e10) {
            throw LimitExceeded("these aberrations in a window that reaches to v = " + shortened(field.reach()) +
                                " take tables that are too large: less aberration or a smaller window takes smaller ones");
        }
        double peak = 0.0;
        for (std::size_t i = 0; i < height_ * width_; ++i) {
            look();
            const double y = static_cast<double>(static_cast<std::int64_t>(i / width_) - tiles.row),
                         x = static_cast<double>(static_cast<std::int64_t>(i % width_) - tiles.column),
                         r = std::max(std::sqrt(x * x + y * y), 1e-150);
            const double intensity = std::norm(field.at(step_ * r, x / r, y / r));
            values[i] = static_cast<T>(scale * intensity);
            peak = std::max(peak, intensity);
        }
        return peak;
    }

    void render(std::size_t pupil, int threads) {
        const bool divide = answer_.scales[pupil] == 0.0;
        check_phase(phase(pupil).size());
        // Values are scaled after they are stored if they are divided by the largest of them, or if single precision might not
        // hold the products before.
        const double given = answer_.scales[pupil];
        const bool after = divide || given < 1e-25 || given > 1e25;
        // Tolerance that remains after the rounding of stored values.
        const double rest = tol_ - (1.0 + tol_) * storing<T>(after);
        if (rest <= 0.0) {
            throw ToleranceNotMet(storing<T>(after));
        }
        const double tol = divide ? ZernikeBudget::divided * rest : rest;
        const std::size_t pixels = height_ * width_;
        T* values = answer_.images + pupil * pixels;
        const Tiles tiles(static_cast<std::int64_t>(height_), static_cast<std::int64_t>(width_), stack_.rows[pupil],
                          stack_.columns[pupil]);
        const double reach = step_ * std::sqrt(static_cast<double>(tiles.farthest()));
        double error = ZernikeBudget::field * tol * stack_.amplitude.integral(stack_.obscuration) / phase(pupil).dimmest();
        thread_local ZernikeField field;
        thread_local PolarImage image;
        expand(pupil, reach, error, threads, field);
        const bool circles = SeriesCost::circles(reach, static_cast<double>(field.outer().degrees),
                                                 static_cast<double>(field.outer().orders), static_cast<double>(pixels));
        image.begin(tiles, step_, worthwhile_threads(threads, 1e-4 * PolarImage::work(field, tiles)));
        bool scanned = divide, likely = true;
        int attempts = 0;
        // share: factor of the tolerance; outside, off: largest I outside of the window, and the error bound of U there.
        double share = 1.0, outside = 0.0, off = 0.0, peak = 0.0;
        const auto attempt = [&] {
            ++attempts;
            const double scale = after ? 1.0 : given;
            PaintedPart brightest{field.base() + field.rounding(), 0.0};
            double error_bound = 0.0;
            if (circles) {
                likely = image.prepare(PolarPupil(field), share * tol, outside);
                image.paint(scale, values);
                brightest = {image.error_at_peak(), image.peak()};
                error_bound = image.error_bound();
            } else {
                brightest.top = directly(field, tiles, scale, values);
                error_bound = brightest.error_bound();
            }
            peak = std::max(brightest.top, outside);
            const double relative = over_peak(error_bound, peak, brightest.top < peak ? off : brightest.error);
            return stored(divide ? normalized_error(relative) : relative, storing<T>(after));
        };
        answer_.bounds[pupil] = settle(tol_, attempt, [&](double bound) {
            if (!scanned && (!likely || attempts > 1)) {
                scanned = true;
                scan(pupil, error, outside, off);
                if (outside > peak) {
                    return true;
                }
            }
            // The tolerance is relative to a previewed peak, which widely spaced pixels may miss.
            share *= PolarBudget::retry * std::max(1e-3, tol_ / bound);
            if (!likely || attempts > 1) {
                error *= ZernikeBudget::retry;
                expand(pupil, reach, error, threads, field);
            }
            return attempts < (likely ? 4 : 3);
        });
        answer_.peaks[pupil] = peak;
        if (divide) {
            answer_.scales[pupil] = 1.0 / peak;
        }
        if (after) {
            store_scaled(values, answer_.scales[pupil], pixels, values);
        }
    }

    // Pixels may miss the peak of the intensity I: search it at 65 x 65 points in a square around the axis, which extends by `blur`
    // (at most 400) to every side. peak: the largest I there; off: the error bound of U there.
    void scan(std::size_t pupil, double error, double& peak, double& off) const {
        double blur = 4.0;
        phase(pupil).amplitudes(
            [&](double amplitude, std::size_t n, std::size_t) { blur += amplitude * static_cast<double>(n * n); });
        constexpr std::int64_t side = 65;
        std::vector<double> values(static_cast<std::size_t>(side * side));
        ZernikeField field;
        PolarImage image;
        const Tiles tiles(side, side, side / 2, side / 2);
        const double step = std::min(blur, 400.0) / 32.0;
        image.begin(tiles, step, 1);
        expand(pupil, step * std::sqrt(2.0) * (side / 2), error, 1, field);
        image.prepare(PolarPupil(field), std::max(tol_, 1e-8));
        image.paint(1.0, values.data());
        peak = image.peak();
        off = image.error_at_peak();
    }

    const DiskStack& stack_;
    std::size_t height_, width_;
    double step_, tol_;
    int threads_;
    Answer<T> answer_;
    Amplitude within_;  // amplitude within the obscuration
    TermPairs terms_;
};

}  // namespace lommel
