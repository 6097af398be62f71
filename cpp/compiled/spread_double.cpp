// Compiles blur by depth in double precision. Headers before LOMMEL_DEFINES are compiled by other units.
#include "lommel/base/parallel.hpp"
#include "lommel/imaging/column.hpp"
#include "lommel/imaging/mixture.hpp"

#define LOMMEL_DEFINES

#include "lommel/imaging/spread.hpp"

template class lommel::Spreader<double>;
