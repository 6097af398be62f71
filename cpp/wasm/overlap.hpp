// Optical transfer function (OTF) of a wavefront of Zernike terms, by integration over the overlap of two shifted apertures.
//
// With the pupil function P and the frequency f in units of the cutoff,
//     OTF(f) = (integral of P(rho - f) conj(P(rho + f))) / (integral of |P|^2).
// Let u be the coordinate along f, y that perpendicular to f. At y = sin(theta) the overlap of two discs has the ends
// u = +-(cos(theta) - f), entire functions of theta: Gauss-Legendre rules in theta and u converge faster than any power. With an
// obscuration of ratio eps, the region is cut where its arcs meet; beside the obscuration y = eps sin(theta) (H. H. Hopkins, Proc.
// R. Soc. A 231, 91, 1955).
//
// The phase of the integrand is D(u, y) = Phi(u - f, y) - Phi(u + f, y), with Phi the phase of P. On an interval where D changes by
// s radians, a rule of n nodes for exp(i D) has an error of about J_2n(s / 2), which falls faster than any power once n exceeds s/4
// by a few cube roots of s. The change of D is estimated from derivatives of Phi; intervals of large change are divided.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <map>
#include <vector>

#include "lommel/base/pi.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/limits.hpp"
#include "lommel/special/legendre.hpp"
#include "lommel/special/sincos.hpp"

namespace lommel {

// Area shared by two discs of radii a and b whose centres are at the distance d.
inline double shared_area(double a, double b, double d) {
    if (d >= a + b) {
        return 0.0;
    }
    const double least = std::min(a, b);
    if (d <= std::abs(a - b)) {
        return pi * least * least;
    }
    const double x = (d * d + a * a - b * b) / (2.0 * d), other = d - x;
    const double height = std::sqrt(std::max(0.0, (a - x) * (a + x)));
    return a * a * std::atan2(height, x) + b * b * std::atan2(height, other) - d * height;
}

// OTF without aberrations. f: frequency in units of the cutoff; eps: obscuration ratio.
inline double flat_overlap(double f, double eps) {
    const double area = shared_area(1.0, 1.0, 2.0 * f) - 2.0 * shared_area(1.0, eps, 2.0 * f) + shared_area(eps, eps, 2.0 * f);
    return area / (pi * (1.0 - eps * eps));
}

class Overlap {
   public:
    // Highest Zernike degree: beyond it, monomials in x and y would lose digits by cancellation.
    static constexpr std::size_t most = 12;
    using Line = std::array<double, most + 1>;

    // edge: coefficients, in radians, of Zernike terms normalized to 1 at the pupil's edge; eps: obscuration ratio.
    Overlap(const std::vector<ZernikeTerm>& terms, const double* edge, double eps) : eps_(eps) {
        for (std::size_t j = 0; j < terms.size(); ++j) {
            if (edge[j] == 0.0) {
                continue;
            }
            if (static_cast<std::size_t>(terms[j].n) > most) {
                throw LimitExceeded("transfer functions are made of Zernike terms up to degree " + std::to_string(most));
            }
            terms_.push_back(terms[j]);
            edge_.push_back(edge[j]);
            degree_ = std::max(degree_, static_cast<std::size_t>(terms[j].n));
        }
    }

    // Set the direction of the frequency: its angle in radians from +x (along columns) towards +y (along rows).
    void face(double angle) {
        for (auto& row : powers_) {
            row.fill(0.0);
        }
        even_ = mirrored_ = true;
        for (std::size_t j = 0; j < terms_.size(); ++j) {
            const int m = std::abs(terms_[j].m);
            const double c = std::cos(m * angle), s = std::sin(m * angle);
            // Expand cos(m (theta + angle)) or sin(m (theta + angle)) in cos(m theta) and sin(m theta).
            const double cosine = terms_[j].m >= 0 ? c : s, sine = terms_[j].m >= 0 ? -s : c;
            even_ = even_ && m % 2 == 0;
            mirrored_ = mirrored_ && (m == 0 || std::abs(sine) < 1e-15);
            add(terms_[j].n, m, edge_[j] * cosine, m == 0 ? 0.0 : edge_[j] * sine);
        }
        survey();
    }

