// Conversion of pupils from arrays, and of output arrays for images.
#pragma once

#include <nanobind/stl/variant.h>

#include <algorithm>
#include <cstdlib>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "lommel/radial/images.hpp"
#include "lommel/zernike/disk_stack.hpp"

#include "python.hpp"

namespace bindings {

// NamedTuples of lommel.core.engine, which cross field by field.
// RadialStack: coefficients[pupil][term], radians; obscuration; powers of the amplitude.
using RadialFields = std::tuple<In<double, 2>, double, In<double, 1>>;
// DiskStack: terms[term][n, m]; coefficients[pupil][term], radians at the edge; obscuration; powers of the amplitude;
// strips[strip][cosine, sine, low, high, mirrored, ahead, behind, begins, start].
using DiskFields = std::tuple<In<std::int32_t, 2>, In<double, 2>, double, In<double, 1>, In<double, 2>>;
// Pixel at the axis of all images, as (row, column) or one row of an array; or centers[pupil][row, column].
using Center = std::variant<std::pair<double, double>, In<double, 2>>;
// Window: (height, width), center, pitch in v.
using WindowFields = std::tuple<std::pair<std::size_t, std::size_t>, Center, double>;

// Tolerance, largest number of threads (0: all processors), and factor of the intensity (0: over its largest value).
using Request = std::tuple<double, int, double>;

// Amplitude without checking that it is at most 1, for tests of its bounds.
inline lommel::Amplitude powers_of_amplitude(const In<double, 1>& powers) {
    require(powers.shape(0) <= 1 + lommel::Amplitude::most, "amplitude must have at most 11 powers");
    return {powers.data(), powers.shape(0)};
}

inline lommel::Amplitude amplitude_of(const In<double, 1>& powers) {
    const lommel::Amplitude amplitude = powers_of_amplitude(powers);
    // Limit of 100, with a margin for rounding.
    require(amplitude.size() <= 100.0 * (1.0 + 1e-9), "amplitude must have an exponent of 100 at most");
    require(amplitude.passive(), "amplitude must be at most 1");
    return amplitude;
}

inline double obscuration_of(double obscuration) {
    require(obscuration >= 0.0 && obscuration < 1.0, "obscuration must be from 0 to below 1");
    return obscuration;
}

inline lommel::Stack stack_of(const double* coefficients, std::size_t pupils, std::size_t terms, double obscuration,
                              const lommel::Amplitude& amplitude) {
    require(pupils > 0 && terms > 0, "coefficients must not be empty");
    require(terms <= lommel::LegendreRule::most_terms, "coefficients must be 30 a pupil at most");
    return {coefficients, pupils, terms, obscuration, amplitude};
}
inline lommel::Stack stack_of(const RadialFields& given) {
    const auto& [coefficients, obscuration, amplitude] = given;
    return stack_of(coefficients.data(), coefficients.shape(0), coefficients.shape(1), obscuration_of(obscuration),
                    amplitude_of(amplitude));
}

template <class Integer>
std::vector<lommel::ZernikeTerm> terms_of(const In<Integer, 2>& given, std::size_t coefficients) {
    require(given.shape(0) > 0 && given.shape(1) == 2, "terms must have the shape (terms, 2), with one term at least");
    require(given.shape(0) == coefficients, "one coefficient a term and pupil");
    std::vector<lommel::ZernikeTerm> terms;
    for (std::size_t j = 0; j < given.shape(0); ++j) {
        terms.push_back({static_cast<std::int32_t>(given.data()[2 * j]), static_cast<std::int32_t>(given.data()[2 * j + 1])});
    }
    return terms;
}

// Check the last two axes of images, or of weights of their pixels.
template <class Images>
void require_shape(const WindowFields& window, const Images& images) {
    require(std::get<0>(window) == std::pair(images.shape(1), images.shape(2)), "images must have the shape of the window");
    require_image(images.shape(1), images.shape(2));
}

// Output arrays: an image for each pupil, and numbers[scale, error bound, peak][pupil] in one array, as calls may take only a
// microsecond. scale: factor of the intensity; 0 divides by the largest value.
template <class T>
lommel::Answer<T> answer_of(std::size_t pupils, const WindowFields& window, double scale, const Out<T, 3>& images,
                            const Out<double, 2>& numbers) {
    require(images.shape(0) == pupils && numbers.shape(0) == 3 && numbers.shape(1) == pupils,
            "one image, scale, bound and peak a pupil");
    require_shape(window, images);
    double* const scales = numbers.data();
    std::fill_n(scales, pupils, scale);
    return {images.data(), scales, scales + pupils, scales + 2 * pupils};
}

inline void require_request(double step, double tol, int threads) {
    require(step > 0.0 && tol > 0.0 && threads >= 0, "step and tol must be positive, threads at least 0");
}

// Run an engine. Returns 0, or the achieved error bound if the tolerance cannot be met.
template <class Work>
double judged(const Work& work) {
    try {
        released(work);
    } catch (const lommel::ToleranceNotMet& failure) {
        return failure.bound;
    }
    return 0.0;
}

inline std::size_t pupils_of(const In<double, 2>& edge) {
    require(edge.shape(0) > 0, "one pupil at least");
    return edge.shape(0);
}

inline void require_terms(const std::vector<lommel::ZernikeTerm>& list) {
    for (auto term = list.begin(); term != list.end(); ++term) {
        const std::int32_t n = term->n, order = std::abs(term->m);
        require(n >= 0 && n <= 200 && order <= n && (n - order) % 2 == 0, "no such Zernike term");
        require(std::find(list.begin(), term, *term) == term, "a Zernike term comes twice");
    }
}

// Terms with respect to whose coefficients derivatives are requested.
inline std::vector<lommel::ZernikeTerm> factors_of(const In<std::int32_t, 2>& given) {
    const std::vector<lommel::ZernikeTerm> terms = terms_of(given, given.shape(0));
    require_terms(terms);
    for (const lommel::ZernikeTerm& term : terms) {
        require(term.n > 0, "no image depends on a constant");
    }
    return terms;
}

// Window around the one axis of all images; around the first of several, which `centers` then points to.
struct AxisWindow {
    lommel::DiskWindow first;
    const double* centers;  // [pupil][row, column], or null

