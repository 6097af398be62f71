// Compiles the Zernike series. Functions of headers included above LOMMEL_DEFINES are compiled in other units.
#include "lommel/base/parallel.hpp"
#include "lommel/bounds/disk.hpp"
#include "lommel/bounds/ellipse.hpp"
#include "lommel/special/bessel_table.hpp"
#include "lommel/special/gridding.hpp"

#define LOMMEL_DEFINES

#include "lommel/zernike/disk_stack.hpp"
#include "lommel/zernike/far_averages.hpp"
#include "lommel/zernike/field.hpp"
