// Matrix products, and blur that depends on depth.
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include <nanobind/stl/optional.h>

#include "lommel/imaging/composite.hpp"
#include "lommel/imaging/depth_layers.hpp"
#include "lommel/imaging/field_spread.hpp"
#include "lommel/imaging/plane_filter.hpp"
#include "lommel/imaging/shrinkage.hpp"
#include "lommel/base/product.hpp"
#include "lommel/imaging/spread.hpp"

#include "python.hpp"

using namespace bindings;

namespace {

template <class T>
using Strided = nb::ndarray<const T, nb::numpy, nb::ndim<2>, nb::device::cpu>;

Out<double, 2> product(In<double, 2> rows, In<double, 2> matrix, int threads) {
    const std::size_t count = rows.shape(1);
    require(matrix.shape(0) == count && threads >= 0, "the matrix must have a row for each column");
    auto out = new_array<double, 2>({rows.shape(0), matrix.shape(1)});
    released([&] { lommel::product(rows.data(), rows.shape(0), count, matrix.data(), matrix.shape(1), threads, out.data()); });
    return out;
}

// Windows of a bank[position][row][column], the half width of each, and its share of the light.
template <class T>
using BankFields = std::tuple<In<T, 3>, In<std::int64_t, 1>, In<double, 1>>;

template <class T>
lommel::WindowBank<T> bank_of(const BankFields<T>& bank) {
    const auto& [windows, halves, energies] = bank;
    const std::size_t count = windows.shape(0), rows = windows.shape(1), stride = windows.shape(2);
    // The last window is a spare that vectors may read.
    return {windows.data(), halves.data(), energies.data(), count - 1, rows - 1, stride};
}

lommel::Scene scene_of(const In<double, 2>& positions) {
    require(lommel::all_finite(positions.data(), positions.size()), "positions must be finite");
    return {positions.data(), positions.shape(0), positions.shape(1)};
}

// out += each pixel spread over its window; `out` is larger than the scene by half a window above and below, and by the next
// multiple of 16 on either side. Or the transpose, in which light beyond the edges is not folded back.
// For occlusion, `layers` has the shape of `positions`, `seen` that of the image with margins.
template <class T, bool Transposed>
void spread(BankFields<T> windows, In<double, 2> positions, std::conditional_t<Transposed, In<T, 2>, Strided<T>> image,
            int threads, Out<T, 2> out, std::optional<In<T, 2>> layers, std::optional<In<T, 2>> seen) {
    const lommel::WindowBank<T> bank = bank_of<T>(windows);
    const lommel::Scene scene = scene_of(positions);
    const lommel::Screen<T> screen = layers ? lommel::Screen<T>{layers->data(), seen->data()} : lommel::Screen<T>{};
    released([&] {
        const lommel::Spreader<T> spreader(bank, scene, threads, screen);
        if constexpr (Transposed) {
            spreader.adjoint(image.data(), out.data());
        } else {
            spreader.forward(image.data(), image.stride(0), image.stride(1), out.data());
        }
    });
}

// Write the layer of each point (0: nearest) and the representative point for the light behind it (-1: none). Returns the
// numbers of layers and of occluding points.
std::pair<std::size_t, std::size_t> depth_layers(In<double, 2> defocus, double low, double high, In<double, 1> radii,
                                                 double thickness, int most, int threads, Out<std::uint8_t, 2> layers,
                                                 Out<std::int32_t, 2> behind) {
    const std::size_t height = defocus.shape(0), width = defocus.shape(1), size = height * width;
    require(lommel::all_finite(defocus.data(), size), "defocus must be finite");
    std::pair<std::size_t, std::size_t> found;
    released([&] {
        std::vector<float> radius(size);
        const lommel::BlurRadii known{radii.data(), radii.size(), low, high, thickness, static_cast<std::size_t>(most)};
        lommel::sort_into_layers(defocus.data(), size, known, threads, layers.data(), radius.data());
        found.second = lommel::HiddenPoints(layers.data(), radius.data(), height, width, threads).find(behind.data());
        found.first = lommel::renumber(layers.data(), size);
    });
    return found;
}

// Layer of each pixel (0: nearest), the representative pixel of the light behind it (-1: none), and the number of layers.
using LayerFields = std::tuple<In<std::uint8_t, 2>, std::optional<In<std::int32_t, 2>>, int>;

// Add the layers from .. to - 1, front to back, to the composite image.
template <class T>
void composite(BankFields<T> windows, In<double, 2> positions, LayerFields layering, std::optional<Strided<T>> image,
               std::pair<int, int> range, bool known, int threads, Out<T, 2> seen, Out<T, 2> total,
               std::optional<Out<T, 2>> out) {
    const lommel::WindowBank<T> bank = bank_of<T>(windows);
    const lommel::Scene scene = scene_of(positions);
    const auto& [layers, behind, count] = layering;
    const auto [from, to] = range;
    const lommel::LayeredScene layered{scene, layers.data(), behind ? behind->data() : nullptr,
                                       static_cast<std::size_t>(count)};
    released([&] {
        lommel::Compositor<T>(bank, layered, threads, image ? image->data() : nullptr, image ? image->stride(0) : 0,
                              image ? image->stride(1) : 0)(static_cast<std::size_t>(from), static_cast<std::size_t>(to), known,
                                                            {seen.data(), total.data(), out ? out->data() : nullptr});
    });
}

// Arrays of splines and source pixels, see field_spread.hpp: windows[row][column][node][pixel] of `side` pixels a
// side, weights of the rows and of the columns of nodes, and the three shares of each column.
template <class T>
using SplineFields = std::tuple<In<T, 4>, std::size_t, In<T, 2>, In<T, 2>, In<T, 2>>;
// Tile of each column, defocus of each pixel, and breaks and powers of the interpolation over the defocus.
template <class T>
using DefocusFields = std::tuple<In<std::int64_t, 1>, In<double, 2>, In<double, 1>, In<T, 3>>;

template <class T>
lommel::FieldSpreader<T> field_spreader(const SplineFields<T>& splines, const DefocusFields<T>& at, int threads) {
    const auto& [windows, side, down, places, shares] = splines;
    const auto& [tiles, defocus, breaks, powers] = at;
    const std::size_t size = windows.shape(3), order = powers.shape(1), intervals = powers.shape(0);
    const std::size_t high = defocus.shape(0), broad = defocus.shape(1), count = places.shape(0);
    require(lommel::all_finite(defocus.data(), defocus.size()) && lommel::all_finite(breaks.data(), breaks.size()),
            "defocus must be finite");
    return {{windows.data(), windows.shape(0), windows.shape(1), windows.shape(2), side, size},
            {down.data(), places.data(), shares.data(), tiles.data(), count, high, broad, defocus.data(), breaks.data(),
             powers.data(), intervals, order},
            threads};
}

// Add each pixel spread over its window to an image larger by the size of a window; or the transpose.
template <class T>
void field_spread(SplineFields<T> splines, DefocusFields<T> defocus, In<T, 2> image, int threads, Out<T, 2> out,
                  bool transposed) {
    const auto spreader = field_spreader(splines, defocus, threads);
    released([&] {
        if (transposed) {
            spreader.adjoint(image.data(), out.data());
        } else {
            spreader.forward(image.data(), out.data());
        }
    });
}

// Convolve the first planes of `room` axially, or apply the transpose, in place; see plane_filter.hpp.
void filter_planes(Out<std::complex<float>, 3> room, const nb::typed<nb::list, nb::object>& transfers, In<float, 2> weights,
                   std::size_t recording, std::size_t first, std::size_t before, std::size_t after, std::size_t length,
                   bool transposed, int threads) {
    const lommel::StackPlanes planes{room.shape(0), recording, first, before, after};
    const std::size_t rows = room.shape(1), columns = room.shape(2);
    std::vector<In<float, 4>> arrays;
    std::vector<lommel::PlaneTransfer> kernels;
    for (const nb::handle each : transfers) {
        const auto& array = arrays.emplace_back(nb::cast<In<float, 4>>(each));
        kernels.push_back({array.data(), array.shape(0), array.shape(2)});
    }
    released([&] {
        lommel::PlaneFilter(planes, length, rows, columns, kernels, weights.data()).run(room.data(), transposed, threads);
    });
}

template <class Values>
lommel::Planes planes_of(const Values& planes, bool periodic = false) {
    return {planes.shape(0), planes.shape(1), planes.shape(2), periodic};
}

double gradient_sum(In<float, 3> light, bool periodic) {
    require(light.size() > 0, "planes must not be empty");
    return released([&] { return lommel::gradient_sum(planes_of(light, periodic), light.data()); });
}

// One step of the total variation, see shrinkage.hpp.
Out<float, 3> shrink_gradient(In<float, 3> light, Out<float, 4> dual, float factor, float limit, bool periodic) {
    const lommel::Planes planes = planes_of(light, periodic);
    require(light.size() > 0 && dual.size() == 2 * light.size() && limit > 0.0F,
            "the dual must have two planes for each of the light, and the limit must be positive");
    auto out = new_array<float, 3>({planes.count, planes.height, planes.width});
    released([&] { lommel::shrink_gradient(planes, light.data(), dual.data(), factor, limit, out.data()); });
    return out;
}

// Shrink the coefficients of a frame by their own energy or, if given, by that of an estimate, in place.
void shrink_bands(Out<float, 3> values, In<float, 2> relative, In<float, 1> noise, In<float, 1> taps,
                  std::optional<In<float, 3>> seen, std::optional<In<float, 3>> sharp) {
    const lommel::Planes planes = planes_of(values);
    require(values.size() > 0 && relative.size() == planes.size() && noise.size() == planes.count && taps.size() > 0 &&
                (!seen || (sharp && seen->size() == values.size() && sharp->size() == values.size())),
            "coefficients, estimates and noise must have the same shape");
    released([&] {
        lommel::Shrinkage shrinkage(planes, relative.data(), noise.data(), taps.data(), taps.size() - 1);
        seen ? shrinkage.by_estimate(values.data(), seen->data(), sharp->data()) : shrinkage.by_own_energy(values.data());
    });
}

}  // namespace

