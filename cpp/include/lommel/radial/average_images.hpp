// From pupils to windows whose pixels average, or whose axis is anywhere, each with its proven error.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

#include "lommel/radial/batch.hpp"
#include "lommel/radial/field.hpp"
#include "lommel/radial/images.hpp"
#include "lommel/base/parallel.hpp"
#include "lommel/radial/average_values.hpp"

namespace lommel {

// sup|U| of an aperture, or no more than its error above, and about the light that passes it over pi.
struct Aperture {
    double area, light;
    double obscuration;

    Aperture(double eps, const Amplitude& amplitude)
        : area(bright(eps, amplitude)), light(amplitude.raised(2.0).integral(eps)), obscuration(eps) {}

    // sup of int t^power exp(i Phi) J0 dt.
    double moment(std::size_t power) const {
        const double k = static_cast<double>(power);
        return std::min(area, (1.0 - std::pow(obscuration, 2.0 * (k + 1.0))) / (k + 1.0));
    }

   private:
    // No closed form, no exact value: U on the axis and its error instead.
    static double bright(double eps, const Amplitude& amplitude) {
        if (amplitude.closed()) {
            return amplitude.integral(eps);
        }
        const double flat = 0.0, axis[1 + widest_step] = {};
        double found[1 + widest_step] = {};
        Field field;
        const double error = field.prepare({&flat, 1, &amplitude}, 0, eps, {axis, 1, 1.0}, 1e-12);
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            field.evaluate(isa, axis, 0, 1, 1.0, [&](std::size_t i, auto re, auto) LOMMEL_INLINE_LAMBDA { store(found + i, re); });
        });
        return std::min(1.0 - eps * eps, found[0] + error);
    }
};

template <class T>
class PixelRenderer {
   public:
    // `peaks` receives what the bounds are related to: what the largest value over the plane, or in the window where
    // values are divided by that, is at least.
    PixelRenderer(const Stack& stack, const PixelWindow& window, double tol, int threads, const Answer<T>& answer, double* peaks)
        : stack_(stack), aperture_(stack.obscuration, stack.amplitude), window_(window),
          tol_(tol), allowed_(std::max(1e-16, tol - 1.1 * storing<T>(false))), threads_(threads),
          answer_(answer), peaks_(peaks) {}

    void run() {
        const double work = static_cast<double>(stack_.count) * (0.3 + 2e-3 * static_cast<double>(pixels()));
        const int worthwhile = static_cast<int>(std::min(1024.0, std::max(1.0, work / work_per_thread())));
        threads_ = std::min(threads_ > 0 ? threads_ : worthwhile, worthwhile);
        if (answer_.derivatives == 0 && stack_.count >= 4 && stack_.obscuration == 0.0 && run_batch()) {
            return;
        }
        const bool one = stack_.count == 1;
        parallel_for(stack_.count, one ? 1 : threads_, [&](std::size_t, std::size_t pupil) { render(pupil, one ? threads_ : 1); });
    }

   private:
    static constexpr std::size_t chunk = 4096;  // radii whose values stay in the first cache
    static constexpr int last_level = 15;

    struct Attempt {
        double error;  // asked of U
        int level;     // asked of the table
    };
    // What a window turned out to be.
    struct Found {
        std::shared_ptr<const PixelTable> table;
        double bound, size;                    // of U; the largest I at the radii
        double top, off, by_field, by_table;   // the largest value, the bound on its error, and two parts of that
    };

    std::size_t pixels() const { return window_.height * window_.width; }
    static Places places(const PixelTable& table) { return {table.radii.data(), table.count, 1.0}; }

    // What the largest value of a window may be: the peak of I or, of pixels that hold all light, its average.
    double likely_value(const Phase& phase) const {
        const double root = likely_peak(phase, stack_.obscuration);
        return 1.0 / (1.0 / (root * root) + window_.side() * window_.side() / (12.566370614359172 * aperture_.light));
    }

    Attempt first_attempt(const Phase& phase) const {
        const double value = likely_value(phase), half = 0.5 * aperture_.area * aperture_.area;
        const double digits = std::ceil(-std::log10(0.25 * allowed_ * value / half));
        const double field = 0.02 * allowed_ * value / likely_peak(phase, stack_.obscuration);
        return {std::max(field, 8.0 * unit_roundoff), static_cast<int>(std::max(3.0, std::min(digits, double(last_level))))};
    }

    double window_bound(const PixelTable& table, double penalty, double size, double bound) const {
        const double root = std::sqrt(size);
        // |I'| = 2 |U| |U'|, and |U'| < 1/2.
        return window_error(table, penalty, size, bound * (2.0 * root + bound), root * std::sqrt(table.of_nodes),
                            0.5 * aperture_.area * aperture_.area);
    }

