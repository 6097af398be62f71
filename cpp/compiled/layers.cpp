// Compiles images of planes in layered media.
#include "lommel/stratified/images.hpp"
#include "lommel/stratified/rings_image.hpp"

template class lommel::LayeredImages<float>;
template class lommel::LayeredImages<double>;
template class lommel::RingImages<float>;
template class lommel::RingImages<double>;
