// Images of pupils with arbitrary Zernike terms in small windows, by the chordal Gauss rule.
#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "lommel/chordal/field_gradient.hpp"
#include "lommel/chordal/fields.hpp"
#include "lommel/chordal/gradient.hpp"
#include "lommel/chordal/images.hpp"
#include "lommel/chordal/series_errors.hpp"
#include "lommel/chordal/sums.hpp"

#include "pupils.hpp"

using namespace bindings;

namespace {

template <class T>
using Images = lommel::ChordalRenderer<T>;

template <class T>
double derivatives(DiskFields stack, WindowFields window, Request request, Out<T, 3> images, Out<double, 2> numbers,
                   In<std::int32_t, 2> factors, Out<T, 4> slopes, Out<double, 2> bounds) {
    using Slopes = lommel::ChordalDerivatives<T>;
    const auto [tol, threads, scale] = request;
    const lommel::Answer<T> answer = answer_of(pupils_of(std::get<1>(stack)), window, scale, images, numbers);
    const Slopes wanted{factors_of(factors), slopes.data(), bounds.data()};
    require(scale > 0.0, "derivatives of values that are divided by their largest one are not available");
    return ask_disks<false, true>(stack, window, tol, threads, [&](const lommel::DiskStack& of, const lommel::DiskWindow& at) {
        lommel::ChordalRenderer<T, Slopes>(of, at, tol, threads, answer, wanted).run();
    });
}

// Check weights[pupil][row][column] and values[pupil][term], to which the gradient by the coefficients of terms is written.
lommel::ChordalGradient gradient_of(const DiskFields& stack, const WindowFields& window, const In<std::int32_t, 2>& terms,
                                    const In<double, 3>& weights, const Out<double, 2>& values) {
    const std::size_t pupils = pupils_of(std::get<1>(stack));
    lommel::ChordalGradient wanted{factors_of(terms), weights.data(), values.data()};
    require(weights.shape(0) == pupils, "one image of weights a pupil");
    require(values.shape(0) == pupils && values.shape(1) == wanted.terms.size(), "one value a pupil and term");
    require_shape(window, weights);
    return wanted;
}

double gradient(DiskFields stack, WindowFields window, double tol, int threads, In<double, 3> weights,
                In<std::int32_t, 2> factors, Out<double, 2> values) {
    const lommel::ChordalGradient wanted = gradient_of(stack, window, factors, weights, values);
    const std::size_t pupils = weights.shape(0);
    std::vector<double> scales(pupils, 1.0), bounds(pupils), peaks(pupils);
    const lommel::Answer<double> answer{nullptr, scales.data(), bounds.data(), peaks.data()};
    return ask_disks<false>(stack, window, tol, threads, [&](const lommel::DiskStack& of, const lommel::DiskWindow& at) {
        lommel::ChordalRenderer<double, lommel::ChordalGradient>(of, at, tol, threads, answer, wanted).run();
    });
}

// Even numbers of chords and of nodes on each.
using Counts = std::pair<std::size_t, std::size_t>;

lommel::ChordCount count_of(const Counts& counts) {
    const auto [chords, nodes] = counts;
    const auto fits = [](std::size_t count) { return count >= 4 && count <= lommel::max_chords && count % 2 == 0; };
    require(fits(chords) && fits(nodes), "chords and nodes must be even, and from 4 to 1024");
    return {chords, nodes};
}

// Intensities[pupil][column][row].
void sums(DiskFields stack, WindowFields window, Counts counts, int threads, Out<float, 3> images) {
    const lommel::ChordCount count = count_of(counts);
    ask_disks<false>(stack, window, 1.0, threads, [&](const lommel::DiskStack& of, const lommel::DiskWindow& at) {
        lommel::ChordalSums<>(of, at, count).run(images.data(), threads);
    });
}

void sums_gradient(DiskFields stack, WindowFields window, Counts counts, int threads, In<double, 3> weights,
                   Out<double, 2> values) {
    const lommel::ChordCount count = count_of(counts);
    const lommel::ChordalGradient wanted = gradient_of(stack, window, std::get<0>(stack), weights, values);
    ask_disks<false>(stack, window, 1.0, threads, [&](const lommel::DiskStack& of, const lommel::DiskWindow& at) {
        lommel::ChordalSums<lommel::ChordalGradient>(of, at, count, wanted).run(nullptr, threads);
    });
}

// NamedTuples of lommel.core.engine. NodeTables: radial[term][chord][node]; ends of the terms of each part; shares[share][field,
// parity, part]; factors[share][chord][node].
using TableFields = std::tuple<In<double, 3>, In<std::int32_t, 1>, In<std::int32_t, 2>, In<complex, 3>>;
// NodeTerms: Zernike terms[term][chord][node], and the parity of each.
using TermFields = std::tuple<In<double, 3>, In<std::int32_t, 1>>;
// NodeWaves: sums of waves[kind][wave][parity][chord][node], and the wave of each plane.
using WaveFields = std::tuple<In<complex, 5>, In<std::int32_t, 1>>;
// Coefficients[series][plane][term] of the tables, and sets[set][series, term, kind of waves].
using SetFields = std::tuple<In<complex, 3>, In<std::int32_t, 2>>;

// Convert the arrays that describe fields at the nodes of a quadrant for the core.
lommel::NodeSeries node_series(const TableFields& tables, const SetFields& series, const TermFields& of_terms,
                               const WaveFields& of_waves) {
    const auto& [radial, ends, shares, factors] = tables;
    const auto& [coefficients, sets] = series;
    const auto& [terms, parities] = of_terms;
    const auto& [waves, wave] = of_waves;
    const std::size_t chords = radial.shape(1), nodes = radial.shape(2);
    const std::size_t planes = wave.shape(0), total = radial.shape(0);
    lommel::NodeSeries given{count_of({2 * chords, 2 * nodes}),
                             planes,
                             0,
                             total,
                             {},
                             radial.data(),
                             coefficients.data(),
                             {},
                             factors.data(),
                             {},
                             terms.data(),
                             parities.data(),
                             waves.shape(1),
                             waves.data(),
                             wave.data()};
    given.ends.assign(ends.data(), ends.data() + ends.size());
    for (std::size_t i = 0; i < shares.shape(0); ++i) {
        const std::int32_t* of = shares.data() + 3 * i;
        given.shares.push_back({of[0], of[1], of[2]});
        given.fields = std::max(given.fields, static_cast<std::size_t>(of[0]) + 1);
    }
    for (std::size_t i = 0; i < sets.shape(0); ++i) {
        const std::int32_t* of = sets.data() + 3 * i;
        given.sets.push_back({of[0], of[1], of[2]});
    }
    return given;
}

Out<complex, 5> folded_waves(TermFields of, In<double, 2> edge, In<double, 2> weights, double largest) {
    const auto& [terms, parities] = of;
    const std::size_t waves = edge.shape(0), nodes = weights.size(), each = 4 * nodes, kinds = largest > 0.0 ? 2 : 1;
    auto values = new_array<complex, 5>({kinds, waves, 4, weights.shape(0), weights.shape(1)});
    for (std::size_t i = 0; i < waves; ++i) {
        lommel::fold_waves(lommel::processor_level(), nodes, terms.data(), parities.data(), terms.shape(0),
                           edge.data() + i * edge.shape(1), weights.data(), largest, values.data() + i * each, waves * each);
    }
    return values;
}

using Sizes = std::tuple<Out<double, 4>, Out<double, 3>, double, double>;

Sizes series_sizes(In<complex, 3> coefficients, In<std::int32_t, 1> ends, In<double, 2> powers, In<double, 1> rate,
                   In<double, 2> chosen) {
    const std::size_t sets = coefficients.shape(0), planes = coefficients.shape(1), curves = rate.size(), parts = ends.size();
    const std::vector<std::size_t> last(ends.data(), ends.data() + parts);
    auto on_curves = new_array<double, 4>({sets, planes, parts, curves});
    auto moduli = new_array<double, 3>({sets, planes, parts});
    double needed[2];
    lommel::SeriesSizes{sets * planes, parts, curves, on_curves.data(), moduli.data()}.sum(
        lommel::processor_level(), coefficients.data(), last, powers.data(), rate.data(), chosen.data(), needed);
    return {on_curves, moduli, needed[0], needed[1]};
}

Out<double, 3> field_errors(Out<double, 4> on_curves, Out<double, 3> moduli, In<std::int32_t, 1> series, In<double, 2> chords,
                            In<double, 2> nodes, In<double, 1> left, In<double, 1> rounding, In<double, 2> shares,
                            double error) {
    const std::size_t sets = series.size(), planes = on_curves.shape(1), parts = on_curves.shape(2),
                      curves = on_curves.shape(3);
    auto wrong = new_array<double, 3>({sets, planes, shares.shape(0)});
    lommel::SeriesSizes{on_curves.shape(0) * planes, parts, curves, on_curves.data(), moduli.data()}.errors(
        series.data(), sets, planes, chords.data(), nodes.data(), left.data(), rounding.data(), shares.data(), shares.shape(0),
        error, wrong.data());
    return wrong;
}

using Light = std::tuple<Out<double, 4>, Out<double, 2>, Out<double, 2>>;

Light series_light(TableFields tables, SetFields series, TermFields terms, WaveFields waves, WindowFields place,
                   In<double, 3> wrong, In<double, 1> power, int threads) {
    const lommel::NodeSeries given = node_series(tables, series, terms, waves);
    const lommel::DiskWindow window = one_axis_window(place).first;
    require_request(window.step, 1.0, threads);
    auto values = new_array<double, 4>({given.sets.size(), given.planes, window.height, window.width});
    auto errors = new_array<double, 2>({given.sets.size(), given.planes});
    auto largest = new_array<double, 2>({given.sets.size(), given.planes});
    released([&] {
        std::vector<double> of_fields(wrong.size());
        lommel::node_light(given, window, threads, values.data(), of_fields.data());
        lommel::light_errors(wrong.data(), of_fields.data(), given.sets.size(), given.planes, given.fields, errors.data());
        const std::size_t size = window.height * window.width;
        for (std::size_t i = 0; i < errors.size(); ++i) {
            const double over = power.data()[i % given.planes];
            largest.data()[i] = lommel::divide(lommel::processor_level(), over, size, values.data() + i * size);
            errors.data()[i] *= (1.0 + 1e-12) / over;
        }
    });
    return {values, errors, largest};
}

std::pair<Out<double, 2>, Out<double, 2>> series_gradient(TableFields tables, SetFields series, TermFields of_terms,
                                                          WaveFields waves, WindowFields place, In<double, 3> weights,
                                                          int threads) {
    const lommel::NodeSeries given = node_series(tables, series, of_terms, waves);
    const lommel::DiskWindow window = one_axis_window(place).first;
    const std::size_t rates = given.sets.size() - 1, terms = std::get<0>(of_terms).shape(0);
    require_shape(place, weights);
    require(weights.shape(0) == given.planes, "one image of weights a plane");
    require_request(window.step, 1.0, threads);
    auto values = new_array<double, 2>({given.planes, 1 + rates + terms});
    auto largest = new_array<double, 2>({given.planes, 1 + given.fields});
    const lommel::NodeGradient wanted{terms, weights.data(), values.data(), largest.data()};
    released([&] { lommel::node_gradient(given, window, threads, wanted); });
    return {values, largest};
}

// Images by the chordal rule, only if their estimated time is less than that of the series.
template <class T>
struct CheaperImages : Images<T> {
    using Images<T>::Images;
    void run() { this->run_if_cheaper(); }
};

std::pair<double, double> costs(DiskFields stack, WindowFields window, double tol, bool single) {
    std::pair<double, double> found;
    std::vector<double> scales(pupils_of(std::get<1>(stack)), 1.0), bounds(scales.size()), peaks(scales.size());
    const double unmet =
        ask_disks<false>(stack, window, tol, 1, [&](const lommel::DiskStack& of, const lommel::DiskWindow& at) {
            const auto ask = [&](auto pixel) {
                using T = decltype(pixel);
                const lommel::Answer<T> nowhere{nullptr, scales.data(), bounds.data(), peaks.data()};
                found = Images<T>(of, at, tol, 1, nowhere).costs();
            };
            single ? ask(float()) : ask(double());
        });
    require(unmet == 0.0, "the tolerance cannot be met");
    return found;
}

}  // namespace

