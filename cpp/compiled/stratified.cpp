// Compiles profiles and circles of planes through layers. Headers before LOMMEL_DEFINES are compiled by other units.
#include "lommel/base/product.hpp"
#include "lommel/pixels/shift.hpp"
#include "lommel/radial/average_values.hpp"

#define LOMMEL_DEFINES

#include "lommel/stratified/profiles.hpp"
#include "lommel/stratified/rings.hpp"
