// Compiles the geometry, quadrature and fields of apertures made of ellipses and polygons. Functions of headers included
// above LOMMEL_DEFINES are compiled in other units.
#include "lommel/base/cache.hpp"
#include "lommel/base/parallel.hpp"
#include "lommel/limits.hpp"
#include "lommel/special/legendre.hpp"
#include "lommel/special/wave_sums.hpp"
#include "lommel/zernike/disk_stack.hpp"

#define LOMMEL_DEFINES

#include "lommel/aperture/row_field.hpp"
