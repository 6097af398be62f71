// What the compiled core takes its error for, term by term: no answer is made from these, tests hold them against the
// formulas of docs/certificate.md. A bound that cannot be read cannot be tested.
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "lommel/base/wide.hpp"
#include "lommel/chordal/sharp.hpp"
#include "lommel/pixels/table.hpp"
#include "lommel/radial/average_images.hpp"
#include "lommel/radial/field.hpp"
#include "lommel/special/bessel_table.hpp"
#include "lommel/special/fft.hpp"
#include "lommel/special/gridding.hpp"
#include "lommel/zernike/images.hpp"

#include "pupils.hpp"

using namespace bindings;

namespace {

using Doubles1 = In<double, 1>;
using Named = nb::typed<nb::dict, nb::str, nb::object>;

template <class... Values>
Named named(const std::pair<const char*, Values>&... entries) {
    nb::dict made;
    (void)std::initializer_list<int>{(made[entries.first] = entries.second, 0)...};
    return nb::cast<Named>(made);
}
template <class T>
std::pair<const char*, T> entry(const char* name, T value) {
    return {name, value};
}
std::vector<double> listed(const lommel::Doubles& values) { return {values.begin(), values.end()}; }

// The growth of the exponent on the ellipses of some cosh, roundings, the integral over an annulus, and values at t, of an
// amplitude raised to a power on an inner disk of that area.
Named amplitude_bounds(Doubles1 powers, Doubles1 cosh, Doubles1 t, double obscuration, double raised, double area) {
    const lommel::Amplitude amplitude = powers_of_amplitude(powers).raised(raised).scaled(area);
    nb::list growth, values;
    for (std::size_t i = 0; i < cosh.shape(0); ++i) {
        growth.append(amplitude.growth(cosh.data()[i]));
    }
    for (std::size_t i = 0; i < t.shape(0); ++i) {
        values.append(amplitude.at(t.data()[i]));
    }
    return named(entry("growth", growth), entry("sensitivity", amplitude.sensitivity()), entry("values", values),
                 entry("integral", amplitude.integral(obscuration)), entry("size", amplitude.size()),
                 entry("passive", amplitude.passive()), entry("area", lommel::Aperture(obscuration, amplitude).area));
}

// Not copied: the amplitude must outlive the phase.
lommel::Phase phase_of(const Doubles1& coefficients, const lommel::Amplitude& amplitude) {
    require(coefficients.shape(0) > 0, "coefficients must not be empty");
    return {coefficients.data(), coefficients.shape(0), &amplitude};
}

Named series_bounds(Doubles1 coefficients, Doubles1 amplitude, std::size_t power, double reach, double error) {
    require(error > 0.0 && reach >= 0.0, "reach and error must be positive");
    const lommel::Amplitude light = powers_of_amplitude(amplitude);
    const lommel::Phase phase = phase_of(coefficients, light);
    const lommel::Expansion plan({phase.coefficients, phase.terms, light, power}, reach, error);
    return named(entry("terms", plan.terms), entry("truncation", plan.truncation), entry("nodes", 2 * plan.rule->half),
                 entry("quadrature", plan.quadrature), entry("error", plan.error(phase)));
}

// Of one pupil, or of all between two.
Named ellipse_bounds(In<double, 2> pupils, Doubles1 amplitude, std::size_t power, std::size_t terms, std::size_t nodes) {
    require(pupils.shape(0) >= 1 && pupils.shape(0) <= 2 && pupils.shape(1) > 0, "pupils must have one row or two");
    const double *low = pupils.data(), *high = low + pupils.shape(1);
    const lommel::Ellipses ellipses =
        pupils.shape(0) == 1 ? lommel::Ellipses(low, pupils.shape(1), powers_of_amplitude(amplitude), power)
                             : lommel::Ellipses({low, high}, {high, high + pupils.shape(1)}, powers_of_amplitude(amplitude));
    return named(entry("tail", ellipses.tail(terms)), entry("quadrature", ellipses.quadrature(nodes, terms)));
}

// With the spacing at 1 of the numbers that tables are made with.
Named window_bounds(std::size_t count, double reach) {
    return named(entry("legendre", lommel::window_tail(count, reach)), entry("disk", lommel::disk_window_tail(count, reach)),
                 entry("spacing", static_cast<double>(std::numeric_limits<lommel::wide>::epsilon())));
}

Named piece_bounds(std::size_t width, std::size_t piece, std::size_t terms, std::size_t parity) {
    require(width < lommel::widths.size() && parity < 2 && piece < 1000 && terms < 1000, "no such piece");
    const auto table = (parity == 0 ? lommel::even_pieces : lommel::odd_pieces).get(width, {piece + 1, {}}, terms);
    const lommel::Piece& one = *table->pieces[piece];
    return named(entry("width", table->width), entry("error", lommel::piece_error(table->width)),
                 entry("ring_error", lommel::ring_error(table->width)), entry("rows", listed(one.rows)),
                 entry("magnitude", one.magnitude), entry("azimuthal", one.azimuthal),
                 entry("largest_magnitude", table->magnitude), entry("largest_azimuthal", table->azimuthal));
}

double field_bound(Doubles1 coefficients, Doubles1 amplitude, std::size_t power, double obscuration, double reach,
                   double error) {
    require(error > 0.0 && reach >= 0.0, "reach and error must be positive");
    const lommel::Amplitude light = powers_of_amplitude(amplitude);
    return lommel::Field().prepare(phase_of(coefficients, light), power, obscuration, reach, error);
}

// At these radii, rising, of which few leave pieces out; with U itself, whose largest values enter the bounds on I.
double field_values(Doubles1 coefficients, Doubles1 amplitude, std::size_t power, double obscuration, Doubles1 radii,
                    double error, Out<double, 1> re, Out<double, 1> im) {
    const std::size_t count = radii.shape(0);
    require(error > 0.0 && count > 0, "error must be positive, radii not empty");
    require(re.shape(0) == count && im.shape(0) == count, "one value a radius");
    lommel::Doubles at(radii.data(), radii.data() + count), u(count + lommel::widest_step), w(u.size());
    at.resize(u.size(), at.back());
    const lommel::Amplitude light = powers_of_amplitude(amplitude);
    lommel::Field field;
    const double bound = field.prepare(phase_of(coefficients, light), power, obscuration, {at.data(), count, 1.0}, error);
    lommel::dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
        field.evaluate(isa, at.data(), 0, count, 1.0, [&](std::size_t i, auto a, auto b) LOMMEL_INLINE_LAMBDA {
            lommel::store(u.data() + i, a);
            lommel::store(w.data() + i, b);
        });
    });
    std::copy_n(u.data(), count, re.data());
    std::copy_n(w.data(), count, im.data());
    return bound;
}

