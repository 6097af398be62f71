// Compiles blur that varies over the field and with depth.
#include "lommel/imaging/field_spread.hpp"

template class lommel::FieldSpreader<float>;
template class lommel::FieldSpreader<double>;
