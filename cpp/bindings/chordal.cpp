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

// Check the arrays that describe fields at the nodes of a quadrant, and convert them for the core.
lommel::NodeSeries node_series(const In<double, 3>& radial, const In<std::int32_t, 1>& ends, const In<complex, 3>& coefficients,
                               const In<std::int32_t, 2>& shares, const In<complex, 3>& factors,
                               const In<std::int32_t, 2>& sets, const In<double, 3>& terms, const In<std::int32_t, 1>& parities,
                               const In<complex, 5>& waves, const In<std::int32_t, 1>& wave) {
    const auto within = [](const std::int32_t* which, std::size_t size, std::size_t most, std::int32_t least = 0) {
        return std::all_of(which, which + size,
                           [&](std::int32_t i) { return i >= least && (i < 0 || static_cast<std::size_t>(i) < most); });
    };
    const auto at_nodes = [&](const auto& table, std::size_t axis) {
        return table.shape(axis) == radial.shape(1) && table.shape(axis + 1) == radial.shape(2);
    };
    const std::size_t planes = wave.shape(0), total = radial.shape(0);
    require(at_nodes(factors, 1) && at_nodes(terms, 1) && at_nodes(waves, 3), "tables must be at the same nodes");
    require(planes > 0 && coefficients.shape(1) == planes && coefficients.shape(2) == total,
            "one coefficient a plane and term");
    require(waves.shape(2) == 4 && within(wave.data(), planes, waves.shape(1)), "waves have four parities and are one a plane");
    require(within(ends.data(), ends.size(), total + 1) && std::is_sorted(ends.data(), ends.data() + ends.size()),
            "terms must be those of parts");
    require(parities.size() == terms.shape(0) && within(parities.data(), parities.size(), 4), "one parity a term");
    require(shares.shape(0) > 0 && shares.shape(1) == 3 && factors.shape(0) == shares.shape(0), "one factor a share");
    require(sets.shape(0) > 0 && sets.shape(1) == 3, "one set at the least");
    lommel::NodeSeries given{count_of(2 * radial.shape(1), 2 * radial.shape(2)),
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
        require(of[0] >= 0 && of[0] < 64 && within(of + 1, 1, 4) && within(of + 2, 1, ends.size()), "shares must be of parts");
        given.shares.push_back({of[0], of[1], of[2]});
        given.fields = std::max(given.fields, static_cast<std::size_t>(of[0]) + 1);
    }
    for (std::size_t i = 0; i < sets.shape(0); ++i) {
        const std::int32_t* of = sets.data() + 3 * i;
        require(
            within(of, 1, coefficients.shape(0)) && within(of + 1, 1, terms.shape(0), -1) && within(of + 2, 1, waves.shape(0)),
            "sets must be of series, terms and kinds of waves");
        given.sets.push_back({of[0], of[1], of[2]});
    }
    return given;
}

Out<complex, 5> folded_waves(In<double, 3> terms, In<std::int32_t, 1> parities, In<double, 2> edge, In<double, 2> weights,
                             double largest) {
    require(parities.size() == terms.shape(0) && edge.shape(1) == terms.shape(0), "one parity and coefficient a term");
    require(terms.shape(0) == 0 || (terms.shape(1) == weights.shape(0) && terms.shape(2) == weights.shape(1)),
            "tables must be at the same nodes");
    require(std::all_of(parities.data(), parities.data() + parities.size(), [](std::int32_t p) { return p >= 0 && p < 4; }),
            "parities must be from 0 to 3");
    require(largest >= 0.0 && largest < 1e300, "largest must be finite and at least 0");
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
    require(parts > 0 && std::is_sorted(last.begin(), last.end()) && last.back() == coefficients.shape(2),
            "terms must be those of parts");
    require(powers.shape(0) == last.back() && powers.shape(1) == curves && chosen.shape(0) == 2 && chosen.shape(1) == curves,
            "tables must be of the same terms and curves");
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
    require(checked_product({moduli.size(), curves}) == on_curves.size() && shares.shape(1) == parts,
            "tables must be of the same parts");
    require(std::all_of(series.data(), series.data() + sets,
                        [&](std::int32_t s) { return s >= 0 && static_cast<std::size_t>(s) < on_curves.shape(0); }),
            "sets must be of series");
    for (const auto* each : {&chords, &nodes}) {
        require(each->shape(0) == sets && each->shape(1) == curves, "one value a set and curve");
    }
    require(left.size() == sets && rounding.size() == sets, "one value a set");
    auto wrong = new_array<double, 3>({sets, planes, shares.shape(0)});
    lommel::SeriesSizes{on_curves.shape(0) * planes, parts, curves, on_curves.data(), moduli.data()}.errors(
        series.data(), sets, planes, chords.data(), nodes.data(), left.data(), rounding.data(), shares.data(), shares.shape(0),
        error, wrong.data());
    return wrong;
}

using Light = std::tuple<Out<double, 4>, Out<double, 2>, Out<double, 2>>;

