// The core as a page calls it: numbers in named blocks of memory, one light at a time, one thread.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <vector>

#include "light.hpp"

#define EXPORT(name) __attribute__((export_name(#name)))

// There are no exceptions in this library of C++. What is thrown goes to the host as a sentence; it leaves by an exception of
// its own and makes a new instance, for nothing here is unwound. All that the core throws begins with a std::exception.
extern "C" {
__attribute__((import_module("lommel"), import_name("fail"))) void lommel_fail(const char* text, std::size_t length);
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

constexpr std::size_t blocks = 8;
struct Block {
    void* data = nullptr;
    std::size_t bytes = 0;
} memory[blocks];

}  // namespace

extern "C" {

// At least so many bytes; what was in the block is gone where it grows.
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

// The light that all below is about: terms (n, m) with radians at the edge, and lines of the spectrum with their stretch and
// share. Shares sum to 1.
EXPORT(set_light)
void set_light(const std::int32_t* terms, const double* edge, std::size_t count, double obscuration, const double* lines,
               std::size_t line_count) {
    light.terms.clear();
    for (std::size_t j = 0; j < count; ++j) {
        light.terms.push_back({terms[2 * j], terms[2 * j + 1]});
    }
    light.edge.assign(edge, edge + count);
    light.obscuration = obscuration;
    light.lines.clear();
    for (std::size_t k = 0; k < line_count; ++k) {
        light.lines.push_back({lines[2 * k], lines[2 * k + 1]});
    }
}

// Fractions of all light per pixel; numbers: the bound on their error over the peak, the largest value, the sum.
EXPORT(psf) void psf(std::size_t side, double step, bool integrate, double tol, float* out, double* numbers) {
    const live::View view{side, step, integrate};
    const live::Proof proof = live::image_of(light, view, tol, out);
    double sum = 0.0, top = 0.0;
    for (std::size_t y = 0; y < side; ++y) {
        float row = 0.0F, most = 0.0F;
        for (std::size_t x = 0; x < side; ++x) {
            row += out[y * side + x];
            most = std::max(most, out[y * side + x]);
        }
        sum += static_cast<double>(row);
        top = std::max(top, static_cast<double>(most));
    }
    numbers[0] = proof.bound;
    numbers[1] = top;
    numbers[2] = sum;
}
}
