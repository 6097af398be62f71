// Compiles blur by depth in double precision.
#include "lommel/imaging/spread.hpp"

template class lommel::Spreader<double>;
