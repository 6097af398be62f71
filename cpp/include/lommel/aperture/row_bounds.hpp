// Numbers of rows and of Gauss-Legendre nodes along rows of an aperture, for a proven quadrature error (certificate, section 18).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

#include "lommel/aperture/shapes.hpp"
#include "lommel/base/pi.hpp"

namespace lommel {

// Modulus of a number far from overflow; faster than std::abs.
inline double modulus(std::complex<double> z) { return std::sqrt(z.real() * z.real() + z.imag() * z.imag()); }

// Disc of the complex plane that contains a number (circular arithmetic: centre and radius).
struct ComplexDisc {
    std::complex<double> centre;
    double radius = 0.0;

    double largest() const { return modulus(centre) + radius; }
    friend ComplexDisc operator+(ComplexDisc a, ComplexDisc b) { return {a.centre + b.centre, a.radius + b.radius}; }
    friend ComplexDisc operator-(ComplexDisc a, ComplexDisc b) { return {a.centre - b.centre, a.radius + b.radius}; }
    friend ComplexDisc operator*(ComplexDisc a, ComplexDisc b) {
        const double first = modulus(a.centre), second = modulus(b.centre);
        return {a.centre * b.centre, first * b.radius + second * a.radius + a.radius * b.radius};
    }
    friend ComplexDisc operator*(std::complex<double> a, ComplexDisc b) { return {a * b.centre, modulus(a) * b.radius}; }
    friend ComplexDisc operator*(double a, ComplexDisc b) { return {a * b.centre, std::abs(a) * b.radius}; }
    // Disc that contains the square roots of all points of this disc, by the continuous branch that is principal at the centre. If
    // this disc contains 0, no branch is continuous on it; the returned disc then contains both square roots of each point.
    ComplexDisc root() const {
        if (modulus(centre) <= radius) {
            return {0.0, std::sqrt(largest())};
        }
        const double size = modulus(centre), re = std::sqrt(0.5 * std::max(0.0, size + centre.real()));
        const double im = std::sqrt(0.5 * std::max(0.0, size - centre.real()));
        return {{re, centre.imag() < 0.0 ? -im : im}, std::sqrt(size) - std::sqrt(std::max(0.0, size - radius))};
    }
};

// Bound on cosh 2b over discs of x and y. A polynomial of degree n that is at most 1 on the real unit disc is at most e^{n b} at
// complex (x, y), cosh 2b = |x|^2 + |y|^2 + |x^2 + y^2 - 1| (Siciak's extremal function, due to Lundin). The points with b below a
// limit form a convex set.
inline double growth_argument(ComplexDisc x, ComplexDisc y) {
    const double across = x.largest(), down = y.largest();
    const ComplexDisc rest = x * x + y * y - ComplexDisc{1.0, 0.0};
    return across * across + down * down + rest.largest();
}

// Call at(s) for the corners s, in the upper half plane, of a polygon around the ellipse with semi-axes cosh eta and sinh eta.
template <class At>
void each_corner(double eta, const At& at) {
    constexpr std::size_t corners = 40;
    const double scale = 1.0 / std::cos(pi / corners), a = scale * std::cosh(eta), b = scale * std::sinh(eta);
    for (std::size_t i = 0; i <= corners / 2; ++i) {
        const double t = 2.0 * pi * static_cast<double>(i) / corners;
        at(std::complex<double>(a * std::cos(t), b * std::sin(t)));
    }
}

// Number of nodes (`count`) of a Gauss rule on [-1, 1] for which the error of the integral is at most `error` (Trefethen,
// Approximation Theory and Approximation Practice, Theorem 19.3; valid for one node too). Each ellipse with semi-axes cosh eta and
// sinh eta gives a number; count is the smallest. blocked: a singularity excludes large ellipses. largest(eta, limit): bound on
// log |integrand| on an ellipse; it returns 1e300 or more if it knows none, and may do so if log |integrand| exceeds `limit`.
struct GaussNodes {
    double count;
    bool blocked = false;

