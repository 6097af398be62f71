// Polynomials through 16 Chebyshev points, and their approximation by polynomials of lower degree on equal parts of the
// interval (docs/certificate.md, section 9, "Samples around one axis").
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <type_traits>

#include "lommel/base/aligned.hpp"
#include "lommel/base/cache.hpp"
#include "lommel/base/pi.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/special/chebyshev.hpp"

namespace lommel {

// Matrices that map a polynomial's values at 16 Chebyshev points of [-1, 1] to outputs at points x > 0: `even` maps sums, `odd`
// differences of values at mirrored points. The sum of both results is the output at x; their difference, up to sign, at -x.
struct Halves {
    static constexpr std::size_t points = 16, half = points / 2, together = 8;
    std::size_t count, pitch;
    Doubles even, odd;  // matrices [point][output], rows padded to `pitch` outputs

    explicit Halves(std::size_t outputs)
        : count(outputs), pitch((outputs + together - 1) / together * together), even(half * pitch), odd(half * pitch) {}

    // Sums (even) and differences (odd) of the values at mirrored points, times `by`.
    struct Values {
        double even[half], odd[half];
        Values(const double* values, double by) {
            for (std::size_t i = 0; i < half; ++i) {
                const double above = values[half + i], below = values[half - 1 - i];
                even[i] = by * (above + below);
                odd[i] = by * (above - below);
            }
        }
    };

    // Call take(start, even, odd) with the results of both matrices for outputs start, start + 1, ..., `together` at a time.
    template <class I, class Take>
    LOMMEL_INLINE void each(I, const Values& values, const Take& take) const {
        using V = typename I::pack;
        constexpr std::size_t packs = together / I::lanes;
        for (std::size_t start = 0; start < pitch; start += together) {
            V sum[packs] = {}, other[packs] = {};
            for (std::size_t i = 0; i < half; ++i) {
                const V by = splat<V>(values.even[i]), or_by = splat<V>(values.odd[i]);
                for (std::size_t p = 0; p < packs; ++p) {
                    sum[p] = sum[p] + by * load<V>(even.data() + i * pitch + start + p * I::lanes);
                    other[p] = other[p] + or_by * load<V>(odd.data() + i * pitch + start + p * I::lanes);
                }
            }
            alignas(64) double both[2][together];
            for (std::size_t p = 0; p < packs; ++p) {
                store(both[0] + p * I::lanes, sum[p]);
                store(both[1] + p * I::lanes, other[p]);
            }
            take(start, both[0], both[1]);
        }
    }

    // Compute evens[i], odds[i]: m-th derivatives at x of the even and odd parts of the Lagrange polynomial of point half + i.
    void derivative(std::size_t m, double x, double (&evens)[half], double (&odds)[half]) const {
        // chebyshev[k][j]: j-th derivative of the Chebyshev polynomial T_k, from T_(k+1) = 2 x T_k - T_(k-1) differentiated j times.
        wide chebyshev[points][5] = {};
        chebyshev[0][0] = 1;
        chebyshev[1][0] = static_cast<wide>(x);
        chebyshev[1][1] = 1;
        for (std::size_t k = 2; k < points; ++k) {
            for (std::size_t j = 0; j <= m; ++j) {
                const wide lower = j == 0 ? wide{0} : 2 * static_cast<wide>(j) * chebyshev[k - 1][j - 1];
                chebyshev[k][j] = 2 * static_cast<wide>(x) * chebyshev[k - 1][j] + lower - chebyshev[k - 2][j];
            }
        }
        for (std::size_t i = 0; i < half; ++i) {
            wide sums[2] = {};
            for (std::size_t k = 0; k < points; ++k) {
                const wide angle = std::acos(wide{-1}) * static_cast<wide>(k * (2 * (half - 1 - i) + 1)) / (2 * points);
                sums[k % 2] += (k == 0 ? 1 : 2) * std::cos(angle) * chebyshev[k][m] / points;
            }
            evens[i] = static_cast<double>(sums[0]);
            odds[i] = static_cast<double>(sums[1]);
        }
    }
};

// Approximation of a polynomial on `parts` equal parts of [-1, 1]: on each part, the interpolant through `Terms` Chebyshev
// points, in a variable that runs from -1/2 to 1/2.
template <std::size_t Terms>
struct Parts {
    static constexpr std::size_t most = 64;  // largest number of parts, which is always even
    std::size_t parts;
    double sizes = 0.0;  // S in docs/certificate.md, section 9: rounding errors are proportional to it
    Halves halves;       // maps values to coefficients [part][power] of the parts above 0

    explicit Parts(std::size_t count);

    bool is(std::size_t count) const { return parts == count; }
    std::size_t bytes() const { return sizeof(double) * (halves.even.size() + halves.odd.size()); }
    // Bound on the difference between a polynomial of modulus at most 1 and its interpolants on the parts, from Markov's bound
    // on derivatives (mu in docs/certificate.md, section 9).
    double bent() const {
        const double degree = static_cast<double>(Halves::points - 1);
        double size = 2.0;
        for (std::size_t k = 0; k < Terms; ++k) {
            const double n = static_cast<double>(k);
            size *= (degree * degree - n * n) / ((2.0 * n + 1.0) * 2.0 * (n + 1.0) * static_cast<double>(parts));
        }
        return size;
    }
    static constexpr std::size_t most_bytes = std::size_t{1} << 20;
    static std::shared_ptr<const Parts> get(std::size_t count) { return cache<Parts>.get(count); }

