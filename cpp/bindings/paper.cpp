// The paper's closed form, and Huygens' superposition.
#include <algorithm>

#include "lommel/paper/closed_form.hpp"
#include "lommel/paper/huygens.hpp"

#include "python.hpp"

using namespace bindings;

namespace {

Out<complex, 1> huygens_sum(In<double, 1> x, In<double, 1> y, In<complex, 1> amplitude, In<double, 1> sx, In<double, 1> sy,
                            double distance, double wavenumber) {
    require(x.shape(0) == y.shape(0) && x.shape(0) == amplitude.shape(0), "x, y and amplitude must match");
    require(sx.shape(0) == sy.shape(0), "sx and sy must match");
    auto out = new_array<complex, 1>({sx.shape(0)});
    released([&] {
        lommel::huygens_sum(x.data(), y.data(), amplitude.data(), x.shape(0), sx.data(), sy.data(), sx.shape(0), distance,
                            wavenumber, out.data());
    });
    return out;
}

Out<complex, 1> closed_form_field(In<double, 1> edges, In<double, 1> alpha, In<double, 1> beta, In<double, 1> gamma,
                                  double transition, double ratio, std::size_t terms, In<double, 1> v) {
    const std::size_t pieces = alpha.shape(0);
    require(pieces > 0 && edges.shape(0) == pieces + 1 && beta.shape(0) == pieces && gamma.shape(0) == pieces,
            "alpha, beta and gamma must have one value a piece, edges one more");
    require(transition > 0.0 && ratio > 1.0 + 1e-6 && ratio < 10.0, "transition must be positive, ratio from 1 to 10");
    require(terms >= 1 && terms <= 40, "terms must be from 1 to 40");
    require_radii(v);
    const double reach = v.size() == 0 ? 0.0 : *std::max_element(v.data(), v.data() + v.size());
    auto out = new_array<complex, 1>({v.shape(0)});
    released([&] {
        const lommel::HankelPieces hankel(transition, ratio, reach, terms);
        const lommel::ClosedFormField field({edges.data(), alpha.data(), beta.data(), gamma.data(), pieces}, hankel);
        for (std::size_t i = 0; i < v.shape(0); ++i) {
            lommel::look();
            out.data()[i] = field(v.data()[i]);
        }
    });
    return out;
}

Out<double, 1> chebyshev_intensity(In<complex, 2> pieces, double width, In<double, 1> v) {
    require(pieces.shape(0) > 0 && pieces.shape(1) == 16, "pieces must have the shape (pieces, 16)");
    require(width > 0.0, "width must be positive");
    for (std::size_t i = 0; i < v.shape(0); ++i) {
        require(v.data()[i] >= 0.0 && std::isfinite(v.data()[i]), "v must be at least 0 and finite");
    }
    auto out = new_array<double, 1>({v.shape(0)});
    released([&] { lommel::chebyshev_intensity(pieces.data(), pieces.shape(0), width, v.data(), v.shape(0), out.data()); });
    return out;
}

}  // namespace

void bindings::define_paper(nb::module_& m) {
    m.def("huygens_sum", &huygens_sum, "x"_a, "y"_a, "amplitude"_a, "sx"_a, "sy"_a, "distance"_a, "wavenumber"_a,
          "Sum of spherical wavelets from sources (x, y, 0) at sensor points (sx, sy, distance).");
    m.def("closed_form_field", &closed_form_field, "edges"_a, "alpha"_a, "beta"_a, "gamma"_a, "transition"_a, "ratio"_a,
          "terms"_a, "v"_a,
          "U of the phase alpha R^2 + beta R + gamma on pieces, by Hankel's expansion on pieces that grow by ratio.");
    m.def("chebyshev_intensity", &chebyshev_intensity, "pieces"_a, "width"_a, "v"_a,
          "|U|^2 at v from the Chebyshev coefficients of U on pieces.");
}
