// Header-only or compiled once: if LOMMEL_COMPILED is defined, headers only declare large non-template functions, and a unit of
// cpp/compiled defines LOMMEL_DEFINES before it includes the headers whose functions it compiles.
#pragma once

#if defined(LOMMEL_COMPILED)
#define LOMMEL_ONCE
#else
#define LOMMEL_ONCE inline
#define LOMMEL_DEFINES
#endif
