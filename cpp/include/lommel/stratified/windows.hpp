// Images computed from the azimuthal orders of the intensity at the radii of a table, with error bounds.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "lommel/base/simd.hpp"
#include "lommel/pixels/own_axes.hpp"
#include "lommel/pixels/render.hpp"
#include "lommel/pixels/table.hpp"
#include "lommel/radial/average_values.hpp"
#include "lommel/stratified/error_check.hpp"
#include "lommel/stratified/planes.hpp"

namespace lommel {

// Compute the image of a radially symmetric intensity from values at the radii, at most `size` in modulus; returns its error bound.
template <class Table>
double window_of(const Table& table, const PixelWindow& window, const double* at_radii, const Judged& of, double size,
                 WindowValues& made) {
    made.make(table, window, at_radii, 1);
    return window_error(table, made.penalty, size, of.given, 2.0 * of.swing, of.swing);
}

// One azimuthal order of the intensity at the radii, with its error bounds.
struct Order {
    const double* values;
    Judged judged;
};

// Add to `total` one azimuthal order of the intensity: `values` times the order's cosine and sine in the azimuth. For
// order 1, `values` are given divided by the radius and are multiplied by it here.
inline void add_order(const Harmonic& h, const PixelWindow& here, const double* values, double* total) {
    const double cosine = h.cosine / h.size(), sine = h.sine / h.size();
    for (std::size_t row = 0, i = 0; row < here.height; ++row) {
        const double y = here.step * (static_cast<double>(row) - here.center_y);
        for (std::size_t column = 0; column < here.width; ++column, ++i) {
            const double x = here.step * (static_cast<double>(column) - here.center_x);
            const double turned = cosine * (x - y) * (x + y) + sine * 2.0 * x * y;
            total[i] += values[i] * (h.order == 0   ? 1.0
                                     : h.order == 1 ? cosine * x + sine * y
                                                    : turned / std::max(x * x + y * y, 1e-300));
        }
    }
}

// Compute samples of an intensity that depends on the azimuth; returns their error bound. h_0, h_1, h_2: azimuthal orders. As
// functions of the radius v, h_0, h_1 / v and h_2 are even and of exponential type 2. |h_1 / v| is at most max |h_1'|, which by
// Bernstein's inequality is at most twice max |h_1| (docs/certificate.md, section 15).
template <class Of>
double turned_window(const AnywhereTable& table, const Planes& planes, const PixelWindow& here, const Of& order,
                     WindowValues& made, double* total) {
    thread_local Doubles divided;
    divided.resize(table.count + widest_step);
    double off = 0.0;
    std::fill_n(total, here.height * here.width, 0.0);
    for (std::size_t k = 0; k < planes.harmonics.size(); ++k) {
        const Harmonic& h = planes.harmonics[k];
        Order given = order(k);
        const bool odd = h.order == 1;
        for (std::size_t i = 0; i < table.count; ++i) {
            divided[i] = h.size() * given.values[i] / (odd ? table.radii[i] : 1.0);
        }
        Judged& of = given.judged;
        of.most *= odd ? 2.0 : 1.0;
        of.swing *= odd ? 2.0 : 1.0;
        of.given = of.given / (odd ? table.radii[0] : 1.0) + 8.0 * unit_roundoff * of.most;
        off += (odd ? table.reach() : 1.0) *
               (window_of(table, here, divided.data(), of, of.most, made) + 16.0 * unit_roundoff * of.most);
        add_order(h, here, made.values.data(), total);
    }
    return off;
}

template <class Real>
void store_window(const AnywhereTable&, const WindowValues& made, double scale, Real least, Real* image) {
    store_least(made.values.data(), scale, made.count, least, image);
}

template <class Real>
void store_window(const PixelTable& table, const WindowValues& made, double scale, Real least, Real* image) {
    thread_local std::vector<Real> kept;
    kept.resize(made.count);
    store_least(made.values.data(), scale, made.count, least, kept.data());
    table.groups.paint(kept.data(), 0, table.groups.rows.distances.size(), image);
}

}  // namespace lommel
