// Stacks of radially symmetric pupils: input and output of the radial engine.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/bounds/amplitude.hpp"
#include "lommel/limits.hpp"

namespace lommel {

// Pupil function A exp(i Phi): coefficients (rad) of the Zernike polynomials R_2^0, R_4^0, ... in Phi; amplitude A (not copied).
struct Phase {
    const double* coefficients;
    std::size_t terms;
    const Amplitude* amplitude = &even_light;

    double size() const { return weighted(0.0, 0.0, 1.0); }
    // Rounding error of the phase in roundoffs, averaged over the pupil (docs/certificate.md, section 4). The coefficient of the
    // Legendre polynomial P_j counts j + K + 5 times: 2 for its own roundings, 1 for P_j, K + 1 for products and sum (K: number of
    // nonzero coefficients), 1 to spare, j for half a rounding of the node times the mean |P_j'|, at most sqrt(j (j + 1) / 2).
    double sensitivity() const {
        const double used =
            static_cast<double>(terms) - static_cast<double>(std::count(coefficients, coefficients + terms, 0.0));
        return weighted(0.0, 1.0, used + 5.0) + amplitude->sensitivity();
    }
    // Bound on the distance of geometric rays from the axis, in optical units: |dPhi/drho|, as |dR_2j^0/drho| <= 2j (j + 1).
    double blur() const { return weighted(2.0, 2.0, 0.0); }

   private:
    double weighted(double square, double slope, double start) const {
        double sum = 0.0;
        for (std::size_t k = 0; k < terms; ++k) {
            const double j = static_cast<double>(k + 1);
            sum += ((square * j + slope) * j + start) * std::abs(coefficients[k]);
        }
        return sum;
    }
};

struct Stack {
    const double* coefficients;  // [pupil][term]: in rad, of the Zernike polynomials R_2^0, R_4^0, ...
    std::size_t count, terms;
    double obscuration;
    Amplitude amplitude{};
    Phase operator[](std::size_t i) const { return {coefficients + i * terms, terms, &amplitude}; }
};

// Smallest and largest value (least, most) of each phase coefficient in a stack, and its largest modulus (farthest).
struct Box {
    std::vector<double> least, most, farthest;

    Box() = default;
    explicit Box(const Stack& stack) { hold(stack); }

    // Set least, most and farthest from the pupils of a stack; allocates nothing if the number of terms has not grown.
    void hold(const Stack& stack) {
        least.assign(stack.coefficients, stack.coefficients + stack.terms);
        most = least;
        for (std::size_t i = 1; i < stack.count; ++i) {
            for (std::size_t k = 0; k < stack.terms; ++k) {
                least[k] = std::min(least[k], stack[i].coefficients[k]);
                most[k] = std::max(most[k], stack[i].coefficients[k]);
            }
        }
        farthest.clear();
        for (std::size_t k = 0; k < stack.terms; ++k) {
            farthest.push_back(std::max(std::abs(least[k]), std::abs(most[k])));
        }
    }
    Phase worst(const Amplitude& amplitude) const { return {farthest.data(), farthest.size(), &amplitude}; }
};

// Output, by pupil. scales: factors of the intensity (0 on entry: divide by the maximum); bounds: error bounds relative to `peaks`.
template <class T>
struct Answer {
    T* images;
    double *scales, *bounds, *peaks;
    const std::size_t* powers =
        nullptr;  // [derivative]: exponent k of t^k, t the squared pupil radius, whose coefficient varies
    std::size_t derivatives = 0;
    T* derivative_images = nullptr;  // [derivative][pupil][height][width]
    double* derivative_bounds = nullptr;  // [derivative][pupil]: error bound relative to the peak of the intensity

    // Store peak and error bound of a pupil, and return the scale of its image, whose largest intensity is `top`.
    double finish(std::size_t pupil, double top, double peak, double bound) const {
        bounds[pupil] = bound;
        peaks[pupil] = peak;
        return scales[pupil] = scales[pupil] == 0.0 ? 1.0 / top : scales[pupil];
    }
};

// Error budget of an image (docs/certificate.md, section 6).
struct RadialBudget {
    // Error of the field U / (tolerance * peak of |U|). It counts twice in the intensity; 1 - 2 * field is a margin.
    static constexpr double field = 0.4;
    static_assert(2.0 * field <= 1.0);
    // Factors of the allowed error of the field U: full disk (outer), obscuration (inner), interpolation in the radius (pieces).
    // A disk uses only the fraction truncation + quadrature of its allowed error.
    static constexpr double outer = 0.5, inner = 0.5, pieces = 0.4;
    // Shares of the allowed error of one disk: omitted terms of the Legendre series, and quadrature of its coefficients.
    static constexpr double truncation = 0.5, quadrature = 0.1;
    static_assert((outer + inner) * (truncation + quadrature) + pieces <= 1.0);
    // Factor on the requested error of the field U for the next attempt, and the smallest error to try.
    static constexpr double retry = 0.1, least = 8.0 * unit_roundoff;
};

// Low estimate of the largest modulus of a field. A field that does not reach it is computed again with a smaller error.
inline double likely_peak(const Phase& phase, double obscuration) {
    return phase.amplitude->integral(obscuration) / (4.0 * phase.size() + 1.0);
}

inline double first_error(const Phase& phase, double obscuration, double tol) {
    return RadialBudget::field * tol * likely_peak(phase, obscuration);
}

}  // namespace lommel
