// Floating-point type in which tables are computed.
#pragma once

#include <limits>

namespace lommel {

// Floating-point type wider than double where the processor has one: 64 bits of mantissa on x86. The 113-bit long double of Arm
// and WebAssembly is not used, as software computes it. LOMMEL_WIDE selects another type. If `wide` is double, the error bounds
// include the additional rounding of the tables.
#if defined(LOMMEL_WIDE)
using wide = LOMMEL_WIDE;
#elif defined(__LDBL_MANT_DIG__) && __LDBL_MANT_DIG__ == 64
using wide = long double;
#else
using wide = double;
#endif
constexpr bool wider = std::numeric_limits<wide>::digits > std::numeric_limits<double>::digits;

}  // namespace lommel
