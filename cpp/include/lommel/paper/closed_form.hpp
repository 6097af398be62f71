// The paper's closed form, refined: Hankel's expansion beyond a transition, its amplitude and the phase by quadratics on
// pieces, every piece an elementary end-point term and a Fresnel integral.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <vector>

#include "lommel/base/watch.hpp"
#include "lommel/limits.hpp"
#include "lommel/special/fresnel.hpp"
#include "lommel/special/legendre.hpp"

namespace lommel {

// alpha R^2 + beta R + gamma on [edges[i], edges[i + 1]), R from 0 to 1.
struct PhasePieces {
    const double *edges, *alpha, *beta, *gamma;
    std::size_t count;
};

// x J0(x) ~ Re[(c0 + c1 x + c2 x^2) e^{i (x - pi/4)}] on pieces of x from the transition on: the paper's tangent line, made
// as good as one likes. x sqrt(2 / (pi x)) (P + i Q) is interpolated at the Chebyshev points of geometric pieces.
class HankelPieces {
   public:
    std::vector<double> edges;
    std::vector<std::array<std::complex<double>, 3>> coefficients;

    HankelPieces(double transition, double ratio, double reach, std::size_t terms) {
        edges.push_back(transition);
        while (edges.back() < reach) {
            look();
            const double low = edges.back(), high = low * ratio;
            std::array<double, 3> x;
            std::array<std::complex<double>, 3> f;
            for (std::size_t j = 0; j < 3; ++j) {
                // cos(pi (2j + 1) / 6) = 0.866, 0, -0.866
                x[j] = 0.5 * (low + high) - 0.5 * (high - low) * 0.86602540378443864676 * (1.0 - static_cast<double>(j));
                f[j] = std::sqrt(two_over_pi * x[j]) * series(x[j], terms);
            }
            const std::complex<double> first = (f[1] - f[0]) / (x[1] - x[0]), second = (f[2] - f[1]) / (x[2] - x[1]);
            const std::complex<double> c2 = (second - first) / (x[2] - x[0]), c1 = first - c2 * (x[0] + x[1]);
            coefficients.push_back({f[0] - (c1 + c2 * x[0]) * x[0], c1, c2});
            edges.push_back(high);
        }
    }

   private:
    static constexpr double two_over_pi = 0.63661977236758134308;

    // P + i Q of order 0 (DLMF 10.17): sum_k (i / x)^k a_k with a_k = prod (-(2j-1)^2) / (8 j).
    static std::complex<double> series(double x, std::size_t terms) {
        std::complex<double> sum = 1.0, term = 1.0;
        for (std::size_t k = 1; k < terms; ++k) {
            const double odd = 2.0 * static_cast<double>(k) - 1.0;
            term *= std::complex<double>(0.0, -odd * odd / (8.0 * static_cast<double>(k) * x));
            sum += term;
        }
        return sum;
    }
};

class ClosedFormField {
   public:
    ClosedFormField(const PhasePieces& phase, const HankelPieces& hankel) : phase_(phase), hankel_(hankel) {
        nodes_.resize(node_count);
        weights_.resize(node_count);
        gauss_legendre(node_count, nodes_.data(), weights_.data());
    }

    // U(v) = 2 int_0^1 exp(i Phi) J0(v R) R dR.
    std::complex<double> operator()(double v) const {
        const double transition = hankel_.edges.front();
        const double split = v > transition ? transition / v : 1.0;
        std::complex<double> sum = 0.0;
        std::size_t piece = 0;
        for (std::size_t i = 0; i < phase_.count; ++i) {
            look();
            const double low = phase_.edges[i], high = phase_.edges[i + 1];
            if (low < split) {
                sum += inner(v, i, low, std::min(high, split));
            }
            double from = std::max(low, split);
            while (from < high) {
                while (piece + 1 < hankel_.coefficients.size() && hankel_.edges[piece + 1] <= from * v * (1.0 + 1e-15)) {
                    ++piece;
                }
                const bool last = piece + 1 == hankel_.coefficients.size();
                // Rounding must not keep the same place from being left.
                const double to =
                    std::max(last ? high : std::min(high, hankel_.edges[piece + 1] / v), std::nextafter(from, 2.0));
                sum += outer(v, i, piece, from, to);
                from = to;
            }
        }
        return 2.0 * sum;
    }

   private:
    static constexpr std::size_t node_count = 12;

    // Calls add(R, weight) for the nodes of a Gauss rule on panels of at most six radians each.
    template <class Add>
    void integrate(double low, double high, double span, const Add& add) const {
        if (!(span <= 4.0 * (max_phase + max_reach))) {
            throw LimitExceeded("phases and radii this large take more panels of quadrature than there may be");
        }
        const std::size_t panels = static_cast<std::size_t>(span / 6.0) + 1;
        const double width = (high - low) / static_cast<double>(panels);
        Glance glance;
        for (std::size_t p = 0; p < panels; ++p) {
            glance(64 * node_count);
            const double middle = low + (static_cast<double>(p) + 0.5) * width;
            for (std::size_t k = 0; k < node_count; ++k) {
                add(middle + 0.5 * width * nodes_[k], 0.5 * width * weights_[k]);
            }
        }
    }

