// Compiles the kernels of the chordal rule in single precision.
#include "lommel/chordal/kernels.hpp"

template struct lommel::ChordKernels<float>;
template void lommel::ChordKernels<float>::store_row<float>(lommel::Level, const float*, double, std::size_t, float*);
template void lommel::ChordKernels<float>::store_lanes<float>(lommel::Level, const float*, std::size_t, const double*,
                                                              std::size_t, float* const*);
