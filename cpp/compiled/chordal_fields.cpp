// Compiles intensities of fields with amplitude series by the chordal rule, and their derivatives. Functions of headers
// included above LOMMEL_DEFINES are compiled in other units.
#include "lommel/base/parallel.hpp"
#include "lommel/chordal/batch.hpp"
#include "lommel/chordal/kernels.hpp"

#define LOMMEL_DEFINES

#include "lommel/chordal/field_gradient.hpp"
#include "lommel/chordal/fields.hpp"
#include "lommel/chordal/series_errors.hpp"
