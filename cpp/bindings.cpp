// The one place where the compiled core meets Python: shapes are checked here, the GIL is released here, and
// no arithmetic is done here. What tests ask of the bounds on errors is in bindings_bounds.cpp.
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "lommel/special/bessel.hpp"
#include "lommel/chordal/images.hpp"
#include "lommel/paper/closed_form.hpp"
#include "lommel/paper/huygens.hpp"
#include "lommel/radial/images.hpp"
#include "lommel/special/legendre.hpp"
#include "lommel/imaging/means.hpp"
#include "lommel/radial/average_images.hpp"
#include "lommel/radial/profiles.hpp"
#include "lommel/pixels/render.hpp"
#include "lommel/imaging/spread.hpp"
#include "lommel/base/watch.hpp"
#include "lommel/zernike/images.hpp"

namespace nb = nanobind;
using namespace nb::literals;

namespace {

template <class T, std::size_t N>
using In = nb::ndarray<const T, nb::numpy, nb::ndim<N>, nb::c_contig, nb::device::cpu>;
template <class T, std::size_t N>
using Out = nb::ndarray<T, nb::numpy, nb::ndim<N>, nb::c_contig, nb::device::cpu>;
template <class T>
using Strided = nb::ndarray<const T, nb::numpy, nb::ndim<2>, nb::device::cpu>;
using complex = std::complex<double>;

// The one thread that Python runs the handlers of signals in; in a child it is the one that called fork().
struct MainThread final : lommel::ForkAware {
    unsigned long id = 0;
    bool here() const { return PyThread_get_thread_ident() == id; }

