// The Python module of the core. Bindings check shapes and release the GIL; all arithmetic is in the headers.
#include "python.hpp"

using namespace bindings;

NB_MODULE(_core, m) {
    m.doc() = "Compiled core of lommel: the spectral engine, Bessel sequences, rendering, Huygens' sum.";
    define_special(m);
    define_pixels(m);
    define_radial(m);
    define_zernike(m);
    define_aperture(m);
    define_chordal(m);
    define_averages(m);
    define_paper(m);
    define_imaging(m);
    define_estimation(m);
    define_localize(m);
    define_stratified(m);
    define_focal(m);
    define_process(m);
}
