// Compiles depth and sharp images of frames that differ in focus. Headers before LOMMEL_DEFINES are compiled by other units.
#include "lommel/base/parallel.hpp"

#define LOMMEL_DEFINES

#include "lommel/focal/scale.hpp"
#include "lommel/focal/stream.hpp"