    template <class Largest>
    GaussNodes(double error, const Largest& largest) : count(none) {
        constexpr int etas = 16, patience = 2;
        const auto needed = [&](int k) {
            const double eta = 0.02 * std::pow(1.5, k), known = std::log(64.0 / 15.0 / -std::expm1(-2.0 * eta) / error);
            const double most = largest(eta, 2.0 * eta * count - known);
            return most < 1e300 ? std::max(1.0, std::ceil((known + most) / (2.0 * eta))) : none;
        };
        int start = 8;
        count = needed(start);
        while (count >= none && start > 0) {
            start -= 2;
            blocked = true;
            count = needed(start);
        }
        for (const int step : {1, -1}) {
            int missed = 0;
            for (int k = start + step; k >= 0 && k < etas && missed < patience; k += step) {
                const double next = needed(k);
                missed = next < count ? 0 : missed + 1;
                count = std::min(count, next);
            }
        }
    }
    static constexpr double none = 1e9;
};

// Bound on a function over the upper half of the ellipse with semi-axes cosh eta and sinh eta; at(disc): bound on it over a disc
// that contains an arc of the ellipse. The arc with the largest bound is halved until this bound is close to a value of the
// function, or until such a value exceeds `limit`: then 1e301 is returned.
template <class At>
double largest_on_ellipse(double eta, double limit, const At& at) {
    constexpr std::size_t first = 8, most = 96;
    const double a = std::cosh(eta), b = std::sinh(eta);
    struct Arc {
        double from, to, bound;
        bool operator<(const Arc& other) const { return bound < other.bound; }
    };
    const auto disc = [&](double from, double to) {
        const double middle = 0.5 * (from + to), half = 0.5 * (to - from);
        // Bound on |sin| over the arc: the speed along the ellipse is sqrt(b^2 + sin^2), largest near its flat sides.
        const double sine = std::min(1.0, std::abs(std::sin(middle)) + half);
        return ComplexDisc{{a * std::cos(middle), b * std::sin(middle)}, half * std::sqrt(b * b + sine * sine)};
    };
    std::array<Arc, most> arcs;
    std::size_t count = 0;
    const auto add = [&](double from, double to) {
        arcs[count++] = {from, to, at(disc(from, to))};
        std::push_heap(arcs.begin(), arcs.begin() + count);
    };
    for (std::size_t i = 0; i < first; ++i) {
        add(pi * static_cast<double>(i) / first, pi * static_cast<double>(i + 1) / first);
    }
    while (count < most) {
        const Arc worst = arcs[0];
        const double seen = at({disc(worst.from, worst.to).centre, 0.0});
        if (worst.bound < seen + 1.5 || seen > limit) {
            return seen > limit ? 1e301 : worst.bound;
        }
        std::pop_heap(arcs.begin(), arcs.begin() + count--);
        const double middle = 0.5 * (worst.from + worst.to);
        add(worst.from, middle);
        add(middle, worst.to);
    }
    return arcs[0].bound;
}

// Map from s in [-1, 1] to y over a panel (range of heights y, see Panel). root = 0: linear; root = -1 or 1: an arc begins at the
// low or high end, and the distance from this end is length * ((1 + s) / 2)^2, which removes the square root of the arc.
class PanelMap {
   public:
    PanelMap(double low, double high, int root)
        : root_(root), length_(high - low), anchor_(root < 0   ? low
                                                    : root > 0 ? high
                                                               : 0.5 * (low + high)),
          sign_(root > 0 ? -1.0 : 1.0) {}

    template <class Number>
    Number y(Number s) const {
        return anchor_ + sign_ * distance(s);
    }
    double slope(double s) const { return root_ == 0 ? 0.5 * length_ : 0.5 * length_ * (1.0 + s); }

    ComplexDisc y(ComplexDisc s) const {
        ComplexDisc t = distance(s);
        return ComplexDisc{anchor_, 0.0} + sign_ * t;
    }
    double largest_slope(ComplexDisc s) const {
        return 0.5 * length_ * (root_ == 0 ? 1.0 : (ComplexDisc{1.0, 0.0} + s).largest());
    }

