// Planes of a microscope through layers: images and profiles.
#include <algorithm>
#include <memory>
#include <vector>

#include "lommel/stratified/images.hpp"
#include "lommel/stratified/rings_image.hpp"

#include "pupils.hpp"

using namespace bindings;

namespace {

// Angles and planes as arrays: rho (q,), parts (m, q), rates (3, q), depth, focus and power (n,), forms (k, m, m), and of each of
// these the order, and the factors of its cosine and its sine, (k, 3).
lommel::Planes planes_of(const In<double, 1>& rho, const In<complex, 2>& parts, const In<complex, 2>& rates, double error,
                         const In<double, 2>& planes, const In<complex, 3>& forms, const In<double, 2>& turns) {
    const std::size_t angles = rho.shape(0), count = parts.shape(0), orders = forms.shape(0), n = planes.shape(1);
    require(angles > 0 && count > 0 && count <= lommel::most_parts && n > 0 && orders > 0, "empty, or too many parts");
    require(parts.shape(1) == angles && rates.shape(0) == 3 && rates.shape(1) == angles, "one value an angle");
    require(planes.shape(0) == 3, "planes are depth, focus and power");
    require(forms.shape(1) == count && forms.shape(2) == count && turns.shape(0) == orders && turns.shape(1) == 3,
            "forms must match the parts, and have an order, a cosine and a sine each");
    require(turns.data()[0] == 0.0, "the order 0 must come first");
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

// Windows around the axis that all planes share, or around one each: centers (1, 2) or (n, 2).
template <class T>
bool layered_images(In<double, 1> rho, In<complex, 2> parts, In<complex, 2> rates, double error, In<double, 2> planes,
                    In<complex, 3> forms, In<double, 2> turns, In<double, 2> centers, double step, bool integrate,
                    double allowed, int threads, Out<T, 3> images, Out<double, 2> numbers, In<double, 2> by,
                    Out<double, 4> slopes, Out<double, 2> slope_errors) {
    lommel::Planes asked = planes_of(rho, parts, rates, error, planes, forms, turns);
    const std::size_t n = asked.count;
    require(images.shape(0) == n && numbers.shape(0) == 3 && numbers.shape(1) == n, "one image, scale, bound and peak a plane");
    require(allowed > 0.0 && threads >= 0, "allowed must be positive, threads at least 0");
    require_centers(centers, centers.shape(0) == 1 ? 1 : n);
    lommel::LayeredSlopes derivatives{};
    if (by.is_valid()) {
        const std::size_t count = by.shape(0);
        require(by.shape(1) == 2 && count > 0, "derivatives are a number and an error each");
        bool axis = false;
        for (std::size_t d = 0; d < count; ++d) {
            const double which = by.data()[2 * d];
            require(!axis && (which == 0.0 || which == 1.0 || which == 2.0), "derivatives are 0, 1 or, the last, 2");
            axis = which == 2.0;
            asked.derivatives.push_back({static_cast<lommel::By>(static_cast<int>(which)), by.data()[2 * d + 1]});
        }
        const std::size_t made = count + (axis ? 1 : 0);
        require(!axis || !integrate, "averages have no derivatives by the axis here");
        require(slopes.is_valid() && slope_errors.is_valid() && slopes.shape(0) == made && slopes.shape(1) == n &&
                    slopes.shape(2) == images.shape(1) && slopes.shape(3) == images.shape(2) && slope_errors.shape(0) == made &&
                    slope_errors.shape(1) == n,
                "derivatives must match the images");
        derivatives = {slopes.data(), slope_errors.data()};
    }
    const double* at = centers.data();
    const lommel::PixelWindow first = window_of(images.shape(1), images.shape(2), at[0], at[1], step, integrate);
    // One axis off the middle is one of each plane: the same table serves windows around any; derivatives are of such.
    std::vector<double> own;
    lommel::PixelWindows windows(first);
    if (centers.shape(0) == n && n > 1) {
        windows = {first, at, n};
    } else if (!first.centered() || (!integrate && !asked.derivatives.empty())) {
        for (std::size_t p = 0; p < n; ++p) {
            own.insert(own.end(), at, at + 2);
        }
        windows = {first, own.data(), n};
    }
    if (!lommel::LayeredImages<T>::fits(asked, windows)) {
        return false;
    }
    double* const scales = numbers.data();
    const lommel::Answer<T> answer{images.data(), scales, scales + n, scales + 2 * n, nullptr, 0, nullptr, nullptr};
    released([&] { lommel::LayeredImages<T>(asked, windows, allowed, threads, answer, derivatives).run(); });
    return true;
}

// The orders of the azimuth at rising v, shape (n, k, radii), and what their sum is off by, shape (n,).
std::pair<Out<double, 3>, Out<double, 1>> layered_profiles(In<double, 1> rho, In<complex, 2> parts, In<complex, 2> rates,
                                                           double error, In<double, 2> planes, In<complex, 3> forms,
                                                           In<double, 2> turns, In<double, 1> v, int threads) {
    const lommel::Planes asked = planes_of(rho, parts, rates, error, planes, forms, turns);
    require_radii(v);
    require(v.shape(0) > 0 && threads >= 0, "v must not be empty, threads at least 0");
    const std::size_t count = v.shape(0), orders = asked.harmonics.size();
    auto values = new_array<double, 3>({asked.count, orders, count});
    auto bounds = new_array<double, 1>({asked.count});
    released([&] {
        const auto radii = std::make_shared<lommel::Radii>();
        radii->count = count;
        radii->radii.assign(v.data(), v.data() + count);
        radii->radii.resize(count + lommel::widest_step, v.data()[count - 1]);
        const std::vector<double> angles(asked.angles.rho, asked.angles.rho + asked.angles.count);
        const lommel::Profiles profiles(
            asked, std::make_shared<const lommel::AngleTable>(radii, 1.0, angles, asked.angles.parts, false));
        profiles.run(threads, [&](std::size_t first, std::size_t here, const double* found, const lommel::PartSizes* sizes) {
            for (std::size_t row = 0; row < here * orders; ++row) {
                std::copy_n(found + row * profiles.stride(), count, values.data() + (first * orders + row) * count);
            }
            for (std::size_t p = 0; p < here; ++p) {
                bounds.data()[first + p] = lommel::Judged(asked, first + p, sizes[p]).given;
            }
        });
    });
    return {values, bounds};
}

lommel::RingTaps taps_of(const In<double, 2>& polynomials, std::size_t count) {
    require(polynomials.shape(0) > 0 && polynomials.shape(1) == lommel::RingTaps::most, "taps are sixteen polynomials");
    require(count >= 4 && count <= lommel::RingTaps::most && count % 2 == 0, "of taps there are 4 to 16, an even number");
    return {polynomials.data(), polynomials.shape(0), count};
}

// Images of planes with any wavefront: Bessel functions (orders, circles, nodes), parts (n or 1, 2 orders - 1, fields, nodes),
// waves (n, nodes) and power (n,); how circles are filtered, taps of both ways and how many these are, gains and aliases (2, m).
template <class T>
Out<double, 2> ringed_images(In<double, 3> bessel, In<complex, 4> parts, In<complex, 2> waves, In<double, 1> power,
                             std::size_t angles, In<double, 1> filter, In<double, 2> along, In<double, 2> around,
                             std::pair<std::size_t, std::size_t> taps, In<double, 2> gains, In<double, 2> centers, double step,
                             In<double, 1> scales, int threads, Out<T, 3> images) {
    const std::size_t n = waves.shape(0), orders = bessel.shape(0), circles = bessel.shape(1), nodes = bessel.shape(2);
    const std::size_t fields = parts.shape(2), height = images.shape(1), width = images.shape(2);
    require(n > 0 && orders > 0 && nodes > 0 && fields > 0 && height > 0 && width > 0 && threads >= 0, "nothing may be empty");
    require(parts.shape(0) == n || parts.shape(0) == 1, "one wavefront, or one a plane");
    require(parts.shape(1) == 2 * orders - 1 && parts.shape(3) == nodes && waves.shape(1) == nodes, "one value a node");
    require(power.shape(0) == n && scales.shape(0) == n && images.shape(0) == n, "one image, power and scale a plane");
    require(gains.shape(0) == 2 && gains.shape(1) == 2 * orders - 1, "a gain and an alias for each order of the intensity");
    require(angles == lommel::RowFft<double>::length(angles) && angles >= 4 * orders - 3, "too few angles, or no length");
    const lommel::RingLight light{bessel.data(),  orders, circles,      nodes,        parts.data(),
                                  parts.shape(0), fields, waves.data(), power.data(), n};
    const lommel::RingSteps steps{angles,
                                  filter.data(),
                                  filter.shape(0),
                                  taps_of(along, taps.first),
                                  taps_of(around, taps.second),
                                  gains.data(),
                                  gains.data() + gains.shape(1),
                                  gains.shape(1)};
    require(steps.filters > 0, "a filter has one weight at least");
    require_centers(centers, centers.shape(0) == 1 ? 1 : n);
    const lommel::RingWindow window{height, width, centers.data(), centers.shape(0), step};
    const double most = window.farthest() * step + static_cast<double>(steps.before() + steps.filters) + 1.0;
    require(step > 0.0 && most <= static_cast<double>(circles), "too few circles for the window");
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
            "layered_images", &layered_images<decltype(pixel)>, "rho"_a, "parts"_a, "rates"_a, "error"_a, "planes"_a, "forms"_a,
            "turns"_a, "centers"_a, "step"_a, "integrate"_a, "allowed"_a, "threads"_a, "images"_a.noconvert(),
            "numbers"_a.noconvert(), "by"_a.none() = nb::none(), "slopes"_a.noconvert().none() = nb::none(),
            "slope_errors"_a.noconvert().none() = nb::none(),
            "Images of planes through layers, and of each in `numbers` what it is multiplied by (0 on entry: over its largest "
            "value), the bound on its error over the peak, and that peak; False, with nothing written, for windows that this "
            "has no way for.");
        m.def(
            "ringed_images", &ringed_images<decltype(pixel)>, "bessel"_a, "parts"_a, "waves"_a, "power"_a, "angles"_a,
            "filter"_a, "along"_a, "around"_a, "taps"_a, "gains"_a, "centers"_a, "step"_a, "scales"_a, "threads"_a,
            "images"_a.noconvert(),
            "Images of planes with any wavefront, interpolated between circles, times scales. Returns of each plane the "
            "largest square of each field, the largest intensity on circles, what its orders may be off by and their sum, and "
            "the largest pixel.");
    });
    m.def("layered_profiles", &layered_profiles, "rho"_a, "parts"_a, "rates"_a, "error"_a, "planes"_a, "forms"_a, "turns"_a,
          "v"_a, "threads"_a, "The orders of the azimuth of the intensity at rising v, and what their sum is off by.");
}
