// Compiles blur with occlusion in double precision.
#include "lommel/imaging/composite.hpp"

template class lommel::Compositor<double>;
