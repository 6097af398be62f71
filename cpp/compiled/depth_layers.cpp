// Compiles layers of depth, and what points hide. Headers before LOMMEL_DEFINES are compiled by other units.
#include "lommel/base/parallel.hpp"

#define LOMMEL_DEFINES

#include "lommel/imaging/depth_layers.hpp"
