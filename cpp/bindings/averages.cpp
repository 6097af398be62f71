// Pupils that are radially symmetric: pixels that average, or around any axis.
#include "lommel/radial/average_images.hpp"

#include "pupils.hpp"

using namespace bindings;

namespace {

template <class T>
double render_pixels(In<double, 2> coefficients, double obscuration, In<double, 1> amplitude, double center_y, double center_x,
                     double step, bool integrate, double tol, int threads, Out<T, 3> images, Out<double, 1> scales,
                     Out<double, 1> bounds, Out<double, 1> peaks, In<std::int64_t, 1> powers, Out<T, 4> derivative_images,
                     Out<double, 2> derivative_bounds) {
    const lommel::Stack stack = stack_of(coefficients, obscuration, amplitude);
    require_answers(stack.count, images, scales, bounds, peaks);
    const lommel::PixelWindow window = window_of(images.shape(1), images.shape(2), center_y, center_x, step, integrate);
    require_request(step, tol, threads);
    const std::vector<std::size_t> which = powers_of(powers);
    require_derivatives(which.size(), stack.count, images, derivative_images, derivative_bounds);
    return judged([&] {
        lommel::PixelRenderer<T>(stack, window, tol, threads,
                                 {images.data(), scales.data(), bounds.data(), which.data(), which.size(),
                                  derivative_images.data(), derivative_bounds.data()},
                                 peaks.data())
            .run();
    });
}

}  // namespace

void bindings::define_averages(nb::module_& m) {
    for_both([&](auto pixel) {
        m.def("render_pixels", &render_pixels<decltype(pixel)>, "coefficients"_a, "obscuration"_a, "amplitude"_a, "center_y"_a,
              "center_x"_a, "step"_a, "integrate"_a, "tol"_a, "threads"_a, "images"_a.noconvert(), "scales"_a.noconvert(),
              "bounds"_a.noconvert(), "peaks"_a.noconvert(), "powers"_a, "derivative_images"_a.noconvert(),
              "derivative_bounds"_a.noconvert(), "differentiate() of pixels that average, or around an axis anywhere.");
    });
}
