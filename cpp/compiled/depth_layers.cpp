// Compiles the division of scenes into depth layers, and the search for the light behind occluding points. Functions of
// headers included above LOMMEL_DEFINES are compiled in other units.
#include "lommel/base/parallel.hpp"

#define LOMMEL_DEFINES

#include "lommel/imaging/depth_layers.hpp"
