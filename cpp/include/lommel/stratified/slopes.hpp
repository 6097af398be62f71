// Derivatives of the images of a microscope's planes, each with its error bound (docs/certificate.md, section 15).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <type_traits>
#include <variant>
#include <vector>

#include "lommel/base/simd.hpp"
#include "lommel/pixels/own_axes.hpp"
#include "lommel/pixels/shift.hpp"
#include "lommel/limits.hpp"
#include "lommel/stratified/error_check.hpp"
#include "lommel/stratified/planes.hpp"
#include "lommel/stratified/windows.hpp"

namespace lommel {

// Requested derivative of the intensity I: factor * dI/dx + own[plane] * I, where x is the depth or the focus. For By::radius: two
// images, where x is the row and the column of the axis.
struct LayeredSlope {
    By by;
    double factor;
    const double* own;  // [plane]: coefficient of I
};

// Requested derivatives and their results. images[image][plane][pixel]: derivatives, times the scale of the intensities;
// errors[image][plane]: absolute error bounds before scaling.
template <class T>
struct LayeredSlopes {
    std::vector<LayeredSlope> requested;
    T* images = nullptr;
    double* errors = nullptr;
};

// Radial profiles of one plane, `stride` values apart: values[kind][azimuthal order][radius]; kind 0: intensity, others: its
// derivatives. sizes[kind]: sizes (PartSizes) of the field and of its derivatives; judged: error bounds of the intensity.
struct PlaneProfiles {
    const double* values;
    std::size_t stride;
    const PartSizes* sizes;
    const Judged& judged;
};

// Derivatives of images, computed from radial profiles by tables of weights.
template <class T>
class WindowSlopes {
   public:
    template <class Table>
    WindowSlopes(const Planes& planes, const PixelWindows& windows, const LayeredSlopes<T>& slopes,
                 const std::shared_ptr<const Table>& table)
        : planes_(planes), windows_(windows), slopes_(slopes), table_(table.get()) {
        if constexpr (std::is_same_v<Table, AnywhereTable>) {
            const bool moved = std::any_of(slopes.requested.begin(), slopes.requested.end(),
                                           [](const LayeredSlope& slope) { return slope.by == By::radius; });
            shift_ = moved && table->integrate ? ShiftTable::get(table) : nullptr;
        }
    }

    // Write the derivatives of one plane, for radially symmetric intensities.
    void radial(std::size_t plane, const PlaneProfiles& of, double scale, WindowValues& made) const {
        const auto write = [&](const auto* own) {
            const auto& table = *own;
            std::size_t image = 0;
            for (const LayeredSlope& slope : slopes_.requested) {
                if (slope.by == By::radius) {
                    axis(image, plane, of, scale, made);
                    image += 2;
                } else {
                    const Order mixed = mix(table, slope, plane, of, 0);
                    const double error = window_of(table, windows_[plane], mixed.values, mixed.judged, mixed.judged.most, made);
                    store_window(table, made, scale, std::numeric_limits<T>::lowest(), at(image, plane));
                    note(image++, plane, error, made.values.data(), made.count);
                }
            }
        };
        std::visit(write, table_);
    }

    // Write the derivatives of one plane, for samples of intensities that depend on the azimuth.
    void turned(std::size_t plane, const PlaneProfiles& of, double scale, WindowValues& made, double* total) const {
        const AnywhereTable& table = *std::get<const AnywhereTable*>(table_);
        for (std::size_t image = 0; image < slopes_.requested.size(); ++image) {
            const double error = turned_window(
                table, planes_, windows_[plane],
                [&](std::size_t k) { return mix(table, slopes_.requested[image], plane, of, k); }, made, total);
            store_scaled(total, scale, pixels(), at(image, plane));
            note(image, plane, error, total, pixels());
        }
    }

   private:
    std::size_t pixels() const { return windows_.first.height * windows_.first.width; }
    T* at(std::size_t image, std::size_t plane) const { return slopes_.images + (image * planes_.count + plane) * pixels(); }

    std::size_t kind(By by) const {
        std::size_t d = 0;
        while (planes_.derivatives[d].by != by) {
            ++d;
        }
        return d + 1;
    }
    const double* profile(const PlaneProfiles& of, std::size_t kind, std::size_t order) const {
        return of.values + (kind * planes_.harmonics.size() + order) * of.stride;
    }
    Judged judged(std::size_t plane, const PlaneProfiles& of, std::size_t kind, std::size_t order) const {
        return {planes_, plane, *of.sizes, of.sizes[kind], planes_.derivatives[kind - 1].error, order, order + 1};
    }