    // Evaluate the arc sqrt((y - low) (high - y)) of a side at y(s) as a product of square roots of linear functions of s. Returns
    // false if one of these functions vanishes on or inside the ellipse of points s with semi-axes cosh eta and sinh eta.
    bool arc(const Side& side, double eta, ComplexDisc s, ComplexDisc& value) const {
        const double near = sign_ > 0.0 ? anchor_ - side.low : side.high - anchor_;
        const double far = sign_ > 0.0 ? side.high - anchor_ : anchor_ - side.low;
        // Argument of the square root: (near + t) (far - t), with t = sign_ * (y - anchor_).
        if (root_ == 0) {
            const double half = 0.5 * length_;
            return linear(-near / half, eta, s, std::sqrt(std::max(near, 0.0)), value = {1.0, 0.0}) &&
                   linear(far / half, eta, s, std::sqrt(std::max(far, 0.0)), value);
        }
        const ComplexDisc u = 0.5 * (ComplexDisc{1.0, 0.0} + s);
        if (near <= 0.0) {
            value = std::sqrt(length_) * u;
        } else {
            const std::complex<double> at(-1.0, 2.0 * std::sqrt(near / length_));
            value = {1.0, 0.0};
            if (!linear(at, eta, s, std::sqrt(length_) * 0.5 * std::abs(at), value) ||
                !linear(std::conj(at), eta, s, 1.0, value)) {
                return false;
            }
        }
        // The factor far - t = far - length u^2, u = (1 + s) / 2, has the roots u = +-sqrt(far / length).
        const double end = 2.0 * std::sqrt(std::max(far, 0.0) / length_);
        return linear(end - 1.0, eta, s, std::sqrt(0.25 * length_ * (end - 1.0) * (end + 1.0)), value) &&
               linear(-end - 1.0, eta, s, 1.0, value);
    }

   private:
    template <class Number>
    Number distance(Number s) const {
        if (root_ == 0) {
            return 0.5 * length_ * s;
        }
        const Number u = 0.5 * (1.0 + s);
        return length_ * u * u;
    }
    ComplexDisc distance(ComplexDisc s) const {
        if (root_ == 0) {
            return 0.5 * length_ * s;
        }
        const ComplexDisc u = 0.5 * (ComplexDisc{1.0, 0.0} + s);
        return length_ * (u * u);
    }
    // Multiply `value` by scale * sqrt(1 - s / at). Return false unless the zero `at` is outside the ellipse of arc(). If it is
    // outside, 1 - s / at maps the inside of the ellipse to a convex set that contains 1 and not 0. Such a set does not meet the
    // negative real axis, so the principal root is analytic on it.
    static bool linear(std::complex<double> at, double eta, ComplexDisc s, double scale, ComplexDisc& value) {
        if (!(std::abs(at - 1.0) + std::abs(at + 1.0) > 2.0 * std::cosh(eta) * (1.0 + 1e-9))) {
            return false;
        }
        value = value * (scale * (ComplexDisc{1.0, 0.0} - (1.0 / at) * s).root());
        return true;
    }

    int root_;
    double length_, anchor_, sign_;
};

// Range of heights y, low to high, in which the clear intervals of all rows lie between the same pairs of sides.
struct Panel {
    double low, high;
    int root;  // end of the panel at which an arc begins: low (-1), high (1), none (0)
    std::vector<std::array<Side, 2>> spans;

    // Bound on log |f| on the ellipse with semi-axes cosh eta, sinh eta. f(s): dy/ds * integral, over the spans of row y(s), of a
    // polynomial of degree `degree` that is at most 1 on the unit disc. If the bound exceeds `limit`, 1e301 may be returned.
    double largest(double eta, double degree, double limit) const {
        const PanelMap map(low, high, root);
        if (straight()) {
            return largest_straight(eta, degree, map);
        }
        return largest_on_ellipse(eta, limit, [&](ComplexDisc s) {
            const ComplexDisc y = map.y(s);
            double growth = 1.0, width = 1e-300;
            for (const auto& span : spans) {
                ComplexDisc x[2];
                for (std::size_t i = 0; i < 2; ++i) {
                    const Side& side = span[i];
                    x[i] = ComplexDisc{side.p - side.q * side.origin, 0.0} + side.q * y;
                    if (side.k != 0.0) {
                        ComplexDisc arc;
                        if (!map.arc(side, eta, s, arc)) {
                            return 1e301;
                        }
                        x[i] = x[i] + side.k * arc;
                    }
                    growth = std::max(growth, growth_argument(x[i], y));
                }
                width += (x[1] - x[0]).largest();
            }
            // The polynomial grows at most like e^{degree * b} (growth_argument()). Points with b below a limit form a convex set,
            // so between the two sides of a span b is at most its larger value on these sides.
            return 0.5 * degree * std::acosh(growth) + std::log(width * map.largest_slope(s) + 1e-300) + 1e-9;
        });
    }

