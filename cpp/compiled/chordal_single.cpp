// Compiles the kernels of the chordal rule in single precision.
#include "lommel/chordal/kernels.hpp"

template struct lommel::ChordKernels<float>;
