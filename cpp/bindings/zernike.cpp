// Pupils with arbitrary Zernike terms, by their series.
#include "lommel/zernike/images.hpp"

#include "pupils.hpp"

void bindings::define_zernike(nb::module_& m) {
    define_disk_images<lommel::ZernikeRenderer, true>(
        m, "series_images",
        "Images of pupils of Zernike terms (n, m), by their series; scales are 0 on entry where values are to be divided by "
        "their largest one. 0, or the bound that is left.");
    m.def(
        "interpolation_worth", [](double share) { lommel::interpolation_worth() = share; }, "share"_a,
        "Interpolate between circles where that is predicted to take at most this share of the series' time: 1, or 0 for "
        "never.");
}
