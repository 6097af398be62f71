// Images of pixel averages, or of samples around an arbitrary axis, with error bounds.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <type_traits>
#include <vector>

#include "lommel/base/tasks.hpp"
#include "lommel/bounds/refine.hpp"
#include "lommel/pixels/sample_pieces.hpp"
#include "lommel/radial/average_values.hpp"
#include "lommel/radial/batch.hpp"
#include "lommel/radial/coarse_averages.hpp"
#include "lommel/radial/images.hpp"
#include "lommel/radial/intensity.hpp"
#include "lommel/radial/stack.hpp"

namespace lommel {

// Aperture. area: upper bound on |U|, U: field; light: transmitted light / pi, approximately; obscuration: its relative radius.
struct Aperture {
    double area, light;
    double obscuration;

    Aperture(double eps, const Amplitude& amplitude)
        : area(bright(eps, amplitude)), light(amplitude.raised(2.0).integral(eps)), obscuration(eps) {}

    // Upper bound, for any phase, on the field's modulus |U| for the pupil function times t^power, t: squared pupil radius.
    double moment(std::size_t power) const {
        const double k = static_cast<double>(power);
        return std::min(area, (1.0 - std::pow(obscuration, 2.0 * (k + 1.0))) / (k + 1.0));
    }

   private:
    // Integral of the amplitude with respect to the squared pupil radius, in closed form; if there is none, an upper bound.
    static double bright(double eps, const Amplitude& amplitude) {
        if (amplitude.closed()) {
            return amplitude.integral(eps);
        }
        const double flat = 0.0, axis[1 + widest_step] = {};
        double found[1 + widest_step] = {}, turned[1 + widest_step];
        Field field;
        const double error = field.prepare({&flat, 1, &amplitude}, 0, eps, {axis, 1, 1.0}, 1e-12);
        field.values(axis, 0, 1, 1.0, found, turned);
        return std::min(1.0 - eps * eps, found[0] + error);
    }
};

template <class T>
class PixelRenderer {
   public:
    // Error bounds are relative to a lower bound on the largest pixel value: that of the whole plane or, if an image is divided by
    // its largest value, that of the window.
    PixelRenderer(const Stack& stack, const PixelWindows& windows, double tol, int threads, const Answer<T>& answer)
        : stack_(stack), aperture_(stack.obscuration, stack.amplitude), windows_(windows), window_(windows.first), tol_(tol),
          allowed_(std::max(1e-16, tol - 1.1 * storing<T>(false))), threads_(threads), answer_(answer) {}

    // Return whether filters of finer samples, in another class, compute the averages faster than any method of this class.
    bool filters_pay() const { return filters_serve() && !weights_are_few() && !of_rings() && !light_pays(); }
    // Return whether filters of finer samples should compute the derivatives, but not the averages: if the flux through pixel
    // edges, which gives no derivatives, is faster for averages, and filters are faster than tables of weights for derivatives.
    bool filters_pay_for_derivatives() const { return filters_serve() && pixels() > most_weighed && light_pays(); }

    void run() {
        if (window_.integrate) {
            thread_local Box box;
            box.hold(stack_);
            light_ = coarse(box.worst(stack_.amplitude));
        }
        // Estimated time in microseconds. Measured on a Zen 5 with AVX-512: 1.2 for each of 300 images of 33^2 samples, 40 for
        // one of 128^2; on an older processor 400 for 128^2 averages by rings.
        const double pixel = of_rings() ? 2e-2 : 2e-3;
        threads_ =
            worthwhile_threads(threads_, static_cast<double>(stack_.count) * (0.3 + pixel * static_cast<double>(pixels())));
        const bool batch =
            answer_.derivatives == 0 && Batch::fits(stack_) && !light_ && (window_.integrate || pixels() <= most_sampled);
        // PixelTable holds the weights of one axis, so it does not serve pupils with other axes.
        const bool one_axis = windows_.centers == nullptr;
        if (!(batch && (anywhere() ? render_batch<AnywhereTable>() : one_axis && render_batch<PixelTable>()))) {
            if (window_.integrate && !light_) {
                for (std::size_t pupil = 0; pupil < stack_.count; ++pupil) {
                    level_ = first_attempt(stack_[pupil]).level;  // becomes the highest of all pupils: it never falls
                }
            }
            for_pupils(stack_.count, threads_, [&](std::size_t pupil, int threads) { render(pupil, threads); });
        }
    }

