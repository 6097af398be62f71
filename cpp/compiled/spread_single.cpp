// Compiles blur by depth in single precision.
#include "lommel/imaging/spread.hpp"

template class lommel::Spreader<float>;
