// e^x of a vector of doubles, and an upper bound of e^x for error bounds.
#pragma once

#include "lommel/base/simd.hpp"

namespace lommel {

// Upper bound of e^x for x from -80 to 0, at most 1.07 e^x: between consecutive powers of two the chord lies above the curve.
template <class V>
LOMMEL_INLINE V chord_of_exp(V x) {
    const V low = splat<V>(-80.0f);
    return from_bits(larger(x, low) * splat<V>(12102203.16f) + splat<V>(1065353216.0f));
}

// e^x for x <= 0, with a relative error of a few roundings; 0 for x < -700. A power of two times a Taylor polynomial.
template <class I>
LOMMEL_INLINE typename I::pack exponential(I, typename I::pack x) {
    using V = typename I::pack;
    const V magic = splat<V>(6755399441055744.0), least = splat<V>(-700.0), at = larger(x, least);
    const V shifted = at * splat<V>(1.44269504088896340736) + magic, k = shifted - magic;
    // r = x - k ln 2, with ln 2 in two parts: the product of the integer k with the first part is exact.
    const V r = (at - k * splat<V>(0.693147180369123816490)) - k * splat<V>(1.90821492927058770002e-10);
    V sum = splat<V>(1.0 / 6227020800.0);
    for (const double factorial :
         {479001600.0, 39916800.0, 3628800.0, 362880.0, 40320.0, 5040.0, 720.0, 120.0, 24.0, 6.0, 2.0, 1.0, 1.0}) {
        sum = sum * r + splat<V>(1.0 / factorial);
    }
    return below(x, least, splat<V>(0.0), sum * power_of_two<typename I::bits>(shifted));
}

}  // namespace lommel
