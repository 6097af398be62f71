// Interpolation kernel of the non-uniform FFT, and its Fourier transform, by which the spectrum is divided beforehand
// (certificate, section 11).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

#include "lommel/base/pi.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/special/chebyshev.hpp"

namespace lommel {

// Unit roundoff: half the distance from 1 to the next number.
template <class Real>
constexpr double roundoff = 0.5 * static_cast<double>(std::numeric_limits<Real>::epsilon());

// Continuous Kaiser-Bessel window of w taps: phi(x) = sqrt(y) I_1(beta sqrt(y)) / I_1(beta), y = 1 - (2x/w)^2, for |x| <= w/2;
// elsewhere phi = 0. Let F(j) be samples, at integers j, of a function whose spectrum was divided by the Fourier transform of
// phi; then sum_j phi(x - j) F(j) is the function of the undivided spectrum, up to aliases.
class GriddingKernel {
   public:
    GriddingKernel(std::size_t taps, double beta) : w(taps), beta_(beta), top_(shape(1.0)) {}

    // Kernel of `taps` taps for frequencies up to pi / oversampling (radians per step).
    static GriddingKernel of(std::size_t taps, double oversampling) {
        return {taps, 0.975 * pi * static_cast<double>(taps) * (1.0 - 0.5 / oversampling)};
    }

    const std::size_t w;
    double beta() const { return beta_; }

    double operator()(double x) const {
        const double z = 2.0 * x / static_cast<double>(w), y = 1.0 - z * z;
        return y > 0.0 ? shape(y) / top_ : 0.0;
    }

    // Fourier transform of the kernel, integral of phi(x) cos(omega x) dx: w beta (cosh y - sinh(y) / y) / (y^2 I_1(beta)),
    // with w taps, the shape parameter beta and y^2 = beta^2 - (w omega / 2)^2.
    double transform(double omega) const {
        const double zeta = 0.5 * static_cast<double>(w) * omega;
        return scale() * quotient(beta_ * beta_ - zeta * zeta);
    }

    // Bound, increasing with omega (0 to pi), on the aliases at frequency omega: sum of |transform(omega + 2 pi k)| /
    // transform(omega) over all k != 0.
    double aliases(double omega) const {
        constexpr std::size_t counted = 64;
        double sum = 0.0;
        for (std::size_t k = 1; k <= counted; ++k) {
            const double turns = 2.0 * pi * static_cast<double>(k);
            // size(f) bounds |transform| at frequencies of at least f, so size(2 pi k) serves omega + 2 pi k.
            sum += size(turns - omega) + size(turns);
        }
        // Larger k: |transform| <= scale() sqrt(1 + 1/eta^2) / eta^2, eta^2 = zeta^2 - beta^2 >= zeta^2 (1 - (beta / first)^2),
        // with w taps, the shape parameter beta and zeta = w/2 x frequency >= w pi (k - 1/2) >= first.
        const double width = static_cast<double>(w), first = width * pi * (counted + 0.5), ratio = beta_ / first;
        const double least = 1.0 - ratio * ratio, each = std::sqrt(1.0 + 1.0 / (first * first * least)) / least;
        sum += 2.0 * scale() * each / (width * width * pi * pi * counted);
        return sum / transform(omega);
    }

    // Root mean square of aliases(step * s) over -1 <= s <= 1 with the weight w(s) = (2 / pi) sqrt(1 - s^2). It bounds the aliases
    // of a function whose spectrum at the frequency step * s is w(s) g(s), if the mean of |g|^2 with the same weight is 1.
    double aliasing(double step) const {
        constexpr std::size_t cells = 192;
        double squares = 0.0;
        for (std::size_t i = 0; i < cells; ++i) {
            // Integral over a, s = cos(a): in each cell of a, aliases() is largest at the start and sin(a) at the end.
            const double first = 0.5 * pi * static_cast<double>(i) / cells,
                         last = 0.5 * pi * static_cast<double>(i + 1) / cells;
            const double most = aliases(step * std::cos(first)), sine = std::sin(last);
            squares += most * most * sine * sine;
        }
        return std::sqrt(2.0 * squares / cells);
    }

