// Images of a pupil at one or several wavelengths, for the live page.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

#include "encircled.hpp"
#include "lommel/pixels/filter.hpp"
#include "lommel/pixels/taps.hpp"
#include "lommel/radial/average_images.hpp"
#include "lommel/zernike/far_averages.hpp"
#include "lommel/zernike/images.hpp"

namespace live {

// Spectral line. Optical path differences do not depend on the wavelength, so phases and v are those of the reference times
// `stretch`, the reference wavelength over that of the line.
struct Line {
    double stretch, share;
    double weight() const { return share * stretch * stretch; }
};

struct Light {
    std::vector<lommel::ZernikeTerm> terms;
    std::vector<double> edge;  // [term]: coefficient in radians at the edge, at the reference wavelength
    double obscuration = 0.0;
    std::vector<Line> lines;
    std::vector<double> vanes;  // directions in radians
    double vane_width = 0.0;    // width over the radius of the aperture

    bool radial() const {
        return std::all_of(terms.begin(), terms.end(), [](const lommel::ZernikeTerm& term) { return term.m == 0; });
    }
    double area() const { return 1.0 - obscuration * obscuration; }
    std::vector<double> stretched(double stretch) const {
        std::vector<double> out(edge);
        std::for_each(out.begin(), out.end(), [&](double& c) { c *= stretch; });
        return out;
    }
};

struct View {
    std::size_t side;
    double step;  // pixel pitch in v of the reference
    bool integrate;
};

// bound: error relative to the peak; peak: lower bound on the maximum; rest: smallest bound that any tolerance can reach.
struct Proof {
    double bound, peak, rest = 0.0;
};

// Samples of a pupil without radial symmetry, on part of a window.
template <class T>
Proof sampled(const Light& light, const std::vector<double>& edge, const lommel::DiskWindow& window, double tol, double scale,
              T* out) {
    using namespace lommel;
    double numbers[3] = {scale, 0.0, 0.0};
    DiskStack stack(light.terms, edge.data(), 1, light.obscuration, Amplitude{});
    stack.move_axes(window);
    stack.shrink();
    ZernikeRenderer<T>(stack, window, tol, 1, {out, numbers, numbers + 1, numbers + 2}).run();
    return {numbers[1], numbers[2]};
}

// Pixel averages from finer samples, some rows of pixels at a time, like methods/averaging.py. The bound is relative to a lower
// bound on the largest average anywhere.
struct Averages {
    static constexpr double single = 2e-7;  // tolerance from which on samples are stored in single precision
    static constexpr double spared = 4e5;    // number of samples to be saved to omit those of far pixels
    static constexpr double exactly = 1.2e7;  // maximum number of samples of all lines for full accuracy in all pixels
    static constexpr std::size_t at_once = std::size_t{1} << 23,
                                 most = std::size_t{1} << 23;  // maximum number of samples: per block of rows; of all lines

    const Light& light;
    const std::vector<double>& edge;
    std::size_t side;
    double step;
    std::vector<double> total;
    double given = 0.0, peak = 0.0;  // error of averages from that of the samples, and lower bound on the largest intensity

    // Return whether the peak is far below the peak without aberrations.
    bool blurred() const {
        return std::accumulate(edge.begin(), edge.end(), 0.0, [](double sum, double c) { return sum + std::abs(c); }) > 20.0;
    }

    template <class S>
    void make(const lommel::PixelTaps& taps, double tol) {
        const lommel::PixelFilter filter{taps.weights.data(), taps.weights.size(), taps.stride};
        const std::size_t wide = filter.samples(side), rows = std::max<std::size_t>(1, at_once / (wide * taps.stride));
        const double middle = static_cast<double>(taps.stride * (side / 2) + taps.margin());
        std::vector<S> samples;
        total.assign(side * side, 0.0);
        given = peak = 0.0;
        for (std::size_t y = 0; y < side; y += rows) {
            const std::size_t here = std::min(rows, side - y), tall = filter.samples(here);
            samples.resize(tall * wide);
            const lommel::DiskWindow window{tall, wide, middle - static_cast<double>(taps.stride * y), middle,
                                            step / static_cast<double>(taps.stride)};
            const Proof proof = sampled(light, edge, window, tol, 1.0, samples.data());
            given = std::max(given, taps.gain * taps.gain * proof.bound * proof.peak);
            peak = std::max(peak, proof.peak * (1.0 - proof.bound));
            filter.average(samples.data(), 1, here, side, &total[y * side], side * side, 1);
        }
    }

