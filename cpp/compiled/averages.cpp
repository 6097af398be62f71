// Compiles pixel averages at the nodes of a window. Functions of headers included above LOMMEL_DEFINES are compiled in other
// units.
#include "lommel/base/parallel.hpp"
#include "lommel/base/product.hpp"
#include "lommel/chordal/images.hpp"
#include "lommel/rim/averages.hpp"
#include "lommel/rim/boxes.hpp"
#include "lommel/special/least_squares.hpp"
#include "lommel/zernike/disk_stack.hpp"

#define LOMMEL_DEFINES

#include "lommel/averages/disks.hpp"
