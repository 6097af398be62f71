// Radially symmetric pupils: images, fields and profiles by their series.
#include <nanobind/stl/optional.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <optional>
#include <vector>

#include "lommel/radial/average_images.hpp"
#include "lommel/radial/profiles.hpp"

#include "pupils.hpp"

using namespace bindings;

namespace {

template <class T>
double images_of(const lommel::Stack& stack, const lommel::PixelWindows& windows, double tol, int threads,
                 const lommel::Answer<T>& answer) {
    return judged([&] { lommel::render_radial<T>(stack, windows, tol, threads, answer); });
}

template <class T>
double render(RadialFields pupils, WindowFields window, bool integrate, Request request, Out<T, 3> images,
              Out<double, 2> numbers, In<std::int64_t, 1> powers, Out<T, 4> derivative_images,
              Out<double, 2> derivative_bounds) {
    const auto [tol, threads, scale] = request;
    const lommel::Stack stack = stack_of(pupils);
    std::vector<std::size_t> which;
    lommel::Answer<T> answer = answer_of(stack.count, window, scale, images, numbers);
    const AxisWindow at = axis_window(window, stack.count);
    const lommel::PixelWindow first = at.pixels(integrate);
    const auto windows =
        at.centers == nullptr ? lommel::PixelWindows(first) : lommel::PixelWindows{first, at.centers, stack.count};
    require_request(std::get<2>(window), tol, threads);
    if (powers.is_valid() && powers.shape(0) > 0) {
        which.assign(powers.data(), powers.data() + powers.shape(0));
        answer.powers = which.data();
        answer.derivatives = which.size();
        answer.derivative_images = derivative_images.data();
        answer.derivative_bounds = derivative_bounds.data();
    }
    return images_of(stack, windows, tol, threads, answer);
}

// Return whether averages of a stack, or only their derivatives, are faster from finer samples.
bool filters_pay(RadialFields pupils, WindowFields window, double tol, bool derivatives) {
    const lommel::Stack stack = stack_of(pupils);
    require_request(std::get<2>(window), tol, 1);
    const lommel::PixelRenderer<double> renderer(stack, one_axis_window(window).pixels(true), tol, 1, {});
    return derivatives ? renderer.filters_pay_for_derivatives() : renderer.filters_pay();
}

// Plan for repeated calls with stacks of pupils that differ in their phases only; everything else is checked once.
class RadialPlan {
   public:
    RadialPlan(double obscuration, In<double, 1> amplitude, WindowFields window, bool integrate, Request request, char kind)
        : obscuration_(obscuration_of(obscuration)), amplitude_(amplitude_of(amplitude)),
          window_(one_axis_window(window).pixels(integrate)), tol_(std::get<0>(request)), threads_(std::get<1>(request)),
          scale_(std::get<2>(request)), kind_(kind) {
        require_request(window_.step, tol_, threads_);
        require(kind == 'f' || kind == 'd', "kind must be f or d");
    }

    // Return the largest error bound, negative if the tolerance cannot be met; nothing if the arrays have other types or
    // shapes, or if finer samples are faster.
    std::optional<double> render(nb::handle coefficients, nb::handle images, nb::handle scales) const {
        return kind_ == 'f' ? rendered<float>(coefficients, images, scales) : rendered<double>(coefficients, images, scales);
    }

