// From planes to windows of pixels, each with its proven error: docs/certificate.md, section 15.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "lommel/base/tasks.hpp"
#include "lommel/bounds/settle.hpp"
#include "lommel/pixels/layout.hpp"
#include "lommel/pixels/render.hpp"
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
        return (centered(windows) && planes.derivatives.empty()) ||
               (planes.radial() && windows.farthest * windows.first.step <= AnywhereTable::most_reach);
    }

    void run() const {
        if (!centered(windows_) || !planes_.derivatives.empty()) {
            return around();
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
    static bool centered(const PixelWindows& windows) {
        return windows.centers == nullptr && windows.first.centered() && !windows.first.integrate;
    }

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
                const double off = between->magnification() * judged.given + between->error * judged.swing +
                                   unit_roundoff * (between->rounding() * judged.most +
                                                    12.0 * layout->reach() * window_.step * judged.swing);
                paint(first + p, *layout, turned, made.data() + p * profiles.harmonics() * stride, stride, off);
            }
        });
    }

    // Windows whose pixels average, or whose axis is anywhere.
    void around() const {
        const int level = static_cast<int>(std::min(15.0, std::max(3.0, std::ceil(-std::log10(allowed_)))));
        const auto table = AnywhereTable::get(window_.step, window_.integrate, windows_.farthest, level);
        const Profiles profiles(planes_, table, 1.0);
        profiles.run(threads_, [&](std::size_t first, std::size_t here, const double* values, const PartSizes* sizes) {
            thread_local WindowValues made;
            for (std::size_t p = 0; p < here; ++p, values += profiles.outputs() * profiles.stride(), sizes += profiles.kinds()) {
                const Judged judged(planes_, first + p, *sizes);
                made.make(*table, windows_[first + p], values, 1);
                double size = 0.0, top = 0.0;
                dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
                    size = largest(values, table->count);
                    top = largest(made.values.data(), made.count);
                });
                const double off = window_error(*table, made.penalty, size, judged.given, 2.0 * judged.swing, judged.swing);
                // Of samples the peak is I at any radius.
                const double peak = std::max(top - off, window_.integrate ? 0.0 : size - judged.given);
                finish(first + p, made.values.data(), top, peak, off);
                for (std::size_t d = 0; d < planes_.derivatives.size(); ++d) {
                    const double* profile = values + (d + 1) * profiles.stride();
                    if (planes_.derivatives[d].by == By::radius) {
                        slope(*table, d, first + p, profile, judged, sizes[0], sizes[d + 1], made);
                    } else {
                        const Judged of(planes_, first + p, sizes[0], sizes[d + 1], planes_.derivatives[d].error);
                        made.make(*table, windows_[first + p], profile, 1);
                        const double wrong =
                            window_error(*table, made.penalty, of.most, of.given, 2.0 * of.swing, of.swing);
                        differentiate(first + p, d, made.values.data(), wrong);
                    }
                }
            }
        });
    }

    // I' / v, even and of type 2, at most the largest |I''|; from it what moves the axis by a pixel along rows and columns.
    void slope(const AnywhereTable& table, std::size_t d, std::size_t plane, const double* profile, const Judged& judged,
               const PartSizes& of, const PartSizes& sizes, WindowValues& made) const {
        thread_local Doubles divided, moved;
        divided.resize(table.count + widest_step);
        for (std::size_t i = 0; i < table.count; ++i) {
            divided[i] = profile[i] / table.radii[i];
        }
        const Judged by_v(planes_, plane, of, sizes, planes_.derivatives[d].error);
        const PixelWindow window = windows_[plane];
        made.make(table, window, divided.data(), 1);
        const double most = 4.0 * judged.swing, given = by_v.given / table.radii[0] + 2.0 * unit_roundoff * most;
        const double wrong = window_error(table, made.penalty, most, given, 2.0 * most, most) + 8.0 * unit_roundoff * most;
        const double pitch = window.step * window.step;
        moved.resize(2 * pixels());
        for (std::size_t y = 0, i = 0; y < window.height; ++y) {
            for (std::size_t x = 0; x < window.width; ++x, ++i) {
                moved[i] = pitch * made.values[i] * (window.center_y - static_cast<double>(y));
                moved[pixels() + i] = pitch * made.values[i] * (window.center_x - static_cast<double>(x));
            }
        }
        differentiate(plane, d, moved.data(), wrong * pitch * windows_.farthest);
        differentiate(plane, d + 1, moved.data() + pixels(), wrong * pitch * windows_.farthest);
    }

    // As doubles, with absolute errors: callers sum derivatives of them.
    void differentiate(std::size_t plane, std::size_t d, const double* values, double wrong) const {
        std::copy_n(values, pixels(), slopes_.images + (d * planes_.count + plane) * pixels());
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
            return finish(plane, all.data(), top, top - off, off);
        }
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA { top = largest(values, layout.count); });
        profile.resize(layout.count);
        const double scale = note(plane, top, top - off, off);
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA { store_light(values, scale, layout.count, profile.data()); });
        scatter_rows(profile.data(), layout.index.data(), layout.height, layout.width, 0, layout.height / 2 + 1,
                     answer_.images + plane * pixels());
    }

    void finish(std::size_t plane, const double* values, double top, double peak, double off) const {
        const double scale = note(plane, top, peak, off);
        T* const image = answer_.images + plane * pixels();
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA { store_light(values, scale, pixels(), image); });
    }

    // No intensity is negative, and none less exact for it.
    static LOMMEL_INLINE void store_light(const double* values, double scale, std::size_t count, T* out) {
        store_scaled(values, scale, count, out);
        for (std::size_t i = 0; i < count; ++i) {
            out[i] = std::max(out[i], T{0});
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
