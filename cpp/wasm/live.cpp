// Interface of the live page: numbers in numbered blocks of memory, one light source at a time, one thread.
#include <algorithm>
#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "convolution.hpp"
#include "light.hpp"
#include "overlap.hpp"
#include "vanes.hpp"

// Replacement for the function of libc++ that prints a message before it aborts.
[[noreturn]] void std::__libcpp_verbose_abort(const char*, ...) noexcept { __builtin_trap(); }

#define EXPORT(name) __attribute__((export_name(#name)))

// This C++ library has no exceptions. The message of an exception is passed to the host, which throws an exception of its own
// and creates a new instance, as the stack is not unwound here. Every exception of the core begins with a std::exception. The
// host also formats numbers: the only format of the core is "%.3g", and printf would be a fiftieth of the download.
extern "C" {
__attribute__((import_module("lommel"), import_name("fail"))) void lommel_fail(const char* text, std::size_t length);
__attribute__((import_module("lommel"), import_name("shorten"))) int lommel_shorten(double number, char* text,
                                                                                    std::size_t room);
int snprintf(char* text, std::size_t room, const char* format, ...) {
    if (std::strcmp(format, "%.3g") != 0) {
        __builtin_trap();
    }
    va_list given;
    va_start(given, format);
    const int length = lommel_shorten(va_arg(given, double), text, room);
    va_end(given);
    return length;
}
void __cxa_pure_virtual() { __builtin_trap(); }
void* __cxa_allocate_exception(std::size_t bytes) { return std::malloc(bytes); }
void __cxa_free_exception(void* exception) { std::free(exception); }
int __cxa_thread_atexit(void (*)(void*), void*, void*) { return 0; }
void __cxa_throw(void* exception, void*, void (*)(void*)) {
    const char* text = static_cast<std::exception*>(exception)->what();
    lommel_fail(text, std::strlen(text));
    __builtin_trap();
}
}

namespace {

live::Light light;
live::Circles circles;
live::CutSums sums;
std::unique_ptr<lommel::Convolution> convolution;

constexpr std::size_t blocks = 15;
struct Block {
    void* data = nullptr;
    std::size_t bytes = 0;
} memory[blocks];

}  // namespace

