// Pupils of any Zernike terms on small windows, by the chordal rule.
#include "lommel/chordal/images.hpp"

#include "pupils.hpp"

void bindings::define_chordal(nb::module_& m) {
    define_disk_images<lommel::ChordalRenderer, false>(
        m, "chordal_images", "The same by the chordal rule; bounds are over the largest value of the window.");
}