Light series_light(In<double, 3> radial, In<std::int32_t, 1> ends, In<complex, 3> coefficients, In<std::int32_t, 2> shares,
                   In<complex, 3> factors, In<std::int32_t, 2> sets, In<double, 3> terms, In<std::int32_t, 1> parities,
                   In<complex, 5> waves, In<std::int32_t, 1> wave, double center_y, double center_x, std::size_t height,
                   std::size_t width, double step, In<double, 3> wrong, In<double, 1> power, int threads) {
    const lommel::NodeSeries given =
        node_series(radial, ends, coefficients, shares, factors, sets, terms, parities, waves, wave);
    require_image(height, width);
    require_center(center_y, center_x);
    require_request(step, 1.0, threads);
    require(wrong.shape(0) == given.sets.size() && wrong.shape(1) == given.planes && wrong.shape(2) == given.fields,
            "one error a set, plane and field");
    require(power.size() == given.planes &&
                std::all_of(power.data(), power.data() + power.size(), [](double p) { return p > 0.0; }),
            "one power a plane, above 0");
    auto values = new_array<double, 4>({given.sets.size(), given.planes, height, width});
    auto errors = new_array<double, 2>({given.sets.size(), given.planes});
    auto largest = new_array<double, 2>({given.sets.size(), given.planes});
    released([&] {
        std::vector<double> of_fields(wrong.size());
        const lommel::DiskWindow window{height, width, center_y, center_x, step};
        lommel::node_light(given, window, threads, values.data(), of_fields.data());
        lommel::light_errors(wrong.data(), of_fields.data(), given.sets.size(), given.planes, given.fields, errors.data());
        for (std::size_t i = 0; i < errors.size(); ++i) {
            const double over = power.data()[i % given.planes];
            largest.data()[i] =
                lommel::divide(lommel::processor_level(), over, height * width, values.data() + i * height * width);
            errors.data()[i] *= (1.0 + 1e-12) / over;
        }
    });
    return {values, errors, largest};
}

std::pair<Out<double, 2>, Out<double, 2>> series_gradient(In<double, 3> radial, In<std::int32_t, 1> ends,
                                                          In<complex, 3> coefficients, In<std::int32_t, 2> shares,
                                                          In<complex, 3> factors, In<std::int32_t, 2> sets, In<double, 3> terms,
                                                          In<std::int32_t, 1> parities, In<complex, 5> waves,
                                                          In<std::int32_t, 1> wave, double center_y, double center_x,
                                                          double step, In<double, 3> weights, int threads) {
    const lommel::NodeSeries given =
        node_series(radial, ends, coefficients, shares, factors, sets, terms, parities, waves, wave);
    const std::size_t height = weights.shape(1), width = weights.shape(2), rates = given.sets.size() - 1;
    require(weights.shape(0) == given.planes, "one image of weights a plane");
    require(std::all_of(given.sets.begin(), given.sets.end(), [](const lommel::FieldSet& set) { return set.term < 0; }),
            "sets must be without terms");
    require_image(height, width);
    require_center(center_y, center_x);
    require_request(step, 1.0, threads);
    auto values = new_array<double, 2>({given.planes, 1 + rates + terms.shape(0)});
    auto largest = new_array<double, 2>({given.planes, 1 + given.fields});
    const lommel::NodeGradient wanted{terms.shape(0), weights.data(), values.data(), largest.data()};
    released([&] { lommel::node_gradient(given, {height, width, center_y, center_x, step}, threads, wanted); });
    return {values, largest};
}

// Images by the chordal rule, only if their estimated time is less than that of the series.
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
    m.def("folded_waves", &folded_waves, "terms"_a, "parities"_a, "edge"_a, "weights"_a, "largest"_a,
          "Weighted sums by parity of exp(i W) at the images of nodes, and of i W exp(i W) over a largest W above 0.");
    m.def("chordal_series_light", &series_light, "radial"_a, "ends"_a, "coefficients"_a, "shares"_a, "factors"_a, "sets"_a,
          "terms"_a, "parities"_a, "waves"_a, "wave"_a, "center_y"_a, "center_x"_a, "height"_a, "width"_a, "step"_a, "wrong"_a,
          "power"_a, "threads"_a,
          "Sums of squares of fields whose amplitudes are series at the nodes of a quadrant, and derivatives, over the power "
          "of each "
          "plane; what they are off by, of fields that are `wrong` by so much; and the largest of each in modulus.");
    m.def("chordal_series_sizes", &series_sizes, "coefficients"_a, "ends"_a, "powers"_a, "rate"_a, "chosen"_a,
          "What parts are at most on curves around the real angles, and at these; and halved numbers of chords and nodes.");
    m.def("chordal_field_errors", &field_errors, "on_curves"_a, "moduli"_a, "series"_a, "chords"_a, "nodes"_a, "left"_a,
          "rounding"_a, "shares"_a, "error"_a, "What sums over chords and nodes are off by, of each set, plane and field.");
    m.def("chordal_series_gradient", &series_gradient, "radial"_a, "ends"_a, "coefficients"_a, "shares"_a, "factors"_a,
          "sets"_a, "terms"_a, "parities"_a, "waves"_a, "wave"_a, "center_y"_a, "center_x"_a, "step"_a, "weights"_a,
          "threads"_a,
          "Of weighted sums of these: they, their derivatives by further series and by all terms; and the largest of each.");
    m.def("chordal_sums_gradient", &sums_gradient, "terms"_a, "edge"_a, "obscuration"_a, "amplitude"_a, "center_y"_a,
          "center_x"_a, "step"_a, "chords"_a, "nodes"_a, "threads"_a, "weights"_a, "values"_a.noconvert(),
          "Of the sum of weights times these, the derivatives by the coefficients of all terms.");
}
