// Averages of many PSFs over pixels, and blur by depth.
#include <cmath>
#include <vector>

#include "lommel/imaging/profile_sums.hpp"
#include "lommel/imaging/spread.hpp"

#include "pupils.hpp"

using namespace bindings;

namespace {

// Bounds are negative where the tolerance cannot be met.
std::tuple<Out<double, 2>, Out<double, 1>> means(In<double, 2> coefficients, double obscuration, In<double, 1> amplitude,
                                                 In<double, 1> v, double tol, In<double, 2> matrix, int threads) {
    const lommel::Stack stack = stack_of(coefficients, obscuration, amplitude);
    require(matrix.shape(0) == v.shape(0) && v.shape(0) > 0 && threads >= 0, "the matrix must have a row for each v");
    auto out = new_array<double, 2>({stack.count, matrix.shape(1)});
    auto bounds = new_array<double, 1>({stack.count});
    released([&] {
        lommel::profile_sums(stack, v.data(), v.shape(0), tol, matrix.data(), matrix.shape(1), threads, out.data(),
                             bounds.data());
    });
    return {out, bounds};
}

template <class T>
lommel::WindowBank<T> bank_of(const In<T, 3>& windows, const In<double, 1>& halves, const In<double, 2>& energies,
                              const In<double, 2>& positions) {
    const std::size_t count = windows.shape(0), rows = windows.shape(1), stride = windows.shape(2);
    // The last window is there for vectors to reach into only.
    require(count >= 5 && rows >= 1 && stride >= 2 * rows - 1 && rows * stride >= lommel::Spreader<T>::padding,
            "windows must be padded, 5 or more");
    const std::size_t widest = rows - 1;
    require(halves.shape(0) == count - 1 && energies.shape(0) == count - 1 && energies.shape(1) == widest + 1,
            "one half width and one row of energies a window");
    for (std::size_t i = 0; i < halves.shape(0); ++i) {
        require(halves.data()[i] >= 0.0 && halves.data()[i] <= static_cast<double>(widest), "halves must fit in the windows");
    }
    for (std::size_t i = 0; i < positions.size(); ++i) {
        require(std::isfinite(positions.data()[i]), "positions must be finite");
    }
    return {windows.data(), halves.data(), energies.data(), count - 1, widest, stride};
}

// Adds each pixel, spread over its window, to an image larger by half a window on every side, and 16 columns beyond.
template <class T>
void spread(In<T, 3> windows, In<double, 1> halves, In<double, 2> energies, In<double, 2> positions, In<T, 2> image,
            int threads, Out<T, 2> out) {
    const lommel::WindowBank<T> bank = bank_of<T>(windows, halves, energies, positions);
    const std::size_t height = image.shape(0), width = image.shape(1);
    require(positions.shape(0) == height && positions.shape(1) == width && threads >= 0, "positions must match the image");
    require(out.shape(0) == height + 2 * bank.widest && out.shape(1) == width + 2 * bank.widest + lommel::Spreader<T>::beyond,
            "out must be larger than the image by a window, and have 16 columns more");
    released([&] { lommel::Spreader<T>(bank, positions.data(), height, width, threads).forward(image.data(), out.data()); });
}

// The transpose of spread().
template <class T>
void collect(In<T, 3> windows, In<double, 1> halves, In<double, 2> energies, In<double, 2> positions, In<T, 2> image,
             int threads, Out<T, 2> out) {
    const lommel::WindowBank<T> bank = bank_of<T>(windows, halves, energies, positions);
    const std::size_t height = positions.shape(0), width = positions.shape(1);
    require(image.shape(0) == height + 2 * bank.widest && image.shape(1) == width + 2 * bank.widest && threads >= 0,
            "the image must be larger than the positions by a window");
    require(out.shape(0) == height && out.shape(1) == width, "out must match the positions");
    released([&] {
        std::vector<T> padded(image.data(), image.data() + image.size());
        padded.resize(image.size() + lommel::Spreader<T>::padding, T(0));
        lommel::Spreader<T>(bank, positions.data(), height, width, threads).adjoint(padded.data(), out.data());
    });
}

}  // namespace

void bindings::define_imaging(nb::module_& m) {
    m.def("means", &means, "coefficients"_a, "obscuration"_a, "amplitude"_a, "v"_a, "tol"_a, "matrix"_a, "threads"_a,
          "Weighted sums of I at rising v, and bounds on the error of I over its peak.");
    for_both([&](auto pixel) {
        using T = decltype(pixel);
        m.def("spread", &spread<T>, "windows"_a.noconvert(), "halves"_a, "energies"_a, "positions"_a, "image"_a.noconvert(),
              "threads"_a, "out"_a.noconvert(),
              "Adds each pixel times the window at its position in the bank to an image larger by a window.");
        m.def("collect", &collect<T>, "windows"_a.noconvert(), "halves"_a, "energies"_a, "positions"_a, "image"_a.noconvert(),
              "threads"_a, "out"_a.noconvert(), "The transpose of spread().");
    });
}
