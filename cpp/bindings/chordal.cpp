// Pupils with arbitrary Zernike terms on small windows, by the chordal Gauss rule.
#include <utility>
#include <vector>

#include "lommel/chordal/gradient.hpp"
#include "lommel/chordal/images.hpp"
#include "lommel/chordal/sums.hpp"

#include "pupils.hpp"

using namespace bindings;

namespace {

template <class T>
using Images = lommel::ChordalRenderer<T>;

std::vector<lommel::ZernikeTerm> factors_of(const In<std::int32_t, 2>& given) {
    const std::vector<lommel::ZernikeTerm> terms = terms_of(given, given.shape(0));
    require_terms(terms);
    for (const lommel::ZernikeTerm& term : terms) {
        require(term.n > 0, "no image depends on a constant");
    }
    return terms;
}

template <class T, class... Center>
double derivatives(In<std::int32_t, 2> terms, In<double, 2> edge, double obscuration, In<double, 1> amplitude, Center... center,
                   double step, double tol, int threads, double scale, Out<T, 3> images, Out<double, 2> numbers,
                   In<std::int32_t, 2> factors, Out<T, 4> slopes, Out<double, 2> bounds) {
    using Slopes = lommel::ChordalDerivatives<T>;
    const lommel::DiskAnswer<T> answer = disk_answer_of(pupils_of(edge), scale, images, numbers);
    const Slopes wanted{factors_of(factors), slopes.data(), bounds.data()};
    require(scale > 0.0, "derivatives of values that are divided by their largest one are not available");
    require_derivatives(wanted.terms.size(), edge.shape(0), images, slopes, bounds);
    return ask_disks<false>(
        terms, edge, obscuration, amplitude, images.shape(1), images.shape(2), step, tol, threads,
        [&](const lommel::DiskStack& stack, const lommel::DiskWindow& window) {
            lommel::ChordalRenderer<T, Slopes>(stack, window, tol, threads, answer, wanted).run();
        },
        center...);
}

template <class... Center>
double gradient(In<std::int32_t, 2> terms, In<double, 2> edge, double obscuration, In<double, 1> amplitude, Center... center,
                double step, double tol, int threads, In<double, 3> weights, In<std::int32_t, 2> factors,
                Out<double, 2> values) {
    const std::size_t pupils = pupils_of(edge);
    const lommel::ChordalGradient wanted{factors_of(factors), weights.data(), values.data()};
    require(weights.shape(0) == pupils, "one image of weights a pupil");
    require(values.shape(0) == pupils && values.shape(1) == wanted.terms.size(), "one value a pupil and term");
    std::vector<double> scales(pupils, 1.0), bounds(pupils), peaks(pupils);
    const lommel::DiskAnswer<double> answer{nullptr, scales.data(), bounds.data(), peaks.data()};
    return ask_disks<false>(
        terms, edge, obscuration, amplitude, weights.shape(1), weights.shape(2), step, tol, threads,
        [&](const lommel::DiskStack& stack, const lommel::DiskWindow& window) {
            lommel::ChordalRenderer<double, lommel::ChordalGradient>(stack, window, tol, threads, answer, wanted).run();
        },
        center...);
}

lommel::ChordCount count_of(std::size_t chords, std::size_t nodes) {
    const auto fits = [](std::size_t count) { return count >= 4 && count <= lommel::max_chords && count % 2 == 0; };
    require(fits(chords) && fits(nodes), "chords and nodes must be even, and from 4 to 1024");
    return {chords, nodes};
}

void sums(In<std::int32_t, 2> terms, In<double, 2> edge, double obscuration, In<double, 1> amplitude, double center_y,
          double center_x, double step, std::size_t chords, std::size_t nodes, int threads, Out<float, 3> images) {
    const lommel::ChordCount count = count_of(chords, nodes);
    require(images.shape(0) == pupils_of(edge), "one image a pupil");
    ask_disks<false>(
        terms, edge, obscuration, amplitude, images.shape(2), images.shape(1), step, 1.0, threads,
        [&](const lommel::DiskStack& stack, const lommel::DiskWindow& window) {
            lommel::ChordalSums<>(stack, window, count).run(images.data(), threads);
        },
        center_y, center_x);
}

void sums_gradient(In<std::int32_t, 2> terms, In<double, 2> edge, double obscuration, In<double, 1> amplitude, double center_y,
                   double center_x, double step, std::size_t chords, std::size_t nodes, int threads, In<double, 3> weights,
                   Out<double, 2> values) {
    const lommel::ChordCount count = count_of(chords, nodes);
    const std::size_t pupils = pupils_of(edge);
    const lommel::ChordalGradient wanted{factors_of(terms), weights.data(), values.data()};
    require(weights.shape(0) == pupils, "one image of weights a pupil");
    require(values.shape(0) == pupils && values.shape(1) == wanted.terms.size(), "one value a pupil and term");
    ask_disks<false>(
        terms, edge, obscuration, amplitude, weights.shape(1), weights.shape(2), step, 1.0, threads,
        [&](const lommel::DiskStack& stack, const lommel::DiskWindow& window) {
            lommel::ChordalSums<lommel::ChordalGradient>(stack, window, count, wanted).run(nullptr, threads);
        },
        center_y, center_x);
}

// Images only where they are likely to take less time than by the series.
template <class T>
struct CheaperImages : Images<T> {
    using Images<T>::Images;
    void run() { this->run_if_cheaper(); }
};

std::pair<double, double> costs(In<std::int32_t, 2> terms, In<double, 2> edge, double obscuration, In<double, 1> amplitude,
                                double center_y, double center_x, std::size_t height, std::size_t width, double step,
                                double tol, bool single) {
    std::pair<double, double> found;
    std::vector<double> scales(pupils_of(edge), 1.0), bounds(scales.size()), peaks(scales.size());
    const double unmet = ask_disks<false>(
        terms, edge, obscuration, amplitude, height, width, step, tol, 1,
        [&](const lommel::DiskStack& stack, const lommel::DiskWindow& window) {
            const auto ask = [&](auto pixel) {
                using T = decltype(pixel);
                const lommel::DiskAnswer<T> nowhere{nullptr, scales.data(), bounds.data(), peaks.data()};
                found = Images<T>(stack, window, tol, 1, nowhere).costs();
            };
            single ? ask(float()) : ask(double());
        },
        center_y, center_x);
    require(unmet == 0.0, "the tolerance cannot be met");
    return found;
}

}  // namespace

