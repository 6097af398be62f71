// The closed form of the paper, and Huygens' superposition.

#include "lommel/paper/closed_form.hpp"
#include "lommel/paper/huygens.hpp"

#include "python.hpp"

using namespace bindings;

namespace {

Out<complex, 1> huygens_sum(In<double, 1> x, In<double, 1> y, In<complex, 1> amplitude, In<double, 1> sx, In<double, 1> sy,
                            double distance, double wavenumber) {
    auto out = new_array<complex, 1>({sx.shape(0)});
    released([&] {
        lommel::huygens_sum(x.data(), y.data(), amplitude.data(), x.shape(0), sx.data(), sy.data(), sx.shape(0), distance,
                            wavenumber, out.data());
    });
    return out;
}

lommel::FresnelForm fresnel_form(std::size_t terms, In<complex, 1> table) { return {terms, {table.data(), table.shape(0)}}; }

Out<complex, 2> chirp_moments(double a, In<double, 1> b, In<double, 1> low, In<double, 1> high, std::size_t terms,
                              In<complex, 1> table) {
    const lommel::FresnelForm form = fresnel_form(terms, table);
    auto out = new_array<complex, 2>({3, b.shape(0)});
    released([&] { lommel::chirp_moments(form, a, b.data(), low.data(), high.data(), b.shape(0), out.data()); });
    return out;
}

// Edges of the pieces; alpha, beta and the factor of each, [pupil][piece].
using PhaseFields = std::tuple<In<double, 1>, In<double, 2>, In<double, 2>, In<complex, 2>>;
// First |x| of each quadratic for x J0(x), its coefficients, and the number of terms of the power series below.
using BesselFields = std::tuple<In<double, 1>, In<complex, 2>, std::size_t>;
// Number of terms of the error function, and its table.
using ErfFields = std::tuple<std::size_t, In<complex, 1>>;

Out<complex, 2> closed_form_fields(PhaseFields phase, BesselFields bessel, ErfFields erf, In<double, 1> v, int threads) {
    const auto& [edges, alpha, beta, turns] = phase;
    const auto& [starts, coefficients, series] = bessel;
    const std::size_t pupils = alpha.shape(0), pieces = alpha.shape(1);
    require_radii(v);
    const lommel::FresnelForm form = fresnel_form(std::get<0>(erf), std::get<1>(erf));
    auto out = new_array<complex, 2>({pupils, v.shape(0)});
    const lommel::PhasePieces pieces_of{edges.data(), alpha.data(), beta.data(), turns.data(), pieces};
    const lommel::BesselExponentials quadratics{starts.data(), coefficients.data(), starts.shape(0), series};
    released(
        [&] { lommel::closed_form_fields(pieces_of, pupils, quadratics, form, v.data(), v.shape(0), threads, out.data()); });
    return out;
}

Out<complex, 2> polynomial_fields(In<complex, 3> pieces, double start, double width, In<double, 1> v, int threads) {
    auto out = new_array<complex, 2>({pieces.shape(0), v.shape(0)});
    released([&] {
        lommel::polynomial_fields(pieces.data(), pieces.shape(0), pieces.shape(1), pieces.shape(2), start, width, v.data(),
                                  v.shape(0), threads, out.data());
    });
    return out;
}

}  // namespace

void bindings::define_paper(nb::module_& m) {
    m.def("huygens_sum", &huygens_sum, "x"_a, "y"_a, "amplitude"_a, "sx"_a, "sy"_a, "distance"_a, "wavenumber"_a,
          "Sum of spherical wavelets from sources (x, y, 0) at sensor points (sx, sy, distance).");
    m.def("chirp_moments", &chirp_moments, "a"_a, "b"_a, "low"_a, "high"_a, "terms"_a, "table"_a,
          "int_low^high R^m exp(i (a R^2 + b R)) dR for m = 0, 1, 2.");
    m.def("closed_form_fields", &closed_form_fields, "phase"_a, "bessel"_a, "erf"_a, "v"_a, "threads"_a,
          "U of the phases alpha R^2 + beta R on pieces, where turns are factors, by quadratics for x J0(x) beyond a power "
          "series.");
    m.def("polynomial_fields", &polynomial_fields, "pieces"_a, "start"_a, "width"_a, "v"_a, "threads"_a,
          "U at rising v from the coefficients of U on pieces.");
}
