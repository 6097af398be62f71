// The headers are the whole core. Where LOMMEL_COMPILED is defined, large functions that are no templates are only declared by them:
// a unit of cpp/compiled defines LOMMEL_DEFINES before the headers whose functions it compiles, for all units.
#pragma once

#if defined(LOMMEL_COMPILED)
#define LOMMEL_ONCE
#else
#define LOMMEL_ONCE inline
#define LOMMEL_DEFINES
#endif