Named intensity_bounds(double peak, double error) {
    const double relative = lommel::relative_error(peak, error);
    return named(entry("relative", relative), entry("normalized", lommel::normalized_error(relative)));
}

// Of values that are stored in single precision or not, and divided by their own largest one before or after.
double stored_bound(double relative, bool single, bool twice) {
    return lommel::stored(relative, single ? lommel::storing<float>(twice) : lommel::storing<double>(twice));
}

Named peaks(Doubles1 coefficients, Doubles1 amplitude, double obscuration, double tol) {
    const lommel::Amplitude light = powers_of_amplitude(amplitude);
    const lommel::Phase phase = phase_of(coefficients, light);
    const double first = lommel::first_error(phase, obscuration, tol);
    return named(entry("likely", lommel::likely_peak(phase, obscuration)), entry("first_error", first),
                 entry("scanned", lommel::scanned_peak(phase, obscuration, first)));
}

lommel::TermPairs pairs_of(const In<std::int32_t, 1>& n, const In<std::int32_t, 1>& m, const Doubles1& c) {
    require(n.shape(0) > 0 && m.shape(0) == n.shape(0) && c.shape(0) == n.shape(0), "n, m and coefficients must match");
    std::vector<lommel::ZernikeTerm> terms;
    for (std::size_t j = 0; j < n.shape(0); ++j) {
        terms.push_back({n.data()[j], m.data()[j]});
    }
    return lommel::TermPairs(terms);
}

