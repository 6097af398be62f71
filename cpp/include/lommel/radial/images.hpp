// Images of radially symmetric pupils, with error bounds.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>
#include <memory>
#include <vector>

#include "lommel/base/tasks.hpp"
#include "lommel/pixels/layout.hpp"
#include "lommel/pixels/render.hpp"
#include "lommel/pixels/window.hpp"
#include "lommel/radial/batch.hpp"
#include "lommel/radial/intensity.hpp"
#include "lommel/radial/stack.hpp"

namespace lommel {

template <class T>
class Renderer {
   public:
    Renderer(const Stack& stack, std::size_t height, std::size_t width, double step, double tol, int threads,
             const Answer<T>& answer)
        : Renderer(stack, {height, width, static_cast<double>(height / 2), static_cast<double>(width / 2), step, false}, tol,
                   threads, answer) {}
    // Constructor for a window whose axis is at a pixel centre or midway between pixels.
    Renderer(const Stack& stack, const PixelWindow& window, double tol, int threads, const Answer<T>& answer)
        : stack_(stack), layout_(Layout::get(window.rows(), window.columns())), step_(window.step), tol_(tol),
          threads_(threads), answer_(answer) {}

    void run() {
        // Estimated time of the stack in microseconds. Measured in November 2026 on one thread of a Zen 5 with AVX-512: 0.65
        // for each of a thousand images of 33^2 pixels, 96 for one of 512^2.
        threads_ =
            worthwhile_threads(threads_, static_cast<double>(stack_.count) * (0.3 + 0.35e-3 * static_cast<double>(pixels())));
        if (answer_.derivatives == 0 && Batch::fits(stack_)) {
            const Box box(stack_);
            const Phase worst = box.worst(stack_.amplitude);
            if (Batch::pays(stack_, worst, *layout_, step_)) {
                return render_batch(Batch(stack_, box, layout_, step_, first_error(worst, 0.0, tol_)));
            }
        }
        for_pupils(stack_.count, threads_, [&](std::size_t pupil, int threads) { render(pupil, threads); });
    }

    // Compute the image of one pupil, and its derivatives, from fields evaluated by class Field.
    void render(std::size_t pupil, int threads) {
        thread_local std::vector<T> profile;
        thread_local Field field;
        const Phase phase = stack_[pupil];
        const Places places(layout_->radii.data(), layout_->count, step_);
        const bool divide = answer_.scales[pupil] == 0.0;
        const double scale = divide ? 1.0 : answer_.scales[pupil];
        profile.resize(layout_->count);
        T* const values = profile.data();  // buffer of the calling thread, filled by all threads
        const auto take = [&](std::size_t first, std::size_t count, const double* intensity) {
            store_scaled(intensity, scale, count, values + first);
        };
        const Settled settled = settle_field<T>(field, phase, stack_.obscuration, places, tol_, divide,
                                                [&] { return intensities(field, places, threads, take); });
        answer_.finish(pupil, settled.top, settled.peak, settled.relative);
        if (divide) {
            store_scaled(values, answer_.scales[pupil], layout_->count, values);
        }
        paint(values, answer_.images + pupil * pixels(), threads);
        for (std::size_t d = 0; d < answer_.derivatives; ++d) {
            const Slopes slopes(field, phase, answer_.powers[d], stack_.obscuration, places, settled.error);
            store_scaled(slopes.values.data(), answer_.scales[pupil], layout_->count, values);
            const std::size_t at = d * stack_.count + pupil;
            paint(values, answer_.derivative_images + at * pixels(), 1);
            // Error bound, relative to the exact peak, of the derivative 2 Re(conj(U) i T), with U the field of the pupil function
            // and T the field of (squared pupil radius)^power * pupil function, as in Slopes.
            const double u = std::sqrt(settled.peak), t = std::sqrt(slopes.size);
            const double slope_error =
                u * slopes.error + t * settled.bound + slopes.error * settled.bound + u * t * storing<T>(false);
            answer_.derivative_bounds[at] = 2.0 * over_peak(slope_error, settled.peak, settled.bound);
        }
    }

   private:
    std::size_t pixels() const { return layout_->height() * layout_->width(); }

    // Compute the images of a batch; those whose error bound exceeds the tolerance are computed again one by one.
    void render_batch(const Batch& batch) {
        batch.run(threads_, [&](std::size_t first, std::size_t here, const double* intensity, std::size_t stride) {
            for (std::size_t p = 0; p < here; ++p, intensity += stride) {
                const double peak = largest_value(intensity, layout_->count);
                const double bound =
                    finished_error<T>(relative_error(peak, batch.error(first + p)), answer_.scales[first + p] == 0.0, false);
                if (bound <= tol_) {
                    deliver(first + p, intensity, peak, bound);
                } else {
                    render(first + p, 1);
                }
            }
        });
    }

    void deliver(std::size_t pupil, const double* intensity, double peak, double bound) {
        thread_local std::vector<T> profile, assembled;
        profile.resize(layout_->count);
        store_scaled(intensity, answer_.finish(pupil, peak, peak, bound), layout_->count, profile.data());
        T* image = answer_.images + pupil * pixels();
        if (pixels() * sizeof(T) > (std::size_t{1} << 14)) {
            return paint(profile.data(), image, 1);
        }
        // Assemble a small image in the first-level cache and write it in one stream, instead of by rows and mirrored rows.
        assembled.resize(pixels());
        paint(profile.data(), assembled.data(), 1);
        std::memcpy(image, assembled.data(), pixels() * sizeof(T));
    }

    void paint(const T* profile, T* image, int threads) {
        for_rows(layout_->rows.distances(), layout_->width(), threads,
                 [&](std::size_t first, std::size_t last) { layout_->scatter(profile, first, last, image); });
    }

    Stack stack_;
    std::shared_ptr<const Layout> layout_;
    double step_, tol_;
    int threads_;
    Answer<T> answer_;
};

}  // namespace lommel