    lommel::PixelWindow pixels(bool integrate) const {
        return window_of(first.height, first.width, first.row, first.column, first.step, integrate);
    }
};

inline AxisWindow axis_window(const WindowFields& window, std::size_t pupils) {
    const auto& [shape, center, step] = window;
    require_image(shape.first, shape.second);
    if (const auto* centers = std::get_if<In<double, 2>>(&center)) {
        const bool shared = centers->shape(0) == 1;
        const double* const each = centers->data();
        require((shared || centers->shape(0) == pupils) && centers->shape(1) == 2, "one centre a pupil, of a row and a column");
        for (std::size_t i = 0; i < centers->shape(0); ++i) {
            require_center(each[2 * i], each[2 * i + 1]);
        }
        return {{shape.first, shape.second, each[0], each[1], step}, shared ? nullptr : each};
    }
    const auto [row, column] = std::get<0>(center);
    require_center(row, column);
    return {{shape.first, shape.second, row, column, step}, nullptr};
}

// Window of images that are all around one axis.
inline AxisWindow one_axis_window(const WindowFields& window) {
    require(std::holds_alternative<std::pair<double, double>>(std::get<1>(window)), "one centre, a row and a column");
    return axis_window(window, 1);
}

inline std::vector<lommel::Strip> strips_of(const In<double, 2>& given) {
    require(given.shape(0) == 0 || given.shape(1) == 9, "nine numbers a strip");
    std::vector<lommel::Strip> strips;
    for (std::size_t i = 0; i < given.shape(0); ++i) {
        const double* of = given.data() + 9 * i;
        const auto begins = static_cast<lommel::Strip::Begins>(static_cast<int>(of[7]));
        require(of[2] < of[3] && of[7] >= 0.0 && of[7] <= 2.0 && (of[5] != 0.0 || of[6] != 0.0), "no such strip");
        strips.push_back({of[0], of[1], of[2], of[3], of[4] != 0.0, of[4] == 2.0, of[5] != 0.0, of[6] != 0.0, begins, of[8]});
        const double within = begins == lommel::Strip::Begins::circle ? of[8] : 1.0;
        require(strips.back().farthest() < within, "a strip must be narrower than the disk, and than where it begins");
    }
    return strips;
}

inline lommel::DiskPupils disks_of(const DiskFields& stack, const WindowFields& window) {
    const auto& [terms, edge, obscuration, amplitude, strips] = stack;
    const AxisWindow at = axis_window(window, pupils_of(edge));
    std::vector<lommel::ZernikeTerm> list = terms_of(terms, edge.shape(1));
    require_terms(list);
    return {std::move(list),         edge.data(), edge.shape(0), obscuration_of(obscuration),
            amplitude_of(amplitude), at.first,    at.centers,    strips_of(strips)};
}

// Call work(stack, window) for such pupils. With Moves, tilts become shifts by whole pixels. Cuts: strips may be cut out of the
// apertures. Returns 0, or the achieved error bound if the tolerance cannot be met.
template <bool Moves, bool Cuts = false, class Work>
double ask_disks(const DiskFields& given, const WindowFields& window, double tol, int threads, const Work& work) {
    const lommel::DiskPupils pupils = disks_of(given, window);
    require(Cuts || pupils.strips.empty(), "strips are not cut out by this method");
    require_request(pupils.window.step, tol, threads);
    return judged([&] {
        lommel::DiskStack stack = pupils.stack();
        if constexpr (Moves) {
            stack.move_axes(pupils.window);
        }
        stack.shrink();
        work(stack, pupils.window);
    });
}

template <template <class> class Engine, bool Moves, bool Cuts, class T>
double disk_images(DiskFields stack, WindowFields window, Request request, Out<T, 3> images, Out<double, 2> numbers) {
    const auto [tol, threads, scale] = request;
    const lommel::Answer<T> answer = answer_of(pupils_of(std::get<1>(stack)), window, scale, images, numbers);
    return ask_disks<Moves, Cuts>(stack, window, tol, threads, [&](const lommel::DiskStack& of, const lommel::DiskWindow& at) {
        Engine<T>(of, at, tol, threads, answer).run();
    });
}

template <template <class> class Engine, bool Moves, bool Cuts = false>
void define_disk_images(nb::module_& m, const char* name, const char* says) {
    for_both([&](auto pixel) {
        m.def(name, &disk_images<Engine, Moves, Cuts, decltype(pixel)>, "stack"_a, "window"_a, "request"_a,
              "images"_a.noconvert(), "numbers"_a.noconvert(), says);
    });
}

}  // namespace bindings
