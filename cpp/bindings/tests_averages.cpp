// Nodes of windows, rims of pupils and the choice between them, for tests.
#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <nanobind/stl/optional.h>

#include "lommel/averages/disks.hpp"

#include "tests.hpp"

using namespace bindings;

namespace {

std::optional<Named> window_nodes(double step, std::size_t pixels, double error) {
    const auto made = lommel::window_nodes(step, pixels, error);
    if (made == nullptr) {
        return std::nullopt;
    }
    auto weights = new_array<double, 2>({pixels, made->places.size()});
    std::copy(made->weights.begin(), made->weights.end(), weights.data());
    return named("places"_a = made->places, "weights"_a = weights, "error"_a = made->error, "gain"_a = made->gain,
                 "spread"_a = made->spread);
}

// Bound the error of one pupil with given averages (`values`, of the image and of a derivative) and `numbers`; returns the
// requested error of the fields, and the bounds.
Named bounds_at_nodes(double step, std::size_t side, double tol, double storing, In<double, 3> values, In<double, 1> numbers,
                      double field, double slope) {
    const lommel::AverageRequest asked{side, side, step, tol, 1.0, storing, 1, {{2, 0}}};
    double error = 0.0, peak = 0.0, slope_error = 0.0, wanted = 0.0;
    bool single = false;
    std::vector<double> to(side * side), slopes(side * side), places;
    double node_error = 0.0, gain = 0.0, spread = 0.0;
    const auto sample = [&](const lommel::NodeQuestion& question, const lommel::AverageAnswer& answer,
                            lommel::NodeNumbers& found) {
        std::copy_n(values.data(), side * side, answer.values);
        found.error[0] = field * question.tol;
        found.brightest[0] = numbers.data()[0];
        found.largest[0] = numbers.data()[1];
        found.together[0] = numbers.data()[2];
        found.slope_error[0] = slope * question.tol;
        found.steepest[0] = numbers.data()[3];
        wanted = question.tol;
        single = question.single;
        places = question.rows.places;
        node_error = question.rows.error;
        gain = question.rows.gain;
        spread = question.rows.spread;
    };
    const bool made =
        lommel::average_at_nodes(asked, {1.0, 1.0}, 1, {to.data(), slopes.data(), &error, &peak, &slope_error}, sample);
    return named("made"_a = made, "error"_a = error, "slope_error"_a = slope_error, "wanted"_a = wanted, "single"_a = single,
                 "nodes"_a = places.size(), "node_error"_a = node_error, "gain"_a = gain, "spread"_a = spread);
}

// Averages by rims that fail for every `failing`-th pupil of a stack (0: none), to test the fallback.
class Watched : public lommel::DiskAverages {
   public:
    Watched(const lommel::DiskPupils& pupils, const lommel::AverageRequest& asked, bool if_cheaper, std::size_t failing)
        : DiskAverages(pupils, asked, if_cheaper), failing_(failing) {}
    mutable std::vector<std::pair<std::size_t, std::size_t>> boxes;  // side of the box, number of pupils

   protected:
    void outside(const Pupils& which, std::size_t box, double error, const lommel::RimAnswer& answer) const override {
        DiskAverages::outside(which, box, error, answer);
        boxes.emplace_back(box, which.size());
        for (std::size_t i = 0; i < which.size(); ++i) {
            if (failing_ > 0 && which[i] % failing_ == 0) {
                answer.numbers[2 * i] = 1.0;
            }
        }
    }

