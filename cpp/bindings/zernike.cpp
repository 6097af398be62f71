// Pupils of any Zernike terms, by their series.
#include "lommel/zernike/images.hpp"

#include "pupils.hpp"

void bindings::define_zernike(nb::module_& m) {
    define_disk_images<lommel::ZernikeRenderer, true>(
        m, "series_images",
        "Images of pupils of Zernike terms (n, m), by their series; scales are 0 on entry where values are to be divided by "
        "their largest one. 0, or the bound that is left.");
}