    // Bound on the sum of the weights of all taps, at any position between samples, by Poisson's summation formula.
    double weight() const { return transform(0.0) * (1.0 + aliases(0.0)); }

    // Bound, at any position, on the sum over taps i = 0 .. w - 1 of (w - i) * tap i. It bounds the rounding of a sum over taps, as
    // tap i takes part in w - i successive additions.
    double chain() const {
        constexpr std::size_t cells = 64;
        double worst = 0.0;
        for (std::size_t cell = 0; cell < cells; ++cell) {
            double sum = 0.0;
            for (std::size_t i = 0; i < w; ++i) {
                // Each tap is monotonic within a cell, so its maximum is at one of the two ends.
                const double x = 0.5 * static_cast<double>(w) - 1.0 - static_cast<double>(i);
                const double first = x + static_cast<double>(cell) / cells, last = x + static_cast<double>(cell + 1) / cells;
                sum += static_cast<double>(w - i) * std::max((*this)(first), (*this)(last));
            }
            worst = std::max(worst, sum);
        }
        return worst;
    }

    // Write each tap i = 0 .. w - 1 of the kernel phi, phi(t + w/2 - 1 - i), as a polynomial of 2t - 1 for t from 0 to 1:
    // out[power, highest first][tap], in rows of `stride` taps. Returns a bound on the sum of the errors of all taps.
    double polynomials(std::size_t terms, std::size_t stride, std::vector<double>& out) const {
#if defined(__wasm__)  // software long doubles would add a fiftieth to the download of the live page
        using Number = double;
        constexpr double roundings = 1e-11;  // bound on the rounding of 16 taps, about 1e-13 each
#else
        using Number = long double;
        constexpr double roundings = 0.0;  // rounding is negligible: long double is wider than the coefficients
#endif
        constexpr std::size_t all = 32;  // number of Chebyshev coefficients, of which `terms` are kept
        static const ChebyshevToMonomials<all, Number> convert;
        out.assign(terms * stride, 0.0);
        double worst = roundings;
        for (std::size_t i = 0; i < std::min(w, stride); ++i) {
            const double middle = 0.5 * static_cast<double>(w) - static_cast<double>(i) - 0.5;
            std::array<Number, all> values;
            std::array<double, all> powers;
            for (std::size_t j = 0; j < all; ++j) {
                const Number z = Number(2) * (middle + Number(0.5) * chebyshev_point<Number>(j, all)) / static_cast<Number>(w);
                values[j] = shape(Number(1) - z * z) / static_cast<Number>(top_);
            }
            const double left = static_cast<double>(convert(values.data(), 1, powers.data(), terms));
            for (std::size_t p = 0; p < terms; ++p) {
                out[(terms - 1 - p) * stride + i] = powers[p];
            }
            // Error of interpolation at `all` points: 4 M rho^(1 - all) / (rho - 1), M the largest |kernel| on the ellipse with
            // foci -1 and 1 whose semi-axes sum to rho. The argument y of shape() has |y| <= (1 + far)(1 + near) on this ellipse.
            double rest = 1e300;
            for (double rho = 2.0; rho < 100.0; rho *= 1.25) {
                const double far = (2.0 * middle + 0.5 * (rho + 1.0 / rho)) / static_cast<double>(w);
                const double near = (-2.0 * middle + 0.5 * (rho + 1.0 / rho)) / static_cast<double>(w);
                const double most = shape((1.0 + far) * (1.0 + near)) / top_;
                rest = std::min(rest, 4.0 * most * std::pow(rho, 1.0 - static_cast<double>(all)) / (rho - 1.0));
            }
            worst += left + rest;
        }
        return worst;
    }

   private:
    // Unnormalized kernel sqrt(y) I_1(beta sqrt(y)), an entire function of y, by its power series.
    template <class Real>
    Real shape(Real y) const {
        const Real x = Real(0.25) * beta_ * beta_ * y;
        Real term = Real(0.5) * beta_ * y, sum = term;
        for (Real k = 1; term > Real(1e-20) * sum; k += 1) {
            term *= x / (k * (k + 1));
            sum += term;
        }
        return sum;
    }

