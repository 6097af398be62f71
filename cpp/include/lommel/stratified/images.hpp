// From planes to windows of pixels, each with its proven error: docs/certificate.md, section 15.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

#include "lommel/base/tasks.hpp"
#include "lommel/bounds/settle.hpp"
#include "lommel/pixels/layout.hpp"
#include "lommel/pixels/anywhere.hpp"
#include "lommel/pixels/render.hpp"
#include "lommel/pixels/table.hpp"
#include "lommel/pixels/window.hpp"
#include "lommel/radial/average_values.hpp"
#include "lommel/radial/stack.hpp"
#include "lommel/stratified/between.hpp"
#include "lommel/stratified/judged.hpp"
#include "lommel/stratified/profiles.hpp"

namespace lommel {

// Derivatives, the one by v last, as two by the axis: [derivative][plane][pixel], and [derivative][plane].
struct LayeredSlopes {
    double *images, *errors;
};

template <class T>
class LayeredImages {
   public:
    // `allowed` is what interpolation may add to I, on a scale where 1 is the peak of a uniform aperture without aberration.
    LayeredImages(const Planes& planes, const PixelWindows& windows, double allowed, int threads, const Answer<T>& answer,
                  const LayeredSlopes& slopes)
        : planes_(planes), windows_(windows), window_(windows.first), allowed_(allowed), answer_(answer), slopes_(slopes) {
        // Roughly, in microseconds.
        const double each = 0.5 + 1e-3 * static_cast<double>(pixels()) + 0.02 * static_cast<double>(planes.angles.count);
        threads_ = worthwhile_threads(threads, static_cast<double>(planes.count) * each);
    }

    // Whether this engine has such windows; those of light that depends on the azimuth are centred and sampled.
    // Derivatives are of windows around axes anywhere.
    static bool fits(const Planes& planes, const PixelWindows& windows) {
        if (windows.centers == nullptr) {
            return windows.first.integrate ? planes.radial() : planes.derivatives.empty();
        }
        const bool has = planes.radial() || (!windows.first.integrate && planes.derivatives.empty());
        return has && windows.farthest * windows.first.step <= AnywhereTable::most_reach;
    }

    void run() const {
        if (windows_.centers != nullptr || window_.integrate) {
            const int level = static_cast<int>(std::min(15.0, std::max(3.0, std::ceil(-std::log10(allowed_)))));
            if (windows_.centers == nullptr) {
                return around(PixelTable::get(window_, level, threads_));
            }
            const auto table = AnywhereTable::get(window_.step, window_.integrate, windows_.farthest, level);
            return planes_.radial() ? around(table) : turned(table);
        }
        const auto layout = Layout::get(window_.height, window_.width);
        const double reach = layout->reach() * window_.step;
        const std::size_t pieces = Between::pieces_of(reach);
        const double half = pieces > 0 ? 0.5 * reach / static_cast<double>(pieces) : 0.0;
        const std::size_t nodes = fewest(4, [&](std::size_t n) { return interpolation_error(half, n) <= allowed_; }, 200);
        if (pieces == 0 || pieces * nodes >= layout->count) {
            return directly(layout);
        }
        by_pieces(layout, Between::get(layout, window_.step, nodes));
    }

   private:
    std::size_t pixels() const { return window_.height * window_.width; }

    void directly(const std::shared_ptr<const Layout>& layout) const {
        const Profiles profiles(planes_, layout, window_.step);
        const Turned turned(planes_, *layout);
        profiles.run(threads_, [&](std::size_t first, std::size_t here, const double* values, const PartSizes* sizes) {
            const std::size_t stride = profiles.stride();
            for (std::size_t p = 0; p < here; ++p) {
                const Judged judged(planes_, first + p, sizes[p]);
                paint(first + p, *layout, turned, values + p * profiles.harmonics() * stride, stride, judged.given);
            }
        });
    }

