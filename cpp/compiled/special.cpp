// Compiles threads, matrix products, bounds and Bessel tables, shared by all engines.
#define LOMMEL_DEFINES

#include "lommel/base/parallel.hpp"
#include "lommel/base/product.hpp"
#include "lommel/bounds/disk.hpp"
#include "lommel/bounds/ellipse.hpp"
#include "lommel/special/bessel_table.hpp"
#include "lommel/special/gridding.hpp"
#include "lommel/special/least_squares.hpp"
