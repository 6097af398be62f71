// Compiles blur by depth in double precision. Functions of headers included above LOMMEL_DEFINES are compiled in other units.
#include "lommel/base/parallel.hpp"
#include "lommel/imaging/column.hpp"
#include "lommel/imaging/mixture.hpp"

#define LOMMEL_DEFINES

#include "lommel/imaging/spread.hpp"

template class lommel::Spreader<double>;
