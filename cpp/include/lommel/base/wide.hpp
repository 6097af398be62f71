// Number types in which tables are computed.
#pragma once

#include <limits>

namespace lommel {

// Wider than double where the processor has it: 64 bits on x86. Not the 113 bits of Arm's long double and of WebAssembly's, which are
// software: there, as where long double is double, or LOMMEL_WIDE says so, tables are made in double, and bounds say what
// that costs.
#if defined(LOMMEL_WIDE)
using wide = LOMMEL_WIDE;
#elif defined(__LDBL_MANT_DIG__) && __LDBL_MANT_DIG__ == 64
using wide = long double;
#else
using wide = double;
#endif
constexpr bool wider = std::numeric_limits<wide>::digits > std::numeric_limits<double>::digits;

}  // namespace lommel
