// Compiles pixel averages far from the axis from the rims of apertures. Functions of headers included above LOMMEL_DEFINES
// are compiled in other units.
#include "lommel/base/parallel.hpp"
#include "lommel/base/product.hpp"
#include "lommel/chordal/kernels.hpp"
#include "lommel/zernike/disk_stack.hpp"

#define LOMMEL_DEFINES

#include "lommel/rim/averages.hpp"
#include "lommel/rim/boxes.hpp"
