// The one place where the compiled core meets Python: shapes are checked here, the GIL is released here, and
// no arithmetic is done here.
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/pair.h>

#include <complex>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "lommel/bessel.hpp"
#include "lommel/huygens.hpp"
#include "lommel/legendre.hpp"
#include "lommel/render.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace {

template <class T, std::size_t N>
using In = nb::ndarray<const T, nb::numpy, nb::ndim<N>, nb::c_contig, nb::device::cpu>;
template <class T, std::size_t N>
using Out = nb::ndarray<T, nb::numpy, nb::ndim<N>, nb::c_contig, nb::device::cpu>;
using complex = std::complex<double>;

template <class T, std::size_t N>
Out<T, N> new_array(const std::size_t (&shape)[N]) {
    std::size_t size = 1;
    for (const std::size_t extent : shape) {
        size *= extent;
    }
    T* data = new T[size];
    nb::capsule owner(data, [](void* p) noexcept { delete[] static_cast<T*>(p); });
    return Out<T, N>(data, N, shape, owner);
}

void require(bool condition, const char* message) {
    if (!condition) {
        throw std::invalid_argument(message);
    }
}

Out<double, 2> bessel_sequence(In<double, 1> v, std::size_t count) {
    auto out = new_array<double, 2>({v.shape(0), count});
    nb::gil_scoped_release nogil;
    for (std::size_t i = 0; i < v.shape(0); ++i) {
        lommel::bessel_sequence(v.data()[i], count, out.data() + i * count);
    }
    return out;
}

Out<double, 2> legendre_transforms(In<double, 1> v, std::size_t terms) {
    auto out = new_array<double, 2>({v.shape(0), terms});
    nb::gil_scoped_release nogil;
    std::vector<double> scratch;
    for (std::size_t i = 0; i < v.shape(0); ++i) {
        lommel::legendre_transforms(v.data()[i], terms, out.data() + i * terms, scratch);
    }
    return out;
}

std::pair<Out<double, 1>, Out<double, 1>> gauss_legendre(std::size_t n) {
    require(n > 0, "n must be at least 1");
    auto nodes = new_array<double, 1>({n});
    auto weights = new_array<double, 1>({n});
    {
        nb::gil_scoped_release nogil;
        lommel::gauss_legendre(n, nodes.data(), weights.data());
    }
    return {nodes, weights};
}

Out<double, 2> legendre_sequence(In<double, 1> x, std::size_t terms) {
    auto out = new_array<double, 2>({x.shape(0), terms});
    nb::gil_scoped_release nogil;
    for (std::size_t i = 0; i < x.shape(0); ++i) {
        lommel::legendre_sequence(x.data()[i], terms, out.data() + i * terms);
    }
    return out;
}

std::pair<Out<std::int64_t, 1>, Out<std::int32_t, 2>> distinct_radii(std::size_t rows, std::size_t cols) {
    // Ranks are 32-bit and the work is linear in the largest squared radius.
    require(rows <= 20000 && cols <= 20000, "rows and cols must be at most 20000");
    auto index = new_array<std::int32_t, 2>({rows + 1, cols + 1});
    std::vector<std::int64_t> squares;
    {
        nb::gil_scoped_release nogil;
        squares = lommel::distinct_radii(rows, cols, index.data());
    }
    auto radii = new_array<std::int64_t, 1>({squares.size()});
    std::copy(squares.begin(), squares.end(), radii.data());
    return {radii, index};
}

