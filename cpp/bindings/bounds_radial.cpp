// Error bounds for radially symmetric pupils and for windows.
#include <limits>
#include <vector>

#include "lommel/base/wide.hpp"
#include "lommel/pixels/own_axes.hpp"
#include "lommel/pixels/table.hpp"
#include "lommel/radial/average_images.hpp"
#include "lommel/radial/field.hpp"
#include "lommel/special/bessel_table.hpp"
#include "lommel/zernike/rings.hpp"

#include "bounds.hpp"

using namespace bindings;

namespace {

// The growth of the exponent on the ellipses of some cosh, roundings, the integral over an annulus, and values at t, of an
// amplitude raised to a power on an inner disk of that area.
Named amplitude_bounds(Doubles1 powers, Doubles1 cosh, Doubles1 t, double obscuration, double raised, double area) {
    const lommel::Amplitude amplitude = powers_of_amplitude(powers).raised(raised).scaled(area);
    return named("growth"_a = each(cosh, [&](double c) { return amplitude.growth(c); }),
                 "sensitivity"_a = amplitude.sensitivity(), "values"_a = each(t, [&](double x) { return amplitude.at(x); }),
                 "integral"_a = amplitude.integral(obscuration), "size"_a = amplitude.size(), "passive"_a = amplitude.passive(),
                 "area"_a = lommel::Aperture(obscuration, amplitude).area);
}

// One radial pupil; its phase points to its amplitude.
struct RadialPupil {
    const lommel::Amplitude light;
    const lommel::Phase phase;

    RadialPupil(const Doubles1& coefficients, const Doubles1& amplitude)
        : light(powers_of_amplitude(amplitude)), phase{coefficients.data(), coefficients.shape(0), &light} {
        require(coefficients.shape(0) > 0, "coefficients must not be empty");
    }
};

Named series_bounds(Doubles1 coefficients, Doubles1 amplitude, std::size_t power, double reach, double error) {
    require(error > 0.0 && reach >= 0.0, "reach and error must be positive");
    const RadialPupil pupil(coefficients, amplitude);
    const lommel::Expansion plan({coefficients.data(), coefficients.size(), pupil.light, power}, reach, error);
    return named("terms"_a = plan.terms, "truncation"_a = plan.truncation, "nodes"_a = 2 * plan.rule->half,
                 "quadrature"_a = plan.quadrature, "error"_a = plan.error(pupil.phase));
}

// Of one pupil, or of all between two.
Named ellipse_bounds(In<double, 2> pupils, Doubles1 amplitude, std::size_t power, std::size_t terms, std::size_t nodes) {
    require(pupils.shape(0) >= 1 && pupils.shape(0) <= 2 && pupils.shape(1) > 0, "pupils must have one row or two");
    const double *low = pupils.data(), *high = low + pupils.shape(1);
    const lommel::Ellipses ellipses =
        pupils.shape(0) == 1 ? lommel::Ellipses(low, pupils.shape(1), powers_of_amplitude(amplitude), power)
                             : lommel::Ellipses({low, high}, {high, high + pupils.shape(1)}, powers_of_amplitude(amplitude));
    return named("tail"_a = ellipses.tail(terms), "quadrature"_a = ellipses.quadrature(nodes, terms));
}

// With the spacing at 1 of the numbers that tables are made with.
Named window_bounds(std::size_t count, double reach) {
    return named("legendre"_a = lommel::window_tail(count, reach), "disk"_a = lommel::disk_window_tail(count, reach),
                 "spacing"_a = static_cast<double>(std::numeric_limits<lommel::wide>::epsilon()));
}

Named piece_bounds(std::size_t width, std::size_t piece, std::size_t terms, std::size_t parity) {
    require(width < lommel::widths.size() && parity < 2 && piece < 1000 && terms < 1000, "no such piece");
    const auto table = (parity == 0 ? lommel::even_pieces : lommel::odd_pieces).get(width, {piece + 1, {}}, terms);
    const lommel::Piece& one = *table->pieces[piece];
    return named("width"_a = table->width, "error"_a = lommel::piece_error(table->width),
                 "ring_error"_a = lommel::ring_error(table->width), "rows"_a = listed(one.rows), "magnitude"_a = one.magnitude,
                 "azimuthal"_a = one.azimuthal, "largest_magnitude"_a = table->magnitude,
                 "largest_azimuthal"_a = table->azimuthal);
}

double field_bound(Doubles1 coefficients, Doubles1 amplitude, std::size_t power, double obscuration, double reach,
                   double error) {
    require(error > 0.0 && reach >= 0.0, "reach and error must be positive");
    const RadialPupil pupil(coefficients, amplitude);
    return lommel::Field().prepare(pupil.phase, power, obscuration, reach, error);
}

// At these radii, rising, of which few leave pieces out; with U itself, whose largest values enter the bounds on I.
Named field_values(Doubles1 coefficients, Doubles1 amplitude, std::size_t power, double obscuration, Doubles1 radii,
                   double error) {
    const std::size_t count = radii.shape(0);
    require(error > 0.0 && count > 0, "error must be positive, radii not empty");
    const RadialPupil pupil(coefficients, amplitude);
    lommel::Doubles at(radii.data(), radii.data() + count), re(count + lommel::widest_step), im(re.size());
    at.resize(re.size(), at.back());
    lommel::Field field;
    const double bound = field.prepare(pupil.phase, power, obscuration, {at.data(), count, 1.0}, error);
    lommel::dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
        field.evaluate(isa, at.data(), 0, count, 1.0, [&](std::size_t i, auto a, auto b) LOMMEL_INLINE_LAMBDA {
            lommel::store(re.data() + i, a);
            lommel::store(im.data() + i, b);
        });
    });
    re.resize(count);
    im.resize(count);
    return named("error"_a = bound, "re"_a = listed(re), "im"_a = listed(im));
}

