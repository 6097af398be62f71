// Header-only or compiled library. If LOMMEL_COMPILED is defined, headers only declare their large non-template functions; a
// source file of cpp/compiled that defines LOMMEL_DEFINES before it includes a header compiles those of that header.
#pragma once

#if defined(LOMMEL_COMPILED)
#define LOMMEL_ONCE
#else
#define LOMMEL_ONCE inline
#define LOMMEL_DEFINES
#endif
