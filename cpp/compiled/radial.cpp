// Compiles fields and intensities of radially symmetric pupils. Functions of headers included above LOMMEL_DEFINES are
// compiled in other units.
#include "lommel/base/parallel.hpp"
#include "lommel/bounds/disk.hpp"
#include "lommel/bounds/ellipse.hpp"
#include "lommel/radial/average_values.hpp"
#include "lommel/special/bessel_table.hpp"
#include "lommel/special/gridding.hpp"

#define LOMMEL_DEFINES

#include "lommel/radial/average_images.hpp"

template double lommel::SamplePieces::paint<float>(const lommel::PixelWindow&, const double*, double, float, int, float*) const;
template double lommel::SamplePieces::paint<double>(const lommel::PixelWindow&, const double*, double, double, int,
                                                    double*) const;
