// Pixel averages: for circular pupils, and for any aperture by a rule that the caller provides.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include <nanobind/stl/optional.h>

#include "lommel/averages/disks.hpp"
#include "lommel/chordal/aperture_sums.hpp"

#include "pupils.hpp"

using namespace bindings;

namespace {

template <class T>
lommel::AverageRequest request_of(const WindowFields& window, const Request& request, const Out<T, 3>& images,
                                  const In<std::int32_t, 2>& factors) {
    const auto [tol, threads, scale] = request;
    const double step = std::get<2>(window);
    const std::size_t terms = factors.shape(0);
    require_request(step, tol, threads);
    require(terms == 0 || scale > 0.0, "derivatives of values that are divided by their largest one are not available");
    return {images.shape(1),
            images.shape(2),
            step,
            tol,
            scale,
            lommel::storing<T>(false),
            threads,
            terms > 0 ? factors_of(factors) : std::vector<lommel::ZernikeTerm>()};
}

template <class T>
bool disk_averages(DiskFields stack, WindowFields window, Request request, bool if_cheaper, Out<T, 3> images,
                   Out<double, 2> numbers, In<std::int32_t, 2> factors, Out<T, 4> slopes, Out<double, 2> bounds) {
    const lommel::Answer<T> into = answer_of(pupils_of(std::get<1>(stack)), window, std::get<2>(request), images, numbers);
    const lommel::AverageRequest averages = request_of(window, request, images, factors);
    const lommel::DiskPupils pupils = disks_of(stack, window);
    return released([&] {
        return lommel::averaged_images(averages, pupils.count, into, slopes.data(), bounds.data(),
                                       [&](const lommel::AverageAnswer& answer) {
                                           return lommel::DiskAverages(pupils, averages, if_cheaper).run(answer);
                                       });
    });
}

// Rule of an aperture: complex weights of the nodes of the disk that reproduce the moments of the aperture; error of the
// fields; whether that error includes sums in single precision.
using Weights = std::optional<std::tuple<In<double, 3>, double, bool>>;

template <class T>
bool aperture_averages(In<std::int32_t, 2> terms, In<double, 2> edge, WindowFields place, Request asked, double strehl,
                       double transmission, nb::object rule, Out<T, 3> images, Out<double, 2> numbers,
                       In<std::int32_t, 2> factors, Out<T, 4> slopes, Out<double, 2> bounds) {
    require(strehl > 0.0 && strehl <= 1.0 && transmission > 0.0, "strehl and transmission must be positive");
    const lommel::Answer<T> into = answer_of(pupils_of(edge), place, std::get<2>(asked), images, numbers);
    const lommel::AverageRequest request = request_of(place, asked, images, factors);
    const int threads = std::get<1>(asked);
    std::vector<lommel::ZernikeTerm> list = terms_of(terms, edge.shape(1));
    require_terms(list);
    const lommel::DiskWindow window = one_axis_window(place).first;
    const lommel::DiskPupils pupils{std::move(list), edge.data(), edge.shape(0), 0.0, lommel::Amplitude(), window, nullptr, {}};
    const auto sample = [&](const lommel::NodeQuestion& question, const lommel::AverageAnswer& to,
                            lommel::NodeNumbers& of_pupils) {
        lommel::DiskStack stack = pupils.stack();
        const lommel::PixelNodes nodes =
            lommel::nodes_about_axis(stack, pupils.window, {question.rows.places, question.columns.places},
                                     {question.rows.weights.data(), question.columns.weights.data()}, to.values,
                                     of_pupils.largest.data(), of_pupils.together.data());
        // Largest distance of nodes from the axis along one direction; the rule must be exact up to it.
        const auto reach = [](const std::vector<double>& places, std::size_t side, double center, double spacing) {
            const double middle = spacing * (0.5 * static_cast<double>(side - 1) - center);
            return std::max(std::abs(places.front() + middle), std::abs(places.back() + middle));
        };
        const double down = reach(question.rows.places, window.height, window.row, window.step),
                     across = reach(question.columns.places, window.width, window.column, window.step);
        const auto made = nb::cast<Weights>(
            rule(down, across, question.tol, question.single, question.rows.places.size(), question.columns.places.size()));
        if (!made) {
            throw lommel::ToleranceNotMet(1e300);
        }
        const auto& [weights, off, single] = *made;
        const std::size_t size = 2 * weights.shape(0);
        for (const std::size_t p : question.pupils) {
            of_pupils.error[p] = off;
        }
        const lommel::ApertureRule of_aperture{size, weights.data()};
        const auto ask = [&](auto real) {
            using Real = decltype(real);
            const lommel::ChordalDerivatives<Real> more{request.factors, nullptr, of_pupils.slope_error.data(), to.slopes,
                                                        of_pupils.steepest.data()};
            lommel::ApertureSums<Real>(stack, of_aperture, nodes.rows, nodes.columns, 1.0, nullptr, &nodes,
                                       of_pupils.brightest.data(), more, off, question.pupils, of_pupils.moduli.data())
                .run(threads);
        };
        const bool in_single = single;
        released([&] { in_single ? ask(float()) : ask(double()); });
    };
    return lommel::averaged_images(
        request, pupils.count, into, slopes.data(), bounds.data(), [&](const lommel::AverageAnswer& answer) {
            return lommel::average_at_nodes(request, {strehl, transmission}, pupils.count, answer, sample, true);
        });
}

template <class T>
void aperture_images(In<std::int32_t, 2> terms, In<double, 2> edge, WindowFields place, In<double, 3> weights, int threads,
                     Out<T, 3> images, In<std::int32_t, 2> factors, Out<T, 4> slopes) {
    const std::vector<lommel::ZernikeTerm> list = terms_of(terms, edge.shape(1));
    require_terms(list);
    require_shape(place, images);
    const lommel::DiskWindow window = one_axis_window(place).first;
    require_request(window.step, 1.0, threads);
    require(images.shape(0) == pupils_of(edge), "one image a pupil");
    require(weights.shape(0) == weights.shape(1) && weights.shape(2) == 8, "weights of a quadrant must be (chords, chords, 8)");
    const std::vector<lommel::ZernikeTerm> by = factors.shape(0) > 0 ? factors_of(factors) : std::vector<lommel::ZernikeTerm>();
    std::vector<double> brightest(edge.shape(0)), bounds(by.size() * edge.shape(0));  // bounds are left to the caller
    std::vector<std::size_t> all(edge.shape(0));
    std::iota(all.begin(), all.end(), std::size_t{0});
    released([&] {
        const lommel::DiskStack stack(list, edge.data(), edge.shape(0), 0.0, lommel::Amplitude());
        lommel::ApertureSums<T>(stack, {2 * weights.shape(0), weights.data()}, {window.height, window.row},
                                {window.width, window.column}, window.step, images.data(), nullptr, brightest.data(),
                                {by, slopes.data(), bounds.data()}, 0.0, all, nullptr)
            .run(threads);
    });
}

std::pair<Out<double, 1>, Out<double, 1>> transfer_rule(std::size_t degree) {
    const lommel::TransferRule rule(degree);
    return {array_of(rule.at), array_of(rule.weights)};
}

}  // namespace

