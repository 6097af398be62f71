// Growth of a pupil function at complex points: bound on the mean of its modulus over chords of the disk, continued to complex
// coordinates. It is computed from samples, and so is smaller than the product of the bounds for single Zernike terms.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "lommel/base/aligned.hpp"
#include "lommel/base/cache.hpp"
#include "lommel/base/pi.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/base/wide.hpp"
#include "lommel/bounds/disk.hpp"
#include "lommel/special/exponential.hpp"
#include "lommel/special/radial_polynomials.hpp"

namespace lommel {

// Zernike terms at sampled complex points cos(a + ib) xi + sin(a + ib) cos(tau) xi' of the disk, for orthonormal vectors xi, xi',
// one value of b, and a and tau from 0 to pi/2. By symmetry, a sample (x, y) also represents (+-x, +-y) and their complex
// conjugates, so half a turn of directions xi suffices.
struct GrowthTable {
    std::vector<ZernikeTerm> terms;
    std::size_t curve, side, samples, directions;
    std::vector<std::size_t> order;  // indices of the pairs of terms, even azimuthal orders first
    std::size_t even;  // number of pairs of even order
    Floats values;  // [sample][pair][cosine, sine]: imaginary part of the term
    Floats shares;  // [sample]: weight in the mean over a and cos(tau), from hat functions
    std::vector<double> turns;  // [pair][direction][cos(m psi), sin(m psi)]

    GrowthTable(const TermPairs& list, std::size_t at)
        : terms(list.terms), curve(at), side(4 * list.degree + 1), samples(side * side), directions(directions_for(list)) {
        const auto is_even = [&](std::size_t p) { return list.pairs[p].m % 2 == 0; };
        for (std::size_t p = 0; p < list.pairs.size(); ++p) {
            order.push_back(p);
        }
        even = static_cast<std::size_t>(std::stable_partition(order.begin(), order.end(), is_even) - order.begin());
        const double b = chord_curves.b[curve], hat = 4.0 * std::sin(0.5 * step()) * std::sin(0.5 * step()) / step();
        std::vector<ZernikeTerm> both;
        for (const std::size_t k : order) {
            const std::int32_t n = static_cast<std::int32_t>(list.pairs[k].n), m = static_cast<std::int32_t>(list.pairs[k].m);
            both.insert(both.end(), {{n, m}, {n, -m}});
        }
        std::vector<std::size_t> in_turn(both.size());
        std::iota(in_turn.begin(), in_turn.end(), std::size_t{0});
        const ZernikeValues polynomials(both, in_turn);
        values.resize(samples * both.size());
        for (std::size_t s = 0; s < samples; ++s) {
            look();
            const std::size_t p = s / side, q = s % side;
            const std::complex<wide> a(step() * static_cast<double>(p), b);
            const std::complex<wide> x = std::cos(a),
                                     y = std::sin(a) * static_cast<wide>(std::cos(step() * static_cast<double>(q)));
            polynomials.at(x, y, [&](std::size_t j, const std::complex<wide>& value) {
                values[s * both.size() + j] = j % 2 == 1 && both[j].m == 0 ? 0.0f : static_cast<float>(value.imag());
            });
            // Weights of a sample, which represents eight points, in the mean over a (`first`) and over eta = cos(tau) (`second`).
            const double first = (p % (side - 1) == 0 ? 0.5 : 1.0) / static_cast<double>(4 * (side - 1));
            const double along = step() * static_cast<double>(q);
            const double second = q == 0          ? 0.5 * (1.0 - std::sin(step()) / step())
                                  : q == side - 1 ? 0.25 * hat
                                                  : 0.5 * hat * std::sin(along);
            shares.push_back(static_cast<float>(first * second));
        }
        for (const std::size_t k : order) {
            for (std::size_t i = 0; i < directions; ++i) {
                const double angle = static_cast<double>(list.pairs[k].m) * turn() * static_cast<double>(i);
                turns.push_back(std::cos(angle));
                turns.push_back(std::sin(angle));
            }
        }
    }

    // Angles in radians: step() between samples of a and of tau, turn() between directions xi.
    double step() const { return 0.5 * pi / static_cast<double>(side - 1); }
    double turn() const { return pi / static_cast<double>(directions); }

    // Estimated time of sampling, in vector operations.
    static double work(const TermPairs& list) {
        const double side = static_cast<double>(4 * list.degree + 1);
        return side * side * static_cast<double>(directions_for(list) / row_lanes) *
               (2.0 * static_cast<double>(list.pairs.size()) + 40.0);
    }
    // Return whether the imaginary parts of all terms, at most sinh(degree * b), are well within the range of float.
    static bool serves(const TermPairs& list, std::size_t curve) {
        return static_cast<double>(list.degree) * chord_curves.b[curve] <= 15.0;
    }