   private:
    // Accuracies of tables, in decimal digits. last_level: highest one requested; exact_level: where rounding begins to dominate.
    static constexpr int last_level = 15, exact_level = 14;
    // Filters of finer samples are for pixel pitches up to `widest_filtered` (optical units). The flux through pixel edges is
    // faster for tolerances below `least_filtered`, or if interference rings matter in at most beside_filters * pitch^4 pixels.
    static constexpr double widest_filtered = 12.6, least_filtered = 1e-7, beside_filters = 2.5;
    // Tables of weights are faster than filters up to `light_work` products per pupil or, for derivatives, `most_weighed` pixels.
    static constexpr double light_work = 2e5;
    static constexpr std::size_t most_weighed = 5000;
    static constexpr std::size_t most_tabled = 40000;  // largest number of pixels whose weights take reasonable memory and time
    static constexpr std::size_t most_sampled = 8192;  // largest number of pixels for which the table of a batch saves time

    // Error budget: shares of tolerance * estimated largest pixel.
    struct Budget {
        // First attempt. table: error of the table; field: error of U, which counts twice in the intensity; cubics: error of cubic
        // polynomials in single precision, halved if values are divided by their maximum; places * tolerance: error of positions,
        // in optical units.
        static constexpr double table = 0.25, field = 0.02, cubics = 0.3, places = 0.25;
        // Later attempts. each: share for the table, and again for U; both are halved if values are divided by their maximum.
        static constexpr double each = 0.2;
        // Averages from the flux through pixel edges. rings: error due to omitted interference rings; sums: error of quadratures.
        // less: share of the error of U in the first attempt for other pixels, as sums leave little.
        static constexpr double rings = 0.6, sums = 0.4, less = 0.1;
        static_assert(table + 2.0 * field + cubics + places <= 1.0 && 2.0 * each <= 1.0);
    };

    struct Attempt {
        double error;  // requested error of the field U
        int level;  // requested accuracy of the table, in decimal digits
    };
    // Result for a window: table, largest value and error bounds.
    template <class Table>
    struct Found {
        std::shared_ptr<const Table> table;
        double bound, size;  // error bound of the field U; largest intensity at the radii
        double top, off, by_field, by_table;  // largest value; error bound of values; its parts due to field and table
    };

    // Destination of an image that SamplePieces writes directly.
    struct Painted {
        double scale = 1.0;
        T* image = nullptr;
        bool single_precision = false;
        double cubics = 0.0;  // allowed error of cubics, relative to the largest intensity
    };
    // Samples are computed in single precision if the allowed error is at least this share of the largest intensity.
    static constexpr double single_enough = 5e-7;

    std::size_t pixels() const { return window_.height * window_.width; }
    static Places places(const Radii& radii) { return {radii.radii.data(), radii.count, 1.0}; }

    // Return whether to use tables that serve any axis up to `farthest` optical units away: if each pupil has an axis of its
    // own, or if so few pupils share an axis within the window that a table for it would cost more than it saves.
    bool any_axis(double farthest) const {
        double ends[2];
        window_.reach(ends);
        const bool few = window_.integrate && !window_.folds() && ends[0] == 0.0 && stack_.count <= CoarseAverages::few &&
                         pixels() <= most_tabled;
        return (windows_.centers != nullptr || few) && windows_.farthest * window_.step <= farthest;
    }
    bool anywhere() const { return any_axis(AnywhereTable::most_reach); }
    bool of_rings() const {
        const double reach = windows_.farthest * window_.step;
        return window_.integrate && AverageRings::work(window_.step, reach) <= AverageRings::most_work &&
               any_axis(AverageRings::most_reach);
    }
    template <class Table>
    std::shared_ptr<const Table> table_of(const PixelWindow& window, int level) const {
        if constexpr (std::is_same_v<Table, AverageRings>) {
            return AverageRings::get(window.step, windows_.farthest, level, threads_);
        } else if constexpr (std::is_same_v<Table, AnywhereTable>) {
            return AnywhereTable::get(window.step, window.integrate, windows_.farthest, level);
        } else if constexpr (std::is_same_v<Table, SamplePieces>) {
            return SamplePieces::get(window, level);
        } else {
            const auto together = Batch::fits(stack_) ? PixelTable::get(window, level, threads_, true) : nullptr;
            if (together && together->serves_together()) {
                return together;
            }
            return PixelTable::get(window, level, threads_);
        }
    }

