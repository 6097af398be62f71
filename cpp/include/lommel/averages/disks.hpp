// Pixel averages of circular and annular pupils with any Zernike terms: where it is faster, pixels far from the axis are
// computed from the pupil function on the rim, other pixels from samples at nodes of the window.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <vector>

#include "lommel/averages/at_nodes.hpp"
#include "lommel/chordal/images.hpp"
#include "lommel/rim/averages.hpp"
#include "lommel/rim/boxes.hpp"
#include "lommel/zernike/disk_stack.hpp"

namespace lommel {

class DiskAverages {
   public:
    // `if_cheaper`: throw LimitExceeded if the Zernike series that the caller has is estimated to be faster or, behind strips, nodes
    // of the aperture.
    DiskAverages(const DiskPupils& pupils, const AverageRequest& asked, bool if_cheaper)
        : pupils_(pupils), asked_(asked), if_cheaper_(if_cheaper), all_(pupils.count) {
        std::iota(all_.begin(), all_.end(), std::size_t{0});
    }
    virtual ~DiskAverages() = default;

    // Compute the averages; returns false if no nodes suit the window, or if the averages of a pupil miss the tolerance.
    bool run(const AverageAnswer& answer) {
        double variance = 0.0;
        for (std::size_t p = 0; p < pupils_.count; ++p) {
            variance = std::max(variance, phase_variance(pupils_.terms, pupils_.edge + p * pupils_.terms.size()));
        }
        light_ = {1.0 / (1.0 + variance), pupils_.amplitude.raised(2.0).integral(pupils_.obscuration)};
        if (asked_.factors.empty() && from_rims(answer)) {
            return true;
        }
        if (if_cheaper_ && asked_.factors.empty() && of_strips() > (asked_.tol > in_single ? 0.45 : 1.0) * most_behind) {
            throw LimitExceeded("nodes of the aperture are likely to take less time than strips");
        }
        return at_nodes(all_, asked_, centers_of(all_), true, answer);
    }

   protected:
    using Pupils = std::vector<std::size_t>;

    // Compute averages of pixels outside boxes of `box` x `box` pixels around the axes of the pupils `which`, and copy those
    // within boxes from answer.near. `error`: requested error. Write the error bound and the maximum of the averages outside, for
    // each pupil, to answer.numbers. Virtual so that tests can observe the call.
    virtual void outside(const Pupils& which, std::size_t box, double error, const RimAnswer& answer) const {
        const DiskStack stack = moved(which);
        RimAverages(stack, pupils_.window, box, error, answer).run(asked_.threads);
    }

   private:
    static constexpr int tries = 3;  // maximum number of box sizes tried for each pupil
    static constexpr double power = 4.0;  // errors fall at least with this power of the side of a box
    static constexpr double worth = 0.9;  // error aimed at with a larger box, as a fraction of the tolerance
    static constexpr double least_behind = 3e-6;  // smallest tolerance at which strips' averages are computed from rims
    // Largest of_strips() for which strips take less time than nodes of the aperture, whose sums are in single precision, and take
    // half the time, at tolerances above in_single.
    static constexpr double most_behind = 1800.0, in_single = 3e-5;
    static constexpr double farthest = 16.0;  // largest ratio of error to tolerance assumed in choosing the next box

