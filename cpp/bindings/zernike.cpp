// Pupils with arbitrary Zernike terms, by their series, and by their rims.
#include "lommel/rim/boxes.hpp"
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

template <class... Center>
double rim_remainders(In<std::int32_t, 2> terms, In<double, 2> edge, double obscuration, In<double, 1> amplitude,
                      Center... center, std::size_t height, std::size_t width, double step, int threads,
                      Out<double, 1> remainders, Out<double, 2> axes) {
    const std::size_t pupils = pupils_of(edge);
    require(remainders.shape(0) == pupils && axes.shape(0) == pupils && axes.shape(1) == 2, "numbers of each pupil");
    return ask_disks<true>(
        terms, edge, obscuration, amplitude, height, width, step, 0.1, threads,
        [&](const lommel::DiskStack& stack, const lommel::DiskWindow&) {
            for (std::size_t p = 0; p < pupils; ++p) {
                axes.data()[2 * p] = static_cast<double>(stack.rows[p]);
                axes.data()[2 * p + 1] = static_cast<double>(stack.columns[p]);
            }
            if (lommel::RimStack::serves(stack)) {
                lommel::RimStack(stack).remainders(threads, remainders.data());
            } else {
                std::fill_n(remainders.data(), pupils, std::numeric_limits<double>::infinity());
            }
        },
        center...);
}

template <class... Center>
bool rim_boxes(In<std::int32_t, 2> terms, In<double, 2> edge, double obscuration, In<double, 1> amplitude, Center... center,
               std::size_t height, std::size_t width, double step, double tol, double lowest, int threads,
               Out<std::int64_t, 2> sides, Out<std::int64_t, 2> axes, Out<double, 2> numbers) {
    const std::size_t pupils = pupils_of(edge);
    require(sides.shape(0) == 2 && sides.shape(1) == pupils && axes.shape(0) == pupils && axes.shape(1) == 2 &&
                numbers.shape(0) == 2 && numbers.shape(1) == pupils,
            "numbers of each pupil");
    bool pay = false;
    ask_disks<true>(
        terms, edge, obscuration, amplitude, height, width, step, tol, threads,
        [&](const lommel::DiskStack& stack, const lommel::DiskWindow& window) {
            lommel::RimBoxes boxes(stack, window, tol, lowest);
            pay = boxes.choose(threads);
            if (!pay) {
                return;
            }
            std::copy_n(boxes.sides.data(), pupils, sides.data());
            std::copy_n(boxes.most.data(), pupils, sides.data() + pupils);
            std::copy_n(boxes.remainders.data(), pupils, numbers.data());
            std::copy_n(boxes.tolerances.data(), pupils, numbers.data() + pupils);
            for (std::size_t p = 0; p < pupils; ++p) {
                axes.data()[2 * p] = stack.rows[p];
                axes.data()[2 * p + 1] = stack.columns[p];
            }
        },
        center...);
    return pay;
}

template <class... Center>
double rim_averages(In<std::int32_t, 2> terms, In<double, 2> edge, double obscuration, In<double, 1> amplitude,
                    Center... center, double step, double error, int threads, In<double, 1> remainders, In<double, 3> near,
                    In<std::int64_t, 1> places, Out<double, 3> images, Out<double, 2> numbers) {
    const std::size_t pupils = pupils_of(edge), box = near.shape(1);
    require(places.shape(0) == pupils && numbers.shape(0) == pupils && numbers.shape(1) == 2 && remainders.shape(0) == pupils,
            "one place and two numbers a pupil");
    require(std::all_of(places.data(), places.data() + pupils,
                        [&](std::int64_t place) { return place >= 0 && place < static_cast<std::int64_t>(images.shape(0)); }),
            "places must be those of images");
    require(near.shape(0) == pupils && near.shape(2) == box && box % 2 == 1, "boxes of an odd number of pixels");
    return ask_disks<true>(
        terms, edge, obscuration, amplitude, images.shape(1), images.shape(2), step, 0.1, threads,
        [&](const lommel::DiskStack& stack, const lommel::DiskWindow& window) {
            const lommel::RimAnswer answer{remainders.data(), near.data(), places.data(), images.data(), numbers.data()};
            lommel::RimAverages(stack, window, box, error, answer).run(threads);
        },
        center...);
}

template <class... Center, class... Named>
void define_rims(nb::module_& m, const Named&... named) {
    m.def("rim_remainders", &rim_remainders<Center...>, "terms"_a, "edge"_a, "obscuration"_a, "amplitude"_a, named...,
          "height"_a, "width"_a, "step"_a, "threads"_a, "remainders"_a.noconvert(), "axes"_a.noconvert(),
          "Of each pupil what the rim leaves of the field at v = 1, its mean over the disk, and the pixel of the axis.");
    m.def("rim_boxes", &rim_boxes<Center...>, "terms"_a, "edge"_a, "obscuration"_a, "amplitude"_a, named..., "height"_a,
          "width"_a, "step"_a, "tol"_a, "lowest"_a, "threads"_a, "sides"_a.noconvert(), "axes"_a.noconvert(),
          "numbers"_a.noconvert(),
          "Of each pupil the side of the box around the pixel of its axis outside which rims serve, or 0, and the largest one "
          "that "
          "it may have; that pixel; what the rim leaves, and what averages may be off by. Whether rims pay, without which "
          "nothing "
          "is told.");
    m.def("rim_averages", &rim_averages<Center...>, "terms"_a, "edge"_a, "obscuration"_a, "amplitude"_a, named..., "step"_a,
          "error"_a, "threads"_a, "remainders"_a, "near"_a, "places"_a, "images"_a.noconvert(), "numbers"_a.noconvert(),
          "Averages over pixels outside boxes around the axes from the rims of pupils, and the given ones within; of each what "
          "those are off by, and the largest.");
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
    m.attr("RIM_ORDERS") = lommel::rim_orders;
    define_rims<double, double>(m, "center_y"_a, "center_x"_a);
    define_rims<In<double, 2>>(m, "centers"_a);
    m.def(
        "interpolation_worth", [](double share) { lommel::interpolation_worth() = share; }, "share"_a,
        "Interpolate between circles where that is predicted to take at most this share of the series' time: 1, or 0 for "
        "never.");
}
