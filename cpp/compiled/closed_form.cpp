// Compiles the closed form of the paper. Headers before LOMMEL_DEFINES are compiled by other units.
#include "lommel/base/cache.hpp"
#include "lommel/base/parallel.hpp"

#define LOMMEL_DEFINES

#include "lommel/paper/closed_form.hpp"
