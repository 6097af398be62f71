#include "lommel/chordal/kernels.hpp"

template struct lommel::ChordKernels<double>;
