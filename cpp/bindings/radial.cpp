// Pupils that are radially symmetric, by their series: images, fields and profiles.
#include "lommel/radial/average_images.hpp"
#include "lommel/radial/images.hpp"
#include "lommel/radial/profiles.hpp"

#include "pupils.hpp"

using namespace bindings;

namespace {

lommel::PixelWindows windows_of(std::size_t height, std::size_t width, std::size_t, double row, double column, double step,
                                bool integrate) {
    return window_of(height, width, row, column, step, integrate);
}
lommel::PixelWindows windows_of(std::size_t height, std::size_t width, std::size_t pupils, const In<double, 2>& centers,
                                double step, bool integrate) {
    require_centers(centers, pupils);
    const double* first = centers.data();
    return {window_of(height, width, first[0], first[1], step, integrate), first, pupils};
}

// Around one axis, (row, column), or each around its own.
template <class T, class... Center>
double render(In<double, 2> coefficients, double obscuration, In<double, 1> amplitude, Center... center, double step,
              bool integrate, double tol, int threads, double scale, Out<T, 3> images, Out<double, 2> numbers,
              In<std::int64_t, 1> powers, Out<T, 4> derivative_images, Out<double, 2> derivative_bounds) {
    const lommel::Stack stack = stack_of(coefficients, obscuration, amplitude);
    lommel::Answer<T> answer = answer_of(stack.count, scale, images, numbers);
    const lommel::PixelWindows windows = windows_of(images.shape(1), images.shape(2), stack.count, center..., step, integrate);
    require_request(step, tol, threads);
    const std::vector<std::size_t> which = powers_of(powers);
    require_derivatives(which.size(), stack.count, images, derivative_images, derivative_bounds);
    if (!which.empty()) {
        answer.powers = which.data();
        answer.derivatives = which.size();
        answer.derivative_images = derivative_images.data();
        answer.derivative_bounds = derivative_bounds.data();
    }
    return judged([&] {
        const lommel::PixelWindow& window = windows.first;
        if (windows.centers == nullptr && window.centered() && !integrate) {
            lommel::Renderer<T>(stack, window.height, window.width, step, tol, threads, answer).run();
        } else {
            lommel::PixelRenderer<T>(stack, windows, tol, threads, answer).run();
        }
    });
}

std::pair<Out<complex, 2>, Out<double, 1>> field(In<double, 2> coefficients, double obscuration, In<double, 1> amplitude,
                                                 In<double, 1> v, double tol) {
    const lommel::Stack stack = stack_of(coefficients, obscuration, amplitude);
    auto out = new_array<complex, 2>({stack.count, v.shape(0)});
    auto bounds = new_array<double, 1>({stack.count});
    released([&] { lommel::fields(stack, v.data(), v.shape(0), tol, out.data(), bounds.data()); });
    return {out, bounds};
}

// Bounds are negative where the tolerance cannot be met.
std::tuple<Out<double, 2>, Out<double, 1>, Out<double, 1>> profile(In<double, 2> coefficients, double obscuration,
                                                                   In<double, 1> amplitude, In<double, 1> v, double tol,
                                                                   int threads) {
    require(threads >= 0, "threads must be at least 0");
    const lommel::Stack stack = stack_of(coefficients, obscuration, amplitude);
    auto out = new_array<double, 2>({stack.count, v.shape(0)});
    auto peaks = new_array<double, 1>({stack.count});
    auto bounds = new_array<double, 1>({stack.count});
    released([&] { lommel::profiles(stack, v.data(), v.shape(0), tol, out.data(), bounds.data(), peaks.data(), threads); });
    return {out, bounds, peaks};
}

}  // namespace

void bindings::define_radial(nb::module_& m) {
    for_both([&](auto pixel) {
        m.def("render", &render<decltype(pixel), double, double>, "coefficients"_a, "obscuration"_a, "amplitude"_a,
              "center_y"_a, "center_x"_a, "step"_a, "integrate"_a, "tol"_a, "threads"_a, "scale"_a, "images"_a.noconvert(),
              "numbers"_a.noconvert(), "powers"_a.none() = nb::none(), "derivative_images"_a.noconvert().none() = nb::none(),
              "derivative_bounds"_a.noconvert().none() = nb::none(),
              "Images of a stack of pupils by the spectral engine, and their derivatives by the coefficients of t^power; "
              "returns 0, or the bound where tol cannot be met.");
        m.def("render", &render<decltype(pixel), In<double, 2>>, "coefficients"_a, "obscuration"_a, "amplitude"_a, "centers"_a,
              "step"_a, "integrate"_a, "tol"_a, "threads"_a, "scale"_a, "images"_a.noconvert(), "numbers"_a.noconvert(),
              "powers"_a.none() = nb::none(), "derivative_images"_a.noconvert().none() = nb::none(),
              "derivative_bounds"_a.noconvert().none() = nb::none(), "The same, each around an axis of its own.");
    });
    m.def("field", &field, "coefficients"_a, "obscuration"_a, "amplitude"_a, "v"_a, "tol"_a,
          "U at rising v, and bounds on its error.");
    m.def("profile", &profile, "coefficients"_a, "obscuration"_a, "amplitude"_a, "v"_a, "tol"_a, "threads"_a = 1,
          "I at rising v, bounds on its error over the peak, negative where tol cannot be met, and the peaks.");
}
