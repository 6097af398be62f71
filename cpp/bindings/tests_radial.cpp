// Error bounds for radially symmetric pupils and for windows, and Fresnel integrals.
#include <limits>

#include "lommel/base/wide.hpp"
#include "lommel/radial/average_images.hpp"
#include "lommel/radial/field.hpp"
#include "lommel/special/bessel_table.hpp"
#include "lommel/special/fresnel.hpp"

#include "tests.hpp"

using namespace bindings;

namespace {

// For an amplitude raised to a power, on an inner disk of relative area `area`: growth of its exponent on ellipses with the
// given cosh, rounding, values at t, and the integral over an annulus.
Named amplitude_bounds(Doubles1 powers, Doubles1 cosh, Doubles1 t, double obscuration, double raised, double area) {
    const lommel::Amplitude amplitude = powers_of_amplitude(powers).raised(raised).scaled(area);
    return named("growth"_a = each(cosh, [&](double c) { return amplitude.growth(c); }),
                 "sensitivity"_a = amplitude.sensitivity(), "values"_a = each(t, [&](double x) { return amplitude.at(x); }),
                 "integral"_a = amplitude.integral(obscuration), "size"_a = amplitude.size(), "passive"_a = amplitude.passive(),
                 "area"_a = lommel::Aperture(obscuration, amplitude).area);
}

// One radial pupil; `phase` points to the `light` of the same object.
struct RadialPupil {
    const lommel::Amplitude light;
    const lommel::Phase phase;

    RadialPupil(const Doubles1& coefficients, const Doubles1& amplitude)
        : light(powers_of_amplitude(amplitude)), phase{coefficients.data(), coefficients.shape(0), &light} {}
};

Named series_bounds(Doubles1 coefficients, Doubles1 amplitude, std::size_t power, double reach, double error) {
    const RadialPupil pupil(coefficients, amplitude);
    const lommel::Expansion plan({coefficients.data(), coefficients.size(), pupil.light, power}, reach, error);
    return named("terms"_a = plan.terms, "truncation"_a = plan.truncation, "nodes"_a = 2 * plan.rule->half,
                 "quadrature"_a = plan.quadrature, "error"_a = plan.error(pupil.phase));
}

// Bounds for one pupil, or for all pupils between two.
Named ellipse_bounds(In<double, 2> pupils, Doubles1 amplitude, std::size_t power, std::size_t terms, std::size_t nodes) {
    const double *low = pupils.data(), *high = low + pupils.shape(1);
    const lommel::Ellipses ellipses =
        pupils.shape(0) == 1 ? lommel::Ellipses(low, pupils.shape(1), powers_of_amplitude(amplitude), power)
                             : lommel::Ellipses({low, high}, {high, high + pupils.shape(1)}, powers_of_amplitude(amplitude));
    return named("tail"_a = ellipses.tail(terms), "quadrature"_a = ellipses.quadrature(nodes, terms));
}

// Window tails, and the spacing at 1 of the type in which tables are computed.
Named window_bounds(std::size_t count, double reach) {
    return named("legendre"_a = lommel::window_tail(count, reach), "disk"_a = lommel::disk_window_tail(count, reach),
                 "spacing"_a = static_cast<double>(std::numeric_limits<lommel::wide>::epsilon()));
}

Named piece_bounds(std::size_t width, std::size_t piece, std::size_t terms) {
    const auto table = lommel::piece_tables.get(width, {piece + 1, {}}, terms);
    const lommel::Piece& one = *table->pieces[piece];
    return named("width"_a = table->width, "error"_a = lommel::piece_error(table->width), "rows"_a = listed(one.rows),
                 "magnitude"_a = one.magnitude, "largest_magnitude"_a = table->magnitude);
}

double field_bound(Doubles1 coefficients, Doubles1 amplitude, std::size_t power, double obscuration, double reach,
                   double error) {
    const RadialPupil pupil(coefficients, amplitude);
    return lommel::Field().prepare(pupil.phase, power, obscuration, reach, error);
}

// Values of U at increasing radii, few enough that some pieces are skipped; and its largest values, which enter the bounds on
// I.
Named field_values(Doubles1 coefficients, Doubles1 amplitude, std::size_t power, double obscuration, Doubles1 radii,
                   double error) {
    const std::size_t count = radii.shape(0);
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

// Error bound of values stored in single or double precision, and divided by their maximum before or after storing.
double stored_bound(double relative, bool single, bool twice) {
    return lommel::stored(relative, single ? lommel::storing<float>(twice) : lommel::storing<double>(twice));
}

Named peaks(Doubles1 coefficients, Doubles1 amplitude, double obscuration, double tol) {
    const RadialPupil pupil(coefficients, amplitude);
    const double first = lommel::first_error(pupil.phase, obscuration, tol);
    return named("likely"_a = lommel::likely_peak(pupil.phase, obscuration), "first_error"_a = first,
                 "scanned"_a = lommel::scanned_peak(pupil.phase, obscuration, first));
}

// Bounds on the part of averages that interference rings contribute, if I is approximated by mean / r^3.
Named tail_bounds(Doubles1 coefficients, Doubles1 amplitude, double obscuration, double r) {
    const RadialPupil pupil(coefficients, amplitude);
    const lommel::EnergyTail tail(pupil.phase, obscuration);
    return named("mean"_a = tail.mean(), "rings"_a = tail.rings(r), "curved"_a = tail.curved(r));
}

Out<complex, 1> fresnel_auxiliary(In<double, 1> s) {
    auto out = new_array<complex, 1>({s.shape(0)});
    released([&] {
        const auto fresnel = lommel::FresnelAuxiliary::get();
        using V = lommel::Portable::pack;
        for (std::size_t i = 0; i < s.shape(0); ++i) {
            const V at[1] = {lommel::splat<V>(s.data()[i])};
            V re[1], im[1];
            (*fresnel)(lommel::Portable{}, at, re, im);
            out.data()[i] = {re[0][0], im[0][0]};
        }
    });
    return out;
}

}  // namespace

void bindings::define_radial_tests(nb::module_& m) {
    m.def("amplitude_bounds", &amplitude_bounds, "powers"_a, "cosh"_a, "t"_a, "obscuration"_a, "raised"_a, "area"_a,
          "Of the amplitude exp(-(g_0 + g_1 t + ...)), to a power and on an inner disk.");
    m.def("series_bounds", &series_bounds, "coefficients"_a, "amplitude"_a, "power"_a, "reach"_a, "error"_a,
          "Terms and nodes of the series of t^power A exp(i Phi) up to v = reach, and bounds on what they leave.");
    m.def("ellipse_bounds", &ellipse_bounds, "pupils"_a, "amplitude"_a, "power"_a, "terms"_a, "nodes"_a,
          "Bounds on U beyond so many terms and nodes, for one pupil or for all between two.");
    m.def("window_bounds", &window_bounds, "count"_a, "reach"_a,
          "Bounds on U beyond so many Legendre terms, or degrees on the disk, whatever the pupil, up to v = reach.");
    m.def("piece_bounds", &piece_bounds, "width"_a, "piece"_a, "terms"_a,
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
    m.def("fresnel_auxiliary", &fresnel_auxiliary, "s"_a, "exp(-i s^2) int_s^inf exp(i tau^2) d tau for s >= 0.");
}
