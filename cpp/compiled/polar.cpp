// Compiles images by the polar non-uniform FFT.
#include "lommel/zernike/polar_image.hpp"

template void lommel::PolarImage::paint<float>(double, float*);
template void lommel::PolarImage::paint<double>(double, double*);