Named intensity_bounds(double peak, double error) {
    const double relative = lommel::relative_error(peak, error);
    return named("relative"_a = relative, "normalized"_a = lommel::normalized_error(relative));
}

// Of values that are stored in single precision or not, and divided by their own largest one before or after.
double stored_bound(double relative, bool single, bool twice) {
    return lommel::stored(relative, single ? lommel::storing<float>(twice) : lommel::storing<double>(twice));
}

Named peaks(Doubles1 coefficients, Doubles1 amplitude, double obscuration, double tol) {
    const RadialPupil pupil(coefficients, amplitude);
    const double first = lommel::first_error(pupil.phase, obscuration, tol);
    return named("likely"_a = lommel::likely_peak(pupil.phase, obscuration), "first_error"_a = first,
                 "scanned"_a = lommel::scanned_peak(pupil.phase, obscuration, first));
}

// What is left out of averages without rings: mean / r^3 is I then.
Named tail_bounds(Doubles1 coefficients, Doubles1 amplitude, double obscuration, double r) {
    const RadialPupil pupil(coefficients, amplitude);
    const lommel::EnergyTail tail(pupil.phase, obscuration);
    return named("mean"_a = tail.mean(), "rings"_a = tail.rings(r), "curved"_a = tail.curved(r));
}

// Of a table for the averages over the pixels of a window, its axis at (center_y, center_x); each ring as (the least
// and the largest distance of its pixels, the same of its nodes, their count, whether they are of an even function, whether
// pixels have their own weights).
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
    require(height > 0 && height <= 1000 && width > 0 && width <= 1000, "windows must have 1 to 1000 pixels a side");
    require(step > 0.0 && level >= 1 && level <= 15, "step must be positive, level from 1 to 15");
    return rings_of(*lommel::PixelTable::get({height, width, center_y, center_x, step, integrate}, level, 1));
}

Named ring_bounds(double pitch, double farthest, int level) {
    require(pitch > 0.0 && farthest >= 1.0 && pitch * farthest <= lommel::AverageRings::most_reach && level >= 1 && level <= 15,
            "pitch must be positive, farthest 1 at least and within reach, level from 1 to 15");
    return rings_of(*lommel::AverageRings::get(pitch, farthest, level, 1));
}

lommel::PixelWindow anywhere_window(double pitch, bool averages, double farthest, int level) {
    require(
        pitch > 0.0 && farthest >= 1.0 && pitch * farthest <= lommel::AnywhereTable::most_reach && level >= 1 && level <= 15,
        "pitch must be positive, farthest 1 at least and within reach, level from 1 to 15");
    return {1, 1, 0.0, 0.0, pitch, averages};
}

Named anywhere_bounds(double pitch, bool averages, double farthest, int level) {
    anywhere_window(pitch, averages, farthest, level);
    const auto table = lommel::AnywhereTable::get(pitch, averages, farthest, level);
    return named("gauss"_a = table->gauss, "harmonics"_a = table->harmonics, "degree"_a = table->degree,
                 "error"_a = table->error, "of_nodes"_a = table->of_nodes, "of_grid"_a = table->of_grid,
                 "rounding"_a = table->rounding, "penalty"_a = listed(table->penalty),
                 "radii"_a = std::vector<double>(table->radii.data(), table->radii.data() + table->count));
}

