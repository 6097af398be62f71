// Error bounds of tables for pixel averages.
#include <algorithm>
#include <memory>
#include <tuple>
#include <vector>

#include "lommel/bounds/pixels.hpp"
#include "lommel/pixels/average_rings.hpp"
#include "lommel/pixels/own_axes.hpp"
#include "lommel/pixels/shift.hpp"
#include "lommel/pixels/table.hpp"
#include "lommel/radial/average_values.hpp"
#include "lommel/radial/coarse_averages.hpp"

#include "tests.hpp"

using namespace bindings;

namespace {

// Rings of a table for the pixel averages of a window with its axis at (center_y, center_x): for each ring the smallest and
// largest distance of its pixels, the same of its nodes, their number, whether they interpolate an even function, and whether
// pixels have their own weights.
Named rings_of(const lommel::PixelRings& table) {
    nb::list rings;
    for (const auto& ring : table.rings) {
        rings.append(nb::make_tuple(ring.middle - ring.half, ring.middle + ring.half, ring.nodes.low, ring.nodes.high,
                                    ring.nodes.count, ring.nodes.even, ring.direct));
    }
    return named("gauss"_a = table.gauss, "harmonics"_a = table.harmonics, "rings"_a = rings, "error"_a = table.error,
                 "of_nodes"_a = table.of_nodes, "of_grid"_a = table.of_grid, "rounding"_a = table.rounding,
                 "penalty"_a = listed(table.penalty));
}

Named pixel_bounds(std::size_t height, std::size_t width, double center_y, double center_x, double step, bool integrate,
                   int level) {
    return rings_of(*lommel::PixelTable::get({height, width, center_y, center_x, step, integrate}, level, 1));
}

Named ring_bounds(double pitch, double farthest, int level) {
    return rings_of(*lommel::AverageRings::get(pitch, farthest, level, 1));
}

Named anywhere_bounds(double pitch, bool averages, double farthest, int level) {
    const auto table = lommel::AnywhereTable::get(pitch, averages, farthest, level);
    return named("gauss"_a = table->gauss, "harmonics"_a = table->harmonics, "degree"_a = table->degree,
                 "error"_a = table->error, "of_nodes"_a = table->of_nodes, "of_grid"_a = table->of_grid,
                 "rounding"_a = table->rounding, "penalty"_a = listed(table->penalty),
                 "radii"_a = std::vector<double>(table->radii.data(), table->radii.data() + table->count));
}

// Write the pixels of a window around an arbitrary axis, interpolated from I at the radii of the table; returns the rounding of
// the polynomials.
double anywhere_values(In<double, 1> profile, double center_y, double center_x, double pitch, bool averages, double farthest,
                       int level, Out<double, 2> out) {
    const lommel::PixelWindow window{out.shape(0), out.shape(1), center_y, center_x, pitch, averages};
    const auto table = lommel::AnywhereTable::get(pitch, averages, farthest, level);
    lommel::WindowValues made;
    made.make(*table, window, profile.data(), 1);
    std::copy_n(made.values.data(), made.count, out.data());
    return made.penalty;
}

// Table for the shift of averages when the axis moves: orders, degree, and the terms of its error.
using Shift = std::tuple<std::size_t, std::size_t, double, double, double, double, std::vector<double>>;

std::shared_ptr<const lommel::ShiftTable> shift_table(double pitch, double farthest, int level) {
    return lommel::ShiftTable::get(lommel::AnywhereTable::get(pitch, true, farthest, level));
}

Shift shift_bounds(double pitch, double farthest, int level) {
    const auto table = shift_table(pitch, farthest, level);
    return {table->harmonics,
            table->degree,
            table->error,
            table->of_grid,
            table->rounding,
            table->pixels->growth(),
            {table->penalty.begin(), table->penalty.end()}};
}

double shift_values(In<double, 1> profile, double center_y, double center_x, double pitch, double farthest, int level,
                    Out<double, 3> out) {
    const auto table = shift_table(pitch, farthest, level);
    const lommel::PixelWindow window = window_of(out.shape(1), out.shape(2), center_y, center_x, pitch, true);
    const std::size_t count = window.height * window.width;
    lommel::Doubles scratch, down(count + lommel::widest_step), across(count + lommel::widest_step);
    const double penalty = table->values(window, profile.data(), scratch, down.data(), across.data());
    std::copy_n(down.data(), count, out.data());
    std::copy_n(across.data(), count, out.data() + count);
    return penalty;
}

}  // namespace

void bindings::define_table_tests(nb::module_& m) {
    m.def("anywhere_bounds", &anywhere_bounds, "pitch"_a, "averages"_a, "farthest"_a, "level"_a,
          "Degree, harmonics and radii of windows around any axis, and bounds on what they leave and magnify.");
    m.def("anywhere_values", &anywhere_values, "profile"_a, "center_y"_a, "center_x"_a, "pitch"_a, "averages"_a, "farthest"_a,
          "level"_a, "out"_a.noconvert(), "The pixels of one, and the units of roundoff that their sums may be off by.");
    m.def("pixel_bounds", &pixel_bounds, "height"_a, "width"_a, "center_y"_a, "center_x"_a, "step"_a, "integrate"_a, "level"_a,
          "Rings, nodes and harmonics of a window whose pixels average, and bounds on what they leave and magnify.");
    m.def("ring_bounds", &ring_bounds, "pitch"_a, "farthest"_a, "level"_a,
          "Rings of a window whose pixels average around any axis, and bounds on what they leave and magnify.");
    m.def(
        "shift_bounds", &shift_bounds, "pitch"_a, "farthest"_a, "level"_a,
        "Of what averages change by as the axis moves by a pixel: angles, degree, error, of_grid, rounding, what the error of "
        "v I' is over that of I, and the roundings that each coefficient takes part in.");
    m.def("shift_values", &shift_values, "profile"_a, "center_y"_a, "center_x"_a, "pitch"_a, "farthest"_a, "level"_a,
          "out"_a.noconvert(),
          "That change, down and across, from I at the radii of anywhere_bounds(); returns further roundings.");
    m.def("interpolation_error", &lommel::interpolation_error, "half"_a, "points"_a,
          "Bound on interpolating a function of exponential type 2 at Chebyshev points of [-half, half], over half its range.");
    m.def(
        "energy_error",
        [](std::size_t points, double swing) {
            const lommel::EnergyWithin::Between panel(points, swing);
            return std::make_tuple(panel.part, panel.whole, lommel::EnergyWithin::slope(points, swing));
        },
        "points"_a, "swing"_a,
        "Bounds on the energy from an intensity interpolated on a panel, over its end: of a part and of all of it; and on the "
        "derivative of this order over 2^order.");
    m.def("harmonics_error", &lommel::harmonics_error, "side"_a, "angles"_a,
          "Bound on interpolating the average over a square at so many angles, over half the range.");
}