void bindings::define_imaging(nb::module_& m) {
    m.def("product", &product, "rows"_a, "matrix"_a, "threads"_a, "The product of two matrices.");
    m.def("depth_layers", &depth_layers, "defocus"_a, "low"_a, "high"_a, "radii"_a, "thickness"_a, "most"_a, "threads"_a,
          "layers"_a.noconvert(), "behind"_a.noconvert(),
          "Writes the layer of each point, and the point that stands for what it hides, or -1; returns how many layers there "
          "are, "
          "and how many points hide something.");
    m.def("filter_planes", &filter_planes, "room"_a.noconvert(), "transfers"_a, "weights"_a, "recording"_a, "first"_a,
          "before"_a, "after"_a, "length"_a, "transposed"_a, "threads"_a,
          "Convolves the first planes of a room along all planes, at each lateral frequency, or applies the transpose.");
    m.def("gradient_sum", &gradient_sum, "light"_a, "periodic"_a, "The sum of the lengths of the gradients of planes.");
    m.def("shrink_gradient", &shrink_gradient, "light"_a, "dual"_a.noconvert(), "factor"_a, "limit"_a, "periodic"_a,
          "One step of the total variation: the gradient that it subtracts from twice, transposed; the dual is overwritten.");
    m.def("shrink_bands", &shrink_bands, "values"_a.noconvert(), "relative"_a, "noise"_a, "taps"_a, "seen"_a = nb::none(),
          "sharp"_a = nb::none(), "Shrinks coefficients by their energy around them, or that of an estimate, in place.");
    for_both([&](auto pixel) {
        using T = decltype(pixel);
        m.def("composite", &composite<T>, "bank"_a.noconvert(), "positions"_a, "layering"_a.noconvert(),
              "image"_a.noconvert().none(), "range"_a, "known"_a, "threads"_a, "seen"_a.noconvert(), "total"_a.noconvert(),
              "out"_a.noconvert() = nb::none(),
              "Adds a range of layers of points, from the nearest on, to what pixels see of them, of a white scene and of "
              "light.");
        const auto define_spread = [&](const char* name, auto function, const char* says) {
            m.def(name, function, "bank"_a.noconvert(), "positions"_a, "image"_a.noconvert(), "threads"_a, "out"_a.noconvert(),
                  "layers"_a.noconvert() = nb::none(), "seen"_a.noconvert() = nb::none(), says);
        };
        define_spread("spread", &spread<T, false>,
                      "Adds each pixel times the window at its position in the bank to an image larger by a window.");
        define_spread("collect", &spread<T, true>, "The transpose of spread().");
        m.def("field_spread", &field_spread<T>, "splines"_a.noconvert(), "defocus"_a.noconvert(), "image"_a.noconvert(),
              "threads"_a, "out"_a.noconvert(), "transposed"_a = false,
              "Adds each pixel times the window of splines at its place and defocus to an image larger by a window, or writes "
              "the "
              "transpose.");
    });
}
