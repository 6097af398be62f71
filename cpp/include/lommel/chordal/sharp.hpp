// The largest imaginary part of a whole phase on the curves phi = a + ib through the chords, by samples and the theorem
// about trigonometric polynomials between them: sharper than the sum over terms, and worth its work for strong phases.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/bounds/chords.hpp"
#include "lommel/special/radial_polynomials.hpp"

namespace lommel {

// For one b: terms at the samples (phi, eta), and harmonics at the samples of the direction theta of the chords.
struct SharpTable {
    TermPairs list;
    std::vector<TermPairs::Pair> pairs;  // of them, those of degree 2 and more
    double b, margin = 1.0;  // what the largest sample is multiplied by
    std::size_t points, directions, harmonics;
    Doubles values;                 // [point][pair][cosine, sine]
    Doubles waves;                  // [direction][m][cos, sin]

    SharpTable(const std::vector<ZernikeTerm>& terms, double curve)
        : list(terms), pairs(list.pairs.begin() + static_cast<std::ptrdiff_t>(list.curved), list.pairs.end()), b(curve) {
        const std::size_t degree = std::max<std::size_t>(2, list.degree);
        harmonics = degree + 1;
        // A whole turn has 2 `across` samples of phi, 4 `turns` of theta; eta those of Chebyshev, of which half suffice:
        // the others, like the other half turns, are the same points or their opposites or conjugates.
        const std::size_t across = samples(degree), half = (samples(degree) + 1) / 2, turns = half;
        points = across * half;
        directions = turns + 1;
        const wide pi = std::acos(wide(-1));
        values.resize(points * pairs.size() * 2);
        double* to = values.data();
        for (std::size_t p = 0; p < across; ++p) {
            const std::complex<wide> angle(pi * static_cast<wide>(p) / static_cast<wide>(across), b);
            for (std::size_t q = 0; q < half; ++q) {
                look();
                const wide eta = std::cos(pi * static_cast<wide>(2 * q + 1) / static_cast<wide>(4 * half));
                const std::complex<wide> x = std::cos(angle), y = eta * std::sin(angle);
                for (const TermPairs::Pair& pair : pairs) {
                    const std::int32_t n = static_cast<std::int32_t>(pair.n), m = static_cast<std::int32_t>(pair.m);
                    *to++ = static_cast<double>(zernike_value(ZernikeTerm{n, m}, x, y).imag());
                    *to++ = m == 0 ? 0.0 : static_cast<double>(zernike_value(ZernikeTerm{n, -m}, x, y).imag());
                }
            }
        }
        waves.resize(directions * harmonics * 2);
        for (std::size_t d = 0; d < directions; ++d) {
            for (std::size_t m = 0; m < harmonics; ++m) {
                const wide angle = pi * static_cast<wide>(d * m) / static_cast<wide>(2 * turns);
                waves[2 * (d * harmonics + m)] = static_cast<double>(std::cos(angle));
                waves[2 * (d * harmonics + m) + 1] = static_cast<double>(std::sin(angle));
            }
        }
        // Half a step from a sample, a polynomial of that degree has not fallen below this share of its largest value.
        const double d = static_cast<double>(degree), quarter = 0.5 * std::acos(-1.0) * d;
        margin = (1.0 + 1e-9) /
                 (std::cos(quarter / static_cast<double>(across)) * std::cos(quarter / static_cast<double>(2 * half)) *
                  std::cos(quarter / static_cast<double>(2 * turns)));
    }

    static std::size_t samples(std::size_t degree) { return (7 * degree + 1) / 2; }
    // Vector operations for a vector of pupils.
    static double work(const TermPairs& list) {
        const double degree = static_cast<double>(std::max<std::size_t>(2, list.degree)), s = 3.5 * degree;
        return 0.5 * s * s * (2.0 * static_cast<double>(list.terms.size()) + 0.5 * s * (2.0 * degree + 11.0));
    }
    bool is(const std::vector<ZernikeTerm>& terms, double curve) const { return b == curve && list.terms == terms; }
    std::size_t bytes() const { return (values.size() + waves.size()) * sizeof(double); }
    static constexpr std::size_t most_bytes = std::size_t{96} << 20;
};

// Bounds |Im Phi| on the curve of the table: coefficients[pair][cosine, sine], `room` for 2 * harmonics vectors.
template <class I>
LOMMEL_INLINE typename I::pack sharp_size(I, const SharpTable& table, const double* coefficients, double* room) {
    using V = typename I::pack;
    constexpr std::size_t lanes = I::lanes;
    const auto size = [](V x) LOMMEL_INLINE_LAMBDA { return larger(x, splat<V>(0.0) - x); };
    V top = splat<V>(0.0);
    const double* value = table.values.data();
    for (std::size_t point = 0; point < table.points; ++point) {
        look();
        for (std::size_t j = 0; j < 2 * table.harmonics * lanes; j += lanes) {
            store(room + j, splat<V>(0.0));
        }
        // cos m(chi + theta) and sin m(chi + theta), sorted by cos m theta and sin m theta.
        for (std::size_t k = 0; k < table.pairs.size(); ++k, value += 2) {
            const V a = load<V>(coefficients + 2 * k * lanes), s = load<V>(coefficients + (2 * k + 1) * lanes);
            const V c = splat<V>(value[0]), d = splat<V>(value[1]);
            double* to = room + 2 * table.pairs[k].m * lanes;
            store(to, load<V>(to) + a * c + s * d);
            store(to + lanes, load<V>(to + lanes) + s * c - a * d);
        }
        const double* wave = table.waves.data();
        for (std::size_t direction = 0; direction < table.directions; ++direction, wave += 2 * table.harmonics) {
            V even[2] = {splat<V>(0.0), splat<V>(0.0)}, odd[2] = {splat<V>(0.0), splat<V>(0.0)};
            for (std::size_t m = 0; m < table.harmonics; m += 2) {
                even[0] = even[0] + splat<V>(wave[2 * m]) * load<V>(room + 2 * m * lanes);
                even[1] = even[1] + splat<V>(wave[2 * m + 1]) * load<V>(room + (2 * m + 1) * lanes);
            }
            for (std::size_t m = 1; m < table.harmonics; m += 2) {
                odd[0] = odd[0] + splat<V>(wave[2 * m]) * load<V>(room + 2 * m * lanes);
                odd[1] = odd[1] + splat<V>(wave[2 * m + 1]) * load<V>(room + (2 * m + 1) * lanes);
            }
            // The directions theta and -theta, then pi - theta and pi + theta.
            top = larger(top, size(even[0] + odd[0]) + size(even[1] + odd[1]));
            top = larger(top, size(even[0] - odd[0]) + size(even[1] - odd[1]));
        }
    }
    return top * splat<V>(table.margin);
}

// Puts the coefficients of one pupil into a lane of those that sharp_size takes.
inline void sharp_lane(const SharpTable& table, const double* given, std::size_t lane, std::size_t lanes, double* to) {
    for (std::size_t k = 0; k < table.pairs.size(); ++k) {
        const TermPairs::Pair& pair = table.pairs[k];
        to[2 * k * lanes + lane] = pair.cosine == TermPairs::none ? 0.0 : given[pair.cosine];
        to[(2 * k + 1) * lanes + lane] = pair.sine == TermPairs::none ? 0.0 : given[pair.sine];
    }
}

}  // namespace lommel