    // Estimate of the largest pixel: near the peak intensity for small pixels, near (all light / area of the pixel) for large ones.
    double likely_value(const Phase& phase) const {
        const double root = likely_peak(phase, stack_.obscuration);
        return 1.0 / (1.0 / (root * root) + window_.side() * window_.side() / (12.566370614359172 * aperture_.light));
    }

    Attempt first_attempt(const Phase& phase) const {
        const double value = likely_value(phase), half = 0.5 * aperture_.area * aperture_.area;
        const double digits = std::ceil(-std::log10(Budget::table * allowed_ * value / half));
        const double field = Budget::field * allowed_ * value / likely_peak(phase, stack_.obscuration);
        return {std::max(field, RadialBudget::least),
                std::max(level_, static_cast<int>(std::max(3.0, std::min(digits, double(last_level)))))};
    }

    template <class Table>
    double window_bound(const Table& table, double penalty, double size, double bound) const {
        const double root = std::sqrt(size);
        // The slope of the intensity I = |U|^2 is at most 2 |U| |U'|, with |U'| < 1/2.
        return window_error(table, penalty, size, intensity_error(root, bound), root * std::sqrt(table.of_nodes),
                            0.5 * aperture_.area * aperture_.area);
    }

    // Compute a window's pixels, in `made` or, if Table is SamplePieces, in painted.image; return their error bounds.
    template <class Table>
    Found<Table> measure(Field& field, const PixelWindow& window, const Phase& phase, const Attempt& attempt, int threads,
                         Doubles& at_radii, WindowValues& made, const Painted& painted = {}) const {
        Found<Table> f{};
        f.table = table_of<Table>(window, attempt.level);
        const Table& table = *f.table;
        f.bound = field.prepare(phase, 0, stack_.obscuration, places(table), attempt.error);
        at_radii.resize(table.count + widest_step);
        f.size = intensities(field, places(table), threads, [&](std::size_t first, std::size_t count, const double* values) {
            std::copy_n(values, count, at_radii.data() + first);
        });
        double of_singles = 0.0;
        if constexpr (std::is_same_v<Table, SamplePieces> && sizeof(T) == sizeof(float)) {
            f.top = painted.single_precision
                        ? table.paint_single(window, at_radii.data(), painted.scale, painted.cubics * f.size,
                                             Budget::places * allowed_, threads, painted.image, of_singles)
                        : table.paint(window, at_radii.data(), painted.scale, T{0}, threads, painted.image);
            made.penalty = 0.0;
        } else if constexpr (std::is_same_v<Table, SamplePieces>) {
            f.top = table.paint(window, at_radii.data(), painted.scale, T{0}, threads, painted.image);
            made.penalty = 0.0;
        } else {
            made.make(table, window, at_radii.data(), threads);
            f.top = largest_value(made.values.data(), made.count);
        }
        f.off = window_bound(table, made.penalty, f.size, f.bound) + of_singles;
        f.by_field = table.magnification() * intensity_error(std::sqrt(f.size), f.bound);
        f.by_table = table.error * 0.5 * aperture_.area * aperture_.area;
        return f;
    }

    // Lower bound on the maximum over the plane, from pixels on a line from the axis to the farthest rays: a window may miss
    // the peak, which for a defocused lens need not be on the axis.
    double peak_at_least(const Phase& phase, const Attempt& attempt) const {
        const double blur = 4.0 + phase.blur();
        constexpr double most = 512.0;
        const double step = window_.integrate ? window_.step : blur / most;
        const PixelWindow line{
            1, static_cast<std::size_t>(std::min(most, std::ceil(blur / step)) + 1.0), 0.0, 0.0, step, window_.integrate};
        Field field;
        Doubles at_radii;
        WindowValues made;
        const Found<PixelTable> f = measure<PixelTable>(field, line, phase, attempt, 1, at_radii, made);
        return f.top - f.off;
    }

