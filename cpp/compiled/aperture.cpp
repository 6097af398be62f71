// Compiles the geometry and the quadrature of apertures of parts. Headers before LOMMEL_DEFINES are compiled by other units.
#include "lommel/base/cache.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/base/watch.hpp"
#include "lommel/limits.hpp"
#include "lommel/special/legendre.hpp"

#define LOMMEL_DEFINES

#include "lommel/aperture/row_rule.hpp"
