// Fourier transforms of lengths 2^a 3^b for eight sequences at once.
//
// Layout: [element][eight real parts, eight imaginary parts]. Speed is limited by loads and stores.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/base/simd.hpp"

namespace lommel {

constexpr std::size_t fft_rows = 8;
constexpr std::size_t fft_element = 2 * fft_rows;  // floating-point numbers per element

// Vector type of Real on instruction set I, of at most eight lanes.
template <class I, class Real>
struct RowPack;
template <class I>
struct RowPack<I, double> {
    using type = typename I::pack;
};
template <class I>
struct RowPack<I, float> {
    using type = typename I::floats;
};

template <class V>
struct ComplexPack {
    V re, im;
    friend LOMMEL_INLINE ComplexPack operator+(ComplexPack a, ComplexPack b) { return {a.re + b.re, a.im + b.im}; }
    friend LOMMEL_INLINE ComplexPack operator-(ComplexPack a, ComplexPack b) { return {a.re - b.re, a.im - b.im}; }
    LOMMEL_INLINE ComplexPack times_i() const { return {V{} - im, re}; }
    LOMMEL_INLINE ComplexPack times(V c, V s) const { return {re * c - im * s, im * c + re * s}; }
};

// Fourier transform X_l = sum_j x_j exp(2 pi i j l / n) of length n by Stockham's algorithm: a pass of radix r splits each
// transform into r transforms, r times as short. The first and the last pass have radix 4.
template <class Real>
class RowFft {
   public:
    // `length` must be 16 times a product of twos and threes.
    explicit RowFft(std::size_t length) : n(length) {
        std::size_t rest = n / 16;
        radices_.push_back(4);
        for (const std::size_t radix : {4, 3, 2}) {
            for (; rest % radix == 0; rest /= radix) {
                radices_.push_back(radix);
            }
        }
        std::size_t size = n;
        for (const std::size_t radix : radices_) {
            for (std::size_t p = 0; p < size / radix; ++p) {
                for (std::size_t k = 1; k < radix; ++k) {
                    const double angle = 6.283185307179586477 * static_cast<double>(p * k) / static_cast<double>(size);
                    turns_.push_back(static_cast<Real>(std::cos(angle)));
                    turns_.push_back(static_cast<Real>(std::sin(angle)));
                }
            }
            size /= radix;
        }
    }

    // Smallest length 16 x 2^a x 3^b that is not below `least`.
    static std::size_t length(std::size_t least) {
        std::size_t best = 16;
        while (best < least) {
            best *= 2;
        }
        for (std::size_t threes = 3; 16 * threes < 2 * least; threes *= 3) {
            for (std::size_t n = 16 * threes; n < best; n *= 2) {
                best = n >= least ? n : best;
            }
        }
        return best;
    }

    const std::size_t n;

    // Bound on the rounding error of any output X_l, in units of roundoff times the sum of all |x_j| of the input. Contributions of
    // a pass: 1 for one complex sum (radix 2), 2 for two (radix 4), 4.7 for radix 3; 2.24 for a complex product; for the tabulated
    // root of unity 1, plus the error of its angle, 3 * 2 pi in double precision and 0.1 in single. The last pass has two sums and
    // no product.
    double rounding() const {
        constexpr double root = 1.0 + (sizeof(Real) == 8 ? 3.0 * 6.2832 : 0.1);
        double units = 2.0;
        for (const std::size_t radix : radices_) {
            units += (radix == 3 ? 4.7 : radix == 4 ? 2.0 : 1.0) + 2.24 + root;
        }
        return units;
    }

    // Run all passes but the last. The passes alternate between the arrays x and `other`; returns the one with the result.
    // `Sparse`: the two middle quarters of x are zero and are not read.
    template <bool Sparse = true, class I>
    LOMMEL_INLINE Real* run(I, Real* x, Real* other) const {
        using V = typename RowPack<I, Real>::type;
        std::size_t size = n, stride = 1;
        const Real* turns = turns_.data();
        bool first = true;
        for (const std::size_t radix : radices_) {
            if (first) {
                pass<4, Sparse, V>(x, other, size, stride, turns);
            } else if (radix == 4) {
                pass<4, false, V>(x, other, size, stride, turns);
            } else if (radix == 3) {
                pass<3, false, V>(x, other, size, stride, turns);
            } else {
                pass<2, false, V>(x, other, size, stride, turns);
            }
            first = false;
            turns += 2 * (radix - 1) * (size / radix);
            size /= radix;
            stride *= radix;
            std::swap(x, other);
        }
        return x;
    }

