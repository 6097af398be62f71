// Compiles blur along the planes of a stack. Headers before LOMMEL_DEFINES are compiled by other units.
#include "lommel/base/parallel.hpp"

#define LOMMEL_DEFINES

#include "lommel/imaging/plane_filter.hpp"
