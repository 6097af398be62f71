// Compiles blur with occlusion in single precision.
#include "lommel/imaging/composite.hpp"

template class lommel::Compositor<float>;