    // Last pass at index q < n/4, to which y points: x[k] = X_{q + k n/4} = sum_j y_{q + j n/4} i^{jk}, k = 0 .. 3.
    template <class V>
    LOMMEL_INLINE void last(const Real* y, ComplexPack<V>* x) const {
        const auto at = [&](std::size_t j) LOMMEL_INLINE_LAMBDA {
            const Real* here = y + j * (n / 4) * fft_element;
            return ComplexPack<V>{load<V>(here), load<V>(here + fft_rows)};
        };
        const auto a = at(0), b = at(1), d = at(2), e = at(3);
        const auto even = a + d, odd = b + e, other = a - d, third = (b - e).times_i();
        x[0] = even + odd;
        x[1] = other + third;
        x[2] = even - odd;
        x[3] = other - third;
    }

    // Run all passes, for any input x. Returns the array, x or `other`, that holds the transform.
    template <class I>
    LOMMEL_INLINE Real* whole(I isa, Real* x, Real* other) const {
        static constexpr Real none[] = {1, 0, 1, 0, 1, 0};
        Real* const before = run<false>(isa, x, other);
        Real* const to = before == x ? other : x;
        pass<4, false, typename RowPack<I, Real>::type>(before, to, 4, n / 4, none);
        return to;
    }

   private:
    template <std::size_t Radix, bool Sparse, class V>
    static LOMMEL_INLINE void pass(const Real* from, Real* to, std::size_t size, std::size_t stride, const Real* turns) {
        constexpr std::size_t lanes = sizeof(V) / sizeof(Real);
        using C = ComplexPack<V>;
        const std::size_t apart = size / Radix;
        for (std::size_t p = 0; p < apart; ++p, turns += 2 * (Radix - 1)) {
            V c[Radix], s[Radix];
            for (std::size_t k = 1; k < Radix; ++k) {
                c[k] = splat<V>(turns[2 * k - 2]);
                s[k] = splat<V>(turns[2 * k - 1]);
            }
            for (std::size_t q = 0; q < stride; ++q) {
                for (std::size_t part = 0; part < fft_rows; part += lanes) {
                    const auto at = [&](std::size_t k) LOMMEL_INLINE_LAMBDA {
                        const Real* here = from + (q + stride * (p + apart * k)) * fft_element + part;
                        return C{load<V>(here), load<V>(here + fft_rows)};
                    };
                    const auto put = [&](std::size_t k, C value) LOMMEL_INLINE_LAMBDA {
                        Real* here = to + (q + stride * (Radix * p + k)) * fft_element + part;
                        store(here, value.re);
                        store(here + fft_rows, value.im);
                    };
                    if constexpr (Sparse) {
                        const C a = at(0), b = at(3), turned = b.times_i();
                        put(0, a + b);
                        put(1, (a - turned).times(c[1], s[1]));
                        put(2, (a - b).times(c[2], s[2]));
                        put(3, (a + turned).times(c[3], s[3]));
                    } else if constexpr (Radix == 4) {
                        const C a = at(0), b = at(1), d = at(2), e = at(3);
                        const C even = a + d, odd = b + e, other = a - d, turned = (b - e).times_i();
                        put(0, even + odd);
                        put(1, (other + turned).times(c[1], s[1]));
                        put(2, (even - odd).times(c[2], s[2]));
                        put(3, (other - turned).times(c[3], s[3]));
                    } else if constexpr (Radix == 3) {
                        const C a = at(0), b = at(1), d = at(2);
                        const V half = splat<V>(Real(0.5)), root = splat<V>(Real(0.86602540378443864676));
                        const C sum = b + d, apart_by = b - d;
                        const C middle = {a.re - half * sum.re, a.im - half * sum.im};
                        const C turned = C{root * apart_by.re, root * apart_by.im}.times_i();
                        put(0, a + sum);
                        put(1, (middle + turned).times(c[1], s[1]));
                        put(2, (middle - turned).times(c[2], s[2]));
                    } else {
                        const C a = at(0), b = at(1);
                        put(0, a + b);
                        put(1, (a - b).times(c[1], s[1]));
                    }
                }
            }
        }
    }

    std::vector<std::size_t> radices_;  // radices of all passes but the last
    std::vector<Real> turns_;
};

}  // namespace lommel