    // Error bound of stored values / peak. top: largest value in the window; off: error bound of all values; elsewhere: lower bound
    // on the peak, from other pixels; normalize: values are divided by their maximum; after: this is done after storing them.
    double relative(double top, double off, double elsewhere, bool normalize, bool after = false) const {
        const double peak = std::max(top - off, elsewhere);
        return finished_error<T>(peak > 1e-300 ? off / peak : 1e300, normalize, after);
    }

    // Return whether a table of weights would serve only few pupils, and each of its weights only one pixel of a window.
    bool few_share() const { return !window_.folds() && stack_.count <= CoarseAverages::few; }
    // Return whether these pixels can be averaged by filters that are applied to finer samples.
    bool filters_serve() const {
        return window_.integrate && few_share() && windows_.centers == nullptr && window_.step <= widest_filtered;
    }

    // Return whether a table of weights for this axis takes at most light_work products per pupil.
    bool weights_are_few() const {
        const double places = 0.8 * window_.step + 8.0;
        return static_cast<double>(pixels()) * places * places <= light_work * static_cast<double>(stack_.count);
    }
    // Return whether averages may come from the flux through pixel edges: for coarse pixels, or if tables are not accurate enough.
    bool crossings_serve(const Phase& phase) const {
        if (!window_.integrate || !stack_.amplitude.closed() || window_.step < CoarseAverages::least_exact) {
            return false;
        }
        // Pixels are coarse from the pitch `least` on. The pitch least_alone is enough if few pupils have a common axis and the
        // weights of AverageRings would take too long.
        const bool wide = window_.step >= CoarseAverages::least ||
                          (window_.step >= CoarseAverages::least_alone && windows_.centers == nullptr &&
                           any_axis(AverageRings::most_reach) && !of_rings());
        return wide || first_attempt(phase).level >= exact_level;
    }
    // Approximate distance from the axis, in pixels, from which on interference rings are omitted.
    double ringed(const Phase& phase) const {
        const double room = coarse_attempt(phase, likely_value(phase)).rings;
        return CoarseAverages::without_rings(EnergyTail(phase, stack_.obscuration), window_.step, room) / window_.step;
    }
    // Return whether to compute averages from the flux through pixel edges and not by weights. crossings_serve() is required. If
    // the weights are computed once for a stack, the flux of all pupils must also take less than the share of_weights of their
    // time. By measurement, the weights of a pixel take as long as the flux of 20 + step^2 / 4 pixels, `step` the pitch in optical
    // units.
    bool coarse(const Phase& phase) const {
        const bool serve = crossings_serve(phase);
        if (!serve || stack_.count == 1 || pixels() > most_tabled) {
            return serve;
        }
        const double weights = static_cast<double>(pixels()) * (20.0 + 0.25 * window_.step * window_.step);
        return static_cast<double>(stack_.count) * window_.within(ringed(phase)) < CoarseAverages::of_weights * weights;
    }
    // Return whether the flux through pixel edges is faster than filters of finer samples, for all pupils.
    bool light_pays() const {
        const double most = beside_filters * std::pow(window_.step, 4.0);
        const bool many = tol_ >= least_filtered && static_cast<double>(pixels()) > most;
        for (std::size_t pupil = 0; pupil < stack_.count; ++pupil) {
            const Phase phase = stack_[pupil];
            if (!crossings_serve(phase) || (many && window_.within(ringed(phase)) > most)) {
                return false;
            }
        }
        return true;
    }

    CoarseAverages::Attempt coarse_attempt(const Phase& phase, double value) const {
        const double room = allowed_ * value;
        return {Budget::rings * room, std::max(RadialBudget::least, Budget::less * first_attempt(phase).error),
                Budget::sums * room};
    }

    // Lower bound on the largest pixel average over the plane, as in peak_at_least(), from the flux through pixel edges.
    double coarse_peak_at_least(const Phase& phase, const CoarseAverages::Attempt& request) const {
        const std::size_t pixels =
            static_cast<std::size_t>(std::min(512.0, std::ceil((4.0 + phase.blur()) / window_.step)) + 1.0);
        CoarseAverages line;
        line.make(*CoarseWindow::get({1, pixels, 0.0, 0.0, window_.step, true}), phase, stack_.obscuration, aperture_.light,
                  aperture_.area, request, 1);
        return line.top - line.off();
    }