void bindings::define_averages(nb::module_& m) {
    for_both([&](auto pixel) {
        using T = decltype(pixel);
        m.def(
            "disk_averages", &disk_averages<T>, "stack"_a, "window"_a, "request"_a, "if_cheaper"_a, "images"_a.noconvert(),
            "numbers"_a.noconvert(), "factors"_a, "slopes"_a.noconvert(), "bounds"_a.noconvert(),
            "Averages over pixels of pupils of Zernike terms (n, m), and derivatives by the coefficients of `factors`; scale 0 "
            "divides by the largest. Whether there are any: a window has no nodes, or the tolerance cannot be met.");
        m.def(
            "aperture_averages", &aperture_averages<T>, "terms"_a, "edge"_a, "window"_a, "request"_a, "strehl"_a,
            "transmission"_a, "rule"_a, "images"_a.noconvert(), "numbers"_a.noconvert(), "factors"_a, "slopes"_a.noconvert(),
            "bounds"_a.noconvert(),
            "The same of an aperture, by weights of the nodes of the disk: rule(down, across, tol, single, rows, columns) "
            "gives those "
            "of a quadrant, [chord][node][(+,+), (+,-), (-,+), (-,-) in x and y][re, im], what fields are off by within these "
            "distances, and whether sums may be in single precision, or None. Rows and columns are numbers of nodes.");
    });
    for_both([&](auto pixel) {
        m.def("aperture_images", &aperture_images<decltype(pixel)>, "terms"_a, "edge"_a, "window"_a, "weights"_a, "threads"_a,
              "images"_a.noconvert(), "factors"_a, "slopes"_a.noconvert(),
              "Intensities by such weights, and derivatives by the coefficients of `factors`, computed in the type of the "
              "images. Errors are left to the caller.");
    });
    m.def("least_average", &lommel::least_average, "step"_a,
          "What the best placed pixel of a pitch in v averages at least, over the peak of I.");
    m.def("transfer_rule", &transfer_rule, "degree"_a,
          "Frequencies and weights, by which the root of the sum of squares bounds the mean modulus of polynomials, even or "
          "odd.");
    m.def(
        "band_points", [](double reach) { return array_of(lommel::band_points(reach)); }, "reach"_a,
        "Chebyshev points of the band, at which the error of the response of samples up to a distance is found.");
}