extern "C" {

// Return memory block `block`, of at least `bytes`. A block that grows loses its contents.
EXPORT(room) void* room(std::size_t block, std::size_t bytes) {
    Block& here = memory[block];
    if (here.bytes < bytes) {
        std::free(here.data);
        here.data = std::malloc(bytes);
        if (here.data == nullptr) {
            throw std::runtime_error("there is not enough memory for " + std::to_string(bytes >> 20) + " MB");
        }
        here.bytes = bytes;
    }
    return here.data;
}

// Set the light for all functions below: Zernike terms (n, m) with coefficients `edge` in radians at the edge, and spectral
// lines (stretch, share). Shares sum to 1.
EXPORT(set_light)
void set_light(const std::int32_t* terms, const double* edge, std::size_t count, double obscuration, const double* lines,
               std::size_t line_count) {
    light.terms.clear();
    for (std::size_t j = 0; j < count; ++j) {
        light.terms.push_back({terms[2 * j], terms[2 * j + 1]});
    }
    light.edge.assign(edge, edge + count);
    if (count == 0) {
        light.terms.push_back({2, 0});
        light.edge.push_back(0.0);
    }
    light.obscuration = obscuration;
    light.lines.clear();
    for (std::size_t k = 0; k < line_count; ++k) {
        light.lines.push_back({lines[2 * k], lines[2 * k + 1]});
    }
}

// Set straight vanes from the axis to the edge in the directions `angles`; none by default.
EXPORT(set_vanes) void set_vanes(const double* angles, std::size_t count, double width) {
    light.vanes.assign(angles, angles + count);
    light.vane_width = width;
}

// Fraction of all light in each pixel, to `out`. numbers: error bound relative to the peak, maximum, sum, and clear area over
// that of the disk. With `weights`, three for each line, `planes` becomes the three sums over the lines with these weights.
// `cut`: by quadrature along rows, which vanes and very large aberrations need; without an error bound.
EXPORT(psf)
void psf(std::size_t side, double step, bool integrate, double tol, float* out, double* numbers, const double* weights,
         float* planes, bool cut) {
    const live::View view{side, step, integrate};
    numbers[3] = light.area();
    const live::Proof proof = cut ? live::cut_image_of(light, view, out, weights, planes, &numbers[3])
                                  : live::image_of(light, view, tol, out, weights, planes);
    // Explicit lanes, as the compiler may not vectorize this loop.
    constexpr std::size_t lanes = 16;
    const std::size_t pixels = side * side;
    double sum = 0.0;
    float tops[lanes] = {};
    for (std::size_t first = 0; first < pixels; first += 1024) {
        float sums[lanes] = {};
        const std::size_t last = std::min(pixels, first + 1024), whole = last - (last - first) % lanes;
        for (std::size_t i = first; i < whole; i += lanes) {
            for (std::size_t k = 0; k < lanes; ++k) {
                out[i + k] = std::max(0.0F, out[i + k]);  // clamping to 0 does not increase the error of an intensity
                sums[k] += out[i + k];
                tops[k] = std::max(tops[k], out[i + k]);
            }
        }
        for (std::size_t i = whole; i < last; ++i) {
            out[i] = std::max(0.0F, out[i]);
            sums[0] += out[i];
            tops[0] = std::max(tops[0], out[i]);
        }
        sum += static_cast<double>(std::accumulate(sums, sums + lanes, 0.0F));
    }
    numbers[0] = proof.bound;
    numbers[1] = static_cast<double>(*std::max_element(tops, tops + lanes));
    numbers[2] = sum;
}

// Return the estimated time of psf() with `cut`, in seconds.
EXPORT(cut_seconds) double cut_seconds(std::size_t side, double step, bool integrate) {
    return live::cut_seconds(light, {side, step, integrate});
}

// Prepare the means on circles and the encircled energy, for radii up to `reach` in v.
EXPORT(set_circles) void set_circles(double reach, double error) { circles = live::Circles(light, reach, error); }

// Return the error bound of means on circles, relative to the peak without aberration.
EXPORT(circle_error) double circle_error() { return circles.error(); }

// Means on circles over the peak without aberration, and encircled energy as a fraction of all light, at radii in v by
// quadrature along rows. `aberrated`: with aberrations. `keep`: keep the sums for near_contrast(). Returns the clear area.
EXPORT(on_cut_circles)
double on_cut_circles(const double* v, std::size_t count, bool aberrated, bool keep, double* means, double* shares) {
    if (keep) {
        sums.clear();
    }
    return live::cut_circles(light, aberrated, v, count, means, shares, keep ? &sums : nullptr);
}

// The OTF like contrast(), from the light within the last circles that were kept. Returns the fraction of light outside them.
EXPORT(near_contrast)
double near_contrast(const double* f, std::size_t count, std::complex<double>* x, std::complex<double>* y, double* limit) {
    return live::near_contrast(light, sums, f, count, x, y, limit);
}

// Return the largest radius in v, at most `reach`, for which on_cut_circles() should be called.
EXPORT(cut_reach) double cut_reach(double reach) { return live::cut_reach(light, reach); }

// At radii in v, with aberrations (out) and without (flat): means on circles relative to the peak without aberration or, with
// `energy`, encircled energy as a fraction of all light.
EXPORT(on_circles) void on_circles(const double* v, std::size_t count, bool energy, double* out, double* flat) {
    for (std::size_t i = 0; i < count; ++i) {
        out[i] =
            energy ? circles.energy(&live::Circles::Part::profile, v[i]) : circles.mean(&live::Circles::Part::profile, v[i]);
        flat[i] = energy ? circles.energy(&live::Circles::Part::flat, v[i]) : circles.mean(&live::Circles::Part::flat, v[i]);
    }
}

// Return the radius in v of the circle that contains the fraction `share` of all light, or -1 if it exceeds `reach`.
EXPORT(radius_of) double radius_of(double share, double reach) {
    double low = 0.0, high = reach;
    const auto within = [](double v) { return circles.energy(&live::Circles::Part::profile, v); };
    if (within(high) < share) {
        return -1.0;
    }
    for (int i = 0; i < 48; ++i) {
        const double middle = 0.5 * (low + high);
        (within(middle) < share ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

// Return the approximate number of nodes of contrast().
EXPORT(contrast_price) double contrast_price(const double* f, std::size_t count) {
    if (!light.vanes.empty()) {
        return live::cut_contrast_price(light, count);
    }
    double nodes = 0.0;
    for (const live::Line& line : light.lines) {
        lommel::Overlap overlap(light.terms, light.stretched(line.stretch).data(), light.obscuration);
        for (std::size_t axis = 0; axis < (light.radial() ? 1 : 2); ++axis) {
            overlap.face(axis == 0 ? 0.0 : 1.5707963267948966);
            for (std::size_t i = 0; i < count && f[i] < line.stretch; ++i) {
                nodes += overlap.price(f[i] / line.stretch);
            }
        }
    }
    return nodes;
}

// The OTF at frequencies f, relative to the cutoff of the reference wavelength. x: along columns; y: along rows; limit: without
// aberration.
EXPORT(contrast)
void contrast(const double* f, std::size_t count, std::size_t more, std::complex<double>* x, std::complex<double>* y,
              double* limit) {
    if (!light.vanes.empty()) {
        live::cut_contrast(light, f, count, more, x, y, limit);
        return;
    }
    std::fill_n(x, count, 0.0);
    std::fill_n(y, count, 0.0);
    std::fill_n(limit, count, 0.0);
    for (const live::Line& line : light.lines) {
        lommel::Overlap overlap(light.terms, light.stretched(line.stretch).data(), light.obscuration);
        for (std::size_t axis = 0; axis < (light.radial() ? 1 : 2); ++axis) {
            overlap.face(axis == 0 ? 0.0 : 1.5707963267948966);
            for (std::size_t i = 0; i < count; ++i) {
                (axis == 0 ? x : y)[i] += line.share * overlap.at(f[i] / line.stretch, more);
            }
        }
        for (std::size_t i = 0; i < count; ++i) {
            limit[i] += line.share * lommel::flat_overlap(f[i] / line.stretch, light.obscuration);
        }
    }
    if (light.radial()) {
        std::copy_n(x, count, y);
    }
}

// Convolve the planes of an image with `spread`, a PSF of odd side in pixels, divided by its sum.
EXPORT(blur)
void blur(const float* spread, std::size_t side, const float* planes, std::size_t count, std::size_t height, std::size_t width,
          float* out) {
    // Few different sizes, so that PSFs of similar size share one plan of the convolution.
    std::size_t reach = 8;
    while (reach < side / 2) {
        reach += (reach + 8) / 16 * 8;
    }
    if (!convolution || !convolution->is(height, width, reach)) {
        convolution = std::make_unique<lommel::Convolution>(height, width, reach);
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < side * side; ++i) {
        sum += static_cast<double>(spread[i]);
    }
    convolution->set_spread(spread, side, static_cast<float>(1.0 / sum));
    for (std::size_t i = 0; i < count; ++i) {
        convolution->set_plane(i, planes + i * height * width);
        convolution->make(i, out + i * height * width);
    }
}
}
