// Header-only or compiled library. If LOMMEL_COMPILED is defined, headers only declare large non-template functions; a source
// file of cpp/compiled compiles those of a header by defining LOMMEL_DEFINES before it includes the header.
#pragma once

#if defined(LOMMEL_COMPILED)
#define LOMMEL_ONCE
#else
#define LOMMEL_ONCE inline
#define LOMMEL_DEFINES
#endif
