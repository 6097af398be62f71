// Radii of a window, images from radial profiles, and pixel averages.
#include <algorithm>
#include <vector>

#include "lommel/pixels/filter.hpp"
#include "lommel/pixels/render.hpp"
#include "lommel/pixels/table.hpp"
#include "lommel/radial/average_values.hpp"
#include "lommel/radial/images.hpp"

#include <nanobind/stl/vector.h>

#include "python.hpp"

using namespace bindings;

namespace {

std::pair<Out<std::int64_t, 1>, Out<std::int32_t, 2>> distinct_radii(std::size_t rows, std::size_t cols) {
    // Ranks are 32-bit integers, and the work is linear in the largest squared radius.
    require(rows <= 20000 && cols <= 20000, "rows and cols must be at most 20000");
    auto index = new_array<std::int32_t, 2>({rows + 1, cols + 1});
    const std::vector<std::int64_t> squares = released([&] { return lommel::distinct_radii(rows, cols, index.data()); });
    return {array_of(squares), index};
}

template <class T>
void scatter(In<double, 2> profiles, In<double, 1> scales, int threads, Out<T, 3> out) {
    const std::size_t count = out.shape(0), height = out.shape(1), width = out.shape(2), radii = profiles.shape(1);
    released([&] {
        const auto layout = lommel::Layout::get(height, width);
        // About 0.3 microseconds per thousand pixels.
        const double work = 0.3e-3 * static_cast<double>(count * height * width);
        lommel::for_pupils(count, lommel::worthwhile_threads(threads, work), [&](std::size_t i, int own) {
            std::vector<T> profile(radii);
            lommel::store_scaled(profiles.data() + i * radii, scales.data()[i], radii, profile.data());
            lommel::for_rows(layout->rows.distances(), width, own, [&](std::size_t first, std::size_t last) {
                layout->scatter(profile.data(), first, last, out.data() + i * height * width);
            });
        });
    });
}

// Radii at which I is needed, and factors from its errors to those of pixels.
std::tuple<Out<double, 1>, double, double, double, double> pixel_radii(std::size_t height, std::size_t width, double center_y,
                                                                       double center_x, double step, bool integrate, int level,
                                                                       int threads) {
    const lommel::PixelWindow window = window_of(height, width, center_y, center_x, step, integrate);
    const auto table = released([&] { return lommel::PixelTable::get(window, level, threads); });
    auto radii = new_array<double, 1>({table->count});
    std::copy_n(table->radii.data(), table->count, radii.data());
    return {radii, table->error, table->of_nodes, table->of_grid, table->rounding};
}

Out<double, 1> pixel_values(In<double, 2> profiles, double center_y, double center_x, double step, bool integrate, int level,
                            int threads, Out<double, 3> out) {
    const std::size_t n = out.shape(0), height = out.shape(1), width = out.shape(2);
    const lommel::PixelWindow window = window_of(height, width, center_y, center_x, step, integrate);
    auto penalties = new_array<double, 1>({n});
    released([&] {
        const auto table = lommel::PixelTable::get(window, level, threads);
        lommel::WindowValues made;
        for (std::size_t i = 0; i < n; ++i) {
            made.make(*table, window, profiles.data() + i * table->count, threads);
            table->groups.paint(made.values.data(), 0, table->groups.rows.distances.size(), out.data() + i * height * width);
            penalties.data()[i] = made.penalty;
        }
    });
    return penalties;
}

// Rows of pixels are contiguous, images need not be.
using Images = nb::ndarray<double, nb::numpy, nb::ndim<3>, nb::device::cpu>;

template <class T>
void average_samples(In<T, 3> samples, In<double, 2> weights, std::size_t stride, int threads, Images out, double lowest,
                     In<double, 2> across, double dark) {
    require(out.stride(2) == 1 && out.stride(1) == static_cast<std::int64_t>(out.shape(2)), "rows must follow each other");
    const bool others = across.is_valid();
    const lommel::PixelFilter filter{
        weights.data(), weights.shape(1), stride, lowest, others ? across.data() : nullptr, weights.shape(0), dark};
    released([&] {
        filter.average(samples.data(), out.shape(0), out.shape(1), out.shape(2), out.data(),
                       static_cast<std::size_t>(out.stride(0)), threads);
    });
}

}  // namespace

void bindings::define_pixels(nb::module_& m) {
    m.def("distinct_radii", &distinct_radii, "rows"_a, "cols"_a,
          "Distinct squared radii of a quadrant, rising, and the rank of every pixel's.");
    for_both([&](auto pixel) {
        m.def("scatter", &scatter<decltype(pixel)>, "profiles"_a, "scales"_a, "threads"_a, "out"_a.noconvert(),
              "Profiles at the distinct radii, times a scale each, onto a stack of images.");
    });
    m.def("pixel_radii", &pixel_radii, "height"_a, "width"_a, "center_y"_a, "center_x"_a, "step"_a, "integrate"_a, "level"_a,
          "threads"_a,
          "Rising v that the pixels of a window take, the error of the pixels over half the range of I, what errors are "
          "multiplied by at these radii and between the places of harmonics, and roundings over the largest I.");
    m.def("pixel_values", &pixel_values, "profiles"_a, "center_y"_a, "center_x"_a, "step"_a, "integrate"_a, "level"_a,
          "threads"_a, "out"_a.noconvert(), "Pixels of windows from profiles at pixel_radii(); returns further roundings.");
    for_both([&](auto sample) {
        m.def("average_samples", &average_samples<decltype(sample)>, "samples"_a.noconvert(), "weights"_a, "stride"_a,
              "threads"_a, "out"_a.noconvert(), "lowest"_a = 0.0, "across"_a.none() = nb::none(), "dark"_a = 0.0,
              "Averages over pixels from finer samples, raised to `lowest`, by a filter along both axes: of each of some "
              "pixels side "
              "by side that are `stride` samples wide together, the weights of the samples from the first one on. Samples of "
              "single precision up to `dark` are summed "
              "in it.");
    });
    m.def("gauss_error", &lommel::gauss_error, "side"_a, "points"_a,
          "Bound on averaging it over a square by points x points of Gauss and Legendre, over half its range.");
}
