// Natural logarithms of vectors of floats, and of doubles in loops that compilers turn into vectors.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#include "lommel/base/simd.hpp"

namespace lommel {

// ln x of floats x > 0 that are not subnormal, with an error below 2e-7 times the larger of 1 and |ln x|.
template <class V>
LOMMEL_INLINE V logarithm(V x) {
#ifdef LOMMEL_VECTORS
    typedef std::int32_t Whole __attribute__((vector_size(sizeof(V))));
    Whole bits;
    std::memcpy(&bits, &x, sizeof bits);
    // Split x = 2^e m, m between sqrt(1/2), whose bits are 0x3f3504f3, and sqrt(2).
    const Whole shifted = bits - 0x3f3504f3;
    const Whole exponent = shifted >> 23;
    const Whole rest = (shifted & 0x7fffff) + 0x3f3504f3;
    V m;
    std::memcpy(&m, &rest, sizeof m);
    const V e = __builtin_convertvector(exponent, V);
    const V s = (m - 1.0F) / (m + 1.0F), q = s * s;
    const V series = 2.0F + q * (0.66666667F + q * (0.4F + q * (0.28571430F + q * 0.22222222F)));
    return e * 0.69314718F + s * series;
#else
    for (float& lane : x.v) {
        lane = std::log(lane);
    }
    return x;
#endif
}

// ln x of a double x > 0 that is not subnormal, with an error below 4e-16 times the larger of 1 and |ln x|.
LOMMEL_INLINE double logarithm(double x) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    // Split x = 2^e m, m between sqrt(1/2) and sqrt(2). `exponent`: bits of the double 2^52 + (e + 1023); `large`: bits of 2^52.
    constexpr std::uint64_t half_root = 0x3fe6a09e667f3bcd, mantissa = 0x000fffffffffffff, large = 0x4330000000000000;
    const std::uint64_t shifted = bits + (0x3ff0000000000000 - half_root);
    const std::uint64_t exponent = (shifted >> 52) | large, rest = (shifted & mantissa) + half_root;
    double e, m;
    std::memcpy(&e, &exponent, sizeof e);
    std::memcpy(&m, &rest, sizeof m);
    e -= 4503599627371519.0;
    const double s = (m - 1.0) / (m + 1.0), q = s * s;
    double series = 2.0 / 21.0;
    for (const double term :
         {2.0 / 19.0, 2.0 / 17.0, 2.0 / 15.0, 2.0 / 13.0, 2.0 / 11.0, 2.0 / 9.0, 2.0 / 7.0, 2.0 / 5.0, 2.0 / 3.0}) {
        series = term + q * series;
    }
    // Sum e ln 2 + ln m, with ln 2 in two parts: the product of the integer e with the first part is exact.
    return e * 0.693147180369123816490 + (2.0 * s + (s * (q * series) + e * 1.90821492927058770002e-10));
}

}  // namespace lommel