    void by_pieces(const std::shared_ptr<const Layout>& layout, const std::shared_ptr<const Between>& between) const {
        const Profiles profiles(planes_, between, 1.0);
        const Turned turned(planes_, *layout);
        const std::size_t stride = (layout->count + 2 * Between::tile) / Between::tile * Between::tile;
        profiles.run(threads_, [&](std::size_t first, std::size_t here, const double* values, const PartSizes* sizes) {
            constexpr std::size_t together = 6;  // twelve chains
            thread_local Doubles made;
            const std::size_t rows = profiles.harmonics() * here;
            made.resize((rows + together) * stride);
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                std::size_t row = 0;
                for (; row + together <= rows; row += together) {
                    between->template apply<together>(isa, values + row * profiles.stride(), profiles.stride(),
                                                      made.data() + row * stride, stride);
                }
                for (; row < rows; ++row) {
                    between->template apply<1>(isa, values + row * profiles.stride(), profiles.stride(),
                                               made.data() + row * stride, stride);
                }
            });
            for (std::size_t p = 0; p < here; ++p) {
                const Judged judged(planes_, first + p, sizes[p]);
                // Radii are off by a few roundings of the farthest, where I changes by twice its swing at most.
                const double off =
                    between->magnification() * judged.given + between->error * judged.swing +
                    unit_roundoff * (between->rounding() * judged.most + 12.0 * layout->reach() * window_.step * judged.swing);
                paint(first + p, *layout, turned, made.data() + p * profiles.harmonics() * stride, stride, off);
            }
        });
    }

    // Windows whose pixels average, or whose axis is anywhere.
    template <class Table>
    void around(const std::shared_ptr<const Table>& table) const {
        const Profiles profiles(planes_, table, 1.0);
        profiles.run(threads_, [&](std::size_t first, std::size_t here, const double* values, const PartSizes* sizes) {
            thread_local WindowValues made;
            for (std::size_t p = 0; p < here;
                 ++p, values += profiles.outputs() * profiles.stride(), sizes += profiles.kinds()) {
                const Judged judged(planes_, first + p, *sizes);
                double size = 0.0, top = 0.0;
                dispatch([&](auto) LOMMEL_INLINE_LAMBDA { size = largest(values, table->count); });
                const double off = window(*table, first + p, values, judged, size, made);
                dispatch([&](auto) LOMMEL_INLINE_LAMBDA { top = largest(made.values.data(), made.count); });
                // Of samples the peak is I at any radius.
                const double peak = std::max(top - off, window_.integrate ? 0.0 : size - judged.given);
                const double scale = note(first + p, top, peak, off);
                spread(*table, made, scale, T{0}, answer_.images + (first + p) * pixels());
                for (std::size_t d = 0; d < planes_.derivatives.size(); ++d) {
                    const double* profile = values + (d + 1) * profiles.stride();
                    if (planes_.derivatives[d].by == By::radius) {
                        slope(*table, d, first + p, profile, judged, sizes[0], sizes[d + 1], made);
                        continue;
                    }
                    const Judged of(planes_, first + p, sizes[0], sizes[d + 1], planes_.derivatives[d].error);
                    differentiate(*table, first + p, d, window(*table, first + p, profile, of, of.most, made), made);
                }
            }
        });
    }

    // Samples around any axis of light that depends on the azimuth. h_m / v^m is even and of type 2: h_1 and h_2 begin with v and v^2,
    // so that it is at most the largest |h_1'| or half of |h_2''|, both twice that of h_m. With places in v it makes the image.
    void turned(const std::shared_ptr<const AnywhereTable>& table) const {
        const Profiles profiles(planes_, table, 1.0);
        profiles.run(threads_, [&](std::size_t first, std::size_t here, const double* values, const PartSizes* sizes) {
            thread_local WindowValues made;
            thread_local Doubles divided, total;
            divided.resize(table->count + widest_step);
            total.resize(pixels());
            for (std::size_t p = 0; p < here; ++p) {
                double off = 0.0;
                std::fill(total.begin(), total.end(), 0.0);
                for (std::size_t k = 0; k < profiles.harmonics(); ++k, values += profiles.stride()) {
                    const Harmonic& h = planes_.harmonics[k];
                    const double order = static_cast<double>(h.order), reach = std::pow(table->reach(), order);
                    for (std::size_t i = 0; i < table->count; ++i) {
                        divided[i] = h.size() * values[i] / std::pow(table->radii[i], order);
                    }
                    Judged of(planes_, first + p, sizes[p], k, k + 1);
                    of.most *= h.order == 0 ? 1.0 : 2.0;
                    of.swing *= h.order == 0 ? 1.0 : 2.0;
                    of.given = of.given / std::pow(table->radii[0], order) + 8.0 * unit_roundoff * of.most;
                    off +=
                        reach * (window(*table, first + p, divided.data(), of, of.most, made) + 16.0 * unit_roundoff * of.most);
                    add(h, windows_[first + p], made.values.data(), total.data());
                }
                double top = 0.0;
                dispatch([&](auto) LOMMEL_INLINE_LAMBDA { top = largest(total.data(), pixels()); });
                const double scale = note(first + p, top, top - off, off);
                T* const image = answer_.images + (first + p) * pixels();
                dispatch([&](auto) LOMMEL_INLINE_LAMBDA { store_least(total.data(), scale, pixels(), T{0}, image); });
            }
        });
    }

    static void add(const Harmonic& h, const PixelWindow& here, const double* values, double* total) {
        const double cosine = h.cosine / h.size(), sine = h.sine / h.size();
        for (std::size_t row = 0, i = 0; row < here.height; ++row) {
            const double y = here.step * (static_cast<double>(row) - here.center_y);
            for (std::size_t column = 0; column < here.width; ++column, ++i) {
                const double x = here.step * (static_cast<double>(column) - here.center_x);
                total[i] += values[i] * (h.order == 0   ? 1.0
                                         : h.order == 1 ? cosine * x + sine * y
                                                        : cosine * (x * x - y * y) + sine * 2.0 * x * y);
            }
        }
    }

    // The values of a window from those at radii, of at most `size`; returns the bound on their error.
    template <class Table>
    double window(const Table& table, std::size_t plane, const double* profile, const Judged& of, double size,
                  WindowValues& made) const {
        made.make(table, windows_[plane], profile, 1);
        return window_error(table, made.penalty, size, of.given, 2.0 * of.swing, of.swing);
    }

    template <class Real>
    void spread(const AnywhereTable&, const WindowValues& made, double scale, Real least, Real* image) const {
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA { store_least(made.values.data(), scale, made.count, least, image); });
    }
    template <class Real>
    void spread(const PixelTable& table, const WindowValues& made, double scale, Real least, Real* image) const {
        thread_local std::vector<Real> kept;
        kept.resize(made.count);
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA { store_least(made.values.data(), scale, made.count, least, kept.data()); });
        table.groups.paint(kept.data(), 0, table.groups.rows.distances.size(), image);
    }

    // I' / v, even and of type 2, at most the largest |I''|; from it what moves the axis by a pixel along rows and columns.
    template <class Table>
    void slope(const Table& table, std::size_t d, std::size_t plane, const double* profile, const Judged& judged,
               const PartSizes& of, const PartSizes& sizes, WindowValues& made) const {
        thread_local Doubles divided;
        divided.resize(table.count + widest_step);
        for (std::size_t i = 0; i < table.count; ++i) {
            divided[i] = profile[i] / table.radii[i];
        }
        Judged by_v(planes_, plane, of, sizes, planes_.derivatives[d].error);
        by_v.most = by_v.swing = 4.0 * judged.swing;
        by_v.given = by_v.given / table.radii[0] + 2.0 * unit_roundoff * by_v.most;
        const double wrong = window(table, plane, divided.data(), by_v, by_v.most, made) + 8.0 * unit_roundoff * by_v.most;
        const PixelWindow here = windows_[plane];
        const double pitch = here.step * here.step;
        double *const down = slopes_.images + (d * planes_.count + plane) * pixels(), *const across =
                                                                                          down + planes_.count * pixels();
        for (std::size_t y = 0, i = 0; y < here.height; ++y) {
            for (std::size_t x = 0; x < here.width; ++x, ++i) {
                down[i] = pitch * made.values[i] * (here.center_y - static_cast<double>(y));
                across[i] = pitch * made.values[i] * (here.center_x - static_cast<double>(x));
            }
        }
        slopes_.errors[d * planes_.count + plane] = slopes_.errors[(d + 1) * planes_.count + plane] =
            wrong * pitch * windows_.farthest;
    }

    // As doubles, with absolute errors: callers sum derivatives of them.
    template <class Table>
    void differentiate(const Table& table, std::size_t plane, std::size_t d, double wrong, const WindowValues& made) const {
        spread(table, made, 1.0, std::numeric_limits<double>::lowest(),
               slopes_.images + (d * planes_.count + plane) * pixels());
        slopes_.errors[d * planes_.count + plane] = wrong;
    }

    void paint(std::size_t plane, const Layout& layout, const Turned& turned, const double* values, std::size_t stride,
               double off) const {
        thread_local Doubles all;
        thread_local std::vector<T> profile;
        double top = 0.0;
        if (!planes_.radial()) {
            all.resize(pixels());
            turned.sum(layout, values, stride, all.data());
            dispatch([&](auto) LOMMEL_INLINE_LAMBDA { top = largest(all.data(), pixels()); });
            const double scale = note(plane, top, top - off, off);
            return dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
                store_least(all.data(), scale, pixels(), T{0}, answer_.images + plane * pixels());
            });
        }
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA { top = largest(values, layout.count); });
        profile.resize(layout.count);
        const double scale = note(plane, top, top - off, off);
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA { store_least(values, scale, layout.count, T{0}, profile.data()); });
        scatter_rows(profile.data(), layout.index.data(), layout.height, layout.width, 0, layout.height / 2 + 1,
                     answer_.images + plane * pixels());
    }

    // No intensity is negative, and none less exact for being `least`.
    template <class Real>
    static LOMMEL_INLINE void store_least(const double* values, double scale, std::size_t count, Real least, Real* out) {
        store_scaled(values, scale, count, out);
        for (std::size_t i = 0; i < count; ++i) {
            out[i] = std::max(out[i], least);
        }
    }

    double note(std::size_t plane, double top, double peak, double off) const {
        const bool divided = answer_.scales[plane] == 0.0;
        const double relative = peak > 1e-300 ? off / peak : 1e300;
        return answer_.finish(plane, top, peak, finished_error<T>(relative, divided, false));
    }

    const Planes& planes_;
    PixelWindows windows_;
    PixelWindow window_;  // the first
    double allowed_;
    int threads_;
    Answer<T> answer_;
    LayeredSlopes slopes_;
};

}  // namespace lommel
