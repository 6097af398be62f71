// Compiles profiles and circles of planes in layered media. Functions of headers included above LOMMEL_DEFINES are compiled
// in other units.
#include "lommel/base/product.hpp"
#include "lommel/pixels/shift.hpp"
#include "lommel/radial/average_values.hpp"

#define LOMMEL_DEFINES

#include "lommel/stratified/profiles.hpp"
#include "lommel/stratified/rings.hpp"
