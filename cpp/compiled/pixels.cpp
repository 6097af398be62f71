// Compiles tables of pixel windows and their evaluation. Functions of headers included above LOMMEL_DEFINES are compiled in
// other units.
#include "lommel/base/parallel.hpp"
#include "lommel/bounds/disk.hpp"
#include "lommel/bounds/ellipse.hpp"
#include "lommel/special/bessel_table.hpp"
#include "lommel/special/gridding.hpp"

#define LOMMEL_DEFINES

#include "lommel/pixels/shift.hpp"
#include "lommel/radial/average_values.hpp"

template void lommel::Layout::scatter<float>(const float*, std::size_t, std::size_t, float*) const;
template void lommel::Layout::scatter<double>(const double*, std::size_t, std::size_t, double*) const;
template void lommel::PixelGroups::paint<float>(const float*, std::size_t, std::size_t, float*) const;
template void lommel::PixelGroups::paint<double>(const double*, std::size_t, std::size_t, double*) const;
template void lommel::store_scaled<double, float>(const double*, double, std::size_t, float*);
template void lommel::store_scaled<double, double>(const double*, double, std::size_t, double*);
template void lommel::store_scaled<float, float>(const float*, double, std::size_t, float*);
template void lommel::store_least<float>(const double*, double, std::size_t, float, float*);
template void lommel::store_least<double>(const double*, double, std::size_t, double, double*);
