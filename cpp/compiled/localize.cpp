// Compiles images and fits of molecules. Functions of headers included above LOMMEL_DEFINES are compiled in other units.
#include "lommel/base/parallel.hpp"

#define LOMMEL_DEFINES

#include "lommel/localize/bank.hpp"
