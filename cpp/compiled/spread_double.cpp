#include "lommel/imaging/spread.hpp"

template class lommel::Spreader<double>;
