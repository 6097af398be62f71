// Compiles the chordal rule, except its kernels. Functions of headers included above LOMMEL_DEFINES are compiled in other
// units.
#include "lommel/base/parallel.hpp"
#include "lommel/bounds/disk.hpp"
#include "lommel/bounds/ellipse.hpp"
#include "lommel/pixels/render.hpp"
#include "lommel/special/bessel_table.hpp"
#include "lommel/special/gridding.hpp"
#include "lommel/zernike/disk_stack.hpp"
#include "lommel/zernike/polar_image.hpp"

#define LOMMEL_DEFINES

#include "lommel/chordal/images.hpp"

template class lommel::ChordalRenderer<float>;
template class lommel::ChordalRenderer<double>;
template class lommel::ChordalRenderer<float, lommel::ChordalDerivatives<float>>;
template class lommel::ChordalRenderer<double, lommel::ChordalDerivatives<double>>;
