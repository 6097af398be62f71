// Refinement until the error bound meets the tolerance: compute, bound the error, repeat with more terms or nodes.
#pragma once

#include <cstddef>

#include "lommel/base/watch.hpp"
#include "lommel/limits.hpp"

namespace lommel {

// Call attempt(), which computes and returns its error bound, until the bound is at most `tol`; return the bound. more(bound)
// refines the next attempt; it returns false if no refinement is left.
template <class Attempt, class More>
double settle(double tol, const Attempt& attempt, const More& more) {
    for (;;) {
        look();
        const double bound = attempt();
        if (bound <= tol) {
            return bound;
        }
        if (!more(bound)) {
            throw ToleranceNotMet(bound);
        }
    }
}

// Smallest n >= `least` with enough(n), by bisection; about `most` if there is none below. enough(n) must be monotonic in n.
template <class Enough>
std::size_t fewest(std::size_t least, const Enough& enough, std::size_t most = std::size_t{1} << 30) {
    if (enough(least)) {
        return least;
    }
    std::size_t low = least, step = 1;  // enough(low) is false
    while (low + step < most && !enough(low + step)) {
        low += step;
        step *= 2;
    }
    for (std::size_t high = low + step; high - low > 1;) {
        const std::size_t middle = low + (high - low) / 2;
        (enough(middle) ? high : low) = middle;
    }
    return low + 1;
}

}  // namespace lommel
