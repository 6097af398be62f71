// Live depth for the web page, compiled with vectorized loops; the rest of the page is compiled for size.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "lommel/focal/file.hpp"

#define EXPORT(name) __attribute__((export_name(#name)))

namespace {
std::unique_ptr<lommel::FocalCamera> camera;
std::unique_ptr<lommel::FocalStream> sharpener;
}  // namespace

extern "C" {
// Load tables of live depth, as written by LiveDepth.save(), for pairs of frames of height x width pixels.
EXPORT(set_camera) void set_camera(const void* tables, std::size_t bytes, std::size_t height, std::size_t width) {
    camera = std::make_unique<lommel::FocalCamera>(lommel::FocalFile(tables, bytes), height, width, 1);
}

// Distances, standard errors and misfits of all blocks for a pair of frames, three consecutive arrays in `out`, and the sharp
// image.
EXPORT(depth)
void depth(const std::uint16_t* first, const std::uint16_t* second, std::size_t width, float* out, float* image) {
    const void* const frames[] = {first, second};
    const std::size_t count = camera->down() * camera->across();
    camera->take(frames, true, width, out, out + count, out + 2 * count);
    camera->sharpen(image);
}

// Set the filter for single frames of height x width pixels: the sum over m of coefficients[m] T_m, T_m the Chebyshev
// polynomial of a kernel of five taps.
EXPORT(set_filter)
void set_filter(const float* coefficients, std::size_t degree, const float* taps, std::size_t height, std::size_t width) {
    sharpener = std::make_unique<lommel::FocalStream>(lommel::FocalPlan{height,
                                                                        width,
                                                                        1,
                                                                        1,
                                                                        1,
                                                                        {degree, 2, {taps[0], taps[1], taps[2]}},
                                                                        nullptr,
                                                                        0,
                                                                        coefficients,
                                                                        1,
                                                                        {4, {1.0f}},
                                                                        1,
                                                                        0,
                                                                        1},
                                                      nullptr);
}

// Filter a frame in electrons.
EXPORT(filter) void filter(const float* frame, std::size_t height, std::size_t width, float* out) {
    const lommel::FocalFrame one{frame, lommel::FocalFrame::Kind::floats, width, 3e38f, 0.0f, {1.0f}, nullptr, 0};
    const float place = 0.0f, factors[] = {1.0f, 1.0f};
    sharpener->take(&one);
    sharpener->mix(&place, 1, 1, std::min(height, width), factors, 2, out);
}
}
