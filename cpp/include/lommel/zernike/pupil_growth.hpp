// Growth of a pupil function at complex points: bound on the mean of its modulus over chords of the disk, continued to complex
// coordinates. It is computed from samples, and so is smaller than the product of the bounds for single Zernike terms.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

#include "lommel/base/aligned.hpp"
#include "lommel/base/cache.hpp"
#include "lommel/base/parallel.hpp"
#include "lommel/base/pi.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/base/tasks.hpp"
#include "lommel/base/wide.hpp"
#include "lommel/bounds/disk.hpp"
#include "lommel/special/exponential.hpp"
#include "lommel/special/radial_polynomials.hpp"

namespace lommel {

// Zernike terms at sampled complex points cos(a + ib) xi + sin(a + ib) cos(tau) xi' of the disk, for orthonormal vectors xi, xi',
// one value of b, and a and tau from 0 to pi/2. By symmetry, a sample (x, y) also represents (+-x, +-y) and their complex
// conjugates, so half a turn of directions xi suffices. With a window, |v_x| <= reach[0] and |v_y| <= reach[1], the samples are
// fewer, and the modulus of the wave e^{-i v . r} counts too: `waves`, summed over the four corners, where its means are largest.
struct GrowthTable {
    using Reach = std::array<double, 2>;

    std::vector<ZernikeTerm> terms;
    std::size_t curve, side, samples, directions;
    std::vector<std::size_t> order;  // indices of the pairs of terms, even azimuthal orders first
    std::size_t even;  // number of pairs of even order
    Floats values;  // [sample][pair][cosine, sine]: imaginary part of the term
    Floats shares;  // [sample]: weight in the mean over a and cos(tau), from hat functions
    Reach reach;
    Floats
        waves;  // [sample][sign of x y][direction]: sum over corners of |e^{-i v . r}| / e^{log_waves()}; none without a window
    std::vector<double> turns;  // [pair][direction][cos(m psi), sin(m psi)]