    Found measure(Field& field, const PixelWindow& window, const Phase& phase, const Attempt& attempt, int threads,
                  Doubles& at_radii, WindowValues& made) const {
        Found f{};
        f.table = PixelTable::get(window, attempt.level, threads_);
        const PixelTable& table = *f.table;
        f.bound = field.prepare(phase, 0, stack_.obscuration, places(table), attempt.error);
        f.size = intensities(field, table, at_radii, threads);
        made.make(table, at_radii.data(), threads);
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA { f.top = largest(made.values.data(), table.value_count); });
        f.off = window_bound(table, made.penalty, f.size, f.bound);
        f.by_field = table.magnification() * f.bound * (2.0 * std::sqrt(f.size) + f.bound);
        f.by_table = table.error * 0.5 * aperture_.area * aperture_.area;
        return f;
    }

    // I at the radii of a table; returns the largest.
    double intensities(Field& field, const PixelTable& table, Doubles& out, int threads) const {
        const std::size_t tasks = (table.count + chunk - 1) / chunk;
        out.resize(table.count + widest_step);
        const auto work = [&](Field& own, std::size_t task) {
            // Vectors reach beyond the end of a chunk, which is another's beginning.
            alignas(64) double buffer[chunk + widest_step];
            const std::size_t first = task * chunk, last = std::min(table.count, first + chunk);
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                own.evaluate(isa, table.radii.data(), first, last, 1.0, [&](std::size_t i, auto re, auto im) LOMMEL_INLINE_LAMBDA {
                    store(buffer + i, re * re + im * im);
                });
            });
            std::copy_n(buffer, last - first, out.data() + first);
        };
        if (tasks < 16 || threads == 1) {
            for (std::size_t task = 0; task < tasks; ++task) {
                work(field, task);
            }
        } else {
            std::vector<Field> fields(static_cast<std::size_t>(processors()) + 1, field);
            parallel_for(tasks, threads, [&](std::size_t worker, std::size_t task) { work(fields[worker], task); });
        }
        double top = 0.0;
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA { top = largest(out.data(), table.count); });
        return top;
    }

    // What the largest value over the whole plane is at least: a window may miss the peak, which for a defocused lens need
    // not be on the axis. Looks at pixels along a line from the axis to where the last rays arrive.
    double peak_at_least(const Phase& phase, const Attempt& attempt) const {
        const double blur = 4.0 + phase.blur();
        constexpr double most = 512.0;
        const double step = window_.integrate ? window_.step : blur / most;
        const PixelWindow line{1, static_cast<std::size_t>(std::min(most, std::ceil(blur / step)) + 1.0), 0.0, 0.0, step,
                               window_.integrate};
        Field field;
        Doubles at_radii;
        WindowValues made;
        const Found f = measure(field, line, phase, attempt, 1, at_radii, made);
        return f.top - f.off;
    }

    // What the stored values are off by over the peak, which is `elsewhere` at least if not in the window.
    double relative(double top, double off, double elsewhere, bool normalize) const {
        const double peak = std::max(top - off, elsewhere);
        const double simple = peak > 1e-300 ? off / peak : 1e300;
        return stored(normalize ? normalized_error(simple) : simple, storing<T>(false));
    }

    void render(std::size_t pupil, int threads) {
        thread_local Field field;
        thread_local Doubles at_radii;
        thread_local WindowValues made;
        const Phase phase = stack_[pupil];
        const bool normalize = answer_.scales[pupil] == 0.0;
        double elsewhere = 0.0;
        bool looked = false;
        for (Attempt attempt = first_attempt(phase);;) {
            look();
            const Found f = measure(field, window_, phase, attempt, threads, at_radii, made);
            double bound = relative(f.top, f.off, elsewhere, normalize);
            if (!(bound <= tol_) && !normalize && !looked) {
                elsewhere = peak_at_least(phase, attempt);
                looked = true;
                bound = relative(f.top, f.off, elsewhere, normalize);
            }
            if (bound <= tol_) {
                peaks_[pupil] = std::max(f.top - f.off, elsewhere);
                finish(pupil, *f.table, made.values.data(), f.top, bound, threads);
                for (std::size_t d = 0; d < answer_.derivatives; ++d) {
                    differentiate(pupil, d, f, attempt.error, threads);
                }
                return;
            }
            // What the parts of the error may be, at a guess where nothing is seen yet.
            const double room = (normalize ? 0.1 : 0.2) * allowed_ * std::max(std::max(f.top, elsewhere), 1e-3 * f.off);
            Attempt next = attempt;
            if (f.by_field > room) {
                next.error = std::max(8.0 * unit_roundoff, attempt.error * std::min(0.1, room / f.by_field));
            }
            if (f.by_table > room) {
                next.level = std::min(last_level, attempt.level + static_cast<int>(std::ceil(std::log10(f.by_table / room))));
            }
            if (!(next.error < attempt.error) && next.level == attempt.level) {
                throw ToleranceNotMet(bound);
            }
            attempt = next;
        }
    }

    void finish(std::size_t pupil, const PixelTable& table, const double* values, double top, double bound, int threads) {
        double& scale = answer_.scales[pupil];
        scale = scale == 0.0 ? 1.0 / top : scale;
        answer_.bounds[pupil] = bound;
        paint(table, values, scale, T{0}, answer_.images + pupil * pixels(), threads);
    }

    // No average of an intensity is negative, and none less exact for being `least`.
    static void paint(const PixelTable& table, const double* values, double scale, T least, T* image, int threads) {
        thread_local std::vector<T> kept;
        std::vector<T>& rounded = kept;  // of this thread, whoever paints
        rounded.resize(table.value_count);
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA { scaled(values, scale, table.value_count, rounded.data()); });
        for (T& value : rounded) {
            value = std::max(value, least);
        }
        const std::size_t rows = table.groups.rows.distances.size();
        const std::size_t block = std::max<std::size_t>(1, (std::size_t{1} << 18) / table.window.width);
        const T* from = rounded.data();
        parallel_for((rows + block - 1) / block, threads, [&](std::size_t, std::size_t task) {
            table.groups.paint(from, task * block, std::min(rows, (task + 1) * block), image);
        });
    }

    // dI/dc_k = 2 Re(conj(U) i T), T = int t^k exp(i Phi) J0 dt, averaged as I is: it is of exponential type 2 like I.
    void differentiate(std::size_t pupil, std::size_t which, const Found& f, double error, int threads) {
        const PixelTable& table = *f.table;
        const std::size_t power = answer_.powers[which];
        Field field, derivative;
        field.prepare(stack_[pupil], 0, stack_.obscuration, places(table), error);
        const double own = derivative.prepare(stack_[pupil], power, stack_.obscuration, places(table), error);
        Doubles slopes(table.count + widest_step), re(chunk + widest_step), im(re.size()), slope(re.size()), size(re.size());
        double most = 0.0, steepest = 0.0;
        for (std::size_t first = 0; first < table.count; first += chunk) {
            const std::size_t last = std::min(table.count, first + chunk);
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                using V = typename decltype(isa)::pack;
                field.evaluate(isa, table.radii.data(), first, last, 1.0, [&](std::size_t i, V a, V b) LOMMEL_INLINE_LAMBDA {
                    store(&re[i], a);
                    store(&im[i], b);
                });
                derivative.evaluate(isa, table.radii.data(), first, last, 1.0, [&](std::size_t i, V a, V b) LOMMEL_INLINE_LAMBDA {
                    const V u = load<V>(&re[i]), w = load<V>(&im[i]);
                    store(&slope[i], splat<V>(2.0) * (w * a - u * b));
                    store(&size[i], a * a + b * b);
                });
            });
            for (std::size_t i = 0; i < last - first; ++i) {
                slopes[first + i] = slope[i];
                most = std::max(most, size[i]);
                steepest = std::max(steepest, std::abs(slope[i]));
            }
        }
        WindowValues made;
        made.make(table, slopes.data(), threads);
        const double root = std::sqrt(f.size), other = std::sqrt(most);
        const double given = 2.0 * (root * own + other * f.bound + own * f.bound);
        const double off = window_error(table, made.penalty, steepest, given, (root + other) * std::sqrt(table.of_nodes),
                                        2.0 * aperture_.area * aperture_.moment(power));
        answer_.derivative_bounds[which * stack_.count + pupil] =
            (off + storing<T>(false) * steepest * table.magnification()) / peaks_[pupil];
        paint(table, made.values.data(), answer_.scales[pupil], std::numeric_limits<T>::lowest(),
              answer_.derivative_images + (which * stack_.count + pupil) * pixels(), threads);
    }

    // Many pupils on one small window, by the Bessel functions at the radii of its table. Returns false where it would
    // not pay.
    bool run_batch() {
        std::vector<double> least(stack_.coefficients, stack_.coefficients + stack_.terms), most = least, farthest;
        for (std::size_t i = 1; i < stack_.count; ++i) {
            for (std::size_t k = 0; k < stack_.terms; ++k) {
                least[k] = std::min(least[k], stack_[i].coefficients[k]);
                most[k] = std::max(most[k], stack_[i].coefficients[k]);
            }
        }
        for (std::size_t k = 0; k < stack_.terms; ++k) {
            farthest.push_back(std::max(std::abs(least[k]), std::abs(most[k])));
        }
        const Phase worst{farthest.data(), farthest.size(), &stack_.amplitude};
        check_size(worst);
        const Attempt attempt = first_attempt(worst);
        const auto table = PixelTable::get(window_, attempt.level, threads_);
        // Multiply-adds a pupil by pieces, and by the table at the exact radii, whose making is shared by the stack.
        const double reach = table->reach(), radii = static_cast<double>(table->count);
        const double terms = std::min(worst.size() + 12.0, 0.5 * reach + 12.0);
        const double pieces = 32.0 * (terms * (reach / 8.0 + 1.0) + radii) + 4000.0;
        const double exact = 2.0 * terms * radii + 4.0 * radii * (reach + terms + 60.0) / static_cast<double>(stack_.count);
        if (table->rings.size() > 1 || exact > pieces || terms * radii > 4e6 || stack_.terms > 4) {
            return false;
        }
        const Expansion plan(Ellipses(least, most, stack_.amplitude), reach, attempt.error);
        const auto transforms = RadiusTable::get(table, 1.0, plan.terms);
        parallel_for((stack_.count + group - 1) / group, threads_, [&](std::size_t, std::size_t task) {
            const std::size_t first = task * group;
            batch(plan, *table, *transforms, first, std::min(group, stack_.count - first));
        });
        return true;
    }

    void batch(const Expansion& plan, const PixelTable& table, const RadiusTable& transforms, std::size_t first, std::size_t here) {
        constexpr std::size_t rounded = (group + block_pupils - 1) / block_pupils * block_pupils, at_once = 4;
        const std::size_t room = plan.room(), stride = transforms.stride;
        thread_local SeriesScratch scratch;
        thread_local Doubles re, im, values, made, sums;
        re.resize(rounded * room);
        im.resize(rounded * room);
        values.resize(rounded * stride);
        made.resize(group * table.value_count);
        double penalties[at_once] = {};
        // A group at a time through each stage, so that one table at a time fills the first cache.
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            for (std::size_t p = 0; p < here; ++p) {
                const Phase phase = stack_[first + p];
                legendre_coefficients(isa, *plan.rule, phase.coefficients, phase.terms, *phase.amplitude, 0, plan.terms,
                                      re.data() + p * room, im.data() + p * room, scratch);
            }
            for (std::size_t p = 0; p < here; p += block_pupils) {
                block_intensities(isa, transforms, plan.terms, re.data() + p * room, im.data() + p * room, room,
                                  values.data() + p * stride);
            }
            for (std::size_t p = 0; p < here; p += at_once) {
                // Pupils that are not there have some intensities too.
                const double* from[at_once];
                double* to[at_once];
                for (std::size_t k = 0; k < at_once; ++k) {
                    from[k] = values.data() + (p + k) * stride;
                    to[k] = made.data() + (p + k) * table.value_count;
                }
                if (!table.rings.empty()) {
                    table.apply<at_once>(isa, 0, table.rings.size(), from, to, penalties, sums);
                }
            }
        });
        const double penalty = *std::max_element(penalties, penalties + at_once);
        const double rounding = unit_roundoff * (static_cast<double>(plan.terms) + 16.0) + radius_rounding(table.reach());
        for (std::size_t p = 0; p < here; ++p) {
            const double* at_radii = values.data() + p * stride;
            const double* window = table.rings.empty() ? at_radii : made.data() + p * table.value_count;
            double size = 0.0, top = 0.0;
            dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
                size = largest(at_radii, table.count);
                top = largest(window, table.value_count);
            });
            const double off = window_bound(table, penalty, size, plan.error(stack_[first + p]) + rounding);
            const double bound = relative(top, off, 0.0, answer_.scales[first + p] == 0.0);
            if (bound <= tol_) {
                peaks_[first + p] = top - off;
                finish(first + p, table, window, top, bound, 1);
            } else {
                render(first + p, 1);
            }
        }
    }

    static constexpr std::size_t group = 32;  // pupils a task
    Stack stack_;
    Aperture aperture_;
    PixelWindow window_;
    double tol_, allowed_;  // the latter before values are stored
    int threads_;
    Answer<T> answer_;
    double* peaks_;
};

}  // namespace lommel
