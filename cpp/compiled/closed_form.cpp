// Compiles the paper's closed form. Functions of headers included above LOMMEL_DEFINES are compiled in other units.
#include "lommel/base/cache.hpp"
#include "lommel/base/parallel.hpp"

#define LOMMEL_DEFINES

#include "lommel/paper/closed_form.hpp"