    // OTF at frequency f in units of the cutoff, in the direction of face(). more: nodes beyond those for an OTF error of 1e-4.
    std::complex<double> at(double f, std::size_t more) {
        if (f <= 0.0 || f >= 1.0) {
            return f <= 0.0 ? 1.0 : 0.0;
        }
        if (terms_.empty()) {
            return flat_overlap(f, eps_);
        }
        set_shift(f, more);
        re_ = im_ = 0.0;
        cover();
        const double all = pi * (1.0 - eps_ * eps_);
        return {re_ / all, even_ ? 0.0 : im_ / all};
    }

    // Prepare along() for frequency f in units of the cutoff. more: nodes of each rule beyond those for an OTF error of 1e-4.
    void set_shift(double f, std::size_t more) {
        f_ = f;
        more_ = more;
        across_ = 2.0 * std::min(steepest_, f * bend_along_);
        down_ = 2.0 * std::min(steepest_, f * bend_across_);
        shift();
    }

    // Larger of the estimated maxima of |dD/du| and |dD/dy|, in radians per radius of the aperture. D(u, y): phase of the integrand
    // of the OTF (top of the file), with u the coordinate along the frequency and y that perpendicular to it.
    double run() const { return std::max(across_, down_); }

    // Estimated number of nodes of at(f), a measure of its time.
    double price(double f) const {
        const double across = 2.0 * std::min(steepest_, f * bend_along_), down = 2.0 * std::min(steepest_, f * bend_across_);
        const double end = std::acos(f), height = std::sqrt((1.0 - f) * (1.0 + f));
        return (even_ || mirrored_ ? 1.0 : 2.0) * (25.0 + 0.2 * across * (1.0 - f)) *
               (25.0 + 0.25 * end * (across * height + down)) * (eps_ > 0.0 ? 1.7 : 1.0);
    }

    // Integral of exp(i D(u, y)) over u from `low` to `high`, with D(u, y) as for run().
    std::complex<double> along(double y, double low, double high) {
        re_ = im_ = 0.0;
        pieces(across_ * (high - low), [&](const Rule& rule, double first, double part) {
            add_line(rule, y, low + first * (high - low), part * (high - low), part * (high - low));
        });
        return {re_, im_};
    }

    // Phase of the pupil, x along the frequency. powers(): coefficients [power of x][power of y] to degree(); slope(): estimated
    // largest gradient.
    const std::array<Line, most + 1>& powers() const { return powers_; }
    double slope() const { return steepest_; }
    std::size_t degree() const { return degree_; }

    // Gauss-Legendre rule on [0, 1].
    struct Rule {
        Doubles x, w;  // nodes and weights, padded with weights of 0
        std::size_t nodes;
    };
    static const Rule& rule(std::size_t nodes) {
        static thread_local std::map<std::size_t, Rule> rules;
        Rule& made = rules[nodes];
        if (made.x.empty()) {
            made.nodes = nodes;
            made.x.assign(nodes + widest_step, 0.5);
            made.w.assign(nodes + widest_step, 0.0);
            gauss_legendre(nodes, made.x.data(), made.w.data());
            for (std::size_t k = 0; k < nodes; ++k) {
                made.x[k] = 0.5 + 0.5 * made.x[k];
                made.w[k] *= 0.5;
            }
        }
        return made;
    }

   private:
    static constexpr std::size_t size = most + 1;

    // Call use(rule, start, length) for equal pieces of [0, 1], with a rule for the change of phase on one piece. radians: change
    // over [0, 1].
    template <class Use>
    void pieces(double radians, Use use) const {
        const std::size_t count = 1 + static_cast<std::size_t>(radians / 600.0);
        const double each = radians / static_cast<double>(count), part = 1.0 / static_cast<double>(count);
        const std::size_t wanted = static_cast<std::size_t>(6.0 + 0.25 * each + 1.3 * std::cbrt(each)) + more_;
        const Rule& chosen = rule((wanted + 3) / 4 * 4);
        for (std::size_t k = 0; k < count; ++k) {
            use(chosen, static_cast<double>(k) * part, part);
        }
    }