Named disk_bounds(In<std::int32_t, 1> n, In<std::int32_t, 1> m, Doubles1 coefficients, Doubles1 amplitude, std::size_t count) {
    const lommel::TermPairs pairs = pairs_of(n, m, coefficients);
    const lommel::DiskBounds bounds = lommel::ZernikePhase{pairs, coefficients.data(), powers_of_amplitude(amplitude)}.bounds();
    return named(entry("tail", bounds.tail(count)), entry("orders_tail", bounds.orders_tail(count)),
                 entry("distance", bounds.distance(count)));
}

// The transforms of eight rows of which the middle half is 0, but for the last pass, which is done here.
template <class Real>
std::pair<Out<complex, 2>, double> row_fft(In<complex, 2> rows) {
    constexpr std::size_t eight = lommel::fft_rows, element = lommel::fft_element;
    const std::size_t n = rows.shape(1), quarter = n / 4;
    require(rows.shape(0) == eight && n >= 16 && lommel::RowFft<Real>::length(n) == n, "eight rows of 16 2^a 3^b");
    const lommel::RowFft<Real> fft(n);
    std::vector<Real, lommel::AlignedAllocator<Real>> given(n * element), other(n * element);
    for (std::size_t i = 0; i < eight; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            given[j * element + i] = static_cast<Real>(rows.data()[i * n + j].real());
            given[j * element + eight + i] = static_cast<Real>(rows.data()[i * n + j].imag());
        }
    }
    auto out = new_array<complex, 2>({eight, n});
    const Real* found = nullptr;
    lommel::dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA { found = fft.run(isa, given.data(), other.data()); });
    for (std::size_t i = 0; i < eight; ++i) {
        for (std::size_t l = 0; l < n; ++l) {
            const complex turns[4] = {{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}};
            complex sum = 0.0;
            for (std::size_t j = 0; j < 4; ++j) {
                const Real* const y = found + (l % quarter + j * quarter) * element + i;
                sum += complex(y[0], y[eight]) * turns[j * (l / quarter) % 4];
            }
            out.data()[i * n + l] = sum;
        }
    }
    return {out, fft.rounding() * lommel::roundoff<Real>};
}

// Of a kernel for so many taps: values at x, transforms and bounds on aliases at omega, and those of taps.
Named gridding_bounds(std::size_t taps, double oversampling, double step, Doubles1 x, Doubles1 omega) {
    const lommel::GriddingKernel kernel = lommel::GriddingKernel::of(taps, oversampling);
    nb::list values, transforms, aliases;
    for (std::size_t i = 0; i < x.shape(0); ++i) {
        values.append(kernel(x.data()[i]));
    }
    for (std::size_t i = 0; i < omega.shape(0); ++i) {
        transforms.append(kernel.transform(omega.data()[i]));
        aliases.append(kernel.aliases(omega.data()[i]));
    }
    const auto doubles = std::make_unique<lommel::DoubleTaps>(kernel);
    nb::list polynomials;  // from the highest power down, a row each
    for (const auto& row : doubles->at) {
        polynomials.append(std::vector<double>(row, row + taps));
    }
    return named(entry("beta", kernel.beta()), entry("values", values), entry("transforms", transforms),
                 entry("aliases", aliases), entry("aliasing", kernel.aliasing(step)), entry("weight", kernel.weight()),
                 entry("chain", kernel.chain()), entry("taps", polynomials), entry("tap_error", doubles->error));
}