    void render_coarse(std::size_t pupil, int threads) {
        thread_local CoarseAverages found;
        const Phase phase = stack_[pupil];
        const bool normalize = answer_.scales[pupil] == 0.0;
        const auto window = CoarseWindow::get(windows_[pupil]);
        double elsewhere = 0.0;
        bool looked = false;
        CoarseAverages::Attempt request = coarse_attempt(phase, (normalize ? 0.5 : 1.0) * likely_value(phase));
        const auto attempt = [&] {
            found.make(*window, phase, stack_.obscuration, aperture_.light, aperture_.area, request, threads);
            const double bound = relative(found.top, found.off(), elsewhere, normalize);
            if (bound <= tol_ || normalize || looked) {
                return bound;
            }
            elsewhere = coarse_peak_at_least(phase, request);
            looked = true;
            return relative(found.top, found.off(), elsewhere, normalize);
        };
        const double bound = settle(tol_, attempt, [&](double) {
            const double seen = std::max(std::max(found.top, elsewhere), 1e-3 * found.off());
            const double room = (normalize ? 0.5 : 1.0) * Budget::each * allowed_ * seen;
            const CoarseAverages::Attempt before = request;
            if (found.by_rings > room) {
                request.rings = std::min(0.5 * request.rings, room);
            }
            if (found.error > room) {
                request.field =
                    std::max(RadialBudget::least, request.field * std::min(RadialBudget::retry, room / found.error));
                request.sums =
                    std::max(RadialBudget::least * seen, request.sums * std::min(RadialBudget::retry, room / found.error));
            }
            return request.rings < before.rings || request.field < before.field || request.sums < before.sums;
        });
        const double scale = answer_.finish(pupil, found.top, std::max(found.top - found.off(), elsewhere), bound);
        paint_groups(window->groups, window->window.width, found.values.data(), window->groups.v.size(), scale, T{0},
                     answer_.images + pupil * pixels(), threads);
    }

    void render(std::size_t pupil, int threads) {
        if (light_ && rendered_coarse(pupil, threads)) {
            return;
        }
        if (!window_.integrate && SamplePieces::pays(windows_[pupil], first_attempt(stack_[pupil]).level)) {
            try {
                return render_by<SamplePieces>(pupil, threads);
            } catch (const ToleranceNotMet&) {
                // The polynomials of SamplePieces round by more than the tolerance; the methods that follow round less.
            }
        }
        if (!window_.integrate && windows_.centers == nullptr && window_.folds()) {
            return Renderer<T>(stack_, window_, tol_, threads, answer_).render(pupil, threads);
        }
        const bool rings = of_rings();
        try {
            if (rings) {
                return render_by<AverageRings>(pupil, threads);
            }
        } catch (const ToleranceNotMet&) {
            // The polynomials of AverageRings round by more than the tolerance; weights for each pixel round less.
        }
        const bool many = rings || (window_.integrate && few_share() && !weights_are_few());
        if (!light_ && many && stack_.amplitude.closed() && rendered_coarse(pupil, threads)) {
            return;
        }
        render_by<PixelTable>(pupil, threads);
    }
    // Render from the flux through pixel edges; return false if the tolerance is not met, as the flux rounds more than weights do.
    bool rendered_coarse(std::size_t pupil, int threads) {
        try {
            render_coarse(pupil, threads);
        } catch (const ToleranceNotMet&) {
            return false;
        }
        differentiate(pupil, threads);
        return true;
    }