    // Add the Zernike term R_n^m(rho) (c cos(m theta) + s sin(m theta)) to the coefficients of x^i y^j; n = degree.
    void add(std::int32_t degree, int m, double c, double s) {
        const int n = degree;
        for (int k = 0; 2 * k <= n - m; ++k) {
            const double radial =
                (k % 2 == 0 ? 1.0 : -1.0) * std::tgamma(n - k + 1.0) /
                (std::tgamma(k + 1.0) * std::tgamma((n + m) / 2 - k + 1.0) * std::tgamma((n - m) / 2 - k + 1.0));
            const int squares = (n - m) / 2 - k;  // power of x^2 + y^2
            for (int p = 0; p <= squares; ++p) {
                for (int q = 0; q <= m; ++q) {
                    // Term of (x^2 + y^2)^squares (x + i y)^m: C(squares, p) C(m, q) i^q x^(2 squares - 2 p + m - q) y^(2 p + q).
                    const double part = radial * choose_of(squares, p) * choose_of(m, q) * (q % 4 < 2 ? 1.0 : -1.0);
                    powers_[static_cast<std::size_t>(2 * (squares - p) + m - q)][static_cast<std::size_t>(2 * p + q)] +=
                        part * (q % 2 == 0 ? c : s);
                }
            }
        }
    }
    static double choose_of(int n, int k) {
        return std::round(std::tgamma(n + 1.0) / (std::tgamma(k + 1.0) * std::tgamma(n - k + 1.0)));
    }

    // Estimate the maxima of |grad Phi|, |d^2 Phi / dx^2| and |d^2 Phi / dx dy| from samples of the pupil's phase Phi.
    void survey() {
        steepest_ = bend_along_ = bend_across_ = 0.0;
        for (std::size_t i = 0; i <= 8; ++i) {
            const double rho = eps_ + (1.0 - eps_) * static_cast<double>(i) / 8.0;
            for (std::size_t k = 0; k < 24; ++k) {
                const double theta = 6.283185307179586 * static_cast<double>(k) / 24.0;
                const double x = rho * std::cos(theta), y = rho * std::sin(theta);
                // Horner's rule in x: value, first derivative, half the second derivative.
                double along[3] = {}, down[2] = {};
                for (std::size_t a = degree_ + 1; a-- > 0;) {
                    double value = 0.0, slope = 0.0;  // value and y derivative of the coefficient of x^a
                    for (std::size_t b = degree_ - a + 1; b-- > 0;) {
                        slope = slope * y + (b < degree_ - a ? static_cast<double>(b + 1) * powers_[a][b + 1] : 0.0);
                        value = value * y + powers_[a][b];
                    }
                    along[2] = along[2] * x + along[1];
                    along[1] = along[1] * x + along[0];
                    along[0] = along[0] * x + value;
                    down[1] = down[1] * x + down[0];
                    down[0] = down[0] * x + slope;
                }
                steepest_ = std::max(steepest_, 1.05 * std::hypot(along[1], down[0]));
                bend_along_ = std::max(bend_along_, 2.1 * std::abs(along[2]));
                bend_across_ = std::max(bend_across_, 1.05 * std::abs(down[1]));
            }
        }
    }

    // Coefficients [power of u][power of y] of the integrand's phase D(u, y) = Phi(u - f, y) - Phi(u + f, y).
    void shift() {
        for (std::size_t p = 0; p < degree_; ++p) {
            Line& row = shifted_[p];
            row.fill(0.0);
            double power = f_, ways = static_cast<double>(p + 1);  // f^(i - p) and the binomial coefficient C(i, p)
            for (std::size_t i = p + 1; i <= degree_; ++i) {
                if ((i - p) % 2 == 1) {
                    for (std::size_t j = 0; i + j <= degree_; ++j) {
                        row[j] -= 2.0 * ways * power * powers_[i][j];
                    }
                }
                power *= f_;
                ways *= static_cast<double>(i + 1) / static_cast<double>(i + 1 - p);
            }
        }
    }

    // Integrate over the overlap along lines of constant y: its upper half, and the lower half unless that follows by symmetry.
    void cover() {
        const double end = 2.0 * std::asin(std::sqrt(0.5 * (1.0 - f_))), top = std::sqrt((1.0 - f_) * (1.0 + f_));
        panel(std::asin(std::min(eps_, top)), end, 1.0);
        if (eps_ > 0.0) {
            // Arcs meet where the rim of one aperture crosses the obscuration of the other, and where the two obscurations cross.
            const double last = std::asin(std::min(1.0, top / eps_));
            const double meets = std::abs(f_ - (1.0 - eps_ * eps_) / (4.0 * f_));
            std::array<double, 4> edges{0.0, std::min(last, std::acos(std::min(1.0, meets / eps_))),
                                        std::min(last, std::acos(std::min(1.0, f_ / eps_))), last};
            std::sort(edges.begin(), edges.end());
            for (std::size_t k = 0; k < 3; ++k) {
                panel(edges[k], edges[k + 1], eps_);
            }
        }
    }

