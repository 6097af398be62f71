// What all parts of the C interface share: its version, and what went wrong last.
#include "coded.hpp"

#if !defined(LOMMEL_VERSION)
#define LOMMEL_VERSION "unknown"  // compiled without CMake
#endif

int lommel_abi(void) noexcept { return LOMMEL_ABI; }
const char* lommel_version(void) noexcept { return LOMMEL_VERSION; }
const char* lommel_message(void) noexcept { return coding::message.text; }
