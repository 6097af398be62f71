// Conversion of pupils from arrays, and of output arrays for images.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

#include "lommel/radial/images.hpp"
#include "lommel/zernike/disk_stack.hpp"

#include "python.hpp"

namespace bindings {

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
inline lommel::Stack stack_of(const In<double, 2>& coefficients, double obscuration, const In<double, 1>& amplitude) {
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

// Output arrays: an image for each pupil, and numbers[scale, error bound, peak][pupil] in one array, as calls may take only a
// microsecond. scale: factor of the intensity; 0 divides by the largest value.
template <class T>
lommel::Answer<T> answer_of(std::size_t pupils, double scale, const Out<T, 3>& images, const Out<double, 2>& numbers) {
    require(images.shape(0) == pupils && numbers.shape(0) == 3 && numbers.shape(1) == pupils,
            "one image, scale, bound and peak a pupil");
    require_image(images.shape(1), images.shape(2));
    double* const scales = numbers.data();
    std::fill_n(scales, pupils, scale);
    return {images.data(), scales, scales + pupils, scales + 2 * pupils, nullptr, 0, nullptr, nullptr};
}

// Powers k for images of derivatives with respect to the coefficients of t^k; may be empty.
inline std::vector<std::size_t> powers_of(const In<std::int64_t, 1>& powers) {
    std::vector<std::size_t> which;
    for (std::size_t i = 0; powers.is_valid() && i < powers.shape(0); ++i) {
        require(powers.data()[i] >= 1 && powers.data()[i] <= 64, "powers must be from 1 to 64");
        which.push_back(static_cast<std::size_t>(powers.data()[i]));
    }
    return which;
}

template <class T>
void require_derivatives(std::size_t powers, std::size_t pupils, const Out<T, 3>& of, const Out<T, 4>& images,
                         const Out<double, 2>& bounds) {
    require((images.is_valid() ? images.shape(0) : 0) == powers && (bounds.is_valid() ? bounds.shape(0) : 0) == powers,
            "one derivative a power");
    require(powers == 0 || (images.shape(1) == pupils && images.shape(2) == of.shape(1) && images.shape(3) == of.shape(2) &&
                            bounds.shape(1) == pupils),
            "derivatives must match the images");
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

// Pupils without radial symmetry, around one axis (row, column) or an axis for each.
template <class... Center>
lommel::DiskPupils disks_of(const In<std::int32_t, 2>& terms, const In<double, 2>& edge, double obscuration,
                            const In<double, 1>& amplitude, std::size_t height, std::size_t width, double step,
                            const Center&... center) {
    lommel::DiskWindow window{height, width, static_cast<double>(height / 2), static_cast<double>(width / 2), step};
    const double* centers = nullptr;
    require_image(height, width);
    if constexpr (sizeof...(Center) == 2) {
        require_center(center...);
        window = {height, width, center..., step};
    } else {
        require_centers(center..., pupils_of(edge));
        centers = (center.data(), ...);
    }
    std::vector<lommel::ZernikeTerm> list = terms_of(terms, edge.shape(1));
    require_terms(list);
    return {std::move(list),         edge.data(), pupils_of(edge), obscuration_of(obscuration),
            amplitude_of(amplitude), window,      centers};
}

// Call work(stack, window) for such pupils. With Moves, tilts become shifts by whole pixels. Returns 0, or the achieved error
// bound if the tolerance cannot be met.
template <bool Moves, class Work, class... Center>
double ask_disks(const In<std::int32_t, 2>& terms, const In<double, 2>& edge, double obscuration,
                 const In<double, 1>& amplitude, std::size_t height, std::size_t width, double step, double tol, int threads,
                 const Work& work, const Center&... center) {
    const lommel::DiskPupils pupils = disks_of(terms, edge, obscuration, amplitude, height, width, step, center...);
    require_request(step, tol, threads);
    return judged([&] {
        lommel::DiskStack stack = pupils.stack();
        if constexpr (Moves) {
            stack.move_axes(pupils.window);
        }
        stack.shrink();
        work(stack, pupils.window);
    });
}

template <class T>
lommel::DiskAnswer<T> disk_answer_of(std::size_t pupils, double scale, const Out<T, 3>& images, const Out<double, 2>& numbers) {
    const lommel::Answer<T> answer = answer_of(pupils, scale, images, numbers);
    return {answer.images, answer.scales, answer.bounds, answer.peaks};
}

template <template <class> class Engine, bool Moves, class T, class... Center>
double disk_images(In<std::int32_t, 2> terms, In<double, 2> edge, double obscuration, In<double, 1> amplitude, Center... center,
                   double step, double tol, int threads, double scale, Out<T, 3> images, Out<double, 2> numbers) {
    const lommel::DiskAnswer<T> answer = disk_answer_of(pupils_of(edge), scale, images, numbers);
    return ask_disks<Moves>(
        terms, edge, obscuration, amplitude, images.shape(1), images.shape(2), step, tol, threads,
        [&](const lommel::DiskStack& stack, const lommel::DiskWindow& window) {
            Engine<T>(stack, window, tol, threads, answer).run();
        },
        center...);
}

template <template <class> class Engine, bool Moves>
void define_disk_images(nb::module_& m, const char* name, const char* says) {
    for_both([&](auto pixel) {
        using T = decltype(pixel);
        m.def(name, &disk_images<Engine, Moves, T, double, double>, "terms"_a, "edge"_a, "obscuration"_a, "amplitude"_a,
              "center_y"_a, "center_x"_a, "step"_a, "tol"_a, "threads"_a, "scale"_a, "images"_a.noconvert(),
              "numbers"_a.noconvert(), says);
        m.def(name, &disk_images<Engine, Moves, T, In<double, 2>>, "terms"_a, "edge"_a, "obscuration"_a, "amplitude"_a,
              "centers"_a, "step"_a, "tol"_a, "threads"_a, "scale"_a, "images"_a.noconvert(), "numbers"_a.noconvert(),
              "The same, each around an axis of its own.");
    });
}

}  // namespace bindings