   private:
    void after_fork(bool in_child) override {
        if (in_child) {
            id = PyThread_get_thread_ident();
        }
    }
};
MainThread& main_thread = *new MainThread;

// Runs what handlers there are to run; whether one raised an exception, KeyboardInterrupt for one.
bool signalled() {
    const nb::gil_scoped_acquire gil;
    return PyErr_CheckSignals() != 0;
}

// Other threads of Python run meanwhile, and Ctrl-C ends the call.
struct Released {
    lommel::Watch watch{main_thread.here() ? &signalled : nullptr};
    nb::gil_scoped_release nogil;
};

template <class T, std::size_t N>
Out<T, N> new_array(const std::size_t (&shape)[N]) {
    std::size_t size = 1;
    for (const std::size_t extent : shape) {
        size *= extent;
    }
    T* data = new T[size];
    nb::capsule owner(data, [](void* p) noexcept { delete[] static_cast<T*>(p); });
    return Out<T, N>(data, N, shape, owner);
}

void require(bool condition, const char* message) {
    if (!condition) {
        throw std::invalid_argument(message);
    }
}

lommel::Amplitude amplitude_of(const In<double, 1>& powers) {
    require(powers.shape(0) <= 1 + lommel::Amplitude::most, "amplitude must have at most 11 powers");
    const lommel::Amplitude amplitude(powers.data(), powers.shape(0));
    // 100 and what rounding may make of it.
    require(amplitude.size() <= 100.0 * (1.0 + 1e-9), "amplitude must have an exponent of 100 at most");
    require(amplitude.passive(), "amplitude must be at most 1");
    return amplitude;
}

lommel::Stack stack_of(const In<double, 2>& coefficients, double obscuration, const In<double, 1>& amplitude) {
    require(coefficients.shape(0) > 0 && coefficients.shape(1) > 0, "coefficients must not be empty");
    require(coefficients.shape(1) <= lommel::LegendreRule::most_terms, "coefficients must be 30 a pupil at most");
    require(obscuration >= 0.0 && obscuration < 1.0, "obscuration must be from 0 to below 1");
    return {coefficients.data(), coefficients.shape(0), coefficients.shape(1), obscuration, amplitude_of(amplitude)};
}

constexpr std::size_t most_nodes = 20000;  // of Gauss: they take time in proportion to the square, then a second

void require_radii(const In<double, 1>& v) {
    for (std::size_t i = 0; i < v.shape(0); ++i) {
        require(v.data()[i] >= 0.0 && v.data()[i] <= lommel::max_reach, "v must be from 0 to 1e6");
    }
}

Out<double, 2> bessel_sequence(In<double, 1> v, std::size_t count) {
    require_radii(v);
    auto out = new_array<double, 2>({v.shape(0), count});
    Released nogil;
    for (std::size_t i = 0; i < v.shape(0); ++i) {
        lommel::look();
        lommel::bessel_sequence(v.data()[i], count, out.data() + i * count);
    }
    return out;
}

Out<double, 2> legendre_transforms(In<double, 1> v, std::size_t terms) {
    require_radii(v);
    auto out = new_array<double, 2>({v.shape(0), terms});
    Released nogil;
    std::vector<double> scratch;
    for (std::size_t i = 0; i < v.shape(0); ++i) {
        lommel::look();
        lommel::legendre_transforms(v.data()[i], terms, out.data() + i * terms, scratch);
    }
    return out;
}

std::pair<Out<double, 1>, Out<double, 1>> gauss_legendre(std::size_t n) {
    require(n > 0, "n must be at least 1");
    require(n <= most_nodes, "n must be at most 20000");
    auto nodes = new_array<double, 1>({n});
    auto weights = new_array<double, 1>({n});
    {
        Released nogil;
        lommel::gauss_legendre(n, nodes.data(), weights.data());
    }
    return {nodes, weights};
}

std::pair<Out<std::int64_t, 1>, Out<std::int32_t, 2>> distinct_radii(std::size_t rows, std::size_t cols) {
    // Ranks are 32-bit and the work is linear in the largest squared radius.
    require(rows <= 20000 && cols <= 20000, "rows and cols must be at most 20000");
    auto index = new_array<std::int32_t, 2>({rows + 1, cols + 1});
    std::vector<std::int64_t> squares;
    {
        Released nogil;
        squares = lommel::distinct_radii(rows, cols, index.data());
    }
    auto radii = new_array<std::int64_t, 1>({squares.size()});
    std::copy(squares.begin(), squares.end(), radii.data());
    return {radii, index};
}

template <class T>
void scatter(In<double, 2> profiles, In<double, 1> scales, In<std::int32_t, 2> index, Out<T, 3> out) {
    const std::size_t height = out.shape(1), width = out.shape(2), count = profiles.shape(1);
    require(profiles.shape(0) == out.shape(0) && scales.shape(0) == out.shape(0), "one profile and scale an image");
    require(index.shape(0) == height / 2 + 1 && index.shape(1) == width / 2 + 1, "index must cover the quadrant");
    Released nogil;
    const std::size_t quadrant = index.shape(0) * index.shape(1);
    for (std::size_t i = 0; i < quadrant; ++i) {
        const std::int32_t rank = index.data()[i];
        require(rank >= 0 && static_cast<std::size_t>(rank) < count, "index points outside the profile");
    }
    std::vector<T> profile(count);
    for (std::size_t s = 0; s < out.shape(0); ++s) {
        lommel::scaled(profiles.data() + s * count, scales.data()[s], count, profile.data());
        lommel::scatter_rows(profile.data(), index.data(), height, width, 0, height / 2 + 1,
                             out.data() + s * height * width);
    }
}

template <class T>
double rendered(const lommel::Stack& stack, double step, double tol, int threads, const Out<T, 3>& images,
                const Out<double, 1>& scales, const Out<double, 1>& bounds, const std::vector<std::size_t>& powers,
                T* derivative_images, double* derivative_bounds) {
    const std::size_t n = stack.count, height = images.shape(1), width = images.shape(2);
    require(images.shape(0) == n && scales.shape(0) == n && bounds.shape(0) == n, "one image, scale and bound a pupil");
    require(height > 0 && width > 0 && height <= 40000 && width <= 40000, "images must have 1 to 40000 pixels a side");
    require(step > 0.0 && tol > 0.0 && threads >= 0, "step and tol must be positive, threads at least 0");
    Released nogil;
    try {
        lommel::Renderer<T>(stack, height, width, step, tol, threads,
                            {images.data(), scales.data(), bounds.data(), powers.data(), powers.size(),
                             derivative_images, derivative_bounds})
            .run();
    } catch (const lommel::ToleranceNotMet& failure) {
        return failure.bound;
    }
    return 0.0;
}

// Returns 0, or the bound on the error where the tolerance cannot be met.
template <class T>
double render(In<double, 2> coefficients, double obscuration, In<double, 1> amplitude, double step, double tol, int threads, Out<T, 3> images,
              Out<double, 1> scales, Out<double, 1> bounds) {
    return rendered<T>(stack_of(coefficients, obscuration, amplitude), step, tol, threads, images, scales, bounds, {}, nullptr,
                       nullptr);
}

std::vector<std::size_t> powers_of(const In<std::int64_t, 1>& powers) {
    std::vector<std::size_t> which;
    for (std::size_t i = 0; i < powers.shape(0); ++i) {
        require(powers.data()[i] >= 1 && powers.data()[i] <= 64, "powers must be from 1 to 64");
        which.push_back(static_cast<std::size_t>(powers.data()[i]));
    }
    return which;
}

template <class T>
void require_slopes(std::size_t k, std::size_t n, std::size_t height, std::size_t width, const Out<T, 4>& images,
                    const Out<double, 2>& bounds) {
    require(images.shape(0) == k && bounds.shape(0) == k, "one derivative a power");
    require(images.shape(1) == n && images.shape(2) == height && images.shape(3) == width && bounds.shape(1) == n,
            "derivatives must match the images");
}

template <class T>
double differentiate(In<double, 2> coefficients, double obscuration, In<double, 1> amplitude, double step, double tol, int threads,
                     Out<T, 3> images, Out<double, 1> scales, Out<double, 1> bounds, In<std::int64_t, 1> powers,
                     Out<T, 4> derivative_images, Out<double, 2> derivative_bounds) {
    const lommel::Stack stack = stack_of(coefficients, obscuration, amplitude);
    const std::vector<std::size_t> which = powers_of(powers);
    require_slopes(which.size(), stack.count, images.shape(1), images.shape(2), derivative_images, derivative_bounds);
    return rendered<T>(stack, step, tol, threads, images, scales, bounds, which, derivative_images.data(),
                       derivative_bounds.data());
}

lommel::PixelWindow window_of(std::size_t height, std::size_t width, double center_y, double center_x, double step,
                              bool integrate) {
    require(height > 0 && width > 0 && height <= 40000 && width <= 40000, "images must have 1 to 40000 pixels a side");
    require(std::abs(center_y) <= 1e6 && std::abs(center_x) <= 1e6, "the centre must be within 1e6 pixels");
    require(step > 0.0 && step <= 1e7, "step must be above 0, and 1e7 at most");
    return {height, width, center_y, center_x, step, integrate};
}

int level_of(int level) {
    require(level >= 1 && level <= 15, "level must be from 1 to 15");
    return level;
}

// Returns 0, or the bound on the error where the tolerance cannot be met.
template <class T>
double render_pixels(In<double, 2> coefficients, double obscuration, In<double, 1> amplitude, double center_y, double center_x,
                     double step, bool integrate, double tol, int threads, Out<T, 3> images, Out<double, 1> scales,
                     Out<double, 1> bounds, Out<double, 1> peaks, In<std::int64_t, 1> powers, Out<T, 4> derivative_images,
                     Out<double, 2> derivative_bounds) {
    const lommel::Stack stack = stack_of(coefficients, obscuration, amplitude);
    const std::size_t n = stack.count, k = powers.shape(0), height = images.shape(1), width = images.shape(2);
    const lommel::PixelWindow window = window_of(height, width, center_y, center_x, step, integrate);
    require(images.shape(0) == n && scales.shape(0) == n && bounds.shape(0) == n && peaks.shape(0) == n,
            "one image, scale, bound and peak a pupil");
    require(tol > 0.0 && threads >= 0, "tol must be positive, threads at least 0");
    const std::vector<std::size_t> which = powers_of(powers);
    require_slopes(k, n, height, width, derivative_images, derivative_bounds);
    Released nogil;
    try {
        lommel::PixelRenderer<T>(stack, window, tol, threads,
                                 {images.data(), scales.data(), bounds.data(), which.data(), k, derivative_images.data(),
                                  derivative_bounds.data()},
                                 peaks.data())
            .run();
    } catch (const lommel::ToleranceNotMet& failure) {
        return failure.bound;
    }
    return 0.0;
}

// The radii where I is wanted, and what becomes of its errors.
std::tuple<Out<double, 1>, double, double, double, double> pixel_radii(std::size_t height, std::size_t width, double center_y,
                                                               double center_x, double step, bool integrate, int level,
                                                               int threads) {
    const lommel::PixelWindow window = window_of(height, width, center_y, center_x, step, integrate);
    require(threads >= 0, "threads must be at least 0");
    std::shared_ptr<const lommel::PixelTable> table;
    {
        Released nogil;
        table = lommel::PixelTable::get(window, level_of(level), threads);
    }
    auto radii = new_array<double, 1>({table->count});
    std::copy_n(table->radii.data(), table->count, radii.data());
    return {radii, table->error, table->of_nodes, table->of_grid, table->rounding};
}

Out<double, 1> pixel_values(In<double, 2> profiles, double center_y, double center_x, double step, bool integrate, int level,
                            int threads, Out<double, 3> out) {
    const std::size_t n = out.shape(0), height = out.shape(1), width = out.shape(2);
    const lommel::PixelWindow window = window_of(height, width, center_y, center_x, step, integrate);
    require(profiles.shape(0) == n && threads >= 0, "one profile an image, threads at least 0");
    auto penalties = new_array<double, 1>({n});
    Released nogil;
    const auto table = lommel::PixelTable::get(window, level_of(level), threads);
    require(profiles.shape(1) == table->count, "profiles must be at the radii of the window");
    lommel::WindowValues made;
    for (std::size_t i = 0; i < n; ++i) {
        made.make(*table, profiles.data() + i * table->count, threads);
        table->groups.paint(made.values.data(), 0, table->groups.rows.distances.size(), out.data() + i * height * width);
        penalties.data()[i] = made.penalty;
    }
    return penalties;
}

std::vector<lommel::ZernikeTerm> zernike_terms(const In<std::int32_t, 2>& given) {
    require(given.shape(0) > 0 && given.shape(1) == 2, "terms must have the shape (terms, 2), with one term at least");
    std::vector<lommel::ZernikeTerm> terms;
    for (std::size_t j = 0; j < given.shape(0); ++j) {
        const lommel::ZernikeTerm term{given.data()[2 * j], given.data()[2 * j + 1]};
        const std::int32_t order = std::abs(term.m);
        require(term.n >= 0 && term.n <= 200 && order <= term.n && (term.n - order) % 2 == 0, "no such Zernike term");
        require(std::find(terms.begin(), terms.end(), term) == terms.end(), "a Zernike term comes twice");
        terms.push_back(term);
    }
    return terms;
}

// The two engines for pupils that are not radially symmetric. Returns 0, or the bound on the error where the tolerance cannot
// be met.
template <class T, bool Series>
double disk_images(In<std::int32_t, 2> terms, In<double, 2> edge, double obscuration, In<double, 1> amplitude, double center_y,
                   double center_x, double step, double tol, int threads, Out<T, 3> images, Out<double, 1> scales,
                   Out<double, 1> bounds, Out<double, 1> peaks) {
    const std::size_t n = edge.shape(0), height = images.shape(1), width = images.shape(2);
    const std::vector<lommel::ZernikeTerm> list = zernike_terms(terms);
    const lommel::Amplitude light = amplitude_of(amplitude);
    require(n > 0 && edge.shape(1) == list.size(), "one coefficient a term and pupil, and one pupil at least");
    require(obscuration >= 0.0 && obscuration < 1.0, "obscuration must be from 0 to below 1");
    require(images.shape(0) == n && scales.shape(0) == n && bounds.shape(0) == n && peaks.shape(0) == n,
            "one image, scale, bound and peak a pupil");
    require(height > 0 && width > 0 && height <= 40000 && width <= 40000, "images must have 1 to 40000 pixels a side");
    require(std::abs(center_y) <= 1e6 && std::abs(center_x) <= 1e6, "the centre must be within 1e6 pixels");
    require(step > 0.0 && tol > 0.0 && threads >= 0, "step and tol must be positive, threads at least 0");
    const lommel::DiskWindow window{height, width, center_y, center_x, step};
    const lommel::DiskAnswer<T> answer{images.data(), scales.data(), bounds.data(), peaks.data()};
    Released nogil;
    try {
        lommel::DiskStack stack(list, edge.data(), n, obscuration, light);
        if constexpr (Series) {
            stack.move_axes(window);
            stack.shrink();
            lommel::ZernikeRenderer<T>(stack, window, tol, threads, answer).run();
        } else {
            stack.shrink();
            lommel::ChordalRenderer<T>(stack, window, tol, threads, answer).run();
        }
    } catch (const lommel::ToleranceNotMet& failure) {
        return failure.bound;
    }
    return 0.0;
}

template <class T>
void define_disk(nb::module_& m) {
    m.def("series_images", &disk_images<T, true>, "terms"_a, "edge"_a, "obscuration"_a, "amplitude"_a, "center_y"_a, "center_x"_a,
          "step"_a, "tol"_a, "threads"_a, "images"_a.noconvert(), "scales"_a.noconvert(), "bounds"_a.noconvert(), "peaks"_a.noconvert(),
          "Images of pupils of Zernike terms (n, m), by their series; scales are 0 on entry where values are to be divided by "
          "their largest one. 0, or the bound that is left.");
    m.def("chordal_images", &disk_images<T, false>, "terms"_a, "edge"_a, "obscuration"_a, "amplitude"_a, "center_y"_a,
          "center_x"_a, "step"_a, "tol"_a, "threads"_a, "images"_a.noconvert(), "scales"_a.noconvert(), "bounds"_a.noconvert(), "peaks"_a.noconvert(),
          "The same by the chordal rule; bounds are over the largest value of the window.");
}

std::pair<Out<complex, 2>, Out<double, 1>> field(In<double, 2> coefficients, double obscuration,
                                                 In<double, 1> amplitude, In<double, 1> v, double tol) {
    const lommel::Stack stack = stack_of(coefficients, obscuration, amplitude);
    auto out = new_array<complex, 2>({stack.count, v.shape(0)});
    auto bounds = new_array<double, 1>({stack.count});
    {
        Released nogil;
        lommel::fields(stack, v.data(), v.shape(0), tol, out.data(), bounds.data());
    }
    return {out, bounds};
}

// Bounds are negative where the tolerance cannot be met.
std::tuple<Out<double, 2>, Out<double, 1>, Out<double, 1>> profile(In<double, 2> coefficients, double obscuration,
                                                                   In<double, 1> amplitude, In<double, 1> v, double tol) {
    const lommel::Stack stack = stack_of(coefficients, obscuration, amplitude);
    auto out = new_array<double, 2>({stack.count, v.shape(0)});
    auto peaks = new_array<double, 1>({stack.count});
    auto bounds = new_array<double, 1>({stack.count});
    {
        Released nogil;
        lommel::profiles(stack, v.data(), v.shape(0), tol, out.data(), bounds.data(), peaks.data());
    }
    return {out, bounds, peaks};
}

// Bounds are negative where the tolerance cannot be met.
std::tuple<Out<double, 2>, Out<double, 1>> means(In<double, 2> coefficients, double obscuration, In<double, 1> amplitude, In<double, 1> v,
                                                 double tol, In<double, 2> matrix, int threads) {
    const lommel::Stack stack = stack_of(coefficients, obscuration, amplitude);
    require(matrix.shape(0) == v.shape(0) && v.shape(0) > 0 && threads >= 0, "the matrix must have a row for each v");
    auto out = new_array<double, 2>({stack.count, matrix.shape(1)});
    auto bounds = new_array<double, 1>({stack.count});
    {
        Released nogil;
        lommel::means(stack, v.data(), v.shape(0), tol, matrix.data(), matrix.shape(1), threads, out.data(), bounds.data());
    }
    return {out, bounds};
}

Out<double, 2> product(In<double, 2> rows, In<double, 2> matrix, int threads) {
    const std::size_t count = rows.shape(1);
    require(matrix.shape(0) == count && threads >= 0, "the matrix must have a row for each column");
    auto out = new_array<double, 2>({rows.shape(0), matrix.shape(1)});
    Released nogil;
    const auto fill = [&](std::size_t first, std::size_t some, double* values) {
        std::copy_n(rows.data() + first * count, some * count, values);
    };
    lommel::product(rows.shape(0), count, matrix.data(), matrix.shape(1), threads, fill, out.data());
    return out;
}

Out<complex, 1> huygens_sum(In<double, 1> x, In<double, 1> y, In<complex, 1> amplitude, In<double, 1> sx,
                            In<double, 1> sy, double distance, double wavenumber) {
    require(x.shape(0) == y.shape(0) && x.shape(0) == amplitude.shape(0), "x, y and amplitude must match");
    require(sx.shape(0) == sy.shape(0), "sx and sy must match");
    auto out = new_array<complex, 1>({sx.shape(0)});
    Released nogil;
    lommel::huygens_sum(x.data(), y.data(), amplitude.data(), x.shape(0), sx.data(), sy.data(), sx.shape(0), distance,
                        wavenumber, out.data());
    return out;
}

Out<complex, 1> closed_form_field(In<double, 1> edges, In<double, 1> alpha, In<double, 1> beta, In<double, 1> gamma,
                                  double transition, double ratio, std::size_t terms, In<double, 1> v) {
    const std::size_t pieces = alpha.shape(0);
    require(pieces > 0 && edges.shape(0) == pieces + 1 && beta.shape(0) == pieces && gamma.shape(0) == pieces,
            "alpha, beta and gamma must have one value a piece, edges one more");
    require(transition > 0.0 && ratio > 1.0 + 1e-6 && ratio < 10.0, "transition must be positive, ratio from 1 to 10");
    require(terms >= 1 && terms <= 40, "terms must be from 1 to 40");
    require_radii(v);
    double reach = 0.0;
    for (std::size_t i = 0; i < v.shape(0); ++i) {
        reach = std::max(reach, v.data()[i]);
    }
    auto out = new_array<complex, 1>({v.shape(0)});
    Released nogil;
    const lommel::HankelPieces hankel(transition, ratio, reach, terms);
    const lommel::ClosedFormField field({edges.data(), alpha.data(), beta.data(), gamma.data(), pieces}, hankel);
    for (std::size_t i = 0; i < v.shape(0); ++i) {
        lommel::look();
        out.data()[i] = field(v.data()[i]);
    }
    return out;
}

Out<complex, 1> fresnel_auxiliary(In<double, 1> s) {
    auto out = new_array<complex, 1>({s.shape(0)});
    Released nogil;
    for (std::size_t i = 0; i < s.shape(0); ++i) {
        require(s.data()[i] >= 0.0, "s must be at least 0");
        out.data()[i] = lommel::FresnelAuxiliary::at(s.data()[i]);
    }
    return out;
}

Out<double, 1> chebyshev_intensity(In<complex, 2> pieces, double width, In<double, 1> v) {
    require(pieces.shape(0) > 0 && pieces.shape(1) == 16, "pieces must have the shape (pieces, 16)");
    require(width > 0.0, "width must be positive");
    for (std::size_t i = 0; i < v.shape(0); ++i) {
        require(v.data()[i] >= 0.0 && std::isfinite(v.data()[i]), "v must be at least 0 and finite");
    }
    auto out = new_array<double, 1>({v.shape(0)});
    Released nogil;
    lommel::chebyshev_intensity(pieces.data(), pieces.shape(0), width, v.data(), v.shape(0), out.data());
    return out;
}

template <class T>
lommel::WindowBank<T> bank_of(const In<T, 3>& windows, const In<double, 1>& halves, const In<double, 2>& energies) {
    const std::size_t count = windows.shape(0), rows = windows.shape(1), stride = windows.shape(2), widest = rows - 1;
    // The last window is there to be loaded only.
    require(count >= 5 && rows >= 1 && stride == lommel::Spreader<T>::margin(widest), "windows must be padded, 5 or more");
    require(halves.shape(0) == count - 1 && energies.shape(0) == count - 1 && energies.shape(1) == widest + 1,
            "one half width and one row of energies a window");
    for (std::size_t i = 0; i < halves.shape(0); ++i) {
        require(halves.data()[i] >= 0.0 && halves.data()[i] <= static_cast<double>(widest), "halves must fit in the windows");
    }
    return {windows.data(), halves.data(), energies.data(), count - 1, widest, stride};
}

lommel::Scene scene_of(const In<double, 2>& positions, const In<std::int64_t, 1>& rows, const In<std::int64_t, 1>& columns) {
    for (std::size_t i = 0; i < positions.size(); ++i) {
        require(std::isfinite(positions.data()[i]), "positions must be finite");
    }
    const auto inside = [](const In<std::int64_t, 1>& indices, std::size_t count) {
        return std::all_of(indices.data(), indices.data() + indices.size(),
                           [&](std::int64_t i) { return i >= 0 && i < static_cast<std::int64_t>(count); });
    };
    require(inside(rows, positions.shape(0)) && inside(columns, positions.shape(1)), "rows and columns must be of positions");
    return {positions.data(), positions.shape(1), rows.data(), columns.data(), rows.size(), columns.size()};
}

// Whether an image is as much larger than a scene as windows reach.
template <class T>
bool larger(const lommel::WindowBank<T>& bank, const lommel::Scene& scene, std::size_t height, std::size_t width) {
    return height == scene.height + 2 * bank.widest && width == scene.width + 2 * lommel::Spreader<T>::margin(bank.widest);
}

// Adds each pixel, spread over its window, to an image larger by half a window above and below, and by the next multiple of
// 16 on either side.
template <class T>
void spread(In<T, 3> windows, In<double, 1> halves, In<double, 2> energies, In<double, 2> positions, In<std::int64_t, 1> rows,
            In<std::int64_t, 1> columns, Strided<T> image, int threads, Out<T, 2> out) {
    const lommel::WindowBank<T> bank = bank_of<T>(windows, halves, energies);
    const lommel::Scene scene = scene_of(positions, rows, columns);
    require(image.shape(0) == positions.shape(0) && image.shape(1) == positions.shape(1) && threads >= 0,
            "positions must match the image");
    require(larger(bank, scene, out.shape(0), out.shape(1)), "out must be larger than the image by a window");
    Released nogil;
    lommel::Spreader<T>(bank, scene, threads).forward(image.data(), image.stride(0), image.stride(1), out.data());
}

// The transpose of spread(), but that what is beyond the edges stays there.
template <class T>
void collect(In<T, 3> windows, In<double, 1> halves, In<double, 2> energies, In<double, 2> positions, In<std::int64_t, 1> rows,
             In<std::int64_t, 1> columns, In<T, 2> image, int threads, Out<T, 2> out) {
    const lommel::WindowBank<T> bank = bank_of<T>(windows, halves, energies);
    const lommel::Scene scene = scene_of(positions, rows, columns);
    require(larger(bank, scene, image.shape(0), image.shape(1)) && threads >= 0,
            "the image must be larger than the positions by a window");
    require(out.shape(0) == scene.height && out.shape(1) == scene.width, "out must match the positions");
    Released nogil;
    lommel::Spreader<T>(bank, scene, threads).adjoint(image.data(), out.data());
}

void limit_instructions(const std::string& level) {
    if (level == "portable") {
        lommel::level_limit() = lommel::Level::portable;
    } else if (level == "avx2") {
        lommel::level_limit() = lommel::Level::avx2;
    } else {
        require(level == "avx512", "level must be portable, avx2 or avx512");
        lommel::level_limit() = lommel::Level::avx512;
    }
}

const char* instructions() {
    switch (lommel::processor_level()) {
        case lommel::Level::avx512:
            return "avx512";
        case lommel::Level::avx2:
            return "avx2";
        default:
            return "portable";
    }
}

template <class T>
void define_spread(nb::module_& m) {
    m.def("spread", &spread<T>, "windows"_a.noconvert(), "halves"_a, "energies"_a, "positions"_a, "rows"_a, "columns"_a,
          "image"_a.noconvert(), "threads"_a, "out"_a.noconvert(),
          "Adds each pixel times the window at its position in the bank to an image larger by a window.");
    m.def("collect", &collect<T>, "windows"_a.noconvert(), "halves"_a, "energies"_a, "positions"_a, "rows"_a, "columns"_a,
          "image"_a.noconvert(), "threads"_a, "out"_a.noconvert(), "The transpose of spread().");
}

}  // namespace

