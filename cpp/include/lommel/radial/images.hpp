// From pupils to finished images, each with its proven error.
#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <vector>

#include "lommel/radial/batch.hpp"
#include "lommel/radial/field.hpp"
#include "lommel/pixels/layout.hpp"
#include "lommel/base/parallel.hpp"
#include "lommel/pixels/render.hpp"

namespace lommel {

struct Stack {
    const double* coefficients;  // [pupil][term] of R_2^0, R_4^0, ...
    std::size_t count, terms;
    double obscuration;
    Amplitude amplitude{};
    Phase operator[](std::size_t i) const { return {coefficients + i * terms, terms, &amplitude}; }
};

// Where the answer goes. For each pupil: the image, what the intensity was multiplied by (0 on entry: divide by the
// largest value instead), the bound on the error over the peak, and dI/dc_k for each of `derivatives`.
template <class T>
struct Answer {
    T* images;
    double* scales;
    double* bounds;
    const std::size_t* powers;  // the k of dI/dc_k
    std::size_t derivatives;
    T* derivative_images;  // [derivative][pupil][height][width]
    double* derivative_bounds;  // [derivative][pupil], over the peak of the intensity
};

// Microseconds of work that are worth a thread: it takes some 20 to start, and more where the other processors are busy.
// Lowered by tests, to have threads at all.
inline double& work_per_thread() {
    static double microseconds = 200.0;
    return microseconds;
}

// The largest of values >= 0, in eight chains that compilers vectorise.
LOMMEL_INLINE double largest(const double* values, std::size_t count) {
    double top[8] = {};
    std::size_t i = 0;
    for (; i + 8 <= count; i += 8) {
        for (std::size_t j = 0; j < 8; ++j) {
            top[j] = values[i + j] > top[j] ? values[i + j] : top[j];
        }
    }
    for (; i < count; ++i) {
        top[0] = values[i] > top[0] ? values[i] : top[0];
    }
    return *std::max_element(top, top + 8);
}

template <class T>
LOMMEL_INLINE void scaled(const double* values, double scale, std::size_t count, T* out) {
    for (std::size_t i = 0; i < count; ++i) {
        out[i] = static_cast<T>(scale * values[i]);
    }
}

template <class T>
class Renderer {
   public:
    Renderer(const Stack& stack, std::size_t height, std::size_t width, double step, double tol, int threads,
             const Answer<T>& answer)
        : stack_(stack), layout_(Layout::get(height, width)), step_(step), tol_(tol), threads_(threads),
          answer_(answer) {}

    void run() {
        // Roughly what the stack takes, in microseconds.
        const double work = static_cast<double>(stack_.count) * (0.3 + 0.35e-3 * static_cast<double>(pixels()));
        const int worthwhile = static_cast<int>(std::min(1024.0, std::max(1.0, work / work_per_thread())));
        threads_ = std::min(threads_ > 0 ? threads_ : worthwhile, worthwhile);
        if (answer_.derivatives == 0 && stack_.count >= 4 && stack_.obscuration == 0.0 && prefer_batch()) {
            run_batch();
        } else if (stack_.count > 1) {
            parallel_for(stack_.count, threads_, [&](std::size_t, std::size_t pupil) { render(pupil, 1); });
        } else {
            render(0, threads_);
        }
    }

   private:
    static constexpr std::size_t chunk = 4096;  // radii whose values stay in the first cache

    // Multiply-adds a pupil by pieces and by the table at the exact radii, whose making is shared by the stack.
    bool prefer_batch() const {
        std::vector<double> least, most;
        box(least, most);
        const Phase far{most.data(), most.size()}, near{least.data(), least.size()};
        const double reach = layout_->reach() * step_;
        const double terms = std::min(std::max(far.size(), near.size()) + 12.0, 0.5 * reach + 12.0);
        const double radii = static_cast<double>(layout_->count);
        const double pieces = 32.0 * (terms * (reach / 8.0 + 1.0) + radii) + 4000.0;
        const double table = 2.0 * terms * radii + 4.0 * radii * (reach + terms + 60.0) / static_cast<double>(stack_.count);
        return table < pieces && terms * radii < 4e6 && stack_.terms <= 4;
    }

    void box(std::vector<double>& least, std::vector<double>& most) const {
        least.assign(stack_.coefficients, stack_.coefficients + stack_.terms);
        most = least;
        for (std::size_t i = 1; i < stack_.count; ++i) {
            for (std::size_t k = 0; k < stack_.terms; ++k) {
                least[k] = std::min(least[k], stack_[i].coefficients[k]);
                most[k] = std::max(most[k], stack_[i].coefficients[k]);
            }
        }
    }

