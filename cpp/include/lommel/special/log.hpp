// Natural logarithms of vectors of floats.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "lommel/base/simd.hpp"

namespace lommel {

// Of normal numbers above 0, within 2e-7 of 1 or of the logarithm, whichever is more.
template <class V>
LOMMEL_INLINE V logarithm(V x) {
#ifdef LOMMEL_VECTORS
    typedef std::int32_t Whole __attribute__((vector_size(sizeof(V))));
    Whole bits;
    std::memcpy(&bits, &x, sizeof bits);
    // 2^e m, with m between the roots of 1/2 and of 2.
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

}  // namespace lommel
