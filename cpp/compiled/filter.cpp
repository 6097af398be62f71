// Compiles pixel averages by filters of finer samples.
#include "lommel/pixels/filter.hpp"

template void lommel::PixelFilter::average<float>(const float*, std::size_t, std::size_t, std::size_t, double*, std::size_t,
                                                  int) const;
template void lommel::PixelFilter::average<double>(const double*, std::size_t, std::size_t, std::size_t, double*, std::size_t,
                                                   int) const;
