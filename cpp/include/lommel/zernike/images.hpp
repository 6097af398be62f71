// Images of pupils without radial symmetry, each with its error bound.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lommel/base/tasks.hpp"
#include "lommel/bounds/refine.hpp"
#include "lommel/pixels/mirrored.hpp"
#include "lommel/pixels/render.hpp"
#include "lommel/zernike/disk_stack.hpp"
#include "lommel/zernike/image.hpp"
#include "lommel/zernike/polar_image.hpp"

namespace lommel {

template <class T>
class ZernikeRenderer {
   public:
    // Render a stack after move_axes() and shrink(). answer.peaks receives the largest I, to which error bounds are relative: the
    // maximum of the image or, unless images are divided by their maximum, a larger value outside of it.
    ZernikeRenderer(const DiskStack& stack, const DiskWindow& window, double tol, int threads, const DiskAnswer<T>& answer)
        : stack_(stack), height_(window.height), width_(window.width), step_(window.step), tol_(tol), threads_(threads),
          answer_(answer), within_(stack.amplitude.scaled(stack.obscuration * stack.obscuration)), terms_(stack.terms) {}

    void run() {
        for_pupils(stack_.count, threads_, [&](std::size_t pupil, int threads) { render(pupil, threads); });
    }

   private:
    // Destination of an image: values, scale and number of threads.
    struct Painting {
        T* values;
        double scale;
        int threads;
    };

    ZernikePhase phase(std::size_t i) const {
        return {terms_, stack_.outer.data() + i * terms_.terms.size(), stack_.amplitude};
    }
    ZernikePhase inner_phase(std::size_t i) const {
        return {terms_, stack_.inner.data() + (stack_.inner.empty() ? 0 : i * terms_.terms.size()), within_};
    }

    void render(std::size_t pupil, int threads) {
        const bool divide = answer_.scales[pupil] == 0.0;
        check_phase(phase(pupil).size());
        // Tolerance that remains after the rounding of stored values.
        const double rest = tol_ - (1.0 + tol_) * storing<T>(divide);
        if (rest <= 0.0) {
            throw ToleranceNotMet(storing<T>(divide));
        }
        const double tol = divide ? ZernikeBudget::divided * rest : rest, scale = divide ? 1.0 : answer_.scales[pupil];
        const std::size_t pixels = height_ * width_;
        T* values = answer_.images + pupil * pixels;
        thread_local ZernikeImage image;
        const Tiles tiles(static_cast<std::int64_t>(height_), static_cast<std::int64_t>(width_), stack_.rows[pupil],
                          stack_.columns[pupil]);
        const double first =
            ZernikeBudget::field * tol * stack_.amplitude.integral(stack_.obscuration) / phase(pupil).dimmest();
        double error = first, peak = 0.0;
        const auto expand = [&](ZernikeField& field, double reach) {
            field.expand(phase(pupil), inner_phase(pupil), stack_.obscuration, reach, error, stack_.lost[pupil], threads);
        };
        const double reach = step_ * std::sqrt(static_cast<double>(tiles.farthest()));
        expand(image.field(), reach);
        bool anew = true, expanded = true;
        const auto attempt = [&] {
            if (anew) {
                if (!expanded) {
                    expand(image.field(), reach);
                }
                // The tolerance is relative to a previewed peak, which pixels may miss: reduce it in proportion to `error`.
                image.prepare(tol * error / first);
                expanded = false;
            }
            image.paint(scale, values);
            peak = image.peak();
            double off = image.error_at_peak();
            if (!divide && over_peak(image.error_bound(), peak, off) > tol) {
                scan(pupil, expand, peak, off);
            }
            return finished_error<T>(over_peak(image.error_bound(), peak, off), divide, true);
        };
        double& bound = answer_.bounds[pupil];
        bound = between_circles(image.field(), tiles, tol, divide, {values, scale, threads}, peak);
        if (bound > tol_) {
            const double orders = static_cast<double>(image.field().outer().orders);
            image.begin(cache<MirroredPixels>.get(tiles.height, tiles.width, tiles.row, tiles.column), step_,
                        worthwhile_threads(threads, 3e-3 * orders * static_cast<double>(pixels)));
            bound = settle(tol_, attempt, [&](double) {
                anew = !image.tighten(ZernikeBudget::most * tol * peak);
                error *= anew ? ZernikeBudget::retry : 1.0;
                return error > unit_roundoff;
            });
        }
        answer_.peaks[pupil] = peak;
        if (divide) {
            answer_.scales[pupil] = 1.0 / peak;
            store_scaled(values, answer_.scales[pupil], pixels, values);
        }
    }

    // Compute the image and its peak by interpolation between circles, if that is estimated to be faster. Returns the image's error
    // bound, or 1e300 if the method does not apply or misses the tolerance.
    double between_circles(const ZernikeField& field, const Tiles& tiles, double tol, bool divide, const Painting& to,
                           double& peak) const {
        if (!PolarImage::pays(field, tiles) || to.scale < 1e-25 || to.scale > 1e25) {
            return 1e300;
        }
        thread_local PolarImage image;
        const double work = PolarImage::work(field.reach(), static_cast<double>(field.outer().orders),
                                             static_cast<double>(tiles.height * tiles.width));
        image.begin(tiles, step_, worthwhile_threads(to.threads, 1e-4 * work));
        const PolarPupil pupil(field);
        // `tol` is relative to a previewed peak. If widely spaced pixels miss that peak, a second attempt reduces `tol`.
        double share = 1.0;
        for (int attempt = 0; attempt < 2 && image.prepare(pupil, share * tol); ++attempt) {
            image.paint(to.scale, to.values);
            peak = image.peak();
            const double bound = finished_error<T>(over_peak(image.error_bound(), peak, image.error_at_peak()), divide, true);
            if (bound <= tol_) {
                return bound;
            }
            share = PolarBudget::retry * tol_ / bound;
        }
        return 1e300;
    }

    // Pixels may miss the peak of the intensity I: search it at 65 x 65 points in a square around the axis, which extends by `blur`
    // (at most 400) to every side. If the largest I there exceeds `peak`, set `peak` to it and `off` to the error bound of U there.
    template <class Expand>
    void scan(std::size_t pupil, const Expand& expand, double& peak, double& off) const {
        double blur = 4.0;
        phase(pupil).amplitudes(
            [&](double amplitude, std::size_t n, std::size_t) { blur += amplitude * static_cast<double>(n * n); });
        constexpr std::int64_t side = 65;
        std::vector<double> values(static_cast<std::size_t>(side * side));
        ZernikeImage image;
        const double step = std::min(blur, 400.0) / 32.0;
        image.begin(cache<MirroredPixels>.get(side, side, side / 2, side / 2), step, 1);
        expand(image.field(), step * std::sqrt(2.0) * (side / 2));
        image.prepare(tol_);
        image.paint(1.0, values.data());
        if (image.peak() > peak) {
            peak = image.peak();
            off = image.error_at_peak();
        }
    }

    const DiskStack& stack_;
    std::size_t height_, width_;
    double step_, tol_;
    int threads_;
    DiskAnswer<T> answer_;
    Amplitude within_;  // amplitude within the obscuration
    TermPairs terms_;
};

}  // namespace lommel
