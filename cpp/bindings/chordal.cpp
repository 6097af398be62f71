// Pupils of any Zernike terms on small windows, by the chordal rule: images, their derivatives, and gradients.
#include "lommel/chordal/gradient.hpp"
#include "lommel/chordal/images.hpp"
#include "lommel/chordal/slopes.hpp"

#include "pupils.hpp"

using namespace bindings;

namespace {

std::vector<lommel::ZernikeTerm> factors_of(const In<std::int32_t, 2>& factors) {
    std::vector<lommel::ZernikeTerm> list = terms_of(factors, factors.shape(0));
    require_terms(list);
    for (const lommel::ZernikeTerm& term : list) {
        require(term.n > 0, "nothing depends on the constant phase");
    }
    return list;
}

template <class T, class... Center>
double slopes(In<std::int32_t, 2> terms, In<double, 2> edge, double obscuration, In<double, 1> amplitude, Center... center,
              double step, double tol, int threads, double scale, Out<T, 3> images, Out<double, 2> numbers,
              In<std::int32_t, 2> factors, Out<T, 4> derivative_images, Out<double, 2> derivative_bounds) {
    require(scale > 0.0, "images with derivatives are not divided by their largest value");
    const std::vector<lommel::ZernikeTerm> list = factors_of(factors);
    const lommel::DiskAnswer<T> answer = disk_answer(edge.shape(0), scale, images, numbers);
    require_derivatives(list.size(), edge.shape(0), images, derivative_images, derivative_bounds);
    const auto work = [&](const lommel::DiskStack& stack, const lommel::DiskWindow& window) {
        const lommel::SlopeAnswer<T> to{derivative_images.data(), derivative_bounds.data()};
        lommel::ChordalSlopes<T>(stack, window, tol, threads, answer, list, to).run();
    };
    return on_disks<false>(terms, edge, obscuration, amplitude, images.shape(1), images.shape(2), step, tol, threads, work,
                           center...);
}

template <class... Center>
void gradient(In<std::int32_t, 2> terms, In<double, 2> edge, double obscuration, In<double, 1> amplitude, Center... center,
              double step, double tol, int threads, In<double, 3> weights, In<std::int32_t, 2> factors, Out<double, 2> out) {
    const std::vector<lommel::ZernikeTerm> list = factors_of(factors);
    const std::size_t n = edge.shape(0);
    require(weights.shape(0) == n, "one image of weights a pupil");
    require_image(weights.shape(1), weights.shape(2));
    require(out.shape(0) == n && out.shape(1) == list.size(), "one number a pupil and factor");
    const auto work = [&](const lommel::DiskStack& stack, const lommel::DiskWindow& window) {
        lommel::ChordalGradient(stack, window, tol, threads, list, weights.data(), out.data()).run();
    };
    on_disks<false>(terms, edge, obscuration, amplitude, weights.shape(1), weights.shape(2), step, tol, threads, work,
                    center...);
}

}  // namespace

void bindings::define_chordal(nb::module_& m) {
    define_disk_images<lommel::ChordalRenderer, false>(
        m, "chordal_images", "The same by the chordal rule; bounds are over the largest value of the window.");
    for_both([&](auto pixel) {
        using T = decltype(pixel);
        m.def("chordal_slopes", &slopes<T, double, double>, "terms"_a, "edge"_a, "obscuration"_a, "amplitude"_a, "center_y"_a,
              "center_x"_a, "step"_a, "tol"_a, "threads"_a, "scale"_a, "images"_a.noconvert(), "numbers"_a.noconvert(),
              "factors"_a, "derivative_images"_a.noconvert(), "derivative_bounds"_a.noconvert(),
              "And their derivatives by the coefficients of the terms `factors`.");
        m.def("chordal_slopes", &slopes<T, In<double, 2>>, "terms"_a, "edge"_a, "obscuration"_a, "amplitude"_a, "centers"_a,
              "step"_a, "tol"_a, "threads"_a, "scale"_a, "images"_a.noconvert(), "numbers"_a.noconvert(), "factors"_a,
              "derivative_images"_a.noconvert(), "derivative_bounds"_a.noconvert(),
              "The same, each around an axis of its own.");
    });
    m.def("chordal_gradient", &gradient<double, double>, "terms"_a, "edge"_a, "obscuration"_a, "amplitude"_a, "center_y"_a,
          "center_x"_a, "step"_a, "tol"_a, "threads"_a, "weights"_a, "factors"_a, "gradient"_a.noconvert(),
          "The gradient of the sum of weights times I by the coefficients of the terms `factors`.");
    m.def("chordal_gradient", &gradient<In<double, 2>>, "terms"_a, "edge"_a, "obscuration"_a, "amplitude"_a, "centers"_a,
          "step"_a, "tol"_a, "threads"_a, "weights"_a, "factors"_a, "gradient"_a.noconvert(),
          "The same, each around an axis of its own.");
}
