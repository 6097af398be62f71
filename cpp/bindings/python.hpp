// Shared by all bindings: array types, release of the GIL, interrupts.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <vector>

#include "lommel/base/watch.hpp"
#include "lommel/bounds/ellipse.hpp"
#include "lommel/pixels/window.hpp"

namespace bindings {

namespace nb = nanobind;
using namespace nb::literals;

// Each defined in the source file of this name.
void define_special(nb::module_& m);
void define_pixels(nb::module_& m);
void define_radial(nb::module_& m);
void define_zernike(nb::module_& m);
void define_aperture(nb::module_& m);
void define_chordal(nb::module_& m);
void define_averages(nb::module_& m);
void define_paper(nb::module_& m);
void define_imaging(nb::module_& m);
void define_estimation(nb::module_& m);
void define_localize(nb::module_& m);
void define_stratified(nb::module_& m);
void define_focal(nb::module_& m);

// Exceptions, signals, instruction set and caches, needed by every module of the core.
void define_process(nb::module_& m);

template <class T, std::size_t N>
using In = nb::ndarray<const T, nb::numpy, nb::ndim<N>, nb::c_contig, nb::device::cpu>;
template <class T, std::size_t N>
using Out = nb::ndarray<T, nb::numpy, nb::ndim<N>, nb::c_contig, nb::device::cpu>;
using complex = std::complex<double>;

// Function that runs pending Python signal handlers and returns whether one raised an exception, such as KeyboardInterrupt.
// Null in all threads but the main one, where Python runs no handlers.
lommel::Watch::Ask ask_python();

// Run `work` without the GIL; Ctrl-C interrupts it.
template <class Work>
auto released(const Work& work) {
    const lommel::Watch watch{ask_python()};
    const nb::gil_scoped_release nogil;
    return work();
}

inline void require(bool condition, const char* message) {
    if (!condition) {
        throw std::invalid_argument(message);
    }
}

template <class T, std::size_t N>
Out<T, N> new_array(const std::size_t (&shape)[N]) {
    std::size_t size = 1;
    for (const std::size_t side : shape) {  // sizes may come from files or callers
        require(side == 0 || size <= std::numeric_limits<std::size_t>::max() / side, "sizes must have a product below 2^64");
        size *= side;
    }
    T* data = new T[size];
    nb::capsule owner(data, [](void* p) noexcept { delete[] static_cast<T*>(p); });
    return Out<T, N>(data, N, shape, owner);
}

template <class T>
Out<T, 1> array_of(const std::vector<T>& values) {
    auto made = new_array<T, 1>({values.size()});
    std::copy(values.begin(), values.end(), made.data());
    return made;
}

// Contents of an array through the buffer protocol, for calls of a microsecond: this takes a quarter of the time that the
// types above need. Empty unless the array has the type T, is C-contiguous and, if T is not const, writable.
template <class T>
class Buffer {
   public:
    explicit Buffer(nb::handle array) {
        constexpr int flags = PyBUF_C_CONTIGUOUS | PyBUF_FORMAT | (std::is_const_v<T> ? 0 : PyBUF_WRITABLE);
        if (PyObject_GetBuffer(array.ptr(), &view_, flags) != 0) {
            PyErr_Clear();
        } else if (view_.format == nullptr || std::string_view(view_.format) != (sizeof(T) == 4 ? "f" : "d")) {
            PyBuffer_Release(&view_);
        }
    }
    ~Buffer() { PyBuffer_Release(&view_); }
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;

    explicit operator bool() const { return view_.obj != nullptr; }
    T* data() const { return static_cast<T*>(view_.buf); }
    std::size_t ndim() const { return static_cast<std::size_t>(view_.ndim); }
    const Py_ssize_t* shape() const { return view_.shape; }

   private:
    static_assert(std::is_floating_point_v<T>);
    Py_buffer view_{};
};

// Define a function for float and for double.
template <class Define>
void for_both(const Define& define) {
    define(0.0F);
    define(0.0);
}

inline void require_image(std::size_t height, std::size_t width) {
    require(height > 0 && width > 0 && height <= 40000 && width <= 40000, "images must have 1 to 40000 pixels a side");
}

inline void require_center(double y, double x) {
    require(std::abs(y) <= 1e6 && std::abs(x) <= 1e6, "the centre must be within 1e6 pixels");
}

inline lommel::PixelWindow window_of(std::size_t height, std::size_t width, double center_y, double center_x, double step,
                                     bool integrate) {
    require_image(height, width);
    require_center(center_y, center_x);
    require(step > 0.0 && step <= 1e7, "step must be above 0, and 1e7 at most");
    return {height, width, center_y, center_x, step, integrate};
}

inline void require_radii(const In<double, 1>& v) {
    for (std::size_t i = 0; i < v.shape(0); ++i) {
        require(v.data()[i] >= 0.0 && v.data()[i] <= lommel::max_reach, "v must be from 0 to 1e6");
    }
}

}  // namespace bindings