Named zernike_bounds(In<std::int32_t, 1> n, In<std::int32_t, 1> m, Doubles1 coefficients, Doubles1 amplitude, double reach,
                     double error) {
    const lommel::TermPairs pairs = pairs_of(n, m, coefficients);
    const lommel::ZernikePhase phase{pairs, coefficients.data(), powers_of_amplitude(amplitude)};
    const lommel::DiskExpansion plan(phase.bounds(), reach, error);
    return named(entry("degrees", plan.degrees), entry("orders", plan.orders), entry("exact", plan.rule->degree),
                 entry("rings", plan.rule->rings), entry("quarter", plan.rule->quarter), entry("truncation", plan.truncation),
                 entry("quadrature", plan.quadrature), entry("error", plan.error(phase)));
}

// Of one piece, for `wanted` in U, as an image asks for it.
Named zernike_field_bounds(In<std::int32_t, 1> n, In<std::int32_t, 1> m, Doubles1 outer, Doubles1 inner, double obscuration,
                           Doubles1 amplitude, double reach, double error, double wanted, std::size_t piece,
                           std::size_t groups) {
    const lommel::Amplitude light = powers_of_amplitude(amplitude);
    lommel::ZernikeField field;
    const lommel::TermPairs pairs = pairs_of(n, m, outer);
    require(inner.shape(0) == outer.shape(0), "both disks must have all terms");
    field.expand({pairs, outer.data(), light}, {pairs, inner.data(), light.scaled(obscuration * obscuration)}, obscuration,
                 reach, error);
    const double expanded = field.base();
    std::size_t pieces = 0;
    field.prepare(wanted, 1, [&](std::size_t count) {
        std::vector<std::size_t> all(pieces = count);
        std::iota(all.begin(), all.end(), std::size_t{0});
        return all;
    });
    require(piece < pieces, "no such piece");
    const lommel::PiecePlan plan = field.plan(piece, wanted, groups);
    nb::list singles;
    lommel::Doubles ring;
    for (std::size_t r = 0; r < plan.rings; ++r) {
        lommel::dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA { field.ring(isa, plan, piece, r, ring); });
        singles.append(lommel::single_rounding(plan, ring));
    }
    return named(entry("expanded", expanded), entry("prepared", field.base()), entry("width", field.width()),
                 entry("rings", plan.rings), entry("error", plan.error), entry("singles", singles));
}

double single_rounding(In<std::int64_t, 1> orders, std::size_t rows, Doubles1 coefficients) {
    lommel::PiecePlan plan;
    for (std::size_t i = 0; i < orders.shape(0); ++i) {
        plan.orders.add(static_cast<std::size_t>(orders.data()[i]));
    }
    plan.rows.resize(rows);
    return lommel::single_rounding(plan, {coefficients.data(), coefficients.data() + coefficients.shape(0)});
}

// One pupil as the engines of the whole disk take it: its terms, what they are on both disks, and what that loses.
Named disk_stack(In<std::int64_t, 2> terms, Doubles1 edge, double obscuration, double row, double column, double step,
                 bool moved) {
    lommel::DiskStack stack(terms_of(terms, edge.size()), edge.data(), 1, obscuration, {});
    if (moved) {
        stack.move_axes({1, 1, row, column, step});
    }
    stack.shrink();
    std::vector<double> n, m;
    for (const lommel::ZernikeTerm& term : stack.terms) {
        n.push_back(term.n);
        m.push_back(term.m);
    }
    return named(entry("n", n), entry("m", m), entry("outer", stack.outer), entry("inner", stack.inner),
                 entry("lost", stack.lost), entry("row", moved ? static_cast<double>(stack.rows[0]) : row),
                 entry("column", moved ? static_cast<double>(stack.columns[0]) : column));
}

