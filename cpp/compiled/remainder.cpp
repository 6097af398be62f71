// Compiles the factors of the PSF remainder beyond its window.
#include "lommel/imaging/remainder.hpp"

template void lommel::remainder_factors<float>(const RemainderCubics<float>&, const double*, std::size_t, int, float*);
template void lommel::remainder_factors<double>(const RemainderCubics<double>&, const double*, std::size_t, int, double*);
