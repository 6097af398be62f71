// Compiles averages far from the axis from the rims of apertures. Headers before LOMMEL_DEFINES are compiled by other units.
#include "lommel/base/parallel.hpp"
#include "lommel/base/product.hpp"
#include "lommel/chordal/kernels.hpp"
#include "lommel/zernike/disk_stack.hpp"

#define LOMMEL_DEFINES

#include "lommel/rim/averages.hpp"
#include "lommel/rim/boxes.hpp"
