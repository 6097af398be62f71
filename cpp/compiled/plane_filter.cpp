// Compiles axial convolution of image stacks. Functions of headers included above LOMMEL_DEFINES are compiled in other units.
#include "lommel/base/parallel.hpp"

#define LOMMEL_DEFINES

#include "lommel/imaging/plane_filter.hpp"