    // Compute to[part][power], the coefficients of all parts, from a polynomial's values at the Chebyshev points;
    // largest[power] becomes the maximum of itself and their moduli.
    template <class I, class To>
    LOMMEL_INLINE void cut(I isa, const Halves::Values& values, To* to, double* largest) const {
        constexpr std::size_t lanes = std::min(I::lanes, Terms);
        using V = typename Vector<lanes>::pack;
        using Out = std::conditional_t<sizeof(To) == sizeof(double), V, typename Vector<lanes>::narrow>;
        alignas(64) static constexpr double signs[8] = {1.0, -1.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0};
        const V turned = load<V>(signs);
        V top[Terms / lanes];
        for (std::size_t p = 0; p < Terms / lanes; ++p) {
            top[p] = load<V>(largest + p * lanes);
        }
        To *const above = to + parts / 2 * Terms, *const below = above - Terms;
        halves.each(isa, values, [&](std::size_t start, const double* even, const double* odd) LOMMEL_INLINE_LAMBDA {
            const std::size_t end = std::min(halves.count - start, Halves::together);
            for (std::size_t at = 0; at < end; at += Terms) {
                for (std::size_t p = 0; p < Terms / lanes; ++p) {
                    const V e = load<V>(even + at + p * lanes), o = load<V>(odd + at + p * lanes);
                    const V up = e + o, down = turned * (e - o);
                    store(above + start + at + p * lanes, converted<Out>(up));
                    store(below - (start + at) + p * lanes, converted<Out>(down));
                    top[p] = larger(top[p], larger(larger(up, V{} - up), larger(down, V{} - down)));
                }
            }
        });
        for (std::size_t p = 0; p < Terms / lanes; ++p) {
            store(largest + p * lanes, top[p]);
        }
    }
};

// Bounds on the second and the fourth derivative, on [-1, 1], of the polynomial through values at 16 Chebyshev points.
struct Bends {
    static constexpr std::size_t second = 32, fourth = 16;  // numbers of points at which derivatives 2 and 4 are computed
    static_assert(second / 2 % Halves::together == 0 && fourth / 2 % Halves::together == 0);

    struct Sizes {
        double second, fourth;
    };

    Halves halves{(second + fourth) / 2};
    Bends() {
        const auto fill = [&](std::size_t from, std::size_t m, std::size_t count) {
            // A polynomial of degree d is at most 1 / cos(pi d / 2n) times its maximum at n > d Chebyshev points (Ehlich and Zeller).
            const double share = static_cast<double>(Halves::points - 1 - m) / static_cast<double>(count);
            const double by = 1.0 / std::cos(0.5 * pi * share);
            for (std::size_t at = 0; at < count / 2; ++at) {
                double even[Halves::half], odd[Halves::half];
                halves.derivative(m, chebyshev_point(at, count), even, odd);
                for (std::size_t point = 0; point < Halves::half; ++point) {
                    halves.even[point * halves.pitch + from + at] = by * even[point];
                    halves.odd[point * halves.pitch + from + at] = by * odd[point];
                }
            }
        };
        fill(0, 2, second);
        fill(second / 2, 4, fourth);
    }

    static const Bends& get() {
        static const Bends& only = *new Bends;
        return only;
    }

    template <class I>
    LOMMEL_INLINE Sizes operator()(I isa, const Halves::Values& values) const {
        double sizes[2][Halves::together] = {};
        halves.each(isa, values, [&](std::size_t start, const double* even, const double* odd) LOMMEL_INLINE_LAMBDA {
            double* const largest = sizes[start < second / 2 ? 0 : 1];
            for (std::size_t i = 0; i < Halves::together; ++i) {
                const double size = std::abs(even[i]) + std::abs(odd[i]);
                largest[i] = size > largest[i] ? size : largest[i];
            }
        });
        const auto most = [](const double (&all)[Halves::together]) {
            return *std::max_element(std::begin(all), std::end(all));
        };
        return {most(sizes[0]), most(sizes[1])};
    }
};

// Matrix [point][power] that maps values at `Count` ascending Chebyshev points to monomial coefficients.
template <std::size_t Count>
std::array<double, Count * Count> through_points() {
    const ChebyshevToMonomials<Count, wide> taken;
    std::array<double, Count * Count> made{};
    for (std::size_t i = 0; i < Count; ++i) {
        double values[Count] = {};
        values[Count - 1 - i] = 1.0;  // ChebyshevToMonomials takes descending points
        taken(values, 1, made.data() + i * Count);
    }
    return made;
}

template <std::size_t Terms>
Parts<Terms>::Parts(std::size_t count) : parts(count), halves(count / 2 * Terms) {
    const auto powers = through_points<Terms>();
    double each[Terms] = {};
    for (std::size_t part = 0; part < parts / 2; ++part) {
        double sums[Terms] = {};
        for (std::size_t i = 0; i < Terms; ++i) {
            const double y = chebyshev_point(Terms - 1 - i, Terms);
            double even[Halves::half], odd[Halves::half];
            halves.derivative(0, (static_cast<double>(2 * part) + 1.0 + y) / static_cast<double>(parts), even, odd);
            for (std::size_t power = 0; power < Terms; ++power) {
                const double by = powers[i * Terms + power] * std::exp2(static_cast<double>(power));
                for (std::size_t point = 0; point < Halves::half; ++point) {
                    const std::size_t at = point * halves.pitch + part * Terms + power;
                    halves.even[at] += by * even[point];
                    halves.odd[at] += by * odd[point];
                    sums[power] += 2.0 * std::abs(powers[i * Terms + power]) * (std::abs(even[point]) + std::abs(odd[point]));
                }
            }
        }
        for (std::size_t power = 0; power < Terms; ++power) {
            each[power] = std::max(each[power], sums[power]);
        }
    }
    for (const double size : each) {
        sizes += size;
    }
}

}  // namespace lommel
