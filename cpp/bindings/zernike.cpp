// Pupils with arbitrary Zernike terms, by their series.
#include "lommel/zernike/far_averages.hpp"
#include "lommel/zernike/images.hpp"

#include "pupils.hpp"

namespace {

using namespace bindings;

double far_averages(DiskFields stack, WindowFields window, double most, double tol, int threads, Out<double, 3> images,
                    Out<double, 2> numbers) {
    return ask_disks<false>(stack, window, tol, threads, [&](const lommel::DiskStack& given, const lommel::DiskWindow& at) {
        lommel::DiskStack centered = given;
        centered.center_axes(at);
        centered.shrink();
        lommel::FarAverages(centered, at, most, tol, threads, images.data(), numbers.data()).run();
    });
}

}  // namespace

void bindings::define_zernike(nb::module_& m) {
    define_disk_images<lommel::ZernikeRenderer, true>(
        m, "series_images",
        "Images of pupils of Zernike terms (n, m), by their series; scales are 0 on entry where values are to be divided by "
        "their largest one. 0, or the bound that is left.");
    m.def(
        "far_averages", &far_averages, "stack"_a, "window"_a, "most"_a, "tol"_a, "threads"_a, "images"_a.noconvert(),
        "numbers"_a.noconvert(),
        "Averages over pixels far from the axis, 0 nearer to it; none where those `most` from it, in v, are not within `tol` "
        "of the largest average that is likely. Of each pupil: the distance in pixels from which on they are there, the bound "
        "on their error, that largest average, and the row and the column of the axis.");
}