    GrowthTable(const TermPairs& list, std::size_t at, const Reach& window = {})
        : terms(list.terms), curve(at), side(side_for(list, window)), samples(side * side),
          directions(directions_for(list, window)), reach(window) {
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
            if (windowed()) {
                add_waves(static_cast<double>(x.imag()), static_cast<double>(y.imag()));
            }
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
    bool windowed() const { return reach[0] > 0.0 || reach[1] > 0.0; }
    // Logarithm of the largest |e^{-i v . r}|.
    double log_waves() const { return std::hypot(reach[0], reach[1]) * chord_curves.growth[1][curve]; }

    // Estimated time of sampling, in vector operations.
    static double work(const TermPairs& list, const Reach& window = {}) {
        const double side = static_cast<double>(side_for(list, window));
        return side * side * static_cast<double>(directions_for(list, window) / row_lanes) *
               (2.0 * static_cast<double>(list.pairs.size()) + 40.0);
    }
    // Return whether the imaginary parts of all terms, at most sinh(degree * b), are well within the range of float.
    static bool serves(const TermPairs& list, std::size_t curve) {
        return static_cast<double>(list.degree) * chord_curves.b[curve] <= 15.0;
    }

    bool is(const TermPairs& list, std::size_t at, const Reach& window = {}) const {
        return curve == at && reach == window && terms == list.terms;
    }
    std::size_t bytes() const {
        return (values.size() + shares.size() + waves.size()) * sizeof(float) + turns.size() * sizeof(double);
    }
    static constexpr std::size_t most_bytes = std::size_t{8} << 20;

   private:
    static std::size_t side_for(const TermPairs& list, const Reach& window) {
        return (window == Reach{} ? 4 : 3) * list.degree + 1;
    }
    // Number of directions in half a turn: 8 * highest azimuthal order, or 5 with a window, rounded up to a multiple of 16.
    static std::size_t directions_for(const TermPairs& list, const Reach& window) {
        std::size_t highest = 1;
        for (const TermPairs::Pair& pair : list.pairs) {
            highest = std::max(highest, pair.m);
        }
        return window == Reach{} ? 16 * ((highest + 1) / 2) : 16 * ((5 * highest + 15) / 16);
    }
    // Append the waves of the samples whose imaginary parts along xi and xi' are (x, y), and (x, -y).
    void add_waves(double x, double y) {
        for (const double sign : {1.0, -1.0}) {
            for (std::size_t i = 0; i < directions; ++i) {
                const double angle = turn() * static_cast<double>(i), c = std::cos(angle), s = std::sin(angle);
                const double across = reach[0] * (c * x - sign * s * y), down = reach[1] * (s * x + sign * c * y);
                double sum = 0.0;
                for (const double corner : {across + down, across - down, down - across, -across - down}) {
                    sum += std::exp(std::max(corner - log_waves(), -80.0));
                }
                waves.push_back(static_cast<float>(sum));
            }
        }
    }
};

// Growth of a pupil function exp(i Phi): logarithm of the mean of e^{-Im Phi} over the complex points of all chords of a direction,
// for the direction where it is largest. mean: this logarithm from samples. margin: bound on its error, from rounding and, between
// samples, from the second derivatives of the Zernike terms. By a and tau (GrowthTable), these are at most n^2 times the maximum of
// the term; by the angle of the direction, m^2 times. With a window, the bound is for e^{-i v . r} exp(i Phi) and all its v.
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
    if (table.windowed()) {
        bend += table.log_waves();
        around += table.log_waves();
    }
    // Largest exponent, from which all are measured: a bound where it is near enough, else found.
    constexpr double near = 40.0;
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
        V image[4], top = splat<V>(static_cast<float>(most < near ? 1.001 * most : 0.0)), sum = splat<V>(1e-33f);
        for (std::size_t s = 0; s < table.samples && !(most < near); ++s) {
            images(s, image);
            for (const V h : image) {
                top = larger(top, larger(h, splat<V>(0.0f) - h));
            }
        }
        for (std::size_t s = 0; s < table.samples; ++s) {
            images(s, image);
            V here[2] = {};  // of (x, y) and (-x, -y), of (x, -y) and (-x, y)
            for (std::size_t i = 0; i < 4; ++i) {
                const V h = image[i];
                here[i / 2] = here[i / 2] + (chord_of_exp(h - top) + chord_of_exp(splat<V>(0.0f) - h - top));
            }
            if (table.windowed()) {
                const float* const wave = &table.waves[2 * s * directions + first];
                here[0] = here[0] * load<V>(wave);
                here[1] = here[1] * load<V>(wave + directions);
            }
            sum = sum + splat<V>(table.shares[s]) * (here[0] + here[1]);
        }
        for (std::size_t i = 0; i < lanes; ++i) {
            largest = std::max(largest, static_cast<double>(top[i]) + std::log(static_cast<double>(sum[i])));
        }
    }
    const double between = 0.25 * table.step() * table.step() * bend + 0.125 * table.turn() * table.turn() * around;
    const double rounding =
        single * (1.5 * static_cast<double>(2 * pairs + 10) * most + static_cast<double>(8 * table.samples));
    return {largest + (table.windowed() ? table.log_waves() : 0.0), between + rounding + 1e-3};
}

// Bound on the logarithm of the mean of |e^{-i v . r} exp(i Phi)| over the complex points of all chords of a direction, for any of the
// pupils edge[pupil][term], any direction, and all v of a window.
inline double growth_of_stack(const std::vector<ZernikeTerm>& terms, const double* edge, std::size_t pupils, std::size_t curve,
                              const GrowthTable::Reach& window, int threads) {
    const TermPairs list(terms);
    const auto table = cache<GrowthTable>.get(list, curve, window);
    std::vector<double> found(pupils);
    const double work = 1e-3 * GrowthTable::work(list, window) * static_cast<double>(pupils);
    parallel_for(pupils, worthwhile_threads(threads, work), [&](std::size_t, std::size_t p) {
        dispatch_widest(processor_level(), [&](auto isa) LOMMEL_INLINE_LAMBDA {
            const SampledGrowth of_pupil = sampled_growth(isa, *table, list, edge + p * terms.size());
            found[p] = of_pupil.mean + of_pupil.margin;
        });
    });
    return *std::max_element(found.begin(), found.end());
}

}  // namespace lommel
