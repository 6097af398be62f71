// Choice of a box of pixels for each pupil: in it, averages are computed from samples at nodes; outside, from the pupil function on
// the rim of the aperture.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <vector>

#include "lommel/base/pi.hpp"
#include "lommel/rim/averages.hpp"
#include "lommel/zernike/disk_stack.hpp"

namespace lommel {

// Choice of the size of each pupil's box, a square of pixels around the axis, and whether boxes save computing time. Estimated
// times are in units of the time of one sample, for one pair of a node along x and a node along y.
class RimBoxes {
   public:
    std::vector<std::int64_t> sides;  // [pupil]: side of its box in pixels, odd; 0: nodes for the whole window
    std::vector<std::int64_t> most;  // [pupil]: largest allowed side of its box; 0: none
    std::vector<double> remainders, tolerances;  // [pupil]: results of RimStack::remainders(); allowed errors of averages

    // Estimated number of nodes along `pixels` pixels.
    static double nodes(double step, double pixels) { return 0.6366 * step * pixels + 9.0; }
    // `tol`: tolerance relative to the largest average. `lowest`: lower bound on (largest average) / (peak).
    RimBoxes(const DiskStack& stack, const DiskWindow& window, double tol, double lowest)
        : stack_(stack), height_(static_cast<std::int64_t>(window.height)), width_(static_cast<std::int64_t>(window.width)),
          step_(window.step), tol_(tol), lowest_(lowest) {
        for (std::size_t p = 0; p < stack.count; ++p) {
            most.push_back(largest_of(p));
            tolerances.push_back(tolerance_of(p));
        }
    }
    // Compute `sides` and `remainders`; returns whether boxes, with the rim for the pixels outside them, save time.
    bool choose(int threads) {
        const std::size_t pupils = stack_.count, every = (pupils + probed - 1) / probed;
        const bool none = *std::max_element(most.begin(), most.end()) < smallest();
        if (none || !RimStack::serves(stack_) || with_box(smallest()) > whole()) {
            return false;
        }
        // In a large stack, first check whether boxes save time for a sample of its pupils.
        std::vector<std::size_t> all(pupils), some;
        std::iota(all.begin(), all.end(), std::size_t{0});
        std::copy_if(all.begin(), all.end(), std::back_inserter(some), [&](std::size_t p) { return p % every == 0; });
        if ((every > 1 && !pay(some, threads)) || !pay(all, threads)) {
            return false;
        }
        gather_few();
        return true;
    }

   private:
    static constexpr std::size_t probed = 16;  // number of pupils in a sample of a large stack
    // Pixels outside boxes are computed from the waves of the rim only if the diagonal of the window, in pixels, is at most
    // reach * sqrt(P / s). P: number of pupils, which share tables; s: pixel pitch in lambda / (2 pi NA).
    static constexpr double reach = 200.0;
    static constexpr double shorter = 0.5;  // factor on `reach` with an obscuration: a pixel then has 3 times as many weights
    static constexpr double shortest = 48.0;  // least value of reach / sqrt(s): small windows gain most
    static constexpr double further = 4.0;  // least value of P, as small stacks often follow one another
    // Times / (time of one sample). rim, rims: for the pixels outside the box of a pupil without, with an obscuration; call: fixed
    // time of a stack.
    static constexpr double rim = 2500.0, rims = 5500.0, call = 9000.0;
    // The same for the spike of a strip in a window with sides of `spiked` pixels; pupils fill vectors of `vector` lanes.
    static constexpr double spike = 2000.0, spiked = 33.0, vector = 16.0;
    // The same for tables that fields behind strips take, over the pixel pitch: in such a window at the tolerance `coarse`, and of
    // eight stacks, as seldom more share them.
    static constexpr double tables = 1.2e5, coarse = 1e-4;
    static constexpr std::int64_t together = 8;  // least number of pupils with boxes of equal side; fewer get larger boxes
    static constexpr double widest = 0.7;  // largest side of a box, relative to the shorter side of the window
    static constexpr double narrowest = 18.0;  // least half side of a box, in lambda / (2 pi NA)
    // Fraction of the tolerance for errors due to RimStack::remainders(), without and with strips, which take of the rest.
    static constexpr double left = 0.4, left_behind = 0.2;
    // Boxes are used if their estimated time is at most `worth` times that of nodes for the whole window.
    static constexpr double worth = 0.85;

