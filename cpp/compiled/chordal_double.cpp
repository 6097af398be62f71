// Compiles the kernels of the chordal rule in double precision.
#include "lommel/chordal/kernels.hpp"

template struct lommel::ChordKernels<double>;
template void lommel::ChordKernels<double>::store_row<double>(lommel::Level, const double*, double, std::size_t, double*);
template void lommel::ChordKernels<double>::store_lanes<double>(lommel::Level, const double*, std::size_t, const double*,
                                                                std::size_t, double* const*);
template void lommel::ChordKernels<double>::store_row<float>(lommel::Level, const double*, double, std::size_t, float*);
template void lommel::ChordKernels<double>::store_lanes<float>(lommel::Level, const double*, std::size_t, const double*,
                                                               std::size_t, float* const*);