    template <class Table>
    void render_by(std::size_t pupil, int threads) {
        thread_local Field field;
        thread_local Doubles at_radii;
        thread_local WindowValues made;
        const Phase phase = stack_[pupil];
        const bool normalize = answer_.scales[pupil] == 0.0;
        double elsewhere = 0.0;
        bool looked = false;
        Attempt request = first_attempt(phase);
        const PixelWindow window = windows_[pupil];
        Found<Table> f{};
        constexpr bool at_once = std::is_same_v<Table, SamplePieces>;
        Painted painted{normalize ? 1.0 : answer_.scales[pupil], answer_.images + pupil * pixels(),
                        at_once && sizeof(T) == sizeof(float) && allowed_ >= single_enough,
                        (normalize ? 0.5 : 1.0) * Budget::cubics * allowed_};
        const auto attempt = [&] {
            const auto measured = [&] {
                f = measure<Table>(field, window, phase, request, threads, at_radii, made, painted);
                return relative(f.top, f.off, elsewhere, normalize, at_once);
            };
            double bound = measured();
            if (bound > tol_ && !normalize && !looked) {
                elsewhere = peak_at_least(phase, request);
                looked = true;
                bound = relative(f.top, f.off, elsewhere, normalize, at_once);
            }
            if (bound > tol_ && painted.single_precision) {
                painted.single_precision = false;
                bound = measured();
            }
            return bound;
        };
        const double bound = settle(tol_, attempt, [&](double) {
            // seen: largest value in the window or `elsewhere`, but at least 1e-3 of the error bound in the window; room: allowed
            // error due to the field U, and again to the table.
            const double seen = std::max(std::max(f.top, elsewhere), 1e-3 * f.off);
            const double room = (normalize ? 0.5 : 1.0) * Budget::each * allowed_ * seen;
            const Attempt before = request;
            if (f.by_field > room) {
                request.error = std::max(RadialBudget::least, request.error * std::min(RadialBudget::retry, room / f.by_field));
            }
            if (f.by_table > room) {
                request.level =
                    std::min(last_level, request.level + static_cast<int>(std::ceil(std::log10(f.by_table / room))));
            }
            return request.error < before.error || request.level > before.level;
        });
        const double peak = std::max(f.top - f.off, elsewhere);
        if constexpr (at_once) {
            const double scale = answer_.finish(pupil, f.top, peak, bound);
            if (normalize) {
                store_scaled(painted.image, scale, pixels(), painted.image);
            }
        } else {
            finish(pupil, *f.table, made.values.data(), made.count, f.top, peak, bound, threads);
        }
        for (std::size_t d = 0; d < answer_.derivatives; ++d) {
            differentiate(pupil, d, window, field, f, request.error, threads);
        }
    }

    template <class Table>
    void finish(std::size_t pupil, const Table& table, const double* values, std::size_t count, double top, double peak,
                double bound, int threads) {
        const double scale = answer_.finish(pupil, top, peak, bound);
        paint(table, values, count, scale, T{0}, answer_.images + pupil * pixels(), threads);
    }

    template <class Table>
    static void paint(const Table&, const double* values, std::size_t count, double scale, T least, T* image, int) {
        store_least(values, scale, count, least, image);
    }
    static void paint(const PixelTable& table, const double* values, std::size_t count, double scale, T least, T* image,
                      int threads) {
        paint_groups(table.groups, table.window.width, values, count, scale, least, image, threads);
    }
    static void paint_groups(const PixelGroups& groups, std::size_t width, const double* values, std::size_t count,
                             double scale, T least, T* image, int threads) {
        thread_local std::vector<T> kept;
        kept.resize(count);
        store_least(values, scale, count, least, kept.data());
        const T* from = kept.data();  // buffer of the calling thread, read by all threads
        for_rows(groups.rows.distances.size(), width, threads,
                 [&](std::size_t first, std::size_t last) { groups.paint(from, first, last, image); });
    }

    // Compute derivatives by weights, for an image that was computed without weights.
    void differentiate(std::size_t pupil, int threads) {
        if (answer_.derivatives > 0) {
            Field field;
            Doubles at_radii;
            WindowValues made;
            const PixelWindow window = windows_[pupil];
            const Attempt request = first_attempt(stack_[pupil]);
            const auto f = measure<PixelTable>(field, window, stack_[pupil], request, threads, at_radii, made);
            for (std::size_t d = 0; d < answer_.derivatives; ++d) {
                differentiate(pupil, d, window, field, f, request.error, threads);
            }
        }
    }