void bindings::define_chordal(nb::module_& m) {
    define_disk_images<Images, false, true>(m, "chordal_images",
                                            "The same by the chordal rule; bounds are over the largest value of the window.");
    define_disk_images<CheaperImages, false>(m, "cheaper_chordal_images",
                                             "The same, unless the series is likely to take less time: a Declined then.");
    m.def("disk_costs", &costs, "stack"_a, "window"_a, "tol"_a, "single"_a,
          "Nanoseconds that images are likely to take by the chordal rule and by the series.");
    for_both([&](auto pixel) {
        m.def("chordal_derivatives", &derivatives<decltype(pixel)>, "stack"_a, "window"_a, "request"_a, "images"_a.noconvert(),
              "numbers"_a.noconvert(), "factors"_a, "slopes"_a.noconvert(), "bounds"_a.noconvert(),
              "The same, and derivatives by the coefficients of terms (n, m), with bounds on their errors over the peak.");
    });
    m.def("chordal_gradient", &gradient, "stack"_a, "window"_a, "tol"_a, "threads"_a, "weights"_a, "factors"_a,
          "values"_a.noconvert(),
          "Of the sum of weights times intensities over an image, the derivatives by the coefficients of terms.");
    m.def("chordal_sums", &sums, "stack"_a, "window"_a, "counts"_a, "threads"_a, "images"_a.noconvert(),
          "Intensities by so many chords and nodes, in single precision, of each pupil column by column.");
    m.def("folded_waves", &folded_waves, "terms"_a, "edge"_a, "weights"_a, "largest"_a,
          "Weighted sums by parity of exp(i W) at the images of nodes, and of i W exp(i W) over a largest W above 0.");
    m.def("chordal_series_light", &series_light, "tables"_a, "series"_a, "terms"_a, "waves"_a, "window"_a, "wrong"_a, "power"_a,
          "threads"_a,
          "Sums of squares of fields whose amplitudes are series at the nodes of a quadrant, and derivatives, over the power "
          "of each plane; what they are off by, of fields that are `wrong` by so much; and the largest of each in modulus.");
    m.def("chordal_series_sizes", &series_sizes, "coefficients"_a, "ends"_a, "powers"_a, "rate"_a, "chosen"_a,
          "What parts are at most on curves around the real angles, and at these; and halved numbers of chords and nodes.");
    m.def("chordal_field_errors", &field_errors, "on_curves"_a, "moduli"_a, "series"_a, "chords"_a, "nodes"_a, "left"_a,
          "rounding"_a, "shares"_a, "error"_a, "What sums over chords and nodes are off by, of each set, plane and field.");
    m.def("chordal_series_gradient", &series_gradient, "tables"_a, "series"_a, "terms"_a, "waves"_a, "window"_a, "weights"_a,
          "threads"_a,
          "Of weighted sums of these: they, their derivatives by further series and by all terms; and the largest of each.");
    m.def("chordal_sums_gradient", &sums_gradient, "stack"_a, "window"_a, "counts"_a, "threads"_a, "weights"_a,
          "values"_a.noconvert(), "Of the sum of weights times these, the derivatives by the coefficients of all terms.");
}
