// Apertures of ellipses and polygons: quadrature along their rows, and images.
#include <nanobind/stl/vector.h>

#include <numeric>
#include <vector>

#include "lommel/aperture/moments.hpp"
#include "lommel/aperture/row_images.hpp"
#include "lommel/zernike/pupil_growth.hpp"

#include "pupils.hpp"

using namespace bindings;

namespace {

lommel::Region region_of(const In<double, 2>& ellipses, const In<double, 2>& corners, const In<std::int32_t, 1>& counts,
                         const In<std::int32_t, 1>& steps) {
    std::vector<lommel::Part> parts;
    std::size_t ellipse = 0, corner = 0;
    for (std::size_t i = 0; i < counts.shape(0); ++i) {
        const std::size_t count = static_cast<std::size_t>(counts.data()[i]);
        if (count == 0) {
            const double* e = ellipses.data() + 5 * ellipse++;
            parts.push_back(lommel::Part::ellipse({e[0], e[1]}, e[2], e[3], e[4]));
            continue;
        }
        std::vector<lommel::Point> points;
        for (std::size_t k = 0; k < count; ++k, ++corner) {
            points.push_back({corners.data()[2 * corner], corners.data()[2 * corner + 1]});
        }
        parts.push_back(lommel::Part::polygon(points));
    }
    return {parts, {steps.data(), steps.data() + steps.shape(0)}};
}

lommel::RowRule row_rule(In<double, 2> ellipses, In<double, 2> corners, In<std::int32_t, 1> counts, In<std::int32_t, 1> steps,
                         std::size_t degree, double error) {
    require(degree <= 20000 && error > 0.0 && error < 1.0, "degree must be 20000 at most, error from above 0 to below 1");
    const lommel::Region region = region_of(ellipses, corners, counts, steps);
    return released([&] { return lommel::RowRule(region, degree, error); });
}

lommel::RowRule row_samples(In<double, 1> y, In<std::int64_t, 1> counts, In<double, 1> x, In<double, 1> weights,
                            In<double, 1> phase) {
    return {y.data(), counts.data(), y.shape(0), x.data(), weights.data(), phase.shape(0) == 0 ? nullptr : phase.data()};
}

// Nodes as an array [x, y, weight][node].
Out<double, 2> nodes(const lommel::RowRule& rule) {
    const std::size_t count = rule.rows().empty() ? 0 : rule.rows().back().first + rule.rows().back().count;
    const Out<double, 2> found = new_array<double, 2>({3, count});
    for (const lommel::RowRule::Row& row : rule.rows()) {
        for (std::size_t k = row.first; k < row.first + row.count; ++k) {
            found.data()[k] = rule.x()[k];
            found.data()[count + k] = row.y;
            found.data()[2 * count + k] = rule.weights()[k];
        }
    }
    return found;
}

void images(const std::vector<const lommel::RowRule*>& rules, In<double, 2> phases, DiskFields stack, WindowFields place,
            double precision, int threads, Out<double, 3> out, In<std::int32_t, 2> factors, Out<double, 4> slopes,
            Out<double, 1> losses) {
    const auto& [terms, edge, obscuration, amplitude, strips] = stack;  // the rules leave the obscuration out
    const std::vector<lommel::ZernikeTerm> list = terms_of(terms, edge.shape(1));
    require_terms(list);
    const lommel::Amplitude light = amplitude_of(amplitude);
    const std::size_t pupils = pupils_of(edge);
    const lommel::DiskWindow window = one_axis_window(place).first;
    require_request(window.step, precision, threads);
    std::vector<lommel::ZernikeTerm> by;
    for (std::size_t j = 0; j < factors.shape(0); ++j) {
        by.push_back({factors.data()[2 * j], factors.data()[2 * j + 1]});
    }
    require_terms(by);
    std::vector<lommel::PhasedRule> regions;
    for (std::size_t i = 0; i < rules.size(); ++i) {
        const double* phase = phases.data() + 3 * i;
        regions.push_back({rules[i], {phase[0], phase[1], phase[2]}});
    }
    released([&] {
        lommel::row_images(regions, list, edge.data(), pupils, light, window, precision, threads, out.data(), by, slopes.data(),
                           losses.data());
    });
}

Out<double, 1> growth_curves() {
    auto made = new_array<double, 1>({lommel::ChordCurves::count});
    std::copy(lommel::chord_curves.b.begin(), lommel::chord_curves.b.end(), made.data());
    return made;
}

double stack_growth(In<std::int32_t, 2> terms, In<double, 2> edge, std::size_t curve, std::pair<double, double> reach,
                    int threads) {
    const std::vector<lommel::ZernikeTerm> list = terms_of(terms, edge.shape(1));
    require_terms(list);
    require(curve < lommel::ChordCurves::count && reach.first >= 0.0 && reach.second >= 0.0 && threads >= 0,
            "no such curve, or reach or threads below 0");
    const std::size_t pupils = pupils_of(edge);
    return released(
        [&] { return lommel::growth_of_stack(list, edge.data(), pupils, curve, {reach.first, reach.second}, threads); });
}

void require_basis(std::size_t degree) { require(degree <= 2000, "degree must be 2000 at most"); }

Out<complex, 2> moments(std::size_t degree, In<double, 1> y, In<std::int64_t, 1> counts, In<double, 1> t,
                        In<complex, 1> weights) {
    require_basis(degree);
    require(y.size() == counts.size() && t.size() == weights.size(), "one count a row, and one weight a node");
    const auto nonnegative = [](std::int64_t count) { return count >= 0; };
    require(std::all_of(counts.data(), counts.data() + counts.size(), nonnegative) &&
                std::accumulate(counts.data(), counts.data() + counts.size(), std::int64_t{0}) ==
                    static_cast<std::int64_t>(t.size()),
            "counts must sum to the number of nodes");
    auto made = new_array<complex, 2>({degree + 1, degree + 1});
    std::fill_n(made.data(), made.size(), complex(0.0));
    released(
        [&] { lommel::DiskBasis(degree).moments(y.data(), counts.data(), y.size(), t.data(), weights.data(), made.data()); });
    return made;
}

Out<complex, 2> moment_values(std::size_t degree, In<complex, 2> moments, In<double, 1> y, In<double, 1> t) {
    require_basis(degree);
    require(moments.shape(0) > degree && moments.shape(1) > degree, "moments up to the degree");
    auto made = new_array<complex, 2>({y.size(), t.size()});
    released([&] {
        lommel::DiskBasis(degree).values(moments.data(), moments.shape(1), y.data(), y.size(), t.data(), t.size(), made.data());
    });
    return made;
}

}  // namespace