void bindings::define_chordal(nb::module_& m) {
    define_disk_images<Images, false>(m, "chordal_images",
                                      "The same by the chordal rule; bounds are over the largest value of the window.");
    define_disk_images<CheaperImages, false>(m, "cheaper_chordal_images",
                                             "The same, unless the series is likely to take less time: a Declined then.");
    m.def("disk_costs", &costs, "terms"_a, "edge"_a, "obscuration"_a, "amplitude"_a, "center_y"_a, "center_x"_a, "height"_a,
          "width"_a, "step"_a, "tol"_a, "single"_a,
          "Nanoseconds that images are likely to take by the chordal rule and by the series.");
    for_both([&](auto pixel) {
        using T = decltype(pixel);
        m.def("chordal_derivatives", &derivatives<T, double, double>, "terms"_a, "edge"_a, "obscuration"_a, "amplitude"_a,
              "center_y"_a, "center_x"_a, "step"_a, "tol"_a, "threads"_a, "scale"_a, "images"_a.noconvert(),
              "numbers"_a.noconvert(), "factors"_a, "slopes"_a.noconvert(), "bounds"_a.noconvert(),
              "The same, and derivatives by the coefficients of terms (n, m), with bounds on their errors over the peak.");
        m.def("chordal_derivatives", &derivatives<T, In<double, 2>>, "terms"_a, "edge"_a, "obscuration"_a, "amplitude"_a,
              "centers"_a, "step"_a, "tol"_a, "threads"_a, "scale"_a, "images"_a.noconvert(), "numbers"_a.noconvert(),
              "factors"_a, "slopes"_a.noconvert(), "bounds"_a.noconvert(), "The same, each around an axis of its own.");
    });
    m.def("chordal_gradient", &gradient<double, double>, "terms"_a, "edge"_a, "obscuration"_a, "amplitude"_a, "center_y"_a,
          "center_x"_a, "step"_a, "tol"_a, "threads"_a, "weights"_a, "factors"_a, "values"_a.noconvert(),
          "Of the sum of weights times intensities over an image, the derivatives by the coefficients of terms.");
    m.def("chordal_gradient", &gradient<In<double, 2>>, "terms"_a, "edge"_a, "obscuration"_a, "amplitude"_a, "centers"_a,
          "step"_a, "tol"_a, "threads"_a, "weights"_a, "factors"_a, "values"_a.noconvert(),
          "The same, each around an axis of its own.");
    m.def("chordal_sums", &sums, "terms"_a, "edge"_a, "obscuration"_a, "amplitude"_a, "center_y"_a, "center_x"_a, "step"_a,
          "chords"_a, "nodes"_a, "threads"_a, "images"_a.noconvert(),
          "Intensities by so many chords and nodes, in single precision, of each pupil column by column.");
    m.def("chordal_sums_gradient", &sums_gradient, "terms"_a, "edge"_a, "obscuration"_a, "amplitude"_a, "center_y"_a,
          "center_x"_a, "step"_a, "chords"_a, "nodes"_a, "threads"_a, "weights"_a, "values"_a.noconvert(),
          "Of the sum of weights times these, the derivatives by the coefficients of all terms.");
}