    double count() const { return static_cast<double>(stack_.count); }
    std::int64_t smallest() const { return std::max<std::int64_t>(5, 2 * std::llround(std::ceil(narrowest / step_)) + 1); }
    std::int64_t largest_of(std::size_t pupil) const {
        const std::int64_t row = stack_.rows[pupil], column = stack_.columns[pupil], last_row = height_ - 1 - row,
                           last_column = width_ - 1 - column;
        // Limit the distance of the farthest pixel from the axis: the size of the tables grows with it.
        const double farthest = static_cast<double>(std::max({row, last_row, column, last_column}));
        const double most_pixels = std::max(shortest, (stack_.obscuration > 0.0 ? shorter : 1.0) * reach / std::sqrt(step_));
        if (std::sqrt(2.0) * (2.0 * farthest + 1.0) > most_pixels * std::sqrt(std::max(further, count()))) {
            return 0;
        }
        const std::int64_t beside = std::min({row, last_row, column, last_column}),
                           part = std::llround(std::ceil(widest * static_cast<double>(std::min(height_, width_)))) - 1;
        return beside < 0 ? 0 : std::min(2 * beside + 1, part - (part + 1) % 2);
    }
    double tolerance_of(std::size_t pupil) const {
        // tol_ * (estimated largest average). Of two estimates, one for large and one for small pixels, the smaller is used.
        const double variance = phase_variance(stack_.terms, stack_.outer.data() + pupil * stack_.terms.size());
        return tol_ * std::min(4.4 * lowest_ / (1.0 + 0.5 * variance), 0.9 / (1.0 + variance));
    }
    std::int64_t side_of(std::size_t pupil, double remainder) const {
        const double mean = std::min(1.0, std::sqrt(4.0 * pi) / step_) * remainder;
        for (const double part : {stack_.strips.empty() ? left : left_behind, left}) {
            for (std::int64_t side = smallest(); side <= most[pupil]; side += 2) {
                const double nearest = 0.5 * step_ * static_cast<double>(side),
                             field = mean * std::pow(nearest, -static_cast<double>(rim_orders));
                if (field * (2.0 * std::sqrt(1.7 / (nearest * nearest * nearest)) + field) <= part * tolerances[pupil]) {
                    return side;
                }
            }
        }
        return 0;
    }
    double nodes(std::int64_t pixels) const { return nodes(step_, static_cast<double>(pixels)); }
    // Estimated time per pupil; unit: the time of one sample, at a node along x and a node along y. whole(): if all pixels are
    // computed from samples; with_box(): if only those in a box are, and the pixels outside from the rim of the aperture. Behind
    // strips, fewer pupils than lanes take as long as a vector of them.
    double filling() const { return stack_.strips.empty() ? 1.0 : std::max(1.0, vector / count()); }
    double whole() const { return filling() * nodes(height_) * nodes(width_); }
    double with_box(std::int64_t side) const {
        double spikes = 0.0, once = call;
        for (const Strip& strip : stack_.strips) {
            spikes += strip.intervals();
        }
        const double wide = static_cast<double>(std::max(height_, width_)) / spiked;
        if (!stack_.strips.empty()) {
            once += tables * step_ * std::sqrt(coarse / tol_) * wide * wide;
        }
        return filling() * (nodes(side) * nodes(side) + spike * spikes * std::min(1.0, wide)) +
               (stack_.obscuration > 0.0 ? rims : rim) + once / count();
    }
    // Compute `sides` and `remainders` of the pupils `which`; returns whether boxes take at most `worth` of the time without boxes.
    bool pay(const std::vector<std::size_t>& which, int threads) {
        remainders.resize(which.size());
        if (which.size() == stack_.count) {
            RimStack(stack_).remainders(threads, remainders.data());
        } else {
            std::vector<double> edge;
            for (const std::size_t p : which) {
                const auto own = stack_.outer.begin() + static_cast<std::ptrdiff_t>(p * stack_.terms.size());
                edge.insert(edge.end(), own, own + static_cast<std::ptrdiff_t>(stack_.terms.size()));
            }
            const DiskStack some(stack_.terms, edge.data(), which.size(), stack_.obscuration, stack_.amplitude);
            RimStack(some).remainders(threads, remainders.data());
        }
        double work = 0.0;
        sides.assign(which.size(), 0);
        for (std::size_t i = 0; i < which.size(); ++i) {
            sides[i] = side_of(which[i], remainders[i]);
            work += sides[i] > 0 ? with_box(sides[i]) : whole();
        }
        return work <= worth * whole() * static_cast<double>(which.size());
    }
    // If fewer than `together` pupils have boxes of equal side, each gets the next larger side in use, if at most its most[pupil].
    void gather_few() {
        std::vector<std::int64_t> counts(static_cast<std::size_t>(*std::max_element(sides.begin(), sides.end())) + 1, 0);
        for (const std::int64_t side : sides) {
            ++counts[static_cast<std::size_t>(side)];
        }
        std::vector<std::int64_t> to(counts.size(), 0);
        std::int64_t larger = 0;
        for (std::size_t side = counts.size() - 1; side > 0; --side) {
            const bool few = counts[side] < together || static_cast<std::int64_t>(stack_.count) <= together;
            larger = counts[side] > 0 && (larger == 0 || !few) ? static_cast<std::int64_t>(side) : larger;
            to[side] = larger;
        }
        for (std::size_t p = 0; p < sides.size(); ++p) {
            const std::int64_t side = to[static_cast<std::size_t>(sides[p])];
            sides[p] = side <= most[p] ? side : sides[p];
        }
    }

    const DiskStack& stack_;
    std::int64_t height_, width_;
    double step_, tol_, lowest_;
};

}  // namespace lommel