    double scale() const { return static_cast<double>(w) * beta_ / top_; }

    static double quotient(double square) {
        if (std::abs(square) < 1e-2) {
            return (1.0 + square / 10.0 * (1.0 + square / 28.0 * (1.0 + square / 54.0))) / 3.0;
        }
        const double y = std::sqrt(std::abs(square));
        return square > 0.0 ? (std::cosh(y) - std::sinh(y) / y) / square : (std::sin(y) / y - std::cos(y)) / -square;
    }

    // Bound on the modulus of the kernel's transform at all frequencies of at least omega.
    double size(double omega) const {
        const double zeta = 0.5 * static_cast<double>(w) * omega, square = zeta * zeta - beta_ * beta_;
        if (square <= 0.0) {
            return transform(omega);
        }
        return scale() * std::min(1.0 / 3.0, std::sqrt(1.0 + 1.0 / square) / square);
    }

    double beta_, top_;
};

// Horner's rule at x for a vector of polynomials; row(k): address of the coefficients of the k-th highest power.
template <class V, class Row>
LOMMEL_INLINE V horner(std::size_t terms, V x, const Row& row) {
    V sum = load<V>(row(0));
    for (std::size_t k = 1; k < terms; ++k) {
        sum = sum * x + load<V>(row(k));
    }
    return sum;
}

// Taps of a gridding kernel of up to `Most` taps, each a polynomial of `Terms` terms.
template <class Real, std::size_t Terms, std::size_t Most>
struct TapPolynomials {
    static constexpr std::size_t terms = Terms, taps = Most;
    alignas(64) Real at[Terms][taps];  // [power, highest first][tap]
    double error;                      // bound on the sum of the errors of all taps at any position, including rounding

    explicit TapPolynomials(const GriddingKernel& kernel) {
        std::vector<double> exact;
        error = kernel.polynomials(Terms, taps, exact);
        double units = 0.0;
        for (std::size_t i = 0; i < exact.size(); ++i) {
            at[i / taps][i % taps] = static_cast<Real>(exact[i]);
            // Roundings of one term c x^k of Horner's rule, |x| <= 1: 1 of c, k of x, k + 1 products and k + 1 sums.
            const double k = static_cast<double>(Terms - 1 - i / taps);
            units += (3.0 * k + 3.0) * std::abs(exact[i]);
        }
        error += units * roundoff<Real>;
    }
};
using SingleTaps = TapPolynomials<float, 8, 8>;
using CoarseTaps = TapPolynomials<float, 5, 4>;  // kernels of up to four taps, for low accuracy
using DoubleTaps = TapPolynomials<double, 11, 16>;
template <class Real>
using Taps = std::conditional_t<sizeof(Real) == 8, DoubleTaps, SingleTaps>;

// Tap polynomials of two kernels of up to four taps each, side by side in one vector; halves: kernel of each tap.
struct PairedTaps {
    static constexpr std::size_t terms = CoarseTaps::terms, taps = 8;
    static constexpr std::uint32_t halves[taps] = {0, 0, 0, 0, 1, 1, 1, 1};
    alignas(64) float at[terms][taps];

    PairedTaps() = default;
    PairedTaps(const CoarseTaps& first, const CoarseTaps& second) {
        for (std::size_t k = 0; k < terms; ++k) {
            std::copy_n(first.at[k], taps / 2, at[k]);
            std::copy_n(second.at[k], taps / 2, at[k] + taps / 2);
        }
    }
};

// Gridding kernel with its tap polynomials and its bounds weight() and chain(), computed once.
struct GriddingTaps {
    GriddingKernel kernel;
    double weight, chain;
    CoarseTaps coarse;
    SingleTaps singles;
    DoubleTaps doubles;

    explicit GriddingTaps(const GriddingKernel& of)
        : kernel(of), weight(of.weight()), chain(of.chain()), coarse(of), singles(of), doubles(of) {}

    const SingleTaps& taps(float) const { return singles; }
    const DoubleTaps& taps(double) const { return doubles; }
};

}  // namespace lommel
