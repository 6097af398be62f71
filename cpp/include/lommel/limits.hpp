// Limits of arguments, their exceptions, and the error of stored intensities (certificate, section 6).
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace lommel {

constexpr double unit_roundoff = 1.1102230246251565e-16;
constexpr double max_phase = 1e6;        // radians; for larger arguments sin and cos lose digits
constexpr double max_reach = 1e6;        // maximum v = 2 pi NA r / lambda; beyond, I is below 1e-17 of the in-focus peak
constexpr std::size_t max_terms = 6000;  // maximum number n of Legendre terms; their quadrature table takes about 4 n^2 bytes
constexpr std::size_t max_degree = 200;  // maximum degree of a Zernike term

struct LimitExceeded : std::domain_error {
    using std::domain_error::domain_error;
};

struct ToleranceNotMet : std::runtime_error {
    double bound;
    explicit ToleranceNotMet(double reached) : std::runtime_error("tolerance not met"), bound(reached) {}
};

inline std::string shortened(double x) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", x);
    return text;
}

inline void check_reach(double reach) {
    if (!(reach <= max_reach)) {
        throw LimitExceeded("v up to " + shortened(reach) + " from the axis is more than the limit of " + shortened(max_reach));
    }
}

inline void check_phase(double radians) {
    if (!(radians <= max_phase)) {
        throw LimitExceeded("phases of " + shortened(radians) + " rad exceed the limit of 1000000 rad");
    }
}

// Zernike term R_n^|m|(rho) cos(m theta), or R_n^|m|(rho) sin(|m| theta) for m < 0; its radial part is 1 at the edge.
struct ZernikeTerm {
    std::int32_t n, m;
    bool operator==(const ZernikeTerm& other) const { return n == other.n && m == other.m; }
};

// Bound on the error of the intensity I = |U|^2, for an amplitude |U| <= `size` with an error of at most `error`.
inline double intensity_error(double size, double error) { return error * (2.0 * size + error); }

// Bound on (`error` of an intensity) / (exact peak). Exact peak >= (sqrt(peak) - field_error)^2, where `peak` is the computed one.
inline double over_peak(double error, double peak, double field_error) {
    const double exact = std::sqrt(peak) - field_error;
    return exact > 1e-150 ? error / (exact * exact) : 1e300;
}

// Bound on (error of an intensity) / (exact peak): (2 M e + e^2) / (M - e)^2, with M^2 the computed `peak`, e the `field_error`.
inline double relative_error(double peak, double field_error) {
    return over_peak(intensity_error(std::sqrt(peak), field_error), peak, field_error);
}

// Error of values after division by the largest of them. `relative`: their error before, divided by the exact largest value.
inline double normalized_error(double relative) { return relative < 1.0 ? 2.0 * relative / (1.0 - relative) : 1e300; }

// Rounding error of stored values, divided by their peak. The sum of two squares, the scale and their product take at most six
// roundings to double. Conversion to float rounds once more, or twice if stored values are divided by the largest of them.
template <class T>
constexpr double storing(bool twice) {
    return 6.0 * unit_roundoff + (sizeof(T) == 4 ? (twice ? 2.0 : 1.0) * 5.9604644775390625e-08 : 0.0);
}
inline double stored(double relative, double storing) { return relative + (1.0 + relative) * storing; }

// Bound on error / peak of the values returned. `relative`: bound on error / peak of the values as computed. `divided`: they are
// then divided by the largest of them; `after`: they are divided after they are stored.
template <class T>
double finished_error(double relative, bool divided, bool after) {
    return stored(divided ? normalized_error(relative) : relative, storing<T>(divided && after));
}

}  // namespace lommel
