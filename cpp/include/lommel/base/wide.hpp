// Floating-point type in which tables are computed.
#pragma once

#include <limits>

namespace lommel {

// Floating-point type wider than double where the processor has one: 64 bits of mantissa on x86. The 113 bits of long double on
// Arm and WebAssembly are not used, as they are computed in software. There, where long double is double, or if LOMMEL_WIDE
// says so, tables are made in double, and bounds include the additional error.
#if defined(LOMMEL_WIDE)
using wide = LOMMEL_WIDE;
#elif defined(__LDBL_MANT_DIG__) && __LDBL_MANT_DIG__ == 64
using wide = long double;
#else
using wide = double;
#endif
constexpr bool wider = std::numeric_limits<wide>::digits > std::numeric_limits<double>::digits;

}  // namespace lommel