// Over a window of v from `low` to `high` in x and on the axis in y.
Named chordal_bounds(In<std::int64_t, 2> terms, Doubles1 coefficients, Doubles1 amplitude, double low, double high,
                     std::size_t chords) {
    require(low <= high && chords >= 1, "low must be below high, chords positive");
    const lommel::TermPairs pairs(terms_of(terms, coefficients.size()));
    lommel::ChordBound bound;
    bound.prepare(pairs, coefficients.data(), powers_of_amplitude(amplitude), {low, high, 0.0, 0.0});
    return named(entry("quadrature", bound.bound(chords)), entry("rounding", bound.rounding(chords)),
                 entry("variance", bound.variance()));
}

double chordal_growth(In<std::int64_t, 2> terms, Doubles1 coefficients, double b) {
    require(b > 0.0 && b < 5.0, "b must be above 0 and below 5");
    const lommel::SharpTable table(terms_of(terms, coefficients.size()), b);
    double found[lommel::row_lanes];
    lommel::dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
        constexpr std::size_t lanes = decltype(isa)::lanes;
        lommel::Doubles given(2 * table.pairs.size() * lanes), room(2 * table.harmonics * lanes);
        lommel::sharp_lane(table, coefficients.data(), 0, lanes, given.data());
        lommel::store(found, lommel::sharp_size(isa, table, given.data(), room.data()));
    });
    return found[0];
}

// Of a table for the averages over the pixels of a window, its axis at (center_y, center_x); each ring as (the least
// and the largest distance of its pixels, the same of its nodes, their count, whether they are of an even function, whether
// pixels have their own weights).
Named pixel_bounds(std::size_t height, std::size_t width, double center_y, double center_x, double step, bool integrate,
                   int level) {
    require(height > 0 && height <= 1000 && width > 0 && width <= 1000, "windows must have 1 to 1000 pixels a side");
    require(step > 0.0 && level >= 1 && level <= 15, "step must be positive, level from 1 to 15");
    const auto table = lommel::PixelTable::get({height, width, center_y, center_x, step, integrate}, level, 1);
    nb::list rings;
    for (const auto& ring : table->rings) {
        rings.append(nb::make_tuple(ring.middle - ring.half, ring.middle + ring.half, ring.nodes.low, ring.nodes.high,
                                    ring.nodes.count, ring.nodes.even, ring.direct));
    }
    return named(entry("gauss", table->gauss), entry("harmonics", table->harmonics), entry("rings", rings),
                 entry("error", table->error), entry("of_nodes", table->of_nodes), entry("of_grid", table->of_grid),
                 entry("rounding", table->rounding), entry("penalty", listed(table->penalty)));
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
    return named(entry("gauss", table->gauss), entry("harmonics", table->harmonics), entry("degree", table->degree),
                 entry("error", table->error), entry("of_nodes", table->of_nodes), entry("of_grid", table->of_grid),
                 entry("rounding", table->rounding), entry("penalty", listed(table->penalty)),
                 entry("radii", std::vector<double>(table->radii.data(), table->radii.data() + table->count)));
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

// The tilts of one pupil, (along rows, along columns), whose axis is at `center`, where that of the window is elsewhere.
Named tilted_stack(In<std::int64_t, 2> terms, Doubles1 edge, In<double, 1> center, double row, double column, double step) {
    require(center.shape(0) == 2, "center must be a row and a column");
    lommel::DiskStack stack(terms_of(terms, edge.size()), edge.data(), 1, 0.0, {});
    stack.tilt_to(center.data(), {1, 1, row, column, step});
    std::vector<double> tilts(2, 0.0);
    for (std::size_t j = 0; j < stack.terms.size(); ++j) {
        if (stack.terms[j].n == 1) {
            tilts[stack.terms[j].m == 1 ? 1 : 0] = stack.outer[j];
        }
    }
    return named(entry("tilts", tilts), entry("lost", stack.lost));
}

}  // namespace