template <class T>
void scatter(In<double, 2> profiles, In<double, 1> scales, In<std::int32_t, 2> index, Out<T, 3> out) {
    const std::size_t height = out.shape(1), width = out.shape(2);
    require(profiles.shape(0) == out.shape(0) && scales.shape(0) == out.shape(0), "one profile and scale an image");
    require(index.shape(0) == height / 2 + 1 && index.shape(1) == width / 2 + 1, "index must cover the quadrant");
    nb::gil_scoped_release nogil;
    const std::size_t quadrant = index.shape(0) * index.shape(1);
    for (std::size_t i = 0; i < quadrant; ++i) {
        const std::int32_t rank = index.data()[i];
        require(rank >= 0 && static_cast<std::size_t>(rank) < profiles.shape(1), "index points outside the profile");
    }
    for (std::size_t s = 0; s < out.shape(0); ++s) {
        lommel::scatter(profiles.data() + s * profiles.shape(1), scales.data()[s], index.data(), height, width,
                        out.data() + s * height * width);
    }
}

Out<double, 2> intensity_of_pieces(In<complex, 3> pieces, double piece_width, In<double, 1> v) {
    require(piece_width > 0.0, "piece_width must be positive");
    require(pieces.shape(1) > 0 && pieces.shape(2) > 0, "at least one piece and one coefficient");
    const std::size_t stack = pieces.shape(0), count = v.shape(0);
    auto out = new_array<double, 2>({stack, count});
    nb::gil_scoped_release nogil;
    for (std::size_t s = 0; s < stack; ++s) {
        lommel::intensity_of_pieces(pieces.data() + s * pieces.shape(1) * pieces.shape(2), pieces.shape(1),
                                    pieces.shape(2), piece_width, v.data(), count, out.data() + s * count);
    }
    return out;
}

Out<complex, 1> huygens_sum(In<double, 1> x, In<double, 1> y, In<complex, 1> amplitude, In<double, 1> sx,
                            In<double, 1> sy, double distance, double wavenumber) {
    require(x.shape(0) == y.shape(0) && x.shape(0) == amplitude.shape(0), "x, y and amplitude must match");
    require(sx.shape(0) == sy.shape(0), "sx and sy must match");
    auto out = new_array<complex, 1>({sx.shape(0)});
    nb::gil_scoped_release nogil;
    lommel::huygens_sum(x.data(), y.data(), amplitude.data(), x.shape(0), sx.data(), sy.data(), sx.shape(0), distance,
                        wavenumber, out.data());
    return out;
}

}  // namespace

NB_MODULE(_core, m) {
    m.doc() = "Compiled core of lommel: Bessel and Legendre sequences, rendering, Huygens' sum.";
    m.def("bessel_sequence", &bessel_sequence, "v"_a, "count"_a, "J_0 .. J_{count-1} at each v >= 0.");
    m.def("legendre_transforms", &legendre_transforms, "v"_a, "terms"_a,
          "2 (-1)^n J_{2n+1}(v) / v for n < terms, at each v >= 0.");
    m.def("gauss_legendre", &gauss_legendre, "n"_a, "Nodes and weights on [-1, 1].");
    m.def("legendre_sequence", &legendre_sequence, "x"_a, "terms"_a, "P_0 .. P_{terms-1} at each x.");
    m.def("distinct_radii", &distinct_radii, "rows"_a, "cols"_a,
          "Distinct squared radii of a quadrant, rising, and the rank of every pixel's.");
    m.def("scatter", &scatter<float>, "profiles"_a, "scales"_a, "index"_a, "out"_a.noconvert(),
          "Profiles at the distinct radii, times a scale each, onto a stack of images.");
    m.def("scatter", &scatter<double>, "profiles"_a, "scales"_a, "index"_a, "out"_a.noconvert());
    m.def("intensity_of_pieces", &intensity_of_pieces, "pieces"_a, "piece_width"_a, "v"_a,
          "|U|^2 at v from Chebyshev coefficients of U, shape (stack, pieces, terms).");
    m.def("huygens_sum", &huygens_sum, "x"_a, "y"_a, "amplitude"_a, "sx"_a, "sy"_a, "distance"_a, "wavenumber"_a,
          "Sum of spherical wavelets from sources (x, y, 0) at sensor points (sx, sy, distance).");
}
