// Compiles the kernels of the chordal rule in double precision.
#include "lommel/chordal/kernels.hpp"

template struct lommel::ChordKernels<double>;
