// Moments of an aperture: integrals over it of an orthonormal basis of polynomials on the unit disk (docs/certificate.md, section 18,
// "Moments").
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lommel/base/aligned.hpp"
#include "lommel/base/pi.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/base/watch.hpp"

namespace lommel {

// Basis P_k(t) G_km(y), k + m <= degree, with t = x / sqrt(1 - y^2): orthonormal Legendre polynomials P_k on [-1, 1], and products
// G_km of (1 - y^2)^(k/2) with Gegenbauer polynomials of degree m, orthonormal with the weight sqrt(1 - y^2) (T. Koornwinder 1975).
class DiskBasis {
   public:
    explicit DiskBasis(std::size_t degree) : size_(degree + 1), norm_(size_), beta_(size_ * (size_ + 1)) {
        double area = 0.5 * pi;
        for (std::size_t k = 0; k < size_; ++k) {
            const double order = static_cast<double>(k);
            norm_[k] = 1.0 / std::sqrt(area);
            area *= (order + 1.5) / (order + 2.0);
            for (std::size_t i = 1; i + k <= size_; ++i) {
                const double m = static_cast<double>(i);
                beta_[k * (size_ + 1) + i] = std::sqrt(m * (m + 2.0 * order + 1.0) / (4.0 * (m + order + 1.0) * (m + order)));
            }
        }
    }

    // Sums of the basis over nodes in rows: moments[k][m]. Row i, at y[i], has counts[i] nodes at t, with complex weights.
    void moments(const double* y, const std::int64_t* counts, std::size_t rows, const double* t,
                 const std::complex<double>* weights, std::complex<double>* moments) const {
        const std::size_t stride = padded(rows);
        Places places(y, rows);
        Doubles along(2 * size_ * stride, 0.0);  // sums of Legendre polynomials along rows: [k][re, im][row]
        dispatch_widest([&](auto) LOMMEL_INLINE_LAMBDA {
            Doubles sums(2 * size_ * lanes);
            for (std::size_t i = 0; i < rows; ++i) {
                look();
                std::fill(sums.begin(), sums.end(), 0.0);
                const std::size_t count = static_cast<std::size_t>(counts[i]);
                for (std::size_t from = 0; from < count; from += lanes) {
                    double at[lanes] = {}, re[lanes] = {}, im[lanes] = {};
                    for (std::size_t lane = 0; lane < std::min(lanes, count - from); ++lane) {
                        at[lane] = t[from + lane];
                        re[lane] = weights[from + lane].real();
                        im[lane] = weights[from + lane].imag();
                    }
                    legendre(at, [&](std::size_t k, const double* p) LOMMEL_INLINE_LAMBDA {
                        double* const to = sums.data() + 2 * k * lanes;
                        for (std::size_t lane = 0; lane < lanes; ++lane) {
                            to[lane] += p[lane] * re[lane];
                            to[lanes + lane] += p[lane] * im[lane];
                        }
                    });
                }
                for (std::size_t part = 0; part < 2 * size_; ++part) {
                    along[part * stride + i] = total(sums.data() + part * lanes);
                }
                t += count;
                weights += count;
            }
            for (std::size_t k = 0; k < size_; ++k) {
                look();
                const double *re = along.data() + 2 * k * stride, *im = re + stride;
                std::fill(sums.begin(), sums.end(), 0.0);
                for (std::size_t from = 0; from < stride; from += lanes) {
                    gegenbauer(k, places, from, [&](std::size_t m, const double* g) LOMMEL_INLINE_LAMBDA {
                        double* const to = sums.data() + 2 * m * lanes;
                        for (std::size_t lane = 0; lane < lanes; ++lane) {
                            to[lane] += g[lane] * re[from + lane];
                            to[lanes + lane] += g[lane] * im[from + lane];
                        }
                    });
                }
                for (std::size_t m = 0; m + k < size_; ++m) {
                    moments[k * size_ + m] = {total(sums.data() + 2 * m * lanes), total(sums.data() + (2 * m + 1) * lanes)};
                }
            }
        });
    }

