// Compiles the chordal rule, except its kernels.
#include "lommel/chordal/images.hpp"

template class lommel::ChordalRenderer<float>;
template class lommel::ChordalRenderer<double>;
template class lommel::ChordalRenderer<float, lommel::ChordalDerivatives<float>>;
template class lommel::ChordalRenderer<double, lommel::ChordalDerivatives<double>>;
