// Pupils with arbitrary Zernike terms, by their series.
#include "lommel/zernike/far_averages.hpp"
#include "lommel/zernike/images.hpp"

#include "pupils.hpp"

namespace {

using namespace bindings;

template <class... Center>
double far_averages(In<std::int32_t, 2> terms, In<double, 2> edge, double obscuration, In<double, 1> amplitude,
                    Center... center, double step, double most, double tol, int threads, Out<double, 3> images,
                    Out<double, 2> numbers) {
    const std::size_t pupils = pupils_of(edge);
    require(images.shape(0) == pupils && numbers.shape(0) == pupils && numbers.shape(1) == lommel::FarAverages::numbers,
            "one image and five numbers a pupil");
    return ask_disks<false>(
        terms, edge, obscuration, amplitude, images.shape(1), images.shape(2), step, tol, threads,
        [&](const lommel::DiskStack& given, const lommel::DiskWindow& window) {
            lommel::DiskStack stack = given;
            stack.center_axes(window);
            stack.shrink();
            lommel::FarAverages(stack, window, most, tol, threads, images.data(), numbers.data()).run();
        },
        center...);
}

template <class... Center, class... Named>
void define_far_averages(nb::module_& m, const char* says, const Named&... named) {
    m.def("far_averages", &far_averages<Center...>, "terms"_a, "edge"_a, "obscuration"_a, "amplitude"_a, named..., "step"_a,
          "most"_a, "tol"_a, "threads"_a, "images"_a.noconvert(), "numbers"_a.noconvert(), says);
}

}  // namespace

void bindings::define_zernike(nb::module_& m) {
    define_disk_images<lommel::ZernikeRenderer, true>(
        m, "series_images",
        "Images of pupils of Zernike terms (n, m), by their series; scales are 0 on entry where values are to be divided by "
        "their largest one. 0, or the bound that is left.");
    define_far_averages<double, double>(m,
                                        "Averages over pixels far from the axis, 0 nearer to it; none where those `most` from "
                                        "it, in v, are not within `tol` of the "
                                        "largest average that is likely. Of each pupil: the distance in pixels from which on "
                                        "they are there, the bound on their "
                                        "error, that largest average, and the row and the column of the axis.",
                                        "center_y"_a, "center_x"_a);
    define_far_averages<In<double, 2>>(m, "The same, each around an axis of its own.", "centers"_a);
    m.def(
        "interpolation_worth", [](double share) { lommel::interpolation_worth() = share; }, "share"_a,
        "Interpolate between circles where that is predicted to take at most this share of the series' time: 1, or 0 for "
        "never.");
}
