// Compiles images by the polar non-uniform FFT. Functions of headers included above LOMMEL_DEFINES are compiled in other
// units.
#include "lommel/special/gridding.hpp"
#include "lommel/zernike/disk_stack.hpp"
#include "lommel/zernike/field.hpp"

#define LOMMEL_DEFINES

#include "lommel/zernike/polar_image.hpp"

template void lommel::PolarImage::paint<float>(double, float*);
template void lommel::PolarImage::paint<double>(double, double*);
