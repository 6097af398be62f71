// Pupils that are radially symmetric, by their series: images of sampling pixels, fields and profiles.
#include "lommel/radial/images.hpp"
#include "lommel/radial/profiles.hpp"

#include "pupils.hpp"

using namespace bindings;

namespace {

template <class T>
double rendered(const lommel::Stack& stack, double step, double tol, int threads, const Out<T, 3>& images,
                const Out<double, 1>& scales, const Out<double, 1>& bounds, const std::vector<std::size_t>& powers,
                T* derivative_images, double* derivative_bounds) {
    require_answers(stack.count, images, scales, bounds);
    require_request(step, tol, threads);
    return judged([&] {
        lommel::Renderer<T>(
            stack, images.shape(1), images.shape(2), step, tol, threads,
            {images.data(), scales.data(), bounds.data(), powers.data(), powers.size(), derivative_images, derivative_bounds})
            .run();
    });
}

template <class T>
double render(In<double, 2> coefficients, double obscuration, In<double, 1> amplitude, double step, double tol, int threads,
              Out<T, 3> images, Out<double, 1> scales, Out<double, 1> bounds) {
    return rendered<T>(stack_of(coefficients, obscuration, amplitude), step, tol, threads, images, scales, bounds, {}, nullptr,
                       nullptr);
}

template <class T>
double differentiate(In<double, 2> coefficients, double obscuration, In<double, 1> amplitude, double step, double tol,
                     int threads, Out<T, 3> images, Out<double, 1> scales, Out<double, 1> bounds, In<std::int64_t, 1> powers,
                     Out<T, 4> derivative_images, Out<double, 2> derivative_bounds) {
    const lommel::Stack stack = stack_of(coefficients, obscuration, amplitude);
    const std::vector<std::size_t> which = powers_of(powers);
    require_derivatives(which.size(), stack.count, images, derivative_images, derivative_bounds);
    return rendered<T>(stack, step, tol, threads, images, scales, bounds, which, derivative_images.data(),
                       derivative_bounds.data());
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
                                                                   In<double, 1> amplitude, In<double, 1> v, double tol) {
    const lommel::Stack stack = stack_of(coefficients, obscuration, amplitude);
    auto out = new_array<double, 2>({stack.count, v.shape(0)});
    auto peaks = new_array<double, 1>({stack.count});
    auto bounds = new_array<double, 1>({stack.count});
    released([&] { lommel::profiles(stack, v.data(), v.shape(0), tol, out.data(), bounds.data(), peaks.data()); });
    return {out, bounds, peaks};
}

}  // namespace

void bindings::define_radial(nb::module_& m) {
    for_both([&](auto pixel) {
        using T = decltype(pixel);
        m.def("render", &render<T>, "coefficients"_a, "obscuration"_a, "amplitude"_a, "step"_a, "tol"_a, "threads"_a,
              "images"_a.noconvert(), "scales"_a.noconvert(), "bounds"_a.noconvert(),
              "Images of a stack of pupils by the spectral engine; returns 0, or the bound where tol cannot be met.");
        m.def("differentiate", &differentiate<T>, "coefficients"_a, "obscuration"_a, "amplitude"_a, "step"_a, "tol"_a,
              "threads"_a, "images"_a.noconvert(), "scales"_a.noconvert(), "bounds"_a.noconvert(), "powers"_a,
              "derivative_images"_a.noconvert(), "derivative_bounds"_a.noconvert(),
              "render(), and the derivatives by the coefficients of t^power.");
    });
    m.def("field", &field, "coefficients"_a, "obscuration"_a, "amplitude"_a, "v"_a, "tol"_a,
          "U at rising v, and bounds on its error.");
    m.def("profile", &profile, "coefficients"_a, "obscuration"_a, "amplitude"_a, "v"_a, "tol"_a,
          "I at rising v, bounds on its error over the peak, negative where tol cannot be met, and the peaks.");
}
