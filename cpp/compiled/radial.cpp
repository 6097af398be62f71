// Fields and intensities of radial pupils. What comes first is compiled by other units.
#include "lommel/base/parallel.hpp"
#include "lommel/bounds/disk.hpp"
#include "lommel/bounds/ellipse.hpp"
#include "lommel/radial/average_values.hpp"
#include "lommel/special/bessel_table.hpp"
#include "lommel/special/gridding.hpp"

#define LOMMEL_DEFINES

#include "lommel/radial/average_images.hpp"