    // Samples along the window, times about the lines across strips; those on one side of the axis take twice the time.
    double of_strips() const {
        const double pixels = static_cast<double>(std::max(asked_.height, asked_.width)),
                     reach = asked_.step * pixels / std::sqrt(2.0);
        double lines = 0.0;
        for (const Strip& strip : pupils_.strips) {
            lines += (strip.mirrored ? 2.0 : 1.0) * (strip.both() ? 1.0 : 2.0) * (1.0 + 0.6 * reach * strip.half());
        }
        return RimBoxes::nodes(asked_.step, pixels) * lines;
    }
    bool from_rims(const AverageAnswer& answer) {
        const double room = asked_.before_storing();
        const DiskStack stack = moved(all_);
        RimBoxes boxes(stack, pupils_.window, room, least_average(asked_.step));
        // Tables of fields behind strips take longer than other nodes of the aperture for errors this small.
        if (!(room > (stack.strips.empty() ? 0.0 : least_behind)) || !boxes.choose(asked_.threads)) {
            return false;
        }
        std::fill_n(answer.errors, pupils_.count, std::numeric_limits<double>::infinity());
        Pupils rest = all_;
        for (int attempt = 0; attempt < tries && !rest.empty(); ++attempt) {
            std::map<std::int64_t, Pupils> of_side;
            for (const std::size_t p : rest) {
                of_side[boxes.sides[p]].push_back(p);
            }
            of_side.erase(0);
            for (const auto& [side, which] : of_side) {
                with_box(which, side, attempt, boxes, stack, answer);
            }
            rest.erase(std::remove_if(rest.begin(), rest.end(), [&](std::size_t p) { return answer.errors[p] <= asked_.tol; }),
                       rest.end());
            for (const std::size_t p : rest) {
                // Behind strips fields are off, too, and less so with the same box as well.
                const std::int64_t next = larger(boxes.sides[p], answer.errors[p] / asked_.tol, boxes.most[p]);
                boxes.sides[p] = next == 0 && !stack.strips.empty() && boxes.sides[p] > 0 ? boxes.most[p] : next;
            }
        }
        if (rest.empty()) {
            return true;
        }
        const std::size_t pixels = asked_.pixels();
        std::vector<double> values(rest.size() * pixels), errors(rest.size()), peaks(rest.size());
        const AverageAnswer whole{values.data(), nullptr, errors.data(), peaks.data(), nullptr};
        if (!at_nodes(rest, asked_, centers_of(rest), rest.size() == pupils_.count, whole)) {
            return false;
        }
        for (std::size_t i = 0; i < rest.size(); ++i) {
            std::copy_n(values.data() + i * pixels, pixels, answer.values + rest[i] * pixels);
            answer.errors[rest[i]] = errors[i];
            answer.peaks[rest[i]] = peaks[i];
        }
        return true;
    }
    // Compute the averages of the pupils `which`, whose boxes have the same side: pixels in a box from nodes, others from the rim.
    // `stack`: all pupils, with axes at pixel centres; attempt: from 0 on. If averages in boxes miss the tolerance, `answer` is not
    // changed.
    void with_box(const Pupils& which, std::int64_t side, int attempt, const RimBoxes& boxes, const DiskStack& stack,
                  const AverageAnswer& answer) const {
        const std::size_t count = which.size();
        AverageRequest of_box = asked_;
        of_box.height = of_box.width = static_cast<std::size_t>(side);
        std::vector<double> near(count * of_box.pixels()), errors(count), peaks(count), remainders, numbers(2 * count);
        std::vector<double> centers = centers_of(which);
        std::vector<std::int64_t> places;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t p = which[i];
            centers[2 * i] -= static_cast<double>(stack.rows[p] - side / 2);
            centers[2 * i + 1] -= static_cast<double>(stack.columns[p] - side / 2);
            places.push_back(static_cast<std::int64_t>(p));
            remainders.push_back(boxes.remainders[p]);
            least = std::min(least, boxes.tolerances[p]);
        }
        if (!at_nodes(which, of_box, centers, true, {near.data(), nullptr, errors.data(), peaks.data(), nullptr})) {
            return;
        }
        // The tolerance is rounded to a power of sqrt(2), so that stacks with similar peaks share tables; those of fields behind strips
        // are better at each attempt.
        least *= stack.strips.empty() ? 1.0 : std::exp2(-2.0 * attempt);
        least = std::exp2(0.5 * std::floor(2.0 * std::log2(least)));
        std::vector<double> allowed(peaks);
        for (double& each : allowed) {
            each *= asked_.before_storing();
        }
        outside(which, of_box.height, least,
                {remainders.data(), near.data(), places.data(), answer.values, numbers.data(), allowed.data()});
        for (std::size_t i = 0; i < count; ++i) {
            const double off = numbers[2 * i], top = numbers[2 * i + 1];
            answer.peaks[which[i]] = asked_.divides() ? std::max(peaks[i], top) : peaks[i];
            answer.errors[which[i]] = std::max(errors[i], asked_.once_stored(off / peaks[i]));
        }
    }
    // Compute averages from samples at nodes of the window `asked` (image or box), with the pupils' axes at `centers`; return
    // whether the averages of all pupils meet the tolerance. `alone`: no other results exist yet; with if_cheaper_, LimitExceeded
    // is then thrown if a Zernike series is estimated to be faster.
    bool at_nodes(const Pupils& which, const AverageRequest& asked, const std::vector<double>& centers, bool alone,
                  const AverageAnswer& answer) const {
        DiskWindow window{asked.height, asked.width, static_cast<double>(asked.height / 2),
                          static_cast<double>(asked.width / 2), asked.step};
        DiskStack given = placed(which, centers, window);
        given.shrink();
        std::vector<double> scales(which.size());
        const auto sample = [&](const NodeQuestion& question, const AverageAnswer& to, NodeNumbers& numbers) {
            DiskStack stack = given;
            const PixelNodes nodes = nodes_about_axis(stack, window, {question.rows.places, question.columns.places},
                                                      {question.rows.weights.data(), question.columns.weights.data()},
                                                      to.values, numbers.largest.data(), numbers.together.data());
            const auto ask = [&](auto real) {
                using Real = decltype(real);
                std::fill(scales.begin(), scales.end(), 1.0);
                const Answer<Real> into{nullptr, scales.data(), numbers.error.data(), numbers.brightest.data()};
                if (!asked.factors.empty()) {
                    const ChordalDerivatives<Real> more{asked.factors, nullptr, numbers.slope_error.data(), to.slopes,
                                                        numbers.steepest.data()};
                    return ChordalRenderer<Real, ChordalDerivatives<Real>>(stack, nodes, question.tol, asked.threads, into,
                                                                           more)
                        .run();
                }
                ChordalRenderer<Real> images(stack, nodes, question.tol, asked.threads, into);
                if_cheaper_&& alone ? images.run_if_cheaper() : images.run();
            };
            question.single ? ask(float()) : ask(double());
        };
        return average_at_nodes(asked, light_, which.size(), answer, sample);
    }
    DiskStack stack_of(const Pupils& which) const {
        const std::size_t terms = pupils_.terms.size();
        std::vector<double> edge;
        for (const std::size_t p : which) {
            edge.insert(edge.end(), pupils_.edge + p * terms, pupils_.edge + (p + 1) * terms);
        }
        DiskStack made(pupils_.terms, edge.data(), which.size(), pupils_.obscuration, pupils_.amplitude);
        made.strips = pupils_.strips;
        return made;
    }
    // placed(): stack of pupils whose axes are at `centers`: the window's axis is moved there if these positions are equal;
    // otherwise each pupil gets a tilt that moves its image there. moved(): stack in which each pupil's axis is moved to the
    // nearest pixel centre, and a tilt makes up for the rest of the shift.
    DiskStack placed(const Pupils& which, const std::vector<double>& centers, DiskWindow& window) const {
        DiskStack stack = stack_of(which);
        bool same = true;
        for (std::size_t i = 2; i < centers.size(); ++i) {
            same = same && centers[i] == centers[i % 2];
        }
        if (same) {
            window.row = centers[0];
            window.column = centers[1];
        } else {
            stack.tilt_to(centers.data(), window);
        }
        return stack;
    }
    DiskStack moved(const Pupils& which) const {
        DiskWindow window = pupils_.window;
        DiskStack stack = placed(which, centers_of(which), window);
        stack.move_axes(window);
        stack.shrink();
        return stack;
    }
    std::vector<double> centers_of(const Pupils& which) const {
        std::vector<double> centers;
        for (const std::size_t p : which) {
            if (pupils_.centers == nullptr) {
                centers.insert(centers.end(), {pupils_.window.row, pupils_.window.column});
            } else {
                centers.insert(centers.end(), {pupils_.centers[2 * p], pupils_.centers[2 * p + 1]});
            }
        }
        return centers;
    }
    static std::int64_t larger(std::int64_t side, double times, std::int64_t most) {
        // If `times` is NaN, the comparison is false, and `farthest` is used.
        const double off = times < farthest ? times : farthest;
        const double grown = static_cast<double>(side) * std::pow(off / worth, 1.0 / power);
        const std::int64_t next =
            side + 2 * std::max<std::int64_t>(1, std::llround(std::ceil(0.5 * (grown - static_cast<double>(side)))));
        return side > 0 && next <= most ? next : 0;
    }

    DiskPupils pupils_;
    AverageRequest asked_;
    bool if_cheaper_;
    Pupils all_;
    PupilLight light_{1.0, 1.0};
};

}  // namespace lommel
