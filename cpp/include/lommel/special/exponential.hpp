// Upper bound of e^x, for error bounds.
#pragma once

#include "lommel/base/simd.hpp"

namespace lommel {

// At least e^x for x from -80 to 0, and at most 1.07 of it: between powers of two a chord lies above the curve.
template <class V>
LOMMEL_INLINE V chord_of_exp(V x) {
    const V low = splat<V>(-80.0f);
    return from_bits(larger(x, low) * splat<V>(12102203.16f) + splat<V>(1065353216.0f));
}

}  // namespace lommel