    void run_batch() {
        std::vector<double> least, most;
        box(least, most);
        std::vector<double> largest(stack_.terms);
        for (std::size_t k = 0; k < largest.size(); ++k) {
            largest[k] = std::max(std::abs(least[k]), std::abs(most[k]));
        }
        const Phase worst{largest.data(), largest.size(), &stack_.amplitude};
        check_size(worst);
        const double error = first_error(worst, 0.0, tol_), reach = layout_->reach() * step_;
        const Expansion plan(Ellipses(least, most, stack_.amplitude), reach, error);
        const auto table = RadiusTable::get(layout_, step_, plan.terms);
        const std::size_t room = plan.room();
        parallel_for((stack_.count + group - 1) / group, threads_, [&](std::size_t, std::size_t task) {
            thread_local SeriesScratch scratch;
            thread_local Doubles re, im, values;
            // A group at a time through each stage, so that one table at a time fills the first cache.
            const std::size_t first = task * group, here = std::min(group, stack_.count - first);
            constexpr std::size_t rounded = (group + block_pupils - 1) / block_pupils * block_pupils;
            re.resize(rounded * room);
            im.resize(rounded * room);
            values.resize(rounded * table->stride);
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                for (std::size_t p = 0; p < here; ++p) {
                    const Phase phase = stack_[first + p];
                    legendre_coefficients(isa, *plan.rule, phase.coefficients, phase.terms, *phase.amplitude, 0, plan.terms,
                                          re.data() + p * room, im.data() + p * room, scratch);
                }
                for (std::size_t p = 0; p < here; p += block_pupils) {
                    block_intensities(isa, *table, plan.terms, re.data() + p * room, im.data() + p * room, room,
                                      values.data() + p * table->stride);
                }
            });
            const double rounding = unit_roundoff * (static_cast<double>(plan.terms) + 16.0) + radius_rounding(reach);
            for (std::size_t p = 0; p < here; ++p) {
                deliver(first + p, values.data() + p * table->stride, plan.error(stack_[first + p]) + rounding);
            }
        });
    }

    // An image of the batch; one whose bound is too weak for it is computed again on its own.
    void deliver(std::size_t pupil, const double* intensity, double bound) {
        double peak = 0.0;
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA { peak = largest(intensity, layout_->count); });
        const double simple = relative_error(peak, bound);
        const double relative = stored(answer_.scales[pupil] == 0.0 ? normalized_error(simple) : simple, storing<T>(false));
        if (!(relative <= tol_)) {
            return render(pupil, 1);
        }
        thread_local std::vector<T> profile;
        profile.resize(layout_->count);
        finish(pupil, peak, relative);
        const double scale = answer_.scales[pupil];
        scaled(intensity, scale, layout_->count, profile.data());
        T* image = answer_.images + pupil * pixels();
        if (pixels() * sizeof(T) > (std::size_t{1} << 14)) {
            return paint(profile.data(), image, 1);
        }
        // A small image is put together in the first cache and written out in one stream, not row by mirrored row.
        thread_local std::vector<T> assembled;
        assembled.resize(pixels());
        paint(profile.data(), assembled.data(), 1);
        std::memcpy(image, assembled.data(), pixels() * sizeof(T));
    }

    void finish(std::size_t pupil, double peak, double relative) {
        answer_.bounds[pupil] = relative;
        if (answer_.scales[pupil] == 0.0) {
            answer_.scales[pupil] = 1.0 / peak;
        }
    }

    std::size_t pixels() const { return layout_->height * layout_->width; }
    Places places() const { return {layout_->radii.data(), layout_->count, step_}; }

    // One pupil, by pieces.
    void render(std::size_t pupil, int threads) {
        thread_local std::vector<T> profile;
        thread_local Field field;
        profile.resize(layout_->count);
        const Phase phase = stack_[pupil];
        const double fixed = answer_.scales[pupil];
        const auto evaluate = [&] { return intensities(field, fixed == 0.0 ? 1.0 : fixed, profile.data(), threads); };
        const Settled settled =
            settle(field, phase, stack_.obscuration, places(), tol_, fixed == 0.0, evaluate, storing<T>(fixed == 0.0));
        finish(pupil, settled.top, settled.relative);
        if (fixed == 0.0) {
            const double scale = answer_.scales[pupil];
            for (T& value : profile) {
                value = static_cast<T>(scale * static_cast<double>(value));
            }
        }
        paint(profile.data(), answer_.images + pupil * pixels(), threads);
        for (std::size_t d = 0; d < answer_.derivatives; ++d) {
            differentiate(pupil, d, settled);
        }
    }

    // Scaled I at the distinct radii; returns the largest unscaled one.
    double intensities(Field& field, double scale, T* profile, int threads) {
        const std::size_t count = layout_->count, tasks = (count + chunk - 1) / chunk;
        std::vector<double> peaks(tasks, 0.0);
        const double* radii = layout_->radii.data();
        const auto work = [&](Field& own, std::size_t task) {
            alignas(64) double buffer[chunk + widest_step];
            const std::size_t first = task * chunk, last = std::min(count, first + chunk);
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                own.evaluate(isa, radii, first, last, step_, [&](std::size_t i, auto re, auto im) LOMMEL_INLINE_LAMBDA {
                    store(buffer + i, re * re + im * im);
                });
                peaks[task] = largest(buffer, last - first);
                scaled(buffer, scale, last - first, profile + first);
            });
        };
        if (tasks < 16) {
            for (std::size_t task = 0; task < tasks; ++task) {
                look();
                work(field, task);
            }
        } else {
            // The scratch of a field belongs to one thread.
            std::vector<Field> fields(static_cast<std::size_t>(processors()) + 1, field);
            parallel_for(tasks, threads, [&](std::size_t worker, std::size_t task) { work(fields[worker], task); });
        }
        return *std::max_element(peaks.begin(), peaks.end());
    }

    void paint(const T* profile, T* image, int threads) {
        const std::size_t rows = layout_->height / 2 + 1;
        const std::size_t block = std::max<std::size_t>(1, (std::size_t{1} << 18) / layout_->width);
        parallel_for((rows + block - 1) / block, threads, [&](std::size_t, std::size_t task) {
            const std::size_t first = task * block, last = std::min(rows, first + block);
            scatter_rows(profile, layout_->index.data(), layout_->height, layout_->width, first, last, image);
        });
    }

    // dI/dc_k = 2 Re(conj(U) i T), T = int t^k exp(i Phi) J0 dt: further right-hand sides on the same table.
    void differentiate(std::size_t pupil, std::size_t which, const Settled& settled) {
        const std::size_t count = layout_->count;
        const double scale = answer_.scales[pupil];
        Field field, derivative;
        field.prepare(stack_[pupil], 0, stack_.obscuration, places(), settled.error);
        const double own = derivative.prepare(stack_[pupil], answer_.powers[which], stack_.obscuration, places(), settled.error);
        std::vector<T> profile(count);
        double largest = 0.0;
        // Vectors overlap where pieces meet, so the results must not replace what they are made of.
        Doubles re(chunk + widest_step), im(re.size()), slope(re.size()), size(re.size());
        for (std::size_t first = 0; first < count; first += chunk) {
            look();
            const std::size_t last = std::min(count, first + chunk);
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                using V = typename decltype(isa)::pack;
                field.evaluate(isa, layout_->radii.data(), first, last, step_,
                               [&](std::size_t i, V a, V b) LOMMEL_INLINE_LAMBDA {
                                   store(&re[i], a);
                                   store(&im[i], b);
                               });
                derivative.evaluate(isa, layout_->radii.data(), first, last, step_,
                                    [&](std::size_t i, V a, V b) LOMMEL_INLINE_LAMBDA {
                                        const V u = load<V>(&re[i]), w = load<V>(&im[i]);
                                        store(&slope[i], splat<V>(2.0) * (w * a - u * b));
                                        store(&size[i], a * a + b * b);
                                    });
            });
            for (std::size_t i = 0; i < last - first; ++i) {
                profile[first + i] = static_cast<T>(scale * slope[i]);
                largest = std::max(largest, size[i]);
            }
        }
        paint(profile.data(), answer_.derivative_images + (which * stack_.count + pupil) * pixels(), 1);
        // |dI/dc_k| <= 2 |U| |T|, over the exact peak.
        const double u = std::sqrt(settled.peak), t = std::sqrt(largest), exact = u - settled.bound;
        answer_.derivative_bounds[which * stack_.count + pupil] =
            2.0 * (u * own + t * settled.bound + own * settled.bound + u * t * storing<T>(false)) / (exact * exact);
    }

    static constexpr std::size_t group = 32;  // pupils a task
    Stack stack_;
    std::shared_ptr<const Layout> layout_;
    double step_, tol_;
    int threads_;
    Answer<T> answer_;
};

}  // namespace lommel