   private:
    template <class T>
    std::optional<double> rendered(nb::handle coefficients, nb::handle images, nb::handle scales) const {
        const Buffer<const double> phases(coefficients);
        const Buffer<T> values(images);
        if (!phases || !values || phases.ndim() == 0) {
            return {};
        }
        // A stack of any shape: coefficients, an image and a scale for each pupil.
        const std::size_t axes = phases.ndim() - 1;
        const auto matches = [&](const auto& array, std::size_t more) {
            return array.ndim() == axes + more && std::equal(array.shape(), array.shape() + axes, phases.shape());
        };
        if (!matches(values, 2) || values.shape()[axes] != static_cast<Py_ssize_t>(window_.height) ||
            values.shape()[axes + 1] != static_cast<Py_ssize_t>(window_.width)) {
            return {};
        }
        const auto pupils = static_cast<std::size_t>(
            std::accumulate(phases.shape(), phases.shape() + axes, Py_ssize_t{1}, std::multiplies<>()));
        const auto terms = static_cast<std::size_t>(phases.shape()[axes]);
        const lommel::Stack pupil_stack = stack_of(phases.data(), pupils, terms, obscuration_, amplitude_);
        if (window_.integrate && lommel::PixelRenderer<T>(pupil_stack, window_, tol_, threads_, {}).filters_pay()) {
            return {};
        }
        std::vector<double> numbers(3 * pupils);
        double *const bounds = numbers.data(), *const peaks = bounds + pupils, *const own = peaks + pupils;
        const auto answered = [&](double* factors) -> std::optional<double> {
            std::fill_n(factors, pupils, scale_);
            const lommel::Answer<T> answer{values.data(), factors, bounds, peaks};
            const double unmet = images_of(pupil_stack, window_, tol_, threads_, answer);
            return unmet > 0.0 ? -unmet : *std::max_element(bounds, peaks);
        };
        if (scales.is_none()) {
            return answered(own);
        }
        const Buffer<double> factors(scales);
        return factors && matches(factors, 0) ? answered(factors.data()) : std::nullopt;
    }

    double obscuration_;
    lommel::Amplitude amplitude_;
    lommel::PixelWindow window_;
    double tol_;
    int threads_;
    double scale_;
    char kind_;
};

std::pair<Out<complex, 2>, Out<double, 1>> field(RadialFields pupils, In<double, 1> v, double tol) {
    const lommel::Stack stack = stack_of(pupils);
    auto out = new_array<complex, 2>({stack.count, v.shape(0)});
    auto bounds = new_array<double, 1>({stack.count});
    released([&] { lommel::fields(stack, v.data(), v.shape(0), tol, out.data(), bounds.data()); });
    return {out, bounds};
}

// Error bounds are negative if the tolerance cannot be met.
std::tuple<Out<double, 2>, Out<double, 1>, Out<double, 1>> profile(RadialFields pupils, In<double, 1> v, double tol,
                                                                   int threads) {
    const lommel::Stack stack = stack_of(pupils);
    auto out = new_array<double, 2>({stack.count, v.shape(0)});
    auto peaks = new_array<double, 1>({stack.count});
    auto bounds = new_array<double, 1>({stack.count});
    released([&] { lommel::profiles(stack, v.data(), v.shape(0), tol, out.data(), bounds.data(), peaks.data(), threads); });
    return {out, bounds, peaks};
}

}  // namespace

void bindings::define_radial(nb::module_& m) {
    for_both([&](auto pixel) {
        m.def("render", &render<decltype(pixel)>, "stack"_a, "window"_a, "integrate"_a, "request"_a, "images"_a.noconvert(),
              "numbers"_a.noconvert(), "powers"_a.none() = nb::none(), "derivative_images"_a.noconvert().none() = nb::none(),
              "derivative_bounds"_a.noconvert().none() = nb::none(),
              "Images of a stack of pupils by the spectral engine, and their derivatives by the coefficients of t^power; "
              "returns 0, or the bound where tol cannot be met.");
    });
    m.def("filters_pay", &filters_pay, "stack"_a, "window"_a, "tol"_a, "derivatives"_a,
          "Whether averages of a stack, or their derivatives alone, had best be those of finer samples.");
    nb::class_<RadialPlan>(m, "RadialPlan", "Images of pupils, one stack after the other, that differ in their phase alone.")
        .def(nb::init<double, In<double, 1>, WindowFields, bool, Request, char>(), "obscuration"_a, "amplitude"_a, "window"_a,
             "integrate"_a, "request"_a, "kind"_a)
        .def(
            "render", &RadialPlan::render, "coefficients"_a, "images"_a, "scales"_a.none() = nb::none(),
            "Images, and what each is multiplied by, if that is wanted; returns the largest bound, below 0 where tol cannot be "
            "met, or None where the arrays do not match or are not of the types, the order and the access that this takes, and "
            "where averages had best be those of finer samples.");
    m.def("field", &field, "stack"_a, "v"_a, "tol"_a, "U at rising v, and bounds on its error.");
    m.def("profile", &profile, "stack"_a, "v"_a, "tol"_a, "threads"_a = 1,
          "I at rising v, bounds on its error over the peak, negative where tol cannot be met, and the peaks.");
}
