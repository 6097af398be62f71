// Special functions, each with a published source.
#include <vector>

#include "lommel/special/bessel.hpp"
#include "lommel/special/fft.hpp"
#include "lommel/special/least_squares.hpp"
#include "lommel/special/legendre.hpp"

#include "python.hpp"

using namespace bindings;

namespace {

// Array with a row for each v, filled by write(v, row).
template <class Write>
Out<double, 2> rows_of(const In<double, 1>& v, std::size_t count, const Write& write) {
    require_radii(v);
    auto out = new_array<double, 2>({v.shape(0), count});
    released([&] {
        for (std::size_t i = 0; i < v.shape(0); ++i) {
            lommel::look();
            write(v.data()[i], out.data() + i * count);
        }
    });
    return out;
}

Out<double, 2> bessel_sequence(In<double, 1> v, std::size_t count) {
    return rows_of(v, count, [&](double at, double* row) { lommel::bessel_sequence(at, count, row); });
}

Out<double, 2> legendre_transforms(In<double, 1> v, std::size_t terms) {
    std::vector<double> scratch;
    return rows_of(v, terms, [&](double at, double* row) { lommel::legendre_transforms(at, terms, row, scratch); });
}

std::pair<Out<double, 1>, Out<double, 1>> gauss_legendre(std::size_t n) {
    require(n > 0 && n <= 20000, "n must be from 1 to 20000");  // the time grows with the square, to one second at this size
    auto nodes = new_array<double, 1>({n});
    auto weights = new_array<double, 1>({n});
    released([&] { lommel::gauss_legendre(n, nodes.data(), weights.data()); });
    return {nodes, weights};
}

Out<double, 2> least_squares(In<double, 2> matrix, In<double, 2> wanted) {
    const std::size_t rows = matrix.shape(0), unknowns = matrix.shape(1), sides = wanted.shape(1);
    auto found = new_array<double, 2>({unknowns, sides});
    released([&] { lommel::least_squares(rows, unknowns, sides, matrix.data(), wanted.data(), found.data()); });
    return found;
}

}  // namespace

void bindings::define_special(nb::module_& m) {
    m.def("bessel_sequence", &bessel_sequence, "v"_a, "count"_a, "J_0 .. J_{count-1} at each v >= 0.");
    m.def("fft_length", &lommel::RowFft<double>::length, "least"_a, "The next length that transforms over angles have.");
    m.def("legendre_transforms", &legendre_transforms, "v"_a, "terms"_a,
          "2 (-1)^n J_{2n+1}(v) / v for n < terms, at each v >= 0.");
    m.def("gauss_legendre", &gauss_legendre, "n"_a, "Nodes and weights on [-1, 1].");
    m.def(
        "least_squares", &least_squares, "matrix"_a, "wanted"_a,
        "The x that make |A x - b| least for each column b, in directions in which A is not below about 1e-14 of the largest.");
}
