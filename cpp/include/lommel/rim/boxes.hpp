// How large a box around the axis each pupil needs, whose pixels are averaged from samples, all others being averaged from the rim.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lommel/base/once.hpp"
#include "lommel/rim/averages.hpp"
#include "lommel/zernike/disk_stack.hpp"

namespace lommel {

// Boxes are chosen by counts: of the nodes that samples have in a box and in the window, and of what rims take beside them.
class RimBoxes {
   public:
    std::vector<std::int64_t> sides;  // of the box of each pupil, odd; 0 where rims do not pay
    std::vector<double> remainders, tolerances;  // those of RimStack, and what averages may be off by

    // The tolerance is relative to the largest average, which of pupils without aberration is 4.4 times `lowest` or more.
    RimBoxes(const DiskStack& stack, const DiskWindow& window, double tol, double lowest)
        : stack_(stack), height_(static_cast<std::int64_t>(window.height)), width_(static_cast<std::int64_t>(window.width)),
          step_(window.step), tol_(tol), lowest_(lowest) {}

    // Whether rims are likely to take less time than nodes of the whole window; only then there are boxes.
    bool choose(int threads);

   private:
    static constexpr std::size_t probed = 16;  // pupils that stand for a stack
    static constexpr double reach = 48.0;  // pixels from corner to corner, per root of the pupils that share tables
    static constexpr double rim = 2500.0, rims = 5500.0, call = 9000.0;  // pairs of nodes that take as long
    static constexpr std::int64_t together = 8;  // pupils of one box at the least, where others have a larger one
    static constexpr double widest = 0.7;  // of a window, what a box may take
    static constexpr double narrowest = 18.0;  // v around the axis
    static constexpr double left = 0.4;  // of the tolerance, what may be left of the field
    static constexpr double worth = 0.85;  // of the time that nodes of the whole window take

    std::int64_t smallest() const { return std::max<std::int64_t>(5, 2 * std::llround(std::ceil(narrowest / step_)) + 1); }
    double largest() const { return widest * static_cast<double>(std::min(height_, width_)); }
    // Pixels between an axis and the nearest edge of the window.
    std::int64_t beside(std::size_t pupil) const {
        return std::min(std::min(stack_.rows[pupil], height_ - 1 - stack_.rows[pupil]),
                        std::min(stack_.columns[pupil], width_ - 1 - stack_.columns[pupil]));
    }
    double nodes(std::int64_t pixels) const { return 0.6366 * step_ * static_cast<double>(pixels) + 9.0; }
    double tolerance(std::size_t pupil) const;
    std::int64_t box(std::size_t pupil, double remainder) const;
    bool pay(const std::vector<std::size_t>& which, int threads);
    void gather_few();

    const DiskStack& stack_;
    std::int64_t height_, width_;
    double step_, tol_, lowest_;
};

#if defined(LOMMEL_DEFINES)
LOMMEL_ONCE double RimBoxes::tolerance(std::size_t pupil) const {
    // Of the likely largest average, by the variance of the phase over the disk without piston and tilt.
    double variance = 0.0;
    const double* const edge = stack_.outer.data() + pupil * stack_.terms.size();
    for (std::size_t t = 0; t < stack_.terms.size(); ++t) {
        const ZernikeTerm& term = stack_.terms[t];
        const double c = std::clamp(edge[t], -1e6, 1e6);
        variance += term.n > 1 ? c * c / static_cast<double>((term.n + 1) * (term.m == 0 ? 1 : 2)) : 0.0;
    }
    return tol_ * std::min(4.4 * lowest_ / (1.0 + 0.5 * variance), 0.9 / (1.0 + variance));
}

LOMMEL_ONCE std::int64_t RimBoxes::box(std::size_t pupil, double remainder) const {
    const double farthest = static_cast<double>(std::max(std::max(stack_.rows[pupil], height_ - 1 - stack_.rows[pupil]),
                                                         std::max(stack_.columns[pupil], width_ - 1 - stack_.columns[pupil])));
    // Tables grow with the way to the farthest pixel.
    if (std::sqrt(2.0) * (2.0 * farthest + 1.0) > reach * std::sqrt(static_cast<double>(stack_.count))) {
        return 0;
    }
    const double mean = std::min(1.0, std::sqrt(4.0 * 3.14159265358979323846) / step_) * remainder;
    for (std::int64_t side = smallest(); static_cast<double>(side) < largest(); side += 2) {
        const double nearest = 0.5 * step_ * static_cast<double>(side),
                     field = mean * std::pow(nearest, -static_cast<double>(rim_orders));
        if (field * (2.0 * std::sqrt(1.7 / (nearest * nearest * nearest)) + field) <= left * tolerance(pupil)) {
            return side / 2 <= beside(pupil) ? side : 0;
        }
    }
    return 0;
}

// Finds boxes of some pupils; whether these pay.
LOMMEL_ONCE bool RimBoxes::pay(const std::vector<std::size_t>& which, int threads) {
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
    const double whole = nodes(height_) * nodes(width_),
                 beside = (stack_.obscuration > 0.0 ? rims : rim) + call / static_cast<double>(stack_.count);
    double work = 0.0;
    sides.assign(which.size(), 0);
    for (std::size_t i = 0; i < which.size(); ++i) {
        sides[i] = box(which[i], remainders[i]);
        work += sides[i] > 0 ? nodes(sides[i]) * nodes(sides[i]) + beside : whole;
    }
    return work <= worth * whole * static_cast<double>(which.size());
}

// Few pupils of a box go with the next larger one.
LOMMEL_ONCE void RimBoxes::gather_few() {
    const std::int64_t most = *std::max_element(sides.begin(), sides.end());
    std::vector<std::int64_t> counts(static_cast<std::size_t>(most) + 1, 0);
    for (const std::int64_t side : sides) {
        ++counts[static_cast<std::size_t>(side)];
    }
    std::vector<std::int64_t> to(counts.size(), 0);
    std::int64_t larger = most;
    for (std::int64_t side = most; side > 0; --side) {
        const std::int64_t many = counts[static_cast<std::size_t>(side)];
        if (many > 0) {
            const bool few = many < together || static_cast<std::int64_t>(stack_.count) <= together;
            to[static_cast<std::size_t>(side)] = few ? larger : side;
            larger = few ? larger : side;
        }
    }
    for (std::int64_t& side : sides) {
        side = to[static_cast<std::size_t>(side)];
    }
}

LOMMEL_ONCE bool RimBoxes::choose(int threads) {
    const std::size_t count = stack_.count;
    const double whole = nodes(height_) * nodes(width_), least = nodes(smallest()) * nodes(smallest());
    const bool wide =
        std::hypot(static_cast<double>(height_), static_cast<double>(width_)) > reach * std::sqrt(static_cast<double>(count));
    if (!RimStack::serves(stack_) || wide || static_cast<double>(smallest()) >= largest() ||
        least + rim + call / static_cast<double>(count) > whole) {
        return false;
    }
    // Of many, some stand for all at first.
    const std::size_t every = (count + probed - 1) / probed;
    std::vector<std::size_t> all(count), some;
    for (std::size_t p = 0; p < count; ++p) {
        all[p] = p;
        if (p % every == 0) {
            some.push_back(p);
        }
    }
    if ((every > 1 && !pay(some, threads)) || !pay(all, threads)) {
        return false;
    }
    gather_few();
    tolerances.resize(count);
    for (std::size_t p = 0; p < count; ++p) {
        tolerances[p] = tolerance(p);
    }
    return true;
}
#endif

}  // namespace lommel