    // Requested derivative of I by depth or focus, at the radii of a table.
    template <class Table>
    Order mix(const Table& table, const LayeredSlope& slope, std::size_t plane, const PlaneProfiles& of,
              std::size_t order) const {
        thread_local Doubles mixed;
        mixed.resize(table.count + widest_step);
        const std::size_t by = kind(slope.by);
        const double own = slope.own[plane];
        const double *value = profile(of, 0, order), *rate = profile(of, by, order);
        const Judged self = planes_.radial() ? of.judged : Judged(planes_, plane, *of.sizes, order, order + 1);
        Judged all = judged(plane, of, by, order).sum(slope.factor, self, own);
        for (std::size_t i = 0; i < table.count; ++i) {
            mixed[i] = slope.factor * rate[i] + own * value[i];
        }
        // 1e-12: `own` contains the quotient (derivative of the collected power) / (collected power), and the relative errors of
        // numerator and denominator are 1e-13.
        all.given += 1e-12 * std::abs(own) * self.most + 8.0 * unit_roundoff * all.most;
        return {mixed.data(), all};
    }

    // Derivatives by the position of the axis. For pixel averages: differences between averages along opposite pixel sides. For
    // samples: I' / v times (pixel pitch)^2 times the offset, in rows or columns, of the axis from the pixel. As a function of the
    // radius v, I' / v is even, of exponential type 2, and at most max |I''|.
    void axis(std::size_t image, std::size_t plane, const PlaneProfiles& of, double scale, WindowValues& made) const {
        thread_local Doubles down, across, scratch;
        const std::size_t room = pixels() + widest_step;
        down.resize(room);
        across.resize(room);
        const PixelWindow here = windows_[plane];
        double error = 0.0;
        if (shift_ != nullptr) {
            const double penalty = shift_->values(here, of.values, scratch, down.data(), across.data());
            error = window_error(*shift_, penalty, of.judged.most, of.judged.given, 4.0 * of.judged.swing, of.judged.swing);
        } else {
            const AnywhereTable& table = *std::get<const AnywhereTable*>(table_);
            const std::size_t by = kind(By::radius);
            const double *rate = profile(of, by, 0), pitch = here.step * here.step;
            scratch.resize(table.count + widest_step);
            for (std::size_t i = 0; i < table.count; ++i) {
                scratch[i] = rate[i] / table.radii[i];
            }
            Judged all = judged(plane, of, by, 0);
            all.most = all.swing = 4.0 * of.judged.swing;
            all.given = all.given / table.radii[0] + 2.0 * unit_roundoff * all.most;
            error = window_of(table, here, scratch.data(), all, all.most, made) + 8.0 * unit_roundoff * all.most;
            error *= pitch * windows_.farthest;
            for (std::size_t y = 0, i = 0; y < here.height; ++y) {
                for (std::size_t x = 0; x < here.width; ++x, ++i) {
                    down[i] = pitch * made.values[i] * (here.center_y - static_cast<double>(y));
                    across[i] = pitch * made.values[i] * (here.center_x - static_cast<double>(x));
                }
            }
        }
        for (const Doubles* way : {&down, &across}) {
            store_scaled(way->data(), scale, pixels(), at(image, plane));
            note(image++, plane, error, way->data(), pixels());
        }
    }

    // Write the error bound of a derivative's image: `error`, plus the rounding of `values` when they are scaled and stored.
    void note(std::size_t image, std::size_t plane, double error, const double* values, std::size_t count) const {
        double most = 0.0;
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
            double top[8] = {};
            std::size_t i = 0;
            for (; i + 8 <= count; i += 8) {
                for (std::size_t j = 0; j < 8; ++j) {
                    top[j] = std::max(top[j], std::abs(values[i + j]));
                }
            }
            for (; i < count; ++i) {
                top[0] = std::max(top[0], std::abs(values[i]));
            }
            most = *std::max_element(top, top + 8);
        });
        slopes_.errors[image * planes_.count + plane] = error + (storing<T>(false) + 32.0 * unit_roundoff) * most;
    }

    const Planes& planes_;
    PixelWindows windows_;
    const LayeredSlopes<T>& slopes_;
    std::variant<const AnywhereTable*, const PixelTable*> table_;  // around arbitrary axes, or for centred windows
    std::shared_ptr<const ShiftTable> shift_;
};

}  // namespace lommel
