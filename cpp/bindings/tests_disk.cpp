// Error bounds for pupils with arbitrary aberrations.
#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "lommel/chordal/error_samples.hpp"
#include "lommel/special/fft.hpp"
#include "lommel/special/gridding.hpp"
#include "lommel/zernike/polar_zones.hpp"

#include "tests.hpp"

using namespace bindings;

namespace {

Named disk_bounds(Terms terms, Doubles1 coefficients, Doubles1 amplitude, std::size_t count) {
    const lommel::TermPairs pairs(terms_of(terms, coefficients.size()));
    const lommel::DiskBounds bounds = lommel::ZernikePhase{pairs, coefficients.data(), powers_of_amplitude(amplitude)}.bounds();
    return named("tail"_a = bounds.tail(count), "orders_tail"_a = bounds.orders_tail(count),
                 "distance"_a = bounds.distance(count));
}

// Transform of eight rows whose middle half is 0, without the last pass: [element][re, im][row].
template <class Real>
std::pair<Out<Real, 3>, double> row_fft(In<Real, 3> rows) {
    const std::size_t n = rows.shape(0);
    const lommel::RowFft<Real> fft(n);
    lommel::Aligned<Real> given(rows.data(), rows.data() + rows.size()), other(rows.size());
    auto out = new_array<Real, 3>({n, 2, lommel::fft_rows});
    lommel::dispatch(
        [&](auto isa) LOMMEL_INLINE_LAMBDA { std::copy_n(fft.run(isa, given.data(), other.data()), rows.size(), out.data()); });
    return {out, fft.rounding() * lommel::roundoff<Real>};
}

// For the kernel with `taps` taps: its values at x; its transform and the bound on aliases at omega; and the errors of its
// taps.
Named gridding_bounds(std::size_t taps, double oversampling, double step, Doubles1 x, Doubles1 omega) {
    const lommel::GriddingKernel kernel = lommel::GriddingKernel::of(taps, oversampling);
    const auto doubles = std::make_unique<lommel::DoubleTaps>(kernel);
    const lommel::CoarseTaps coarse(kernel);
    // Polynomials, highest power first, one row per power.
    const auto polynomials = [&](const auto& of) {
        nb::list rows;
        for (const auto& row : of.at) {
            rows.append(std::vector<double>(row, row + std::min(taps, of.taps)));
        }
        return rows;
    };
    return named("beta"_a = kernel.beta(), "values"_a = each(x, kernel),
                 "transforms"_a = each(omega, [&](double w) { return kernel.transform(w); }),
                 "aliases"_a = each(omega, [&](double w) { return kernel.aliases(w); }), "aliasing"_a = kernel.aliasing(step),
                 "weight"_a = kernel.weight(), "chain"_a = kernel.chain(), "taps"_a = polynomials(*doubles),
                 "tap_error"_a = doubles->error, "coarse_taps"_a = polynomials(coarse), "coarse_error"_a = coarse.error);
}

Named zernike_bounds(Terms terms, Doubles1 coefficients, Doubles1 amplitude, double reach, double error) {
    const lommel::TermPairs pairs(terms_of(terms, coefficients.size()));
    const lommel::ZernikePhase phase{pairs, coefficients.data(), powers_of_amplitude(amplitude)};
    const lommel::DiskExpansion plan(phase, reach, error);
    return named("degrees"_a = plan.degrees, "orders"_a = plan.orders, "exact"_a = plan.rule->degree,
                 "rings"_a = plan.rule->rings, "angles"_a = plan.rule->fft.n, "transform"_a = plan.rule->rounding(),
                 "truncation"_a = plan.truncation, "quadrature"_a = plan.quadrature, "error"_a = plan.error(phase),
                 "curve"_a = plan.curve, "saved"_a = plan.saved);
}

Named sampled_growth(Terms terms, Doubles1 coefficients, std::size_t curve) {
    const lommel::TermPairs pairs(terms_of(terms, coefficients.size()));
    const lommel::GrowthTable table(pairs, curve);
    lommel::SampledGrowth found{};
    lommel::dispatch([&](auto isa)
                         LOMMEL_INLINE_LAMBDA { found = lommel::sampled_growth(isa, table, pairs, coefficients.data()); });
    return named("mean"_a = found.mean, "margin"_a = found.margin);
}

// Expansion of a pupil, and errors of the field on the circles of a window from the axis to v = reach, in pixels of pitch `step`.
Named circle_errors(Terms terms, Doubles1 outer, Doubles1 inner, double obscuration, Doubles1 amplitude, double reach,
                    double error, double step, double tol) {
    const lommel::Amplitude light = powers_of_amplitude(amplitude);
    const lommel::TermPairs pairs(terms_of(terms, outer.size()));
    lommel::ZernikeField field;
    field.expand({pairs, outer.data(), light}, {pairs, inner.data(), light.scaled(obscuration * obscuration)}, obscuration,
                 reach, error);
    lommel::PolarZones zones;
    const lommel::PolarPupil pupil(field);
    const bool likely = zones.plan(pupil, step, 0, std::llround(reach * reach / (step * step)), tol, 0.0, 1);
    zones.fill(pupil, 1);
    nb::list errors;
    for (std::size_t z = 0; z < zones.size(); ++z) {
        errors.append(zones[z].errors);
    }
    return named("expanded"_a = field.base(), "likely"_a = likely, "errors"_a = errors);
}

// One pupil as the disk engines receive it: terms, coefficients on both disks, and the error of this conversion.
Named disk_stack(Terms terms, Doubles1 edge, double obscuration, double row, double column, double step, bool moved) {
    lommel::DiskStack stack(terms_of(terms, edge.size()), edge.data(), 1, obscuration, {});
    if (moved) {
        stack.move_axes({1, 1, row, column, step});
    }
    stack.shrink();
    nb::list used;
    for (const lommel::ZernikeTerm& term : stack.terms) {
        used.append(nb::make_tuple(term.n, term.m));
    }
    return named("terms"_a = used, "outer"_a = stack.outer, "inner"_a = stack.inner, "lost"_a = stack.lost,
                 "row"_a = moved ? static_cast<double>(stack.rows[0]) : row,
                 "column"_a = moved ? static_cast<double>(stack.columns[0]) : column);
}

// Bounds for a window with v from `low` to `high` along x, on the axis along y: exponents on all curves.
Named chordal_bounds(Terms terms, Doubles1 coefficients, Doubles1 amplitude, double low, double high) {
    const lommel::TermPairs pairs(terms_of(terms, coefficients.size()));
    lommel::ChordBound bound(pairs, powers_of_amplitude(amplitude), {low, high, 0.0, 0.0});
    bound.prepare(coefficients.data());
    std::vector<double> exponents[2], bends[2];
    for (const lommel::Sum sum : {lommel::Sum::chords, lommel::Sum::nodes}) {
        for (std::size_t k = 0; k < lommel::ChordCurves::count; ++k) {
            exponents[sum == lommel::Sum::nodes].push_back(bound.line(sum, k, bound.size(sum, k)).exponent);
            bends[sum == lommel::Sum::nodes].push_back(bound.bend(sum, k));
        }
    }
    return named("chords"_a = exponents[0], "nodes"_a = exponents[1], "chords_bend"_a = bends[0], "nodes_bend"_a = bends[1],
                 "rounding"_a = bound.rounding(), "variance"_a = bound.variance());
}

// One ChordLine: its bound for a number of nodes, the number for an error, the best line for that error, and rounding.
Named chordal_line(bool nodes, std::size_t curve, double exponent, std::size_t size, double error, std::size_t degree) {
    const lommel::Sum sum = nodes ? lommel::Sum::nodes : lommel::Sum::chords;
    const lommel::ChordLine line = lommel::ChordLine{curve, exponent}.times(degree);
    return named("bound"_a = line.bound(sum, size), "enough"_a = line.enough(sum, error));
}

Named chordal_rounding(std::size_t chords, std::size_t nodes, std::size_t terms, std::size_t degree) {
    return named(
        "double"_a = lommel::ChordBound::rounding(chords, nodes),
        "single"_a = lommel::ChordBound::single_rounding(static_cast<double>(chords), static_cast<double>(nodes), terms),
        "factor"_a = lommel::ChordBound::factor_rounding(degree, false),
        "single_factor"_a = lommel::ChordBound::factor_rounding(degree, true));
}

// Cosine and sine of multiples of 2^-32 turns, alternating.
std::vector<double> turned_waves(In<std::uint32_t, 1> turns) {
    std::vector<double> found;
    lommel::dispatch_widest([&](auto isa) LOMMEL_INLINE_LAMBDA {
        using I = decltype(isa);
        constexpr std::size_t lanes = 2 * I::lanes;
        for (std::size_t i = 0; i + lanes <= turns.size(); i += lanes) {
            typename I::floats sine, cosine;
            lommel::sincos_turns(lommel::load<typename I::turns>(turns.data() + i), sine, cosine);
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                found.push_back(static_cast<double>(cosine[lane]));
                found.push_back(static_cast<double>(sine[lane]));
            }
        }
    });
    return found;
}