    // Pixels far from the axis are computed without samples where that saves enough, like methods/averaging.py. If the others
    // would need too many samples, the page gets less accurate averages.
    Proof run(double tol, double storing) {
        const std::size_t whole = side, across = lommel::PixelTaps::across(step, 1.05);
        // Samples of the widest pixels must be so accurate that each takes longer.
        const double budget = static_cast<double>(most) / static_cast<double>(light.lines.size() * (across > 256 ? 8 : 1));
        const std::size_t fit = static_cast<std::size_t>(std::sqrt(budget)) / across;
        const double width = static_cast<double>(whole), inside = width * width - spared / (step * step);
        // During interaction tolerances are larger, and time is short.
        const double samples = (tol > 1e-5 || across > 256 ? 0.25 : 1.0) * exactly / static_cast<double>(light.lines.size());
        const double exact = std::floor(std::sqrt(samples) / static_cast<double>(across));
        const double farthest = 0.5 * step * std::min({std::sqrt(std::max(0.0, inside)), inside / width, exact - 2.0});
        if (farthest > 0.0) {
            for (double requested = tol; requested < 0.02; requested *= 10.0) {
                const Proof proof = near_and_far(requested, storing, farthest);
                if (proof.bound <= requested) {
                    return {proof.bound, proof.peak, requested > tol ? proof.bound : 0.0};
                }
                if (whole <= fit) {
                    break;
                }
            }
        }
        return whole <= fit ? near_axis(tol, storing) : mean_of_edges(tol, storing, fit);
    }

    // The bound exceeds `tol` if pixels farther than `farthest` from the axis do not meet it.
    Proof near_and_far(double tol, double storing, double farthest) {
        using namespace lommel;
        const std::size_t whole = side;
        const double middle = static_cast<double>(whole / 2), room = tol - (1.0 + tol) * storing;
        const DiskWindow window{whole, whole, middle, middle, step};
        DiskStack stack(light.terms, edge.data(), 1, light.obscuration, Amplitude{});
        stack.center_axes(window);
        stack.shrink();
        std::vector<double> image(whole * whole);
        double requested = 0.7 * room;
        for (int retry = 0; retry < 3; ++retry) {
            double found[FarAverages::numbers];
            FarAverages(stack, window, farthest, requested, 1, image.data(), found).run();
            const double row = found[3], column = found[4],
                         reach = std::ceil(found[0]) + std::max(std::abs(row - middle), std::abs(column - middle));
            if (!(2.0 * reach + 1.0 < static_cast<double>(whole))) {
                break;
            }
            const std::size_t half = static_cast<std::size_t>(std::ceil(reach)), first = whole / 2 - half;
            side = 2 * half + 1;
            const Proof near = near_axis(tol, storing);
            side = whole;
            const double far = stored(found[1] / near.peak, storing);
            if (far <= tol) {
                for (std::size_t y = 0; y <= 2 * half; ++y) {
                    std::copy_n(&total[y * (2 * half + 1)], 2 * half + 1, &image[(first + y) * whole + first]);
                }
                total.swap(image);
                return {std::max(near.bound, far), near.peak};
            }
            requested *= 0.8 * room * near.peak / found[1];
        }
        return {1e300, 0.0};
    }

    // Samples only for pixels next to the axis, as many as time permits. Every pixel farther out contains at most the remaining
    // light: its value is the mean of the light diffracted by the edges (EnergyTail) or that remainder, whichever is less.
    Proof mean_of_edges(double tol, double storing, std::size_t fit) {
        const std::size_t whole = side;
        const std::size_t half = fit > 2 ? (fit - 1) / 2 : 0;
        side = 2 * half + 1;
        // Lower bound on the remaining light: the light that the edges of the aperture diffract beyond these pixels.
        const double past =
            0.63661977236758134 * (1.0 + light.obscuration) / (light.area() * (static_cast<double>(half) + 0.5) * step);
        const double taking = static_cast<double>(side * side);
        const Proof inside = near_axis(std::max(tol, std::min(1e-3, 0.1 * past / taking)), storing);
        const std::vector<double> near = std::move(total);
        const double pixel = step * step, sum = std::accumulate(near.begin(), near.end(), 0.0);
        const double missing =
            std::max(0.0, 12.566370614359172 * light.area() / pixel - sum) + taking * inside.bound * inside.peak;
        const double mean = 1.2732395447351628 * (1.0 + light.obscuration) / (pixel * step);
        total.resize(whole * whole);
        const double middle = static_cast<double>(whole / 2);
        for (std::size_t i = 0; i < total.size(); ++i) {
            const double y = static_cast<double>(i / whole) - middle, x = static_cast<double>(i % whole) - middle;
            const double square = std::max(0.25, x * x + y * y);
            total[i] = std::min(missing, mean / (square * std::sqrt(square)));
        }
        const std::size_t first = whole / 2 - half;
        for (std::size_t y = 0; y < side; ++y) {
            std::copy_n(&near[y * side], side, &total[(first + y) * whole + first]);
        }
        side = whole;
        const double rest = lommel::stored(missing / (inside.peak * (1.0 - inside.bound)), storing);
        return {std::max(inside.bound, rest), inside.peak, rest};
    }

