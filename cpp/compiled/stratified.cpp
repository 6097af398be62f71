// Profiles of planes through layers, and circles. What comes first is compiled by other units.
#include "lommel/pixels/shift.hpp"
#include "lommel/radial/average_values.hpp"

#define LOMMEL_DEFINES

#include "lommel/stratified/profiles.hpp"
#include "lommel/stratified/rings.hpp"
