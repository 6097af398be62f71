// Planes of a microscope in plane-layered media: images and profiles.
#include <algorithm>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include <nanobind/stl/optional.h>

#include "lommel/stratified/images.hpp"
#include "lommel/stratified/rings_image.hpp"

#include "pupils.hpp"

using namespace bindings;

namespace {

// Layered of lommel.core.engine: rho (q,), parts (m, q); rates (3, q) with the phase and its change by depth and by focus; the
// error of each part; planes (3, n) with depth, focus and power; forms (k, m, m); turns (k, 3) with the azimuthal order of each
// form and the factors of its cosine and sine.
using PlaneFields =
    std::tuple<In<double, 1>, In<complex, 2>, In<complex, 2>, double, In<double, 2>, In<complex, 3>, In<double, 2>>;

lommel::Planes planes_of(const PlaneFields& given) {
    const auto& [rho, parts, rates, error, planes, forms, turns] = given;
    const std::size_t angles = rho.shape(0), count = parts.shape(0), orders = forms.shape(0), n = planes.shape(1);
    const complex* rate = rates.data();
    const double* plane = planes.data();
    lommel::Planes made{{rho.data(), angles, count, parts.data(), rate, rate + angles, rate + 2 * angles, error},
                        plane,
                        plane + n,
                        plane + 2 * n,
                        n,
                        {},
                        {}};
    for (std::size_t k = 0; k < orders; ++k) {
        const double* turn = turns.data() + 3 * k;
        lommel::Harmonic harmonic{{}, static_cast<std::size_t>(turn[0]), turn[1], turn[2]};
        for (std::size_t i = 0; i < count * count; ++i) {
            harmonic.form[i / count][i % count] = forms.data()[k * count * count + i];
        }
        made.harmonics.push_back(harmonic);
    }
    return made;
}

// Derivatives as arrays: by (k, 2) with the LayeredSlope and its factor; own (k, n), factor of I itself; of_fields (3,), error
// bounds of the fields differentiated with respect to depth, focus and v.
template <class T>
using SlopeFields = std::tuple<In<double, 2>, In<double, 2>, In<double, 1>, Out<T, 4>, Out<double, 2>>;

template <class T>
lommel::LayeredSlopes<T> slopes_of(const SlopeFields<T>& given, lommel::Planes& requested, bool integrate) {
    const auto& [by, own, fields, slopes, errors] = given;
    const In<double, 1>& of_fields = fields;
    const std::size_t count = by.shape(0), n = requested.count;
    lommel::LayeredSlopes<T> made;
    for (std::size_t k = 0; k < count; ++k) {
        const lommel::By which = static_cast<lommel::By>(static_cast<int>(by.data()[2 * k]));
        require(which != lommel::By::radius || requested.radial(), "only light that is radially symmetric is moved here");
        const auto same = [&](const lommel::Derivative& each) { return each.by == which; };
        const bool known = std::any_of(requested.derivatives.begin(), requested.derivatives.end(), same);
        if (!known && !(which == lommel::By::radius && integrate)) {
            requested.derivatives.push_back({which, of_fields.data()[static_cast<std::size_t>(which)]});
        }
        made.requested.push_back({which, by.data()[2 * k + 1], own.data() + k * n});
    }
    made.images = slopes.data();
    made.errors = errors.data();
    return made;
}

// Windows around one axis, or around one axis per plane.
template <class T>
bool layered_images(PlaneFields planes, WindowFields window, bool integrate, double allowed, int threads, Out<T, 3> images,
                    Out<double, 2> numbers, std::optional<SlopeFields<T>> slopes) {
    lommel::Planes requested = planes_of(planes);
    const std::size_t n = requested.count;
    require_shape(window, images);
    const AxisWindow place = axis_window(window, n);
    lommel::LayeredSlopes<T> derivatives;
    if (slopes) {
        derivatives = slopes_of<T>(*slopes, requested, integrate);
    }
    const lommel::PixelWindow first = place.pixels(integrate);
    // A single axis off the middle is treated as one axis per plane, as one table serves windows around any axis. Derivatives
    // of samples, and shifts of averages, are only available around such axes.
    const bool moved = std::any_of(derivatives.requested.begin(), derivatives.requested.end(),
                                   [](const lommel::LayeredSlope& slope) { return slope.by == lommel::By::radius; });
    std::vector<double> own_axes;
    lommel::PixelWindows windows(first);
    if (place.centers != nullptr) {
        windows = {first, place.centers, n};
    } else if (!first.centered() || (integrate ? moved : !derivatives.requested.empty())) {
        for (std::size_t p = 0; p < n; ++p) {
            own_axes.insert(own_axes.end(), {first.center_y, first.center_x});
        }
        windows = {first, own_axes.data(), n};
    }
    if (!lommel::LayeredImages<T>::fits(requested, windows, slopes.has_value())) {
        return false;
    }
    double* const scales = numbers.data();
    const lommel::Answer<T> answer{images.data(), scales, scales + n, scales + 2 * n};
    released([&] { lommel::LayeredImages<T>(requested, windows, allowed, threads, answer, derivatives).run(); });
    return true;
}

// Azimuthal orders of the intensity at increasing v, shape (n, k, radii), and the error bound of their sum, shape (n,).
std::pair<Out<double, 3>, Out<double, 1>> layered_profiles(PlaneFields planes, In<double, 1> v, int threads) {
    const lommel::Planes requested = planes_of(planes);
    require_radii(v);
    const std::size_t count = v.shape(0), orders = requested.harmonics.size();
    auto values = new_array<double, 3>({requested.count, orders, count});
    auto bounds = new_array<double, 1>({requested.count});
    released([&] {
        const auto radii = std::make_shared<lommel::Radii>();
        radii->count = count;
        radii->radii.assign(v.data(), v.data() + count);
        radii->radii.resize(count + lommel::widest_step, v.data()[count - 1]);
        const std::vector<double> angles(requested.angles.rho, requested.angles.rho + requested.angles.count);
        const lommel::Profiles profiles(
            requested, std::make_shared<const lommel::AngleTable>(radii, 1.0, angles, requested.angles.parts, false));
        profiles.run(threads, [&](std::size_t first, std::size_t here, const double* found, const lommel::PartSizes* sizes) {
            for (std::size_t row = 0; row < here * orders; ++row) {
                std::copy_n(found + row * profiles.stride(), count, values.data() + (first * orders + row) * count);
            }
            for (std::size_t p = 0; p < here; ++p) {
                bounds.data()[first + p] = lommel::Judged(requested, first + p, sizes[p]).given;
            }
        });
    });
    return {values, bounds};
}

// Rings of lommel.core.engine: bessel (orders, circles, nodes), parts (n or 1, 2 orders - 1, fields, nodes), waves (n, nodes),
// power (n,); number of angles; filter over circles; tap polynomials along and around, and their numbers; gains and aliases
// (2, m).
using RingFields = std::tuple<In<double, 3>, In<complex, 4>, In<complex, 2>, In<double, 1>, std::size_t, In<double, 1>,
                              In<double, 2>, In<double, 2>, std::pair<std::size_t, std::size_t>, In<double, 2>>;

// Images of planes with any wavefront; the pitch of the window is in circles.
template <class T>
Out<double, 2> ringed_images(RingFields rings, WindowFields place, In<double, 1> scales, int threads, Out<T, 3> images) {
    const auto& [bessel, parts, waves, power, angles, filter, along, around, taps, gains] = rings;
    const std::size_t n = waves.shape(0), orders = bessel.shape(0), circles = bessel.shape(1), nodes = bessel.shape(2);
    const std::size_t fields = parts.shape(2);
    const lommel::RingLight light{bessel.data(),  orders, circles,      nodes,        parts.data(),
                                  parts.shape(0), fields, waves.data(), power.data(), n};
    const lommel::RingSteps steps{angles,
                                  filter.data(),
                                  filter.shape(0),
                                  {along.data(), along.shape(0), taps.first},
                                  {around.data(), around.shape(0), taps.second},
                                  gains.data(),
                                  gains.data() + gains.shape(1),
                                  gains.shape(1)};
    require_shape(place, images);
    const AxisWindow at = axis_window(place, n);
    const auto& [height, width, row, column, step] = at.first;
    const double axis[] = {row, column};
    const bool own = at.centers != nullptr;
    const lommel::RingWindow window{height, width, own ? at.centers : axis, own ? n : 1, step};
    const double most = window.farthest() * step + static_cast<double>(steps.before() + steps.filters) + 1.0;
    require(most <= static_cast<double>(circles), "too few circles for the window");
    auto numbers = new_array<double, 2>({lommel::RingNumbers::count(fields), n});
    released([&] {
        lommel::RingImages<T>(light, steps, window, threads).run(scales.data(), images.data(), {numbers.data(), n, fields});
    });
    return numbers;
}

}  // namespace

void bindings::define_stratified(nb::module_& m) {
    for_both([&](auto pixel) {
        m.def(
            "layered_images", &layered_images<decltype(pixel)>, "planes"_a, "window"_a, "integrate"_a, "allowed"_a, "threads"_a,
            "images"_a.noconvert(), "numbers"_a.noconvert(), "slopes"_a.noconvert() = nb::none(),
            "Images of planes through layers, and of each in `numbers` what it is multiplied by (0 on entry: over its largest "
            "value), the bound on its error over the peak, and that peak; False, with nothing written, for windows that this "
            "has no way for.");
        m.def(
            "ringed_images", &ringed_images<decltype(pixel)>, "rings"_a, "window"_a, "scales"_a, "threads"_a,
            "images"_a.noconvert(),
            "Images of planes with any wavefront, interpolated between circles, times scales. Returns of each plane the "
            "largest square of each field, the largest intensity on circles, what its orders may be off by and their sum, and "
            "the largest pixel.");
    });
    m.def("layered_profiles", &layered_profiles, "planes"_a, "v"_a, "threads"_a,
          "The orders of the azimuth of the intensity at rising v, and what their sum is off by.");
}