    // Filters of fewer samples are longer, and may reach bright light next to a window of dark pixels.
    Proof near_axis(double tol, double storing) {
        for (const double widest : {1.05, 0.8}) {
            Proof proof = attempt(tol, storing, widest);
            if (proof.bound > tol && blurred()) {
                proof.rest = proof.bound;
            }
            if (proof.bound <= tol || proof.rest > 0.0) {
                return proof;
            }
        }
        throw lommel::ToleranceNotMet(tol);
    }

    Proof attempt(double tol, double storing, double widest) {
        using namespace lommel;
        const double ceiling = light.area() * light.area(), aim = tol - (1.0 + tol) * storing, lowest = least_average(step);
        // First attempt: as if the largest average were a few times its lower bound, and the peak not faint.
        double finer = 0.5 * aim * std::min(4.0 * lowest, 1.0), response = 2e-3 * aim * lowest;
        // With large aberrations samples are less bright; sums in single precision show by how much. Samples below `rounded` of
        // their peak are rounding errors, which would take long to detect.
        const bool dim = blurred();
        if (dim) {
            finer = std::max(finer, 1.5 * single);
        }
        double rounded = 0.0;
        Proof proof{1e300, 0.0};
        for (int retry = 0; retry < 5; ++retry) {
            const PixelTaps taps(step, response, widest);
            const double requested = std::max(finer / (taps.gain * taps.gain), rounded);
            requested >= single ? make<float>(taps, requested) : make<double>(taps, requested);
            const double top = *std::max_element(total.begin(), total.end());
            const double rounding =
                static_cast<double>(2 * taps.weights.size() + 8) * unit_roundoff * taps.gain * taps.gain * peak;
            const double own = (2.0 + taps.error) * taps.error * ceiling + rounding, found = std::max(top, lowest * peak);
            if (!(found > 0.0)) {
                break;
            }
            proof = {stored((given + own) / found, storing), found};
            if (proof.bound <= tol || (dim && requested <= rounded)) {
                break;
            }
            rounded = dim ? 2e-12 / peak : 0.0;
            finer = requested >= single && !dim ? 0.9 * single : finer * std::min(1.0, 0.5 * aim * found / given);
            response *= std::min(1.0, 0.2 * aim * found / own);
        }
        return proof;
    }
};

inline Proof image_of_line(const Light& light, const Line& line, const View& view, double tol, double scale, float* out) {
    using namespace lommel;
    const std::vector<double> edge = light.stretched(line.stretch);
    const double step = view.step * line.stretch, middle = static_cast<double>(view.side / 2);
    Proof proof;
    if (light.radial()) {
        std::vector<double> powers(1, 0.0);  // coefficients of R_2^0, R_4^0, ...
        for (std::size_t j = 0; j < edge.size(); ++j) {
            const std::size_t at = static_cast<std::size_t>(light.terms[j].n / 2 - 1);
            powers.resize(std::max(powers.size(), at + 1));
            powers[at] = edge[j];
        }
        double numbers[3] = {scale, 0.0, 0.0};
        const Stack stack{powers.data(), 1, powers.size(), light.obscuration};
        const Answer<float> answer{out, numbers, numbers + 1, numbers + 2, nullptr, 0, nullptr, nullptr};
        const PixelWindow window{view.side, view.side, middle, middle, step, view.integrate};
        render_radial<float>(stack, window, tol, 1, answer);
        proof = {numbers[1], numbers[2]};
    } else if (view.integrate) {
        Averages averages{light, edge, view.side, step, {}};
        proof = averages.run(tol, storing<float>(false));
        std::transform(averages.total.begin(), averages.total.end(), out,
                       [&](double x) { return static_cast<float>(scale * x); });
    } else {
        proof = sampled(light, edge, DiskWindow{view.side, view.side, middle, middle, step}, tol, scale, out);
    }
    return {proof.bound, proof.peak * scale, proof.rest};
}

// Fraction of all light in each pixel. With `weights`, three for each line, `planes` becomes the three sums over the lines with
// these weights.
inline Proof image_of(const Light& light, const View& view, double tol, float* out, const double* weights = nullptr,
                      float* planes = nullptr) {
    // Scale of I of the reference, which is 1 at the peak of a full aperture without aberration.
    const double scale = view.step * view.step / (12.566370614359172 * light.area());
    const std::size_t pixels = view.side * view.side;
    if (light.lines.size() == 1) {
        return image_of_line(light, light.lines[0], view, tol, scale * light.lines[0].weight(), out);
    }
    // Smallest tolerance of a line in single precision. If the sum misses the requested tolerance, its bound shows it.
    constexpr double least = 2.5e-7;
    static std::vector<float> part;
    static std::vector<double> total;
    part.resize(pixels);
    for (double requested = std::max(tol, least);;) {
        total.assign(pixels, 0.0);
        double off = 0.0, peak = 0.0, rest = 0.0;
        if (planes != nullptr) {
            std::fill_n(planes, 3 * pixels, 0.0F);
        }
        for (std::size_t k = 0; k < light.lines.size(); ++k) {
            const Line& line = light.lines[k];
            const Proof proof = image_of_line(light, line, view, requested, scale * line.weight(), part.data());
            std::transform(part.begin(), part.end(), total.begin(), total.begin(),
                           [](float a, double b) { return static_cast<double>(a) + b; });
            for (std::size_t c = 0; planes != nullptr && c < 3; ++c) {
                const float weight = static_cast<float>(weights[3 * k + c]);
                std::transform(part.begin(), part.end(), planes + c * pixels, planes + c * pixels,
                               [=](float a, float b) { return weight * a + b; });
            }
            off += proof.bound * proof.peak;
            rest = std::max(rest, proof.rest);
            // Intensities are not negative, so the sum is at least as bright as each part.
            peak = std::max(peak, proof.peak * (1.0 - proof.bound));
        }
        const double highest = *std::max_element(total.begin(), total.end());
        off += static_cast<double>(light.lines.size() + 8) * lommel::unit_roundoff * highest;
        const double bound = lommel::stored(off / std::max(peak, highest - off), lommel::storing<float>(false));
        if (bound <= tol || requested == least || rest > tol) {
            std::transform(total.begin(), total.end(), out, [](double x) { return static_cast<float>(x); });
            return {bound, highest, rest};
        }
        requested = std::max(least, 0.5 * requested * std::min(1.0, tol / bound));
    }
}

// Light of each line as the mean on circles about the axis, with and without aberrations.
struct Circles {
    struct Part {
        Line line;
        lommel::MeanProfile profile, flat;
    };
    std::vector<Part> parts;
    double brightest = 0.0, area = 1.0, off = 0.0;

