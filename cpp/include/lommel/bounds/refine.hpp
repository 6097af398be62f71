// Refinement until the error bound meets the tolerance: compute, bound the error, repeat with more terms or nodes.
#pragma once

#include <cstddef>

#include "lommel/base/watch.hpp"
#include "lommel/limits.hpp"

namespace lommel {

// Calls attempt(), which computes and returns its error bound, until this is at most `tol`; returns it. more(bound) makes the
// next attempt more exact, or returns false if it cannot.
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

// Returns the least n >= `least` with enough(n), which must be monotonic; about `most` if no smaller n is enough.
template <class Enough>
std::size_t fewest(std::size_t least, const Enough& enough, std::size_t most = std::size_t{1} << 30) {
    if (enough(least)) {
        return least;
    }
    std::size_t low = least, step = 1;  // not enough
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
