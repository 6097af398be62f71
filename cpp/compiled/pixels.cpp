// Compiles what writes pixels of images.
#include "lommel/pixels/layout.hpp"
#include "lommel/pixels/render.hpp"
#include "lommel/pixels/sample_pieces.hpp"
#include "lommel/pixels/window.hpp"

template void lommel::Layout::scatter<float>(const float*, std::size_t, std::size_t, float*) const;
template void lommel::Layout::scatter<double>(const double*, std::size_t, std::size_t, double*) const;
template void lommel::PixelGroups::paint<float>(const float*, std::size_t, std::size_t, float*) const;
template void lommel::PixelGroups::paint<double>(const double*, std::size_t, std::size_t, double*) const;
template void lommel::store_scaled<double, float>(const double*, double, std::size_t, float*);
template void lommel::store_scaled<double, double>(const double*, double, std::size_t, double*);
template void lommel::store_scaled<float, float>(const float*, double, std::size_t, float*);
template void lommel::store_least<float>(const double*, double, std::size_t, float, float*);
template void lommel::store_least<double>(const double*, double, std::size_t, double, double*);
template double lommel::SamplePieces::paint<float>(const lommel::PixelWindow&, const double*, double, float, int, float*) const;
template double lommel::SamplePieces::paint<double>(const lommel::PixelWindow&, const double*, double, double, int,
                                                    double*) const;
