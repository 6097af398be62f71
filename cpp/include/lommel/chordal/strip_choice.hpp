// Choice of the quadrature of the strips of an aperture (docs/certificate-chords.md, section 8, "Strips").
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include "lommel/bounds/strips.hpp"
#include "lommel/chordal/strips.hpp"
#include "lommel/zernike/disk_stack.hpp"

namespace lommel {

struct StripChoice {
    // Parts of the allowed error for the sums across and along strips; the interpolation has the rest.
    static constexpr double part_across = 0.5, part_along = 0.2;

    StripCount count;
    double error = 0.0, misfits = 0.0;  // error by sums; and by interpolation, over the misfit of its weights

    StripChoice() = default;
    // For the strips of some pupils, whose fields at the points of `window`, `pixels` in number, may all be off by `allowed`. degree:
    // highest degree of the terms by which the pupil function is multiplied.
    StripChoice(const DiskStack& stack, const std::vector<std::size_t>& pupils, std::size_t degree, const VBox& window,
                double pixels, double allowed) {
        const TermPairs pairs(stack.terms);
        StripPhases phases;
        for (const std::size_t p : pupils) {
            phases.include(pairs, stack.outer.data() + p * stack.terms.size());
        }
        const std::vector<double> growth = phases.growth(stack.amplitude, degree);
        std::vector<StripBound> bounds;
        for (const Strip& strip : stack.strips) {
            bounds.emplace_back(strip, *cache<StripShape>.get(strip), phases, growth, window);
        }
        const auto all = [&](const auto& bound) {
            double sum = 0.0;
            for (const StripBound& strip : bounds) {
                sum += bound(strip);
            }
            return sum;
        };
        constexpr std::size_t most_nodes = 400;
        std::size_t lines = 1, nodes = 6;
        double across = 0.0, along = 0.0;
        while (!((across = all([&](const StripBound& strip) { return strip.across(lines); })) <= part_across * allowed)) {
            refuse_if(++lines > most_lines, "lines across a strip");
        }
        while (!((along = all([&](const StripBound& strip) { return strip.along(nodes); })) <= part_along * allowed)) {
            nodes += nodes < 32 ? 2 : nodes < 64 ? 4 : 8;
            refuse_if(nodes > most_nodes, "nodes along a strip");
        }
        // Fewer taps take a finer table, whose places take sums over the nodes: the pair of both that takes the least time.
        double least = std::numeric_limits<double>::infinity();
        const double reach = std::hypot(std::max(-window.left, window.right), std::max(-window.top, window.bottom));
        error = across + along;
        misfits = all([&](const StripBound& strip) { return strip.between(1.0); });
        count = {lines, nodes, 0, 0.0};
        for (const Interpolations::Choice& choice : cache<Interpolations>.get()->choices) {
            const double work =
                2.0 * reach / choice.spacing * static_cast<double>(nodes) + pixels * static_cast<double>(choice.taps + 2);
            if (work < least && error + misfits * choice.misfit <= allowed) {
                least = work;
                count.taps = choice.taps;
                count.spacing = choice.spacing;
            }
        }
        refuse_if(count.taps == 0, "taps");
    }
    // Bound on the rounding error of the strips' field, over twice their area / pi, without that of phases: of sums over the nodes of
    // a line and over taps. The moduli of the weights of an interpolation sum to less than 2.
    double rounding(std::size_t terms, bool single) const {
        const double sums = 4.0 * static_cast<double>(count.nodes) + 4.0 * static_cast<double>(count.taps) + 40.0;
        return unit_roundoff * sums + (single ? single_roundoff * sums + 7.4e-10 * static_cast<double>(terms + 4) : 0.0);
    }

   private:
    static void refuse_if(bool too_many, const char* what) {
        if (too_many) {
            throw LimitExceeded(std::string("phases, windows and vanes this large take too many ") + what +
                                "; smaller ones fit");
        }
    }
};

}  // namespace lommel
