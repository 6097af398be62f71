// What the page computes with: a pupil in light of one wavelength or several, and its image.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lommel/radial/average_images.hpp"
#include "lommel/radial/images.hpp"
#include "lommel/zernike/images.hpp"

namespace live {

// Paths of light are the same for all: phases and places on the sensor grow by `stretch`, the reference wavelength over its own.
struct Line {
    double stretch, share;
    double weight() const { return share * stretch * stretch; }
};

struct Light {
    std::vector<lommel::ZernikeTerm> terms;
    std::vector<double> edge;  // of each term, radians in light of the reference
    double obscuration = 0.0;
    std::vector<Line> lines;

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
    double step;  // in v of the reference
    bool integrate;
};

// Bound on the error over the peak, and the largest known value.
struct Proof {
    double bound, peak;
};

template <class T>
Proof image_of_line(const Light& light, const Line& line, const View& view, double tol, double scale, T* out) {
    using namespace lommel;
    const std::vector<double> edge = light.stretched(line.stretch);
    const double step = view.step * line.stretch, middle = static_cast<double>(view.side / 2);
    double numbers[3] = {scale, 0.0, 0.0};
    if (light.radial()) {
        std::vector<double> powers(1, 0.0);  // of R_2^0, R_4^0, ...
        for (std::size_t j = 0; j < edge.size(); ++j) {
            const std::size_t at = static_cast<std::size_t>(light.terms[j].n / 2 - 1);
            powers.resize(std::max(powers.size(), at + 1));
            powers[at] = edge[j];
        }
        const Stack stack{powers.data(), 1, powers.size(), light.obscuration};
        const Answer<T> answer{out, numbers, numbers + 1, numbers + 2, nullptr, 0, nullptr, nullptr};
        if (view.integrate) {
            PixelRenderer<T>(stack, PixelWindow{view.side, view.side, middle, middle, step, true}, tol, 1, answer).run();
        } else {
            Renderer<T>(stack, view.side, view.side, step, tol, 1, answer).run();
        }
    } else {
        DiskStack stack(light.terms, edge.data(), 1, light.obscuration, Amplitude{});
        const DiskWindow window{view.side, view.side, middle, middle, step};
        stack.move_axes(window);
        stack.shrink();
        ZernikeRenderer<T>(stack, window, tol, 1, {out, numbers, numbers + 1, numbers + 2}).run();
    }
    return {numbers[1], numbers[2] * scale};
}

// Fractions of all light per pixel.
inline Proof image_of(const Light& light, const View& view, double tol, float* out) {
    // That of I of the reference, 1 at the peak of a whole aperture without aberration.
    const double scale = view.step * view.step / (12.566370614359172 * light.area());
    const std::size_t pixels = view.side * view.side;
    if (light.lines.size() == 1) {
        return image_of_line(light, light.lines[0], view, tol, scale * light.lines[0].weight(), out);
    }
    // Single precision takes its part of the tolerance of each line.
    constexpr double least_of_floats = 3e-7, least = 1e-10;
    static std::vector<float> floats;
    static std::vector<double> part, total;
    for (double asked = tol;;) {
        total.assign(pixels, 0.0);
        double off = 0.0, peak = 0.0;
        for (const Line& line : light.lines) {
            const double weight = scale * line.weight();
            Proof proof;
            if (asked >= least_of_floats) {
                floats.resize(pixels);
                proof = image_of_line(light, line, view, asked, weight, floats.data());
                std::transform(floats.begin(), floats.end(), total.begin(), total.begin(),
                               [](float a, double b) { return static_cast<double>(a) + b; });
            } else {
                part.resize(pixels);
                proof = image_of_line(light, line, view, asked, weight, part.data());
                std::transform(part.begin(), part.end(), total.begin(), total.begin(),
                               [](double a, double b) { return a + b; });
            }
            off += proof.bound * proof.peak;
            // Nothing is negative, so the sum is at least as bright as any part of it.
            peak = std::max(peak, proof.peak * (1.0 - proof.bound));
        }
        const double highest = *std::max_element(total.begin(), total.end());
        off += static_cast<double>(light.lines.size() + 8) * lommel::unit_roundoff * highest;
        peak = std::max(peak, highest - off);
        const double bound = lommel::stored(off / peak, lommel::storing<float>(false));
        if (bound <= tol) {
            std::transform(total.begin(), total.end(), out, [](double x) { return static_cast<float>(x); });
            return {bound, highest};
        }
        if (asked <= least) {
            throw lommel::ToleranceNotMet(bound);
        }
        asked = std::max(least, asked * std::max(1e-3, std::min(0.5, 0.5 * tol / bound)));
    }
}

}  // namespace live