void define_bounds(nb::module_& m);  // in bindings_bounds.cpp

NB_MODULE(_core, m) {
    main_thread.id = nb::cast<unsigned long>(nb::module_::import_("threading").attr("main_thread")().attr("ident"));
    // The exception is set, by the handler that raised it.
    nb::register_exception_translator([](const std::exception_ptr& thrown, void*) {
        try {
            std::rethrow_exception(thrown);
        } catch (const lommel::Stopped&) {
        }
    });
    m.doc() = "Compiled core of lommel: the spectral engine, Bessel sequences, rendering, Huygens' sum.";
    m.def("bessel_sequence", &bessel_sequence, "v"_a, "count"_a, "J_0 .. J_{count-1} at each v >= 0.");
    m.def("legendre_transforms", &legendre_transforms, "v"_a, "terms"_a,
          "2 (-1)^n J_{2n+1}(v) / v for n < terms, at each v >= 0.");
    m.def("gauss_legendre", &gauss_legendre, "n"_a, "Nodes and weights on [-1, 1].");
    m.def("distinct_radii", &distinct_radii, "rows"_a, "cols"_a,
          "Distinct squared radii of a quadrant, rising, and the rank of every pixel's.");
    m.def("scatter", &scatter<float>, "profiles"_a, "scales"_a, "index"_a, "out"_a.noconvert(),
          "Profiles at the distinct radii, times a scale each, onto a stack of images.");
    m.def("scatter", &scatter<double>, "profiles"_a, "scales"_a, "index"_a, "out"_a.noconvert());
    m.def("render", &render<float>, "coefficients"_a, "obscuration"_a, "amplitude"_a, "step"_a, "tol"_a, "threads"_a,
          "images"_a.noconvert(), "scales"_a.noconvert(), "bounds"_a.noconvert(),
          "Images of a stack of pupils by the spectral engine; returns 0, or the bound where tol cannot be met.");
    m.def("render", &render<double>, "coefficients"_a, "obscuration"_a, "amplitude"_a, "step"_a, "tol"_a, "threads"_a,
          "images"_a.noconvert(), "scales"_a.noconvert(), "bounds"_a.noconvert());
    m.def("differentiate", &differentiate<float>, "coefficients"_a, "obscuration"_a, "amplitude"_a, "step"_a, "tol"_a, "threads"_a,
          "images"_a.noconvert(), "scales"_a.noconvert(), "bounds"_a.noconvert(), "powers"_a,
          "derivative_images"_a.noconvert(), "derivative_bounds"_a.noconvert(),
          "render(), and the derivatives by the coefficients of t^power.");
    m.def("differentiate", &differentiate<double>, "coefficients"_a, "obscuration"_a, "amplitude"_a, "step"_a, "tol"_a, "threads"_a,
          "images"_a.noconvert(), "scales"_a.noconvert(), "bounds"_a.noconvert(), "powers"_a,
          "derivative_images"_a.noconvert(), "derivative_bounds"_a.noconvert());
    define_disk<float>(m);
    define_disk<double>(m);
    m.def("render_pixels", &render_pixels<float>, "coefficients"_a, "obscuration"_a, "amplitude"_a, "center_y"_a, "center_x"_a,
          "step"_a, "integrate"_a, "tol"_a, "threads"_a, "images"_a.noconvert(), "scales"_a.noconvert(),
          "bounds"_a.noconvert(), "peaks"_a.noconvert(), "powers"_a, "derivative_images"_a.noconvert(),
          "derivative_bounds"_a.noconvert(), "differentiate() of pixels that average, or around an axis anywhere.");
    m.def("render_pixels", &render_pixels<double>, "coefficients"_a, "obscuration"_a, "amplitude"_a, "center_y"_a,
          "center_x"_a, "step"_a, "integrate"_a, "tol"_a, "threads"_a, "images"_a.noconvert(), "scales"_a.noconvert(),
          "bounds"_a.noconvert(), "peaks"_a.noconvert(), "powers"_a, "derivative_images"_a.noconvert(),
          "derivative_bounds"_a.noconvert());
    m.def("pixel_radii", &pixel_radii, "height"_a, "width"_a, "center_y"_a, "center_x"_a, "step"_a, "integrate"_a, "level"_a,
          "threads"_a,
          "Rising v that the pixels of a window take, the error of the pixels over half the range of I, what errors are "
          "multiplied by at these radii and between the places of harmonics, and roundings over the largest I.");
    m.def("pixel_values", &pixel_values, "profiles"_a, "center_y"_a, "center_x"_a, "step"_a, "integrate"_a, "level"_a,
          "threads"_a, "out"_a.noconvert(), "Pixels of windows from profiles at pixel_radii(); returns further roundings.");
    m.def("interpolation_error", &lommel::interpolation_error, "half"_a, "points"_a,
          "Bound on interpolating a function of exponential type 2 at Chebyshev points of [-half, half], over half its range.");
    m.def("gauss_error", &lommel::gauss_error, "side"_a, "points"_a,
          "Bound on averaging it over a square by points x points of Gauss and Legendre, over half its range.");
    m.def("harmonics_error", &lommel::harmonics_error, "side"_a, "angles"_a,
          "Bound on interpolating the average over a square at so many angles, over half the range.");
    m.def("field", &field, "coefficients"_a, "obscuration"_a, "amplitude"_a, "v"_a, "tol"_a, "U at rising v, and bounds on its error.");
    m.def("profile", &profile, "coefficients"_a, "obscuration"_a, "amplitude"_a, "v"_a, "tol"_a,
          "I at rising v, bounds on its error over the peak, negative where tol cannot be met, and the peaks.");
    m.def("product", &product, "rows"_a, "matrix"_a, "threads"_a, "The product of two matrices.");
    m.def("means", &means, "coefficients"_a, "obscuration"_a, "amplitude"_a, "v"_a, "tol"_a, "matrix"_a, "threads"_a,
          "Weighted sums of I at rising v, and bounds on the error of I over its peak.");
    m.def("huygens_sum", &huygens_sum, "x"_a, "y"_a, "amplitude"_a, "sx"_a, "sy"_a, "distance"_a, "wavenumber"_a,
          "Sum of spherical wavelets from sources (x, y, 0) at sensor points (sx, sy, distance).");
    m.def("closed_form_field", &closed_form_field, "edges"_a, "alpha"_a, "beta"_a, "gamma"_a, "transition"_a, "ratio"_a,
          "terms"_a, "v"_a,
          "U of the phase alpha R^2 + beta R + gamma on pieces, by Hankel's expansion on pieces that grow by ratio.");
    m.def("fresnel_auxiliary", &fresnel_auxiliary, "s"_a, "exp(-i s^2) int_s^inf exp(i tau^2) d tau for s >= 0.");
    m.def("chebyshev_intensity", &chebyshev_intensity, "pieces"_a, "width"_a, "v"_a,
          "|U|^2 at v from the Chebyshev coefficients of U on pieces.");
    define_spread<float>(m);
    define_spread<double>(m);
    define_bounds(m);
    m.def("instructions", &instructions, "The widest instructions in use: portable, avx2 or avx512.");
    m.def("limit_instructions", &limit_instructions, "level"_a, "Use no wider instructions than these.");
}