    // Compute the pixels of dI/dc_k, c_k the phase coefficient of t^k (t: squared pupil radius). Like the intensity I, this
    // derivative is of exponential type 2, so the same tables serve.
    template <class Table>
    void differentiate(std::size_t pupil, std::size_t which, const PixelWindow& window, Field& field, const Found<Table>& f,
                       double error, int threads) {
        const Table& table = *f.table;
        const std::size_t power = answer_.powers[which], at = which * stack_.count + pupil;
        const Slopes slopes(field, stack_[pupil], power, stack_.obscuration, places(table), error);
        T* const image = answer_.derivative_images + at * pixels();
        const T least = std::numeric_limits<T>::lowest();
        double penalty = 0.0;
        if constexpr (std::is_same_v<Table, SamplePieces>) {
            table.paint(window, slopes.values.data(), answer_.scales[pupil], least, threads, image);
        } else {
            WindowValues made;
            made.make(table, window, slopes.values.data(), threads);
            paint(table, made.values.data(), made.count, answer_.scales[pupil], least, image, threads);
            penalty = made.penalty;
        }
        const double root = std::sqrt(f.size), other = std::sqrt(slopes.size);
        const double given = 2.0 * (root * slopes.error + other * f.bound + slopes.error * f.bound);
        const double off = window_error(table, penalty, slopes.steepest, given, (root + other) * std::sqrt(table.of_nodes),
                                        2.0 * aperture_.area * aperture_.moment(power));
        answer_.derivative_bounds[at] =
            (off + storing<T>(false) * slopes.steepest * table.magnification()) / answer_.peaks[pupil];
    }

    // Compute all pupils with one table of radii, for one small window or for separate axes; return false if this is not faster.
    template <class Table>
    bool render_batch() {
        const Box box(stack_);
        const Phase worst = box.worst(stack_.amplitude);
        const Attempt attempt = first_attempt(worst);
        const auto shared = table_of<Table>(window_, attempt.level);
        const Table& table = *shared;
        bool plain = false;  // the table's radii are those of the pixels, without weights
        std::size_t values = pixels();
        if constexpr (std::is_same_v<Table, PixelTable>) {
            if (!table.serves_together()) {
                return false;
            }
            plain = table.rings.empty();
            values = table.value_count;
        }
        if (!Batch::pays(stack_, worst, table, 1.0)) {
            return false;
        }
        const std::size_t window_stride = (values + widest_step) / widest_step * widest_step;
        const Batch batch(stack_, box, shared, 1.0, attempt.error);
        batch.run(threads_, [&](std::size_t first, std::size_t here, const double* at_radii, std::size_t stride) {
            thread_local Doubles made;
            made.resize(Batch::group * window_stride);
            const double penalty =
                plain ? 0.0 : make_together(table, windows_, first, here, at_radii, stride, made.data(), window_stride);
            for (std::size_t p = 0; p < here; ++p, at_radii += stride) {
                const double* window = plain ? at_radii : made.data() + p * window_stride;
                const double size = largest_value(at_radii, table.count), top = largest_value(window, values);
                const double off = window_bound(table, penalty, size, batch.error(first + p));
                const double bound = relative(top, off, 0.0, answer_.scales[first + p] == 0.0);
                if (bound <= tol_) {
                    finish(first + p, table, window, values, top, top - off, bound, 1);
                } else {
                    render(first + p, 1);
                }
            }
        });
        return true;
    }

    Stack stack_;
    Aperture aperture_;
    PixelWindows windows_;
    PixelWindow window_;  // window of the first pupil
    double tol_, allowed_;  // tolerance; tolerance less the rounding error of stored values
    int level_ = 0;  // minimum accuracy of tables, in decimal digits, common to the stack
    bool light_ = false;  // whether averages come from the flux through pixel edges
    int threads_;
    Answer<T> answer_;
};

// Compute the images of a stack. With the axis at a pixel centre or midway between pixels, samples are looked up in a list of the
// intensity at all distinct distances of pixels, unless this list is so long that interpolation is faster.
template <class T>
void render_radial(const Stack& stack, const PixelWindows& windows, double tol, int threads, const Answer<T>& answer) {
    constexpr std::size_t most_looked_up = std::size_t{1} << 21;
    const PixelWindow& window = windows.first;
    if (windows.centers == nullptr && window.folds() && !window.integrate &&
        window.rows().distances() * window.columns().distances() <= most_looked_up) {
        Renderer<T>(stack, window, tol, threads, answer).run();
    } else {
        PixelRenderer<T>(stack, windows, tol, threads, answer).run();
    }
}

}  // namespace lommel
