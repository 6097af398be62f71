// Compiles blur over the field and by depth.
#include "lommel/imaging/field_spread.hpp"

template class lommel::FieldSpreader<float>;
template class lommel::FieldSpreader<double>;