   private:
    std::size_t failing_;
};

In<double, 2> no_strips() {
    static const double nothing = 0.0;
    return In<double, 2>(&nothing, {0, 9}, nb::none());
}

Named watched_averages(In<std::int32_t, 2> terms, In<double, 2> edge, double obscuration, In<double, 1> amplitude,
                       In<double, 2> centers, double step, double tol, double scale, bool if_cheaper, std::size_t failing,
                       Out<double, 3> values) {
    const lommel::DiskPupils pupils =
        disks_of({terms, edge, obscuration, amplitude, no_strips()}, {{values.shape(1), values.shape(2)}, centers, step});
    const lommel::AverageRequest asked{values.shape(1), values.shape(2), step, tol, scale, 0.0, 1, {}};
    Watched averages(pupils, asked, if_cheaper, failing);
    std::vector<double> errors(pupils.count), peaks(pupils.count);
    const bool made = averages.run({values.data(), nullptr, errors.data(), peaks.data(), nullptr});
    std::vector<std::size_t> sides, counts;
    for (const auto& [side, count] : averages.boxes) {
        sides.push_back(side);
        counts.push_back(count);
    }
    return named("made"_a = made, "sides"_a = sides, "counts"_a = counts, "errors"_a = errors, "peaks"_a = peaks);
}

double rim_remainders(In<std::int32_t, 2> terms, In<double, 2> edge, double obscuration, In<double, 1> amplitude,
                      In<double, 2> centers, std::size_t height, std::size_t width, double step, int threads,
                      Out<double, 1> remainders, Out<double, 2> axes) {
    const std::size_t pupils = pupils_of(edge);
    return ask_disks<true>({terms, edge, obscuration, amplitude, no_strips()}, {{height, width}, centers, step}, 0.1, threads,
                           [&](const lommel::DiskStack& stack, const lommel::DiskWindow&) {
                               for (std::size_t p = 0; p < pupils; ++p) {
                                   axes.data()[2 * p] = static_cast<double>(stack.rows[p]);
                                   axes.data()[2 * p + 1] = static_cast<double>(stack.columns[p]);
                               }
                               if (lommel::RimStack::serves(stack)) {
                                   lommel::RimStack(stack).remainders(threads, remainders.data());
                               } else {
                                   std::fill_n(remainders.data(), pupils, std::numeric_limits<double>::infinity());
                               }
                           });
}

double rim_averages(In<std::int32_t, 2> terms, In<double, 2> edge, double obscuration, In<double, 1> amplitude,
                    In<double, 2> centers, double step, double error, int threads, In<double, 1> remainders, In<double, 3> near,
                    In<std::int64_t, 1> places, Out<double, 3> images, Out<double, 2> numbers) {
    const std::size_t box = near.shape(1);
    return ask_disks<true>(
        {terms, edge, obscuration, amplitude, no_strips()}, {{images.shape(1), images.shape(2)}, centers, step}, 0.1, threads,
        [&](const lommel::DiskStack& stack, const lommel::DiskWindow& window) {
            const lommel::RimAnswer answer{remainders.data(), near.data(), places.data(), images.data(), numbers.data()};
            lommel::RimAverages(stack, window, box, error, answer).run(threads);
        });
}

// Of each pixel of a RimTable, where fields near it are interpolated from, after its first angle: least and largest place; and the
// number of angles before the ring's first and after its last.
Named rim_starts(std::size_t box, std::size_t reach, double step, double error, double slope, In<double, 2> strips) {
    const lommel::RimTable table({step, box, reach, 0.3, 8, error, bindings::strips_of(strips), slope});
    std::vector<std::int64_t> least, largest;
    for (const lommel::RimPixels& each : table.pixels) {
        const auto [low, high] = std::minmax_element(&table.starts[each.turn], &table.starts[each.turn] + each.turns);
        least.push_back(*low);
        largest.push_back(*high);
    }
    return named("least"_a = least, "largest"_a = largest, "taps"_a = table.field_taps, "margin"_a = table.margin);
}

}  // namespace

void bindings::define_average_tests(nb::module_& m) {
    m.def("window_nodes", &window_nodes, "step"_a, "pixels"_a, "error"_a,
          "Nodes of a row of pixels, their weights, and what bounds averages by them; or None.");
    m.def("bounds_at_nodes", &bounds_at_nodes, "step"_a, "side"_a, "tol"_a, "storing"_a, "values"_a, "numbers"_a, "field"_a,
          "slope"_a, "Bounds on averages whose fields, and slopes, are off by so many times what was asked for.");
    m.def("watched_averages", &watched_averages, "terms"_a, "edge"_a, "obscuration"_a, "amplitude"_a, "centers"_a, "step"_a,
          "tol"_a, "scale"_a, "if_cheaper"_a, "failing"_a, "values"_a.noconvert(),
          "Averages over pixels, and the sides of boxes with the numbers of their pupils, one of so many of which fails.");
    m.attr("RIM_ORDERS") = lommel::rim_orders;
    m.def("rim_remainders", &rim_remainders, "terms"_a, "edge"_a, "obscuration"_a, "amplitude"_a, "centers"_a, "height"_a,
          "width"_a, "step"_a, "threads"_a, "remainders"_a.noconvert(), "axes"_a.noconvert(),
          "Of each pupil what the rim leaves of the field at v = 1, its mean over the disk, and the pixel of the axis.");
    m.def("rim_starts", &rim_starts, "box"_a, "reach"_a, "step"_a, "error"_a, "slope"_a, "strips"_a,
          "Places from which fields near pixels are interpolated around a ring, and how far a ring goes on.");
    m.def("rim_averages", &rim_averages, "terms"_a, "edge"_a, "obscuration"_a, "amplitude"_a, "centers"_a, "step"_a, "error"_a,
          "threads"_a, "remainders"_a, "near"_a, "places"_a, "images"_a.noconvert(), "numbers"_a.noconvert(),
          "Averages over pixels outside boxes around the axes from the rims of pupils, and the given ones within; of each what "
          "those are off by, and the largest.");
}
