// Compiles depth maps and sharp images from focal stacks. Functions of headers included above LOMMEL_DEFINES are compiled in
// other units.
#include "lommel/base/parallel.hpp"

#define LOMMEL_DEFINES

#include "lommel/focal/scale.hpp"
#include "lommel/focal/stream.hpp"
