// Compiles images of planes through layers.
#include "lommel/stratified/images.hpp"
#include "lommel/stratified/rings_image.hpp"

template class lommel::LayeredImages<float>;
template class lommel::LayeredImages<double>;
template class lommel::RingImages<float>;
template class lommel::RingImages<double>;