void bindings::define_bounds(nb::module_& m) {
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
          "re"_a.noconvert(), "im"_a.noconvert(), "The same at radii that rise, and U there.");
    m.def("intensity_bounds", &intensity_bounds, "peak"_a, "error"_a,
          "Bounds on the error of I over its exact peak, and of values divided by their own, from that of U.");
    m.def("stored_bound", &stored_bound, "relative"_a, "single"_a, "twice"_a,
          "Bound on the error of values over their peak when they are stored.");
    m.def("peaks", &peaks, "coefficients"_a, "amplitude"_a, "obscuration"_a, "tol"_a,
          "The guess at the peak of |U|, the first error asked of U, and the largest I on the scan.");
    m.def("disk_bounds", &disk_bounds, "n"_a, "m"_a, "coefficients"_a, "amplitude"_a, "count"_a,
          "Bounds on U beyond so many degrees and orders, and on the distance from polynomials of that degree.");
    m.def("zernike_bounds", &zernike_bounds, "n"_a, "m"_a, "coefficients"_a, "amplitude"_a, "reach"_a, "error"_a,
          "Degrees, orders and rule of a Zernike series, and bounds on what they leave.");
    m.def("zernike_field_bounds", &zernike_field_bounds, "n"_a, "m"_a, "outer"_a, "inner"_a, "obscuration"_a, "amplitude"_a,
          "reach"_a, "error"_a, "wanted"_a, "piece"_a, "groups"_a,
          "Bounds on the error of U: of the series, of every piece, of one, and of its rings in single precision.");
    m.def("row_fft", &row_fft<double>, "rows"_a, "Their transforms, and the bound on an error over the sum of the magnitudes.");
    m.def("row_fft_single", &row_fft<float>, "rows"_a, "The same in single precision.");
    m.def("gridding_bounds", &gridding_bounds, "taps"_a, "oversampling"_a, "step"_a, "x"_a, "omega"_a,
          "A kernel that interpolates between equal steps, its transform, and bounds on what it does.");
    m.def("single_rounding", &single_rounding, "orders"_a, "rows"_a, "coefficients"_a,
          "Bound on what single precision does to U on a ring.");
    m.def("disk_stack", &disk_stack, "terms"_a, "edge"_a, "obscuration"_a, "row"_a, "column"_a, "step"_a, "moved"_a,
          "A wavefront on the whole disk and on the obscured one, and what roundings do to U on the way.");
    m.def("chordal_bounds", &chordal_bounds, "terms"_a, "coefficients"_a, "amplitude"_a, "low"_a, "high"_a, "chords"_a,
          "Bounds on the error in U of the chordal Gauss rule for v from low to high along x.");
    m.def("chordal_growth", &chordal_growth, "terms"_a, "coefficients"_a, "b"_a,
          "Bound on the imaginary part of the phase, without tilt, at a distance b from real angles on any chord.");
    m.def("anywhere_bounds", &anywhere_bounds, "pitch"_a, "averages"_a, "farthest"_a, "level"_a,
          "Degree, harmonics and radii of windows around any axis, and bounds on what they leave and magnify.");
    m.def("anywhere_values", &anywhere_values, "profile"_a, "center_y"_a, "center_x"_a, "pitch"_a, "averages"_a, "farthest"_a,
          "level"_a, "out"_a.noconvert(), "The pixels of one, and the units of roundoff that their sums may be off by.");
    m.def("tilted_stack", &tilted_stack, "terms"_a, "edge"_a, "center"_a, "row"_a, "column"_a, "step"_a,
          "A wavefront whose axis is moved by a tilt, and what that loses.");
    m.def("pixel_bounds", &pixel_bounds, "height"_a, "width"_a, "center_y"_a, "center_x"_a, "step"_a, "integrate"_a, "level"_a,
          "Rings, nodes and harmonics of a window whose pixels average, and bounds on what they leave and magnify.");
}