    // Values of the sum over the basis times moments[k * stride + m] at the points (t[j] sqrt(1 - y[i]^2), y[i]): values[i][j].
    void values(const std::complex<double>* moments, std::size_t stride, const double* y, std::size_t rows, const double* t,
                std::size_t nodes, std::complex<double>* values) const {
        const std::size_t room = padded(rows), width = padded(nodes);
        Doubles across(2 * size_ * room), along(size_ * width);  // [k][re, im][row]; [k][node]
        Places places(y, rows);
        dispatch_widest([&](auto) LOMMEL_INLINE_LAMBDA {
            for (std::size_t k = 0; k < size_; ++k) {
                look();
                for (std::size_t from = 0; from < room; from += lanes) {
                    double re[lanes] = {}, im[lanes] = {};
                    gegenbauer(k, places, from, [&](std::size_t m, const double* g) LOMMEL_INLINE_LAMBDA {
                        const std::complex<double> by = moments[k * stride + m];
                        for (std::size_t lane = 0; lane < lanes; ++lane) {
                            re[lane] += g[lane] * by.real();
                            im[lane] += g[lane] * by.imag();
                        }
                    });
                    std::copy_n(re, lanes, across.data() + 2 * k * room + from);
                    std::copy_n(im, lanes, across.data() + (2 * k + 1) * room + from);
                }
            }
            for (std::size_t from = 0; from < width; from += lanes) {
                double at[lanes] = {};
                for (std::size_t lane = 0; lane < std::min(lanes, nodes - from); ++lane) {
                    at[lane] = t[from + lane];
                }
                legendre(at, [&](std::size_t k, const double* p)
                                 LOMMEL_INLINE_LAMBDA { std::copy_n(p, lanes, along.data() + k * width + from); });
            }
            Doubles sums(2 * width);
            for (std::size_t i = 0; i < rows; ++i) {
                look();
                std::fill(sums.begin(), sums.end(), 0.0);
                double *re = sums.data(), *im = re + width;
                for (std::size_t k = 0; k < size_; ++k) {
                    const double a = across[2 * k * room + i], b = across[(2 * k + 1) * room + i];
                    const double* const p = along.data() + k * width;
                    for (std::size_t j = 0; j < width; ++j) {
                        re[j] += a * p[j];
                        im[j] += b * p[j];
                    }
                }
                for (std::size_t j = 0; j < nodes; ++j) {
                    values[i * nodes + j] = {re[j], im[j]};
                }
            }
        });
    }

   private:
    static constexpr std::size_t lanes = 8;

    static std::size_t padded(std::size_t count) { return (count + lanes - 1) / lanes * lanes; }
    LOMMEL_INLINE static double total(const double* sums) {
        double sum = 0.0;
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            sum += sums[lane];
        }
        return sum;
    }

    // Places y, padded by zeros, and (1 - y^2)^(k/2), which gegenbauer() moves on to the next k.
    struct Places {
        Doubles y, end, power;

        Places(const double* at, std::size_t count) : y(at, at + count), end(padded(count)), power(end.size(), 1.0) {
            y.resize(end.size(), 0.0);
            std::transform(y.begin(), y.end(), end.begin(), [](double v) { return std::sqrt((1.0 - v) * (1.0 + v)); });
        }
    };

    // Call visit(k, values[lane]) for P_k at t[lane].
    template <class F>
    LOMMEL_INLINE void legendre(const double* t, const F& visit) const {
        double before[lanes] = {}, here[lanes], value[lanes];
        std::fill_n(here, lanes, 1.0);
        for (std::size_t k = 0; k < size_; ++k) {
            const double order = static_cast<double>(k), scale = std::sqrt(order + 0.5);
            const double once = (2.0 * order + 1.0) / (order + 1.0), twice = order / (order + 1.0);
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                value[lane] = scale * here[lane];
                const double next = once * t[lane] * here[lane] - twice * before[lane];
                before[lane] = here[lane];
                here[lane] = next;
            }
            visit(k, value);
        }
    }

    // Call visit(m, values[lane]) for G_km at the places from `from` on; to be called for k = 0, 1, ... in turn.
    template <class F>
    LOMMEL_INLINE void gegenbauer(std::size_t k, Places& places, std::size_t from, const F& visit) const {
        const double* const beta = beta_.data() + k * (size_ + 1);
        const double* const y = places.y.data() + from;
        double before[lanes] = {}, here[lanes];
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            here[lane] = norm_[k] * places.power[from + lane];
            places.power[from + lane] *= places.end[from + lane];
        }
        for (std::size_t m = 0; m + k < size_; ++m) {
            visit(m, here);
            const double back = beta[m], over = 1.0 / beta[m + 1];
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                const double next = (y[lane] * here[lane] - back * before[lane]) * over;
                before[lane] = here[lane];
                here[lane] = next;
            }
        }
    }

    std::size_t size_;  // degree + 1
    std::vector<double> norm_, beta_;  // G_k0 at y = 0; coefficients of the recurrence in m: [k][m]
};

}  // namespace lommel