// Pixels around an axis from I at these radii, and what evaluating the polynomials may be off by.
double anywhere_values(In<double, 1> profile, double center_y, double center_x, double pitch, bool averages, double farthest,
                       int level, Out<double, 2> out) {
    lommel::PixelWindow window = anywhere_window(pitch, averages, farthest, level);
    window = {out.shape(0), out.shape(1), center_y, center_x, pitch, averages};
    const auto table = lommel::AnywhereTable::get(pitch, averages, farthest, level);
    require(profile.shape(0) == table->count, "the profile must be at the radii");
    lommel::WindowValues made;
    made.make(*table, window, profile.data(), 1);
    std::copy_n(made.values.data(), made.count, out.data());
    return made.penalty;
}

}  // namespace

void bindings::define_radial_bounds(nb::module_& m) {
    m.def("amplitude_bounds", &amplitude_bounds, "powers"_a, "cosh"_a, "t"_a, "obscuration"_a, "raised"_a, "area"_a,
          "Of the amplitude exp(-(g_0 + g_1 t + ...)), to a power and on an inner disk.");
    m.def("series_bounds", &series_bounds, "coefficients"_a, "amplitude"_a, "power"_a, "reach"_a, "error"_a,
          "Terms and nodes of the series of t^power A exp(i Phi) up to v = reach, and bounds on what they leave.");
    m.def("ellipse_bounds", &ellipse_bounds, "pupils"_a, "amplitude"_a, "power"_a, "terms"_a, "nodes"_a,
          "Bounds on U beyond so many terms and nodes, for one pupil or for all between two.");
    m.def("window_bounds", &window_bounds, "count"_a, "reach"_a,
          "Bounds on U beyond so many Legendre terms, or degrees on the disk, whatever the pupil, up to v = reach.");
    m.def("piece_bounds", &piece_bounds, "width"_a, "piece"_a, "terms"_a, "parity"_a,
          "A piece of the table of Bessel functions, the error of its interpolation and the size of its coefficients.");
    m.def("field_bound", &field_bound, "coefficients"_a, "amplitude"_a, "power"_a, "obscuration"_a, "reach"_a, "error"_a,
          "Bound on the error of U, all terms together.");
    m.def("field_values", &field_values, "coefficients"_a, "amplitude"_a, "power"_a, "obscuration"_a, "radii"_a, "error"_a,
          "The same at radii that rise, and U there.");
    m.def("intensity_bounds", &intensity_bounds, "peak"_a, "error"_a,
          "Bounds on the error of I over its exact peak, and of values divided by their own, from that of U.");
    m.def("stored_bound", &stored_bound, "relative"_a, "single"_a, "twice"_a,
          "Bound on the error of values over their peak when they are stored.");
    m.def("tail_bounds", &tail_bounds, "coefficients"_a, "amplitude"_a, "obscuration"_a, "r"_a,
          "The mean of I times r^3 far from the axis, and bounds on what is left out of the light beyond r and of I.");
    m.def("peaks", &peaks, "coefficients"_a, "amplitude"_a, "obscuration"_a, "tol"_a,
          "The guess at the peak of |U|, the first error asked of U, and the largest I on the scan.");
    m.def("anywhere_bounds", &anywhere_bounds, "pitch"_a, "averages"_a, "farthest"_a, "level"_a,
          "Degree, harmonics and radii of windows around any axis, and bounds on what they leave and magnify.");
    m.def("anywhere_values", &anywhere_values, "profile"_a, "center_y"_a, "center_x"_a, "pitch"_a, "averages"_a, "farthest"_a,
          "level"_a, "out"_a.noconvert(), "The pixels of one, and the units of roundoff that their sums may be off by.");
    m.def("pixel_bounds", &pixel_bounds, "height"_a, "width"_a, "center_y"_a, "center_x"_a, "step"_a, "integrate"_a, "level"_a,
          "Rings, nodes and harmonics of a window whose pixels average, and bounds on what they leave and magnify.");
    m.def("ring_bounds", &ring_bounds, "pitch"_a, "farthest"_a, "level"_a,
          "Rings of a window whose pixels average around any axis, and bounds on what they leave and magnify.");
}