Named chordal_mean(Terms terms, Doubles1 coefficients, std::size_t curve, bool nodes, Doubles1 window, bool lone) {
    const lommel::VBox box{window.data()[0], window.data()[1], window.data()[2], window.data()[3]};
    const std::vector<lommel::ZernikeTerm> list = terms_of(terms, coefficients.size());
    const lommel::Sum sum = nodes ? lommel::Sum::nodes : lommel::Sum::chords;
    const lommel::SharpTable table(list, sum, curve, box);
    const lommel::TermPairs pairs(list);
    lommel::ChordBound bound(pairs, lommel::even_light, box);
    bound.prepare(coefficients.data());
    float top[2 * lommel::row_lanes], mean[2 * lommel::row_lanes];
    lommel::dispatch_widest([&](auto isa) LOMMEL_INLINE_LAMBDA {
        constexpr std::size_t lanes = 2 * decltype(isa)::lanes;
        const std::size_t stride = lone ? 1 : lanes;
        lommel::Floats given(list.size() * stride), room(table.room() * lanes);
        for (std::size_t j = 0; j < list.size(); ++j) {
            given[j * stride] = static_cast<float>(coefficients.data()[table.classes.order[j]]);
        }
        if (lone) {
            lommel::sharp_means<true>(isa, table, given.data(), room.data(), top, mean);
        } else {
            lommel::sharp_means<false>(isa, table, given.data(), room.data(), top, mean);
        }
    });
    return named("mean"_a = table.logarithm(top[0], mean[0]),
                 "margin"_a = table.margin(bound.bend(sum, curve), coefficients.data()));
}

