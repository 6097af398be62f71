// Images of the planes of a stack in a layered medium, each with its error bound (docs/certificate.md, section 15).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "lommel/base/tasks.hpp"
#include "lommel/bounds/refine.hpp"
#include "lommel/pixels/layout.hpp"
#include "lommel/pixels/own_axes.hpp"
#include "lommel/pixels/render.hpp"
#include "lommel/pixels/table.hpp"
#include "lommel/pixels/window.hpp"
#include "lommel/radial/stack.hpp"
#include "lommel/stratified/interpolation.hpp"
#include "lommel/stratified/error_check.hpp"
#include "lommel/stratified/profiles.hpp"
#include "lommel/stratified/slopes.hpp"
#include "lommel/stratified/windows.hpp"

namespace lommel {

// Images of planes, interpolated from the intensity at few radii.
template <class T>
class LayeredImages {
   public:
    // `allowed`: allowed interpolation error of the intensity, relative to the peak of a uniform aperture without aberrations.
    LayeredImages(const Planes& planes, const PixelWindows& windows, double allowed, int threads, const Answer<T>& answer,
                  const LayeredSlopes<T>& slopes)
        : planes_(planes), windows_(windows), window_(windows.first), allowed_(allowed), answer_(answer), slopes_(slopes) {
        // Estimated time of a plane in microseconds.
        const double each = 0.5 + 1e-3 * static_cast<double>(pixels()) + 0.02 * static_cast<double>(planes.angles.count);
        threads_ = worthwhile_threads(threads, static_cast<double>(planes.count) * each);
    }

    // Return whether this class supports the windows. Intensities that depend on the azimuth can only be sampled, not averaged
    // over pixels; derivatives need windows around arbitrary axes, or pixel averages in centred windows.
    static bool fits(const Planes& planes, const PixelWindows& windows, bool derivatives) {
        const bool averages = windows.first.integrate;
        if (windows.centers == nullptr) {
            return averages ? planes.radial() : !derivatives;
        }
        return (planes.radial() || !averages) && windows.farthest * windows.first.step <= AnywhereTable::most_reach;
    }

    void run() const;

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
            constexpr std::size_t together = 6;  // rows at once: twelve chains of multiply-adds
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
                // 12 = 6 * 2: up to 6 roundings of a radius v, times |dI/dv| <= 2 * judged.swing (Bernstein's inequality).
                const double off =
                    between->magnification() * judged.given + between->error * judged.swing +
                    unit_roundoff * (between->rounding() * judged.most + 12.0 * layout->reach() * window_.step * judged.swing);
                paint(first + p, *layout, turned, made.data() + p * profiles.harmonics() * stride, stride, off);
            }
        });
    }

    // Images of radially symmetric intensities: pixel averages, or samples around an arbitrary axis.
    template <class Table>
    void around(const std::shared_ptr<const Table>& table) const {
        const Profiles profiles(planes_, table, 1.0);
        const WindowSlopes<T> slopes(planes_, windows_, slopes_, table);
        profiles.run(threads_, [&](std::size_t first, std::size_t here, const double* values, const PartSizes* sizes) {
            thread_local WindowValues made;
            for (std::size_t p = 0; p < here;
                 ++p, values += profiles.outputs() * profiles.stride(), sizes += profiles.kinds()) {
                const Judged judged(planes_, first + p, *sizes);
                const double size = largest_value(values, table->count);
                const double off = window_of(*table, windows_[first + p], values, judged, size, made);
                const double top = largest_value(made.values.data(), made.count);
                // Lower bound on the peak: the largest value less its error bound. For samples, but not for averages, the intensity
                // at any radius of the table, less its error bound, is a lower bound as well.
                const double peak = std::max(top - off, window_.integrate ? 0.0 : size - judged.given);
                const double scale = note(first + p, top, peak, off);
                store_window(*table, made, scale, T{0}, answer_.images + (first + p) * pixels());
                slopes.radial(first + p, {values, profiles.stride(), sizes, judged}, scale, made);
            }
        });
    }

    // Images of intensities that depend on the azimuth: samples around an arbitrary axis.
    void turned(const std::shared_ptr<const AnywhereTable>& table) const {
        const Profiles profiles(planes_, table, 1.0);
        const WindowSlopes<T> slopes(planes_, windows_, slopes_, table);
        profiles.run(threads_, [&](std::size_t first, std::size_t here, const double* values, const PartSizes* sizes) {
            thread_local WindowValues made;
            thread_local Doubles total;
            total.resize(pixels());
            for (std::size_t p = 0; p < here;
                 ++p, values += profiles.outputs() * profiles.stride(), sizes += profiles.kinds()) {
                const double off = turned_window(
                    *table, planes_, windows_[first + p],
                    [&](std::size_t k) {
                        return Order{values + k * profiles.stride(), Judged(planes_, first + p, *sizes, k, k + 1)};
                    },
                    made, total.data());
                const double top = largest_value(total.data(), pixels());
                const double scale = note(first + p, top, top - off, off);
                T* const image = answer_.images + (first + p) * pixels();
                store_least(total.data(), scale, pixels(), T{0}, image);
                slopes.turned(first + p, {values, profiles.stride(), sizes, Judged(planes_, first + p, *sizes)}, scale, made,
                              total.data());
            }
        });
    }

    void paint(std::size_t plane, const Layout& layout, const Turned& turned, const double* values, std::size_t stride,
               double off) const {
        thread_local Doubles all;
        thread_local std::vector<T> profile;
        if (!planes_.radial()) {
            all.resize(pixels());
            turned.sum(layout, values, stride, all.data());
            const double top = largest_value(all.data(), pixels());
            const double scale = note(plane, top, top - off, off);
            return store_least(all.data(), scale, pixels(), T{0}, answer_.images + plane * pixels());
        }
        const double top = largest_value(values, layout.count);
        profile.resize(layout.count);
        const double scale = note(plane, top, top - off, off);
        store_least(values, scale, layout.count, T{0}, profile.data());
        layout.scatter(profile.data(), 0, layout.rows.distances(), answer_.images + plane * pixels());
    }

    double note(std::size_t plane, double top, double peak, double off) const {
        const bool divided = answer_.scales[plane] == 0.0;
        const double relative = peak > 1e-300 ? off / peak : 1e300;
        return answer_.finish(plane, top, peak, finished_error<T>(relative, divided, false));
    }

    const Planes& planes_;
    PixelWindows windows_;
    PixelWindow window_;  // window of the first plane
    double allowed_;
    int threads_;
    Answer<T> answer_;
    LayeredSlopes<T> slopes_;
};

template <class T>
void LayeredImages<T>::run() const {
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

#if defined(LOMMEL_COMPILED)
extern template class LayeredImages<float>;
extern template class LayeredImages<double>;
#endif

}  // namespace lommel