    // Integrate over the lines of constant y = radius sin(theta), with theta from `first` to `last`.
    void panel(double first, double last, double radius) {
        if (!(last > first)) {
            return;
        }
        // Bounds on derivatives with respect to theta: `move` for the ends of a line of constant y, `rise` for y.
        const double move = radius * (radius == 1.0 ? std::sin(last) : 1.0), rise = radius * std::cos(first);
        pieces((last - first) * (across_ * move + down_ * rise), [&](const Rule& rule, double start, double part) {
            rows(rule, first + start * (last - first), part * (last - first), radius);
        });
    }

    // Add the integrals along the lines of constant y at the nodes of `rule` for theta from `first` to first + length.
    void rows(const Rule& rule, double first, double length, double radius) {
        for (std::size_t k = 0; k < rule.nodes; ++k) {
            const double theta = first + length * rule.x[k];
            const double y = radius * std::sin(theta), rim = std::sqrt((1.0 - y) * (1.0 + y));
            const double weight = length * rule.w[k] * radius * std::cos(theta);
            const auto between = [&](double low, double high) {
                if (high > low) {
                    line(y, low, high, weight);
                }
            };
            if (radius == 1.0) {  // lines above the obscurations
                between(f_ - rim, rim - f_);
                continue;
            }
            const double hole = eps_ * std::cos(theta);
            const double right[2][2] = {{f_ - rim, f_ - hole}, {f_ + hole, f_ + rim}};
            const double left[2][2] = {{-f_ - rim, -f_ - hole}, {-f_ + hole, -f_ + rim}};
            for (const auto& a : right) {
                for (const auto& b : left) {
                    between(std::max(a[0], b[0]), std::min(a[1], b[1]));
                }
            }
        }
    }

    void line(double y, double low, double high, double weight) {
        // If the pupil's phase is even, rotation by half a turn gives the conjugate integrand; if it is symmetric in y, reflection
        // in y leaves the integrand unchanged. Either symmetry gives the lower half.
        const bool once = even_ || mirrored_;
        const double times = (once ? 2.0 : 1.0) * weight * (high - low);
        pieces(across_ * (high - low), [&](const Rule& rule, double first, double part) {
            add_line(rule, y, low + first * (high - low), part * (high - low), part * times);
            if (!once) {
                add_line(rule, -y, low + first * (high - low), part * (high - low), part * times);
            }
        });
    }

    void add_line(const Rule& rule, double y, double low, double width, double weight) {
        Line c;
        for (std::size_t p = 0; p < degree_; ++p) {
            double sum = 0.0;
            for (std::size_t j = degree_ - p; j-- > 0;) {
                sum = sum * y + shifted_[p][j];
            }
            c[p] = sum;
        }
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            using I = decltype(isa);
            using V = typename I::pack;
            V re = splat<V>(0.0), im = re;
            for (std::size_t k = 0; k < rule.nodes; k += I::lanes) {
                const V u = splat<V>(low) + splat<V>(width) * load<V>(&rule.x[k]), w = load<V>(&rule.w[k]);
                V d = splat<V>(c[degree_ - 1]), sine, cosine;
                for (std::size_t p = degree_ - 1; p-- > 0;) {
                    d = d * u + splat<V>(c[p]);
                }
                sincos(isa, d, sine, cosine);
                re = re + w * cosine;
                im = im + w * sine;
            }
            re_ += weight * lane_sum(re);
            im_ += weight * lane_sum(im);
        });
    }

    double eps_;
    std::vector<ZernikeTerm> terms_;
    std::vector<double> edge_;
    std::size_t degree_ = 1, more_ = 0;
    std::array<Line, size> powers_{}, shifted_{};  // coefficients of Phi and of D, [power of x or u][power of y]
    bool even_ = true, mirrored_ = true;  // is Phi even under half a turn; is it symmetric in y
    double steepest_ = 0.0, bend_along_ = 0.0, bend_across_ = 0.0;
    double across_ = 0.0, down_ = 0.0;  // estimated bounds on |dD/du| and |dD/dy|
    double f_ = 0.0, re_ = 0.0, im_ = 0.0;
};

}  // namespace lommel