// Tilts (along rows, along columns) of one pupil whose axis `center` differs from that of the window.
Named tilted_stack(Terms terms, Doubles1 edge, In<double, 1> center, double row, double column, double step) {
    lommel::DiskStack stack(terms_of(terms, edge.size()), edge.data(), 1, 0.0, {});
    stack.tilt_to(center.data(), {1, 1, row, column, step});
    std::vector<double> tilts(2, 0.0);
    for (std::size_t j = 0; j < stack.terms.size(); ++j) {
        if (stack.terms[j].n == 1) {
            tilts[stack.terms[j].m == 1 ? 1 : 0] = stack.outer[j];
        }
    }
    return named("tilts"_a = tilts, "lost"_a = stack.lost);
}

}  // namespace

void bindings::define_disk_tests(nb::module_& m) {
    m.def("disk_bounds", &disk_bounds, "terms"_a, "coefficients"_a, "amplitude"_a, "count"_a,
          "Bounds on U beyond so many degrees and orders, and on the distance from polynomials of that degree.");
    m.def("zernike_bounds", &zernike_bounds, "terms"_a, "coefficients"_a, "amplitude"_a, "reach"_a, "error"_a,
          "Degrees, orders and rule of a Zernike series, and bounds on what they leave.");
    m.def("sampled_growth", &sampled_growth, "terms"_a, "coefficients"_a, "curve"_a,
          "The logarithm of the mean of a pupil function on a curve, by samples, and what it may be more.");
    m.def("row_fft", &row_fft<double>, "rows"_a,
          "Their transforms but for the last pass, and the bound on an error over the sum of the magnitudes.");
    m.def("row_fft_single", &row_fft<float>, "rows"_a, "The same in single precision.");
    m.def("gridding_bounds", &gridding_bounds, "taps"_a, "oversampling"_a, "step"_a, "x"_a, "omega"_a,
          "A kernel that interpolates between equal steps, its transform, and bounds on what it does.");
    m.def("circle_errors", &circle_errors, "terms"_a, "outer"_a, "inner"_a, "obscuration"_a, "amplitude"_a, "reach"_a,
          "error"_a, "step"_a, "tol"_a, "Bounds on U of an expansion, and of each circle that a window takes.");
    m.def("disk_stack", &disk_stack, "terms"_a, "edge"_a, "obscuration"_a, "row"_a, "column"_a, "step"_a, "moved"_a,
          "A wavefront on the whole disk and on the obscured one, and what roundings do to U on the way.");
    m.def("chordal_bounds", &chordal_bounds, "terms"_a, "coefficients"_a, "amplitude"_a, "low"_a, "high"_a,
          "Bounds on the error in U of the chordal Gauss rule for v from low to high along x.");
    m.def("chordal_line", &chordal_line, "nodes"_a, "curve"_a, "exponent"_a, "size"_a, "error"_a, "degree"_a = 0,
          "The bound by one curve on the error in U of a sum over chords, or over nodes, of that size; and the size for an "
          "error. Of U, or of the field of P times a term of some degree.");
    m.def("chordal_rounding", &chordal_rounding, "chords"_a, "nodes"_a, "terms"_a, "degree"_a = 0,
          "What the sums of the chordal rule round, and what single precision adds; and what a factor of some degree adds to "
          "either.");
    m.def("turned_waves", &turned_waves, "turns"_a, "Cosine and sine, in floats, of each multiple of 2^-32 turns.");
    m.def(
        "chordal_mean", &chordal_mean, "terms"_a, "coefficients"_a, "curve"_a, "nodes"_a, "window"_a, "lone"_a,
        "Logarithm of the mean modulus of the integrand on a curve for the sum over chords, or over nodes, by samples, and "
        "what it may be beyond that; the window is left, right, top and bottom in v; vectors are of samples for a lone pupil.");
    m.def("tilted_stack", &tilted_stack, "terms"_a, "edge"_a, "center"_a, "row"_a, "column"_a, "step"_a,
          "A wavefront whose axis is moved by a tilt, and what that loses.");
}
