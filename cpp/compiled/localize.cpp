// Compiles images and fits of molecules. Headers before LOMMEL_DEFINES are compiled by other units.
#include "lommel/base/parallel.hpp"

#define LOMMEL_DEFINES

#include "lommel/localize/bank.hpp"