void bindings::define_aperture(nb::module_& m) {
    nb::class_<lommel::RowRule>(m, "RowRule", "Quadrature over a region of ellipses and convex polygons within the unit disc.")
        .def_prop_ro("nodes", &nodes, nb::rv_policy::move, "x, y and weight of each node, shape (3, nodes).")
        .def_prop_ro("weight", &lommel::RowRule::weight, "The sum of the weights: the area over pi.")
        .def_prop_ro("lost", &lommel::RowRule::lost, "Bound on what misplaced edges do to integrals of what is at most 1.");
    m.def("row_rule", &row_rule, "ellipses"_a, "corners"_a, "counts"_a, "steps"_a, "degree"_a, "error"_a,
          "Return a rule that is off by at most an error for polynomials that are at most 1 on the unit disc.");
    m.def("row_samples", &row_samples, "y"_a, "counts"_a, "x"_a, "weights"_a, "phase"_a, "Return samples as such a rule.");
    m.def("row_images", &images, "rules"_a, "phases"_a, "stack"_a, "window"_a, "precision"_a, "threads"_a,
          "images"_a.noconvert(), "factors"_a, "slopes"_a.noconvert(), "losses"_a.noconvert(),
          "Intensities of pupils over regions with phases, and derivatives by the coefficients of terms.");
    m.def("growth_curves", &growth_curves, "Heights of the complex curves of stack_growth.");
    m.def("stack_growth", &stack_growth, "terms"_a, "edge"_a, "curve"_a, "reach"_a, "threads"_a,
          "Bound on the logarithm of the mean of |exp(i Phi - i v.rho)| on the chords of a curve, |v| up to `reach` along x "
          "and y.");
    m.def("moments", &moments, "degree"_a, "y"_a, "counts"_a, "t"_a, "weights"_a,
          "Sums of an orthonormal basis of the unit disc, [k][m], over nodes in rows at y, at x = t sqrt(1 - y^2).");
    m.def("moment_values", &moment_values, "degree"_a, "moments"_a, "y"_a, "t"_a,
          "Sums over the basis times moments at the points (t sqrt(1 - y^2), y), shape (rows, nodes).");
}