    Circles() = default;
    // For radii up to `reach` in v of the reference; errors of U and of the interpolation are below `error`.
    Circles(const Light& light, double reach, double error) : area(light.area()) {
        using namespace lommel;
        for (const Line& line : light.lines) {
            const std::vector<double> edge = light.stretched(line.stretch);
            const double far = reach * line.stretch, eps = light.obscuration;
            DiskStack stack(light.terms, edge.data(), 1, eps, Amplitude{});
            stack.shrink();
            const TermPairs pairs(stack.terms);
            ZernikeField field;
            field.expand({pairs, stack.outer.data(), Amplitude{}},
                         {pairs, (eps > 0.0 ? stack.inner : stack.outer).data(), Amplitude{}}, eps, far, error, stack.lost[0]);
            const auto airy = [](double v) { return v < 1e-4 ? 1.0 - 0.125 * v * v : 2.0 * j1(v) / v; };
            parts.push_back(
                {line, MeanProfile(far, error, [&](double v) { return field.mean(v); }), MeanProfile(far, error, [&](double v) {
                     const double u = airy(v) - eps * eps * airy(eps * v);
                     return u * u;
                 })});
            brightest += line.weight() * area * area;
            // Bessel functions of that many terms, whose factors sum to at most 2 (1 + eps^2), are accurate to some roundings.
            const double terms = static_cast<double>(std::max(field.outer().degrees, field.inner().degrees));
            const double of_field = field.base() + 2.0 * (1.0 + eps * eps) * unit_roundoff * (8.0 * terms + 60.0);
            off += line.weight() *
                   (parts.back().profile.magnification() * of_field * (2.0 * area + of_field) + 0.5 * error * area * area);
        }
    }

    using Kind = lommel::MeanProfile Part::*;
    // Mean relative to the peak without aberration, at v of the reference.
    double mean(Kind kind, double v) const {
        double sum = 0.0;
        for (const Part& part : parts) {
            sum += part.line.weight() * (part.*kind).mean(v * part.line.stretch);
        }
        return sum / brightest;
    }
    // Error bound of mean(), relative to the peak without aberration.
    double error() const { return off / brightest; }
    // Encircled energy as a fraction of all light.
    double energy(Kind kind, double v) const {
        double sum = 0.0;
        for (const Part& part : parts) {
            sum += part.line.share * (part.*kind).energy(v * part.line.stretch);
        }
        return 0.5 * sum / area;
    }
};

}  // namespace live