   private:
    bool straight() const {
        return root == 0 && std::all_of(spans.begin(), spans.end(),
                                        [](const std::array<Side, 2>& span) { return span[0].k == 0.0 && span[1].k == 0.0; });
    }
    // Straight sides are linear in s, so cosh 2b (growth_argument()) and the width of a span are largest at corners of the polygon.
    double largest_straight(double eta, double degree, const PanelMap& map) const {
        double growth = 1.0, width = 1e-300;
        for (const auto& span : spans) {
            double here = 0.0;
            each_corner(eta, [&](std::complex<double> s) {
                const std::complex<double> y = map.y(s);
                std::complex<double> x[2];
                for (std::size_t i = 0; i < 2; ++i) {
                    x[i] = span[i].p + span[i].q * (y - span[i].origin);
                    growth = std::max(growth, std::norm(x[i]) + std::norm(y) + modulus(x[i] * x[i] + y * y - 1.0));
                }
                here = std::max(here, modulus(x[1] - x[0]));
            });
            width += here;
        }
        return 0.5 * degree * std::acosh(growth) + std::log(width * map.largest_slope({0.0, 0.0})) + 1e-9;
    }
};

// Number of nodes along a span (clear interval) of a row, from its position within the row's chord of the unit disc.
class SpanNodes {
   public:
    SpanNodes(std::size_t degree, double error)
        : degree_(static_cast<double>(degree)), error_(error), known_(cells * cells, 0) {}

    // Number of nodes for which the mean of a polynomial over the span [low, high] has an error of at most `error`. The chord of
    // the row is [-half, half].
    std::size_t operator()(double low, double high, double half) {
        // Numbers are cached for spans rounded outwards to cells. They suffice for the spans themselves: the ellipses of a rounded
        // span contain those of any span within it.
        const std::size_t i = cell(low / half, false), j = cell(high / half, true);
        std::size_t& known = known_[i * cells + j];
        if (known == 0) {
            const double from = place(i), to = place(j), middle = 0.5 * (from + to), reach = 0.5 * (to - from);
            // A polynomial that is at most 1 on [-1, 1] is at most e^(degree b) at complex x, with 2 cosh b = |x - 1| + |x + 1|.
            // This sum is a convex function of x, hence on the polygon of each_corner() largest at a corner.
            const GaussNodes most(error_, [&](double eta, double) {
                double sum = 2.0;
                each_corner(eta, [&](std::complex<double> s) {
                    const std::complex<double> x = middle + reach * s;
                    sum = std::max(sum, modulus(x - 1.0) + modulus(x + 1.0));
                });
                return degree_ * std::acosh(0.5 * sum) + 1e-8;
            });
            known = std::min(static_cast<std::size_t>(most.count),
                             static_cast<std::size_t>(0.5 * degree_) + 1);  // enough for an exact rule
        }
        return known;
    }

   private:
    static constexpr std::size_t cells = 65;
    static double place(std::size_t i) { return -std::cos(pi * static_cast<double>(i) / static_cast<double>(cells - 1)); }
    static std::size_t cell(double x, bool up) {
        const double at = std::acos(std::min(1.0, std::max(-1.0, -x))) / pi * (cells - 1);
        return static_cast<std::size_t>(std::min<double>(cells - 1, up ? std::ceil(at) : std::floor(at)));
    }

    double degree_, error_;
    std::vector<std::size_t> known_;
};

}  // namespace lommel