    // Within the transition, by Gauss quadrature of the power series.
    std::complex<double> inner(double v, std::size_t i, double low, double high) const {
        const double a = phase_.alpha[i], b = phase_.beta[i];
        std::complex<double> sum = 0.0;
        integrate(low, high, (std::abs(a) * (low + high) + std::abs(b) + v) * (high - low), [&](double r, double weight) {
            const double angle = (a * r + b) * r + phase_.gamma[i];
            sum += weight * r * power_series(v * r) * std::complex<double>(std::cos(angle), std::sin(angle));
        });
        return sum;
    }

    static double power_series(double x) {
        const double q = -0.25 * x * x;
        double term = 1.0, sum = 1.0;
        for (int m = 1; m < 60; ++m) {
            term *= q / (static_cast<double>(m) * static_cast<double>(m));
            sum += term;
            if (std::abs(term) < 1e-17) {
                break;
            }
        }
        return sum;
    }

    std::complex<double> outer(double v, std::size_t i, std::size_t piece, double low, double high) const {
        // R J0(v R) = x J0(x) / v, of the real part half from each of e^{+-i(x - pi/4)}.
        static const std::complex<double> turn(0.70710678118654752440, -0.70710678118654752440);
        const auto& c = hankel_.coefficients[piece];
        std::complex<double> sum = 0.0;
        for (const double sign : {1.0, -1.0}) {
            std::complex<double> moments[3];
            chirp(phase_.alpha[i], phase_.beta[i] + sign * v, low, high, moments);
            std::complex<double> part = 0.0;
            double power = 1.0;
            for (std::size_t k = 0; k < 3; ++k, power *= v) {
                part += (sign > 0.0 ? c[k] : std::conj(c[k])) * power * moments[k];
            }
            sum += (sign > 0.0 ? turn : std::conj(turn)) * part;
        }
        const double g = phase_.gamma[i];
        return 0.5 / v * sum * std::complex<double>(std::cos(g), std::sin(g));
    }

    // int_low^high R^m exp(i (a R^2 + b R)) dR, m = 0, 1, 2.
    void chirp(double a, double b, double low, double high, std::complex<double>* moments) const {
        if (a < 0.0) {
            chirp(-a, -b, low, high, moments);
            for (int m = 0; m < 3; ++m) {
                moments[m] = std::conj(moments[m]);
            }
            return;
        }
        const double h = high - low;
        const double span = (a * (low + high) + std::abs(b)) * h;
        if (span < 6.0 || a * h * h < 1e-3) {
            moments[0] = moments[1] = moments[2] = 0.0;
            return integrate(low, high, span, [&](double r, double weight) {
                const double angle = (a * r + b) * r;
                const std::complex<double> wave = weight * std::complex<double>(std::cos(angle), std::sin(angle));
                moments[0] += wave;
                moments[1] += r * wave;
                moments[2] += r * r * wave;
            });
        }
        const double root = std::sqrt(a), shift = b / (2.0 * a);
        const double s[2] = {root * (low + shift), root * (high + shift)};
        const double r[2] = {low, high};
        std::complex<double> end[2], part[2];
        for (int j = 0; j < 2; ++j) {
            const double angle = (a * r[j] + b) * r[j];
            end[j] = std::complex<double>(std::cos(angle), std::sin(angle));
            part[j] = (s[j] < 0.0 ? -1.0 : 1.0) * end[j] * fresnel_->at(std::abs(s[j]));
        }
        std::complex<double> zeroth = part[0] - part[1];
        if (s[0] < 0.0 && s[1] >= 0.0) {
            // The stationary point lies inside.
            const double angle = -b * shift / 2.0;
            zeroth += 2.0 * FresnelAuxiliary::half() * std::complex<double>(std::cos(angle), std::sin(angle));
        }
        zeroth /= root;
        const std::complex<double> by(0.0, -0.5 / a);  // 1 / (2 i a)
        moments[0] = zeroth;
        moments[1] = by * (end[1] - end[0]) - shift * zeroth;
        moments[2] = by * (high * end[1] - low * end[0] - zeroth) - shift * moments[1];
    }

    PhasePieces phase_;
    const HankelPieces& hankel_;
    std::shared_ptr<const FresnelAuxiliary> fresnel_ = FresnelAuxiliary::get();
    std::vector<double> nodes_, weights_;
};

// |U|^2 at v from 16 Chebyshev coefficients of U on each piece of the v axis, by Clenshaw's recurrence.
inline void chebyshev_intensity(const std::complex<double>* pieces, std::size_t count, double width, const double* v,
                                std::size_t n, double* intensity) {
    constexpr std::size_t terms = 16;
    const double last = static_cast<double>(count - 1);
    Glance glance;
    for (std::size_t i = 0; i < n; ++i) {
        glance(2 * terms);
        const std::size_t s = static_cast<std::size_t>(std::min(v[i] / width, last));
        const double x = 2.0 * (v[i] / width - static_cast<double>(s)) - 1.0;
        const std::complex<double>* c = pieces + s * terms;
        double re1 = 0.0, re2 = 0.0, im1 = 0.0, im2 = 0.0;
        for (std::size_t k = terms; k-- > 1;) {
            const double re = c[k].real() + 2.0 * x * re1 - re2, im = c[k].imag() + 2.0 * x * im1 - im2;
            re2 = re1;
            re1 = re;
            im2 = im1;
            im1 = im;
        }
        const double re = c[0].real() + x * re1 - re2, im = c[0].imag() + x * im1 - im2;
        intensity[i] = re * re + im * im;
    }
}

}  // namespace lommel