    bool is(const TermPairs& list, std::size_t at) const { return curve == at && terms == list.terms; }
    std::size_t bytes() const { return (values.size() + shares.size()) * sizeof(float) + turns.size() * sizeof(double); }
    static constexpr std::size_t most_bytes = std::size_t{8} << 20;

   private:
    // Number of directions in half a turn: 8 * highest azimuthal order, rounded up to a multiple of 16.
    static std::size_t directions_for(const TermPairs& list) {
        std::size_t highest = 1;
        for (const TermPairs::Pair& pair : list.pairs) {
            highest = std::max(highest, pair.m);
        }
        return 16 * ((highest + 1) / 2);
    }
};

// Growth of a pupil function exp(i Phi): logarithm of the mean of e^{-Im Phi} over the complex points of all chords of a direction,
// for the direction where it is largest. mean: this logarithm from samples. margin: bound on its error, from rounding and, between
// samples, from the second derivatives of the Zernike terms. By a and tau (GrowthTable), these are at most n^2 times the maximum of
// the term; by the angle of the direction, m^2 times.
struct SampledGrowth {
    double mean, margin;
};
template <class I>
LOMMEL_INLINE SampledGrowth sampled_growth(I, const GrowthTable& table, const TermPairs& list, const double* coefficients) {
    using V = typename I::floats;
    constexpr std::size_t lanes = 2 * I::lanes;
    constexpr double single = 5.97e-8;
    const std::size_t pairs = table.order.size(), directions = table.directions;
    Floats given(2 * pairs * directions);
    double most = 0.0, bend = 0.0, around = 0.0;
    for (std::size_t p = 0; p < pairs; ++p) {
        const TermPairs::Pair& pair = list.pairs[table.order[p]];
        const double size = std::sqrt(pair.square(coefficients)) * chord_curves.growth[pair.n][table.curve];
        most += size;
        bend += size * static_cast<double>(pair.n * pair.n);
        around += size * static_cast<double>(pair.m * pair.m);
        const double c = pair.cosine == TermPairs::none ? 0.0 : coefficients[pair.cosine],
                     s = pair.sine == TermPairs::none ? 0.0 : coefficients[pair.sine];
        const double* turns = &table.turns[2 * p * directions];
        for (std::size_t i = 0; i < directions; ++i) {
            given[2 * p * directions + i] = static_cast<float>(c * turns[2 * i] + s * turns[2 * i + 1]);
            given[(2 * p + 1) * directions + i] = static_cast<float>(s * turns[2 * i] - c * turns[2 * i + 1]);
        }
    }
    double largest = -1e300;
    for (std::size_t first = 0; first < directions; first += lanes) {
        // Im Phi, Phi the phase, at the mirror images of a sample: (x, y), (-x, -y), (x, -y), (-x, y).
        const auto images = [&](std::size_t s, V* image) LOMMEL_INLINE_LAMBDA {
            const float *value = &table.values[2 * s * pairs], *with = &given[first];
            // Sums over the cosine terms and over the sine terms; index 0: terms even in x, index 1: terms odd in x.
            V cosines[2] = {}, sines[2] = {};
            const auto add = [&](std::size_t odd, std::size_t end) LOMMEL_INLINE_LAMBDA {
                for (; value < &table.values[2 * s * pairs] + 2 * end; value += 2, with += 2 * directions) {
                    cosines[odd] = cosines[odd] + splat<V>(value[0]) * load<V>(with);
                    sines[1 - odd] = sines[1 - odd] + splat<V>(value[1]) * load<V>(with + directions);
                }
            };
            add(0, table.even);
            add(1, pairs);
            const V a = cosines[0] + sines[1], b = cosines[1] + sines[0], c = cosines[0] - sines[1], d = cosines[1] - sines[0];
            image[0] = a + b;
            image[1] = a - b;
            image[2] = c + d;
            image[3] = c - d;
        };
        V image[4], top = splat<V>(0.0f), sum = top;
        for (std::size_t s = 0; s < table.samples; ++s) {
            images(s, image);
            for (const V h : image) {
                top = larger(top, larger(h, splat<V>(0.0f) - h));
            }
        }
        for (std::size_t s = 0; s < table.samples; ++s) {
            images(s, image);
            V here = splat<V>(0.0f);
            for (const V h : image) {
                here = here + (chord_of_exp(h - top) + chord_of_exp(splat<V>(0.0f) - h - top));
            }
            sum = sum + splat<V>(table.shares[s]) * here;
        }
        for (std::size_t i = 0; i < lanes; ++i) {
            largest = std::max(largest, static_cast<double>(top[i]) + std::log(static_cast<double>(sum[i])));
        }
    }
    const double between = 0.25 * table.step() * table.step() * bend + 0.125 * table.turn() * table.turn() * around;
    const double rounding =
        single * (1.5 * static_cast<double>(2 * pairs + 10) * most + static_cast<double>(8 * table.samples));
    return {largest, between + rounding + 1e-3};
}

}  // namespace lommel
