// Tables of a window, by which averages of far pixels are computed from the Fourier coefficients of pupils on their rims
// (certificate, section 10, "From the rim").
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lommel/pixels/window_nodes.hpp"
#include "lommel/bounds/strips.hpp"
#include "lommel/bounds/transfer_rule.hpp"
#include "lommel/base/cache.hpp"
#include "lommel/base/pi.hpp"
#include "lommel/base/product.hpp"
#include "lommel/chordal/tables.hpp"
#include "lommel/rim/slopes.hpp"
#include "lommel/special/chebyshev.hpp"
#include "lommel/special/legendre.hpp"
#include "lommel/special/sincos.hpp"

namespace lommel {

constexpr std::size_t rim_radii_tile = 3, rim_angles_tile = 3, rim_orders_tile = 6, rim_points_tile = 6;
// Fields near a pixel are interpolated between this many polar angles at most.
constexpr std::size_t rim_most_turns = 10;

// Parameters that determine a RimTable.
struct RimWindow {
    double step;           // pixel pitch, in lambda / (2 pi NA) like the radius v
    std::size_t box;       // side in pixels, odd, of the box around the axis; pixels outside are far
    std::size_t reach;     // distance from the axis to the farthest pixel along an axis, in pixels
    double obscuration;
    std::size_t degree;    // largest degree of Zernike terms
    double error;          // allowed error of averages due to interpolation
    // Fields at points of pixels are wanted, for averages behind these strips, of pupils whose phases have slopes up to about `slope`
    // around the rims.
    std::vector<Strip> strips;
    double slope;

    bool operator==(const RimWindow& other) const {
        return step == other.step && box == other.box && reach == other.reach && obscuration == other.obscuration &&
               degree == other.degree && error == other.error && strips == other.strips && slope == other.slope;
    }
    double nearest() const { return 0.5 * static_cast<double>(box) * step; }
    bool fields() const { return !strips.empty(); }
};

// Waves from one rim: of the aperture (radius 1), or of the obscuration, for which v is `radius` times the image radius.
struct RimWaves {
    double radius = 1.0, weight = 1.0;  // radius of the rim; factor of its waves
    std::size_t orders = 0;  // largest order |mu| of the Fourier coefficients in use
    std::size_t angles = 0;  // number of equally spaced angles on the rim
    std::size_t first = 0;  // wave i < count() has the azimuthal order i - first
    // Factors of the Fourier coefficients in X (`real`) and Y (`imaginary`), amplitudes of the field U:
    // v^(3/2) U = X (e^iv + e^-iv) + i Y (e^iv - e^-iv).
    // Indices: [wave][tile of radii][k][radius in the tile]; k: order of the derivative of the pupil function at the rim.
    Floats real, imaginary;
    Floats forward[4];  // cos, sin on the rim, for each kind of fold(): [tile of orders][angle][order in the tile]
    Floats back[4];  // cos, sin in the image, for each kind of fold(): [tile of angles][order][angle in the tile]
    Floats size[2];  // [ellipse]: bound on the wave of a Fourier coefficient of 1, [k][mu + orders]
    // If fields are wanted, [n]: largest modulus of the wave at the radii, for a Fourier coefficient of 1, times (its order)^(n + 1).
    Floats turned[rim_most_turns];

    std::size_t count() const { return 2 * orders + rim_orders; }
    // Number of even (odd = 0) or odd (odd = 1) orders n >= 0; order -n is combined with n.
    std::size_t halves(std::size_t odd) const { return (orders + rim_orders - 1 + 2 - odd) / 2; }
};

// Far pixels with the same weights: those at (+-p, +-q) and (+-q, +-p) pixels from the axis, p >= q >= 0.
struct RimPixels {
    std::size_t p, q;
    std::size_t from, used;  // weights[radius], from index `from` on: [angle][channel]; used: number of channels
    std::ptrdiff_t begin;  // index of the first angle with a weight
    std::size_t count;  // number of angles with a weight
    // RimTable::off_angles, off_radii, gain and dropped of these pixels alone.
    double off_angles = 0.0, gain = 0.0, dropped = 0.0;
    std::array<double, 2> off_radii{};
    // Fields at points: number of places along the radius and of polar angles near the pixel; indices in RimTable::starts,
    // ::parts and ::local; errors by interpolation between these angles, over RimErrors::turned of their number, and between these
    // places, over either RimSums::size or the root of the largest channel 0 times the number of waves.
    std::size_t places = 0, turns = 0, turn = 0, part = 0, place = 0;
    double off_turns = 0.0;
    std::array<double, 3> off_places{};

    // Row and column, from the axis, of the image of the pixel (row q, column p) after a number of quarter turns; turned: of its
    // mirror image.
    std::array<std::int64_t, 2> image(bool turned, std::size_t quarters) const {
        const std::int64_t a = static_cast<std::int64_t>(p), b = static_cast<std::int64_t>(q);
        const std::array<std::int64_t, 2> images[2][4] = {{{b, a}, {a, -b}, {-b, -a}, {-a, b}},
                                                          {{-b, a}, {a, b}, {b, -a}, {-a, -b}}};
        return images[turned ? 1 : 0][quarters];
    }
    std::size_t mirrors() const { return q == 0 || q == p ? 1 : 2; }
};

// Weights of `taps` angles, `apart` rad from each other, for interpolation between the middle two: a least-squares fit, for the
// functions exp(i m t) of the angle t, over all orders |m| <= `most`.
class AngleWeights {
   public:
    static constexpr std::size_t most_taps = 12;  // a multiple of the lanes of vectors
    double shares[most_taps] = {};
    // sine, cosine: of t / 2; fast_sine, fast_cosine: of (most + 1/2) t; t is the angle from the first tap.
    struct Turn {
        double sine, cosine, fast_sine, fast_cosine;
    };

    AngleWeights(std::size_t taps, double most, double apart) : taps_(taps), order_(most), apart_(apart) {
        for (std::size_t i = 0; i < taps; ++i) {
            const double angle = static_cast<double>(i) * apart;
            turns_[0][i] = std::cos((most + 0.5) * angle);
            turns_[1][i] = std::sin((most + 0.5) * angle);
            turns_[2][i] = std::cos(0.5 * angle);
            turns_[3][i] = std::sin(0.5 * angle);
            for (std::size_t j = 0; j < taps; ++j) {
                common_[i * most_taps + j] = dirichlet((static_cast<double>(i) - static_cast<double>(j)) * apart);
            }
            inverse_[i * most_taps + i] = 1.0;
        }
        std::vector<double> left(common_, common_ + most_taps * most_taps);
        for (std::size_t i = 0; i < taps; ++i) {
            left[i * most_taps + i] += ridge;
        }
        for (std::size_t i = 0; i < taps; ++i) {  // Gauss-Jordan elimination; no pivoting, as the matrix is positive definite
            const double by = 1.0 / left[i * most_taps + i];
            for (std::size_t j = 0; j < taps; ++j) {
                left[i * most_taps + j] *= by;
                inverse_[i * most_taps + j] *= by;
            }
            for (std::size_t r = 0; r < taps; ++r) {
                const double times = left[r * most_taps + i];
                for (std::size_t j = 0; r != i && j < taps; ++j) {
                    left[r * most_taps + j] -= times * left[i * most_taps + j];
                    inverse_[r * most_taps + j] -= times * inverse_[i * most_taps + j];
                }
            }
        }
    }
    // Angle, from the first tap, of a point at the fraction `part` of the way between the middle two taps.
    double angle(double part) const { return (part + static_cast<double>(taps_ / 2 - 1)) * apart_; }
    // Compute the weights `shares` for one angle; returns the sum over all orders of the squared interpolation errors.
    template <class I>
    LOMMEL_INLINE double find(I isa, const Turn& at) {
        using V = typename I::pack;
        const V sine = splat<V>(at.sine), cosine = splat<V>(at.cosine), fast = splat<V>(at.fast_sine),
                other = splat<V>(at.fast_cosine), all = splat<V>(2.0 * order_ + 1.0), zero = splat<V>(0.0);
        double wanted[most_taps], misfits[most_taps];
        for (std::size_t j = 0; j < taps_; j += I::lanes) {
            const V gap = sine * load<V>(turns_[2] + j) - cosine * load<V>(turns_[3] + j);
            const V value = (fast * load<V>(turns_[0] + j) - other * load<V>(turns_[1] + j)) / gap;
            store(wanted + j, below(larger(gap, zero - gap), splat<V>(1e-9), all, value));
        }
        // Both matrices are symmetric, so that multiply() may read rows as columns.
        multiply(isa, inverse_, wanted, shares);
        multiply(isa, common_, shares, misfits);
        double misfit = 2.0 * order_ + 1.0;
        for (std::size_t j = 0; j < taps_; ++j) {
            misfit += shares[j] * (misfits[j] - 2.0 * wanted[j]);
        }
        return std::max(misfit, 0.0) + 1e-13 * order_;
    }
    double find(double part) {
        const double t = angle(part), fast = (order_ + 0.5) * t;
        return find(Portable{}, {std::sin(0.5 * t), std::cos(0.5 * t), std::sin(fast), std::cos(fast)});
    }

   private:
    static constexpr double ridge = 1e-8;
    template <class I>
    LOMMEL_INLINE void multiply(I, const double* matrix, const double* by, double* to) const {
        using V = typename I::pack;
        constexpr std::size_t vectors = most_taps / I::lanes;  // interleaved, as each sum is a chain of dependent additions
        V sums[vectors];
        std::fill_n(sums, vectors, splat<V>(0.0));
        for (std::size_t j = 0; j < taps_; ++j) {
            const V factor = splat<V>(by[j]);
            for (std::size_t i = 0; i < vectors; ++i) {
                sums[i] = sums[i] + factor * load<V>(matrix + j * most_taps + i * I::lanes);
            }
        }
        for (std::size_t i = 0; i < vectors; ++i) {
            store(to + i * I::lanes, sums[i]);
        }
    }
    double dirichlet(double t) const {
        return std::abs(t) < 1e-9 ? 2.0 * order_ + 1.0 : std::sin((order_ + 0.5) * t) / std::sin(0.5 * t);
    }

    std::size_t taps_;
    double order_, apart_;
    double common_[most_taps * most_taps] = {},
                               inverse_[most_taps * most_taps] = {};  // Dirichlet kernel of taps; inverse of kernel + ridge
    double turns_[4][most_taps] = {};  // cos, sin of (order_ + 1/2) t; cos, sin of t / 2; t: angles of the taps
};

// Barycentric interpolation at Chebyshev points of [low, 1], for functions that are analytic in an ellipse around this interval
// which excludes 0. It may be used at any x in the ellipse.
class RadiusRule {
   public:
    std::vector<double> places, shares;  // places: points; shares: weights for the x last requested
    std::vector<double> barycentric;  // barycentric weights of the points
    double low;

    RadiusRule(double from, std::size_t points) : low(from) {
        for (std::size_t i = 0; i < points; ++i) {
            const double point = chebyshev_point(i, points);
            places.push_back(0.5 * (1.0 + low) + 0.5 * (1.0 - low) * point);
            barycentric.push_back((i % 2 == 0 ? 1.0 : -1.0) * std::sqrt((1.0 - point) * (1.0 + point)));
        }
        shares.resize(points);
    }
    // Sum of the semi-axes of the wide (0) or narrow (1) ellipse around [low, 1], scaled to the interval [-1, 1].
    double rho(std::size_t ellipse) const {
        const double c = (1.0 + low) / (1.0 - low);
        return 1.0 + (ellipse == 0 ? 0.85 : 0.6) * (c + std::sqrt(c * c - 1.0) - 1.0);
    }
    // In the ellipse `rho`: bend(): largest imaginary part of x; largest(): largest modulus of x.
    double bend(double rho) const { return 0.25 * (1.0 - low) * (rho - 1.0 / rho); }
    double largest(double rho) const { return 0.5 * (1.0 + low) + 0.25 * (1.0 - low) * (rho + 1.0 / rho); }
    // Bound on the interpolation error at x for functions that are at most 1 in the ellipse.
    double error(double x, double rho) const {
        // Sum of the errors, after interpolation at n points, of the terms k >= n of the function's Chebyshev series. The coefficient
        // of T_k is at most 2 / rho^k, |T_k(x)| <= out^k, and the interpolant of T_k is +-T_j, j < n, or 0.
        const double t = std::abs((2.0 * x - 1.0 - low) / (1.0 - low)), out = t <= 1.0 ? 1.0 : t + std::sqrt(t * t - 1.0);
        const double ratio = out / rho, power = std::pow(ratio, static_cast<double>(places.size()));
        return ratio >= 1.0 ? 1e300 : 2.0 * power * (1.0 / (1.0 - ratio) + 1.0 / (out * (1.0 - 1.0 / rho)));
    }
    // Compute `shares`, the weights of the values at `places` in the interpolated value at x; return the sum of their moduli.
    LOMMEL_INLINE double at(double x) {
        double all = 0.0, moduli = 0.0;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const double off = x - places[i];
            shares[i] = barycentric[i] / (std::abs(off) < 1e-14 ? 1e-14 : off);
        }
        for (const double share : shares) {
            all += share;
            moduli += std::abs(share);
        }
        for (double& share : shares) {
            share /= all;
        }
        return moduli / std::abs(all);
    }
};

struct RimTable {
    RimWindow window;
    std::vector<RimWaves> rims;
    RadiusRule rule;  // interpolation in x = window.nearest() / v, v being the radius
    // Numbers of angles. around: on a ring; taps: from which a point is interpolated; margin: repeated at either end of a ring.
    std::size_t around = 0, taps = 0, margin = 0;
    std::vector<RimPixels> pixels;
    std::vector<Floats> weights;  // [radius]: weights of all pixels, see RimPixels
    // Error of averages due to interpolation between angles, divided by the rms of channel 0 of rim_channels() around a ring.
    double off_angles = 0.0;
    double gain = 0.0;  // largest sum of the moduli of a pixel's weights, all channels
    // Error of averages due to interpolation between radii, relative to the square of RimSums::size, for each of
    // two Bernstein ellipses of the interpolation.
    std::array<double, 2> off_radii{};
    double off_pixels = 0.0;  // error of averages due to Gauss quadrature over a pixel
    double off_field = 1.0;  // bound: mean of |omitted field|^2 in a pixel / (RimStack::remainders() / v^rim_orders)^2
    double dropped = 0.0;  // error of averages due to omitted channels, relative to the largest value of channel 0
    // If fields are wanted: points of a pixel along an axis, from -1 to 1, and their weights; number of taps around a ring; and
    // of all pixels, see RimPixels. X and Y (RimWaves) at polar angles and places near a pixel are sums over taps of shares[angle][tap]
    // times those of rings, from tap starts[angle] of the pixel on, and over radii of local[place][radius]. Fields at points are sums of
    // parts[tile of points][angle][place][rim][X, Y][point in the tile] times these.
    std::vector<double> point_places, point_weights;
    std::size_t field_taps = 0;
    std::vector<std::int16_t> starts;
    Floats shares, parts, local;
    // Errors of fields: by interpolation between angles, over the sum over rims of 2 (|X|^2 + |Y|^2)^(1/2), each the root mean square
    // around a ring; between radii, over RimSums::size. field_gain: largest sum of moduli of weights; most_parts: number of parts.
    double field_angles = 0.0, field_gain = 0.0;
    // Errors of averages over a pixel from these points: of their frequency response along an axis; of what strips add.
    double off_points = 0.0, off_strips = 0.0;
    std::size_t most_parts = 0;
    std::array<double, 2> field_radii{};

    explicit RimTable(const RimWindow& asked) : window(asked), rule(chosen_rule()) {
        const double nearest = asked.nearest();
        const double eps = asked.obscuration;
        for (const double radius : {1.0, eps}) {
            if (radius > 0.0) {
                const double v = radius * nearest;
                RimWaves rim;
                rim.radius = radius;
                rim.weight = radius == 1.0 ? 1.0 : -std::sqrt(radius);
                rim.orders = static_cast<std::size_t>(std::max(0.0, std::min(0.53 * v + 3.0, 0.85 * v - 1.0)));
                rim.angles = angles_of(asked.degree, rim.orders);
                rim.first = rim.orders + rim_orders - 1;
                rims.push_back(rim);
            }
        }
        choose_angles();
        if (window.fields()) {
            choose_points();
        }
        for (RimWaves& rim : rims) {
            make_waves(rim);
        }
        make_pixels();
    }
    bool is(const RimWindow& asked) const { return window == asked; }
    std::size_t bytes() const {
        std::size_t sum =
            (weights.empty() ? 0 : weights.size() * weights[0].size()) + shares.size() + parts.size() + local.size();
        for (const RimWaves& rim : rims) {
            sum += 2 * rim.real.size();
            for (std::size_t i = 0; i < 4; ++i) {
                sum += rim.forward[i].size() + rim.back[i].size();
            }
        }
        return sum * sizeof(float) + pixels.size() * sizeof(RimPixels);
    }
    static constexpr std::size_t most_bytes = std::size_t{64} << 20;

    std::size_t channels() const { return rims.size() == 1 ? 3 : 9; }
    std::size_t radii() const { return rule.places.size(); }
    std::size_t ring() const { return around + 2 * margin; }  // number of angles, margins included
    // Number N of angles on a rim, a multiple of 4. N > 2 (K - 1) (degree - 1), K = rim_orders, makes means over the rim exact for
    // squared derivatives of a pupil of this degree; N >= 5 m + 8, m = `orders`, makes aliases (of orders beyond N - m) small.
    static std::size_t angles_of(std::size_t degree, std::size_t orders) {
        return (std::max(5 * orders + 8, 2 * (rim_orders - 1) * (degree - 1) + 4) + 3) / 4 * 4;
    }
    // Error of the frequency response of Gauss quadrature over a pixel, along one axis with `points` points. The error of
    // averages of the intensity is at most 3 times this.
    static double pixel_error(double step, std::size_t points) {
        // Least bound, over some Bernstein ellipses, on the error of Gauss quadrature of cos(w step t / 2) over |t| <= 1, for |w| <= 2.
        double least = 1.0;
        for (double rho = 1.2; rho < 60.0; rho *= 1.1) {
            const double size = std::exp(0.5 * step * (rho - 1.0 / rho) - 2.0 * static_cast<double>(points) * std::log(rho));
            least = std::min(least, 64.0 / 15.0 * size / (1.0 - 1.0 / (rho * rho)));
        }
        return least;
    }

   private:
    void make_waves(RimWaves& rim) const {
        const double nearest = rim.radius * window.nearest();
        const std::size_t most = rim.orders + 1;
        // Hankel functions v^(1/2) e^-iv H1_n(v): n = 0 and 1 by Hankel's integral with t = s^2, as a sum in equal steps with an
        // error of exp(-2 pi sqrt(v) / step); larger n by the recurrence, which is stable.
        std::vector<std::vector<std::complex<double>>> hankel;
        for (const double place : rule.places) {
            const double v = nearest / place;
            std::vector<std::complex<double>> h(most + 2);
            for (std::size_t n = 0; n < 2; ++n) {
                constexpr double step = 0.04;
                std::complex<double> sum = n == 0 ? 0.5 : 0.0;
                for (double s = step; s < 7.0; s += step) {
                    const std::complex<double> root = std::sqrt(std::complex<double>(1.0, s * s / (2.0 * v)));
                    sum += std::exp(-s * s) * (n == 0 ? 1.0 / root : s * s * root);
                }
                const double gamma = n == 0 ? std::sqrt(pi) : 0.5 * std::sqrt(pi);
                h[n] = std::sqrt(2.0 / pi) * 2.0 * step / gamma * sum *
                       std::polar(1.0, -pi * (0.5 * static_cast<double>(n) + 0.25));
            }
            for (std::size_t n = 1; n <= most; ++n) {
                h[n + 1] = 2.0 * static_cast<double>(n) / v * h[n] - h[n - 1];
            }
            hankel.push_back(std::move(h));
        }
        // Hankel functions of negative order: H_{-n} = (-1)^n H_n.
        const auto wave = [&](std::size_t radius, std::int32_t n) {
            return n < 0 && n % 2 != 0 ? -hankel[radius][static_cast<std::size_t>(-n)]
                                       : hankel[radius][static_cast<std::size_t>(std::abs(n))];
        };
        const std::int32_t first = static_cast<std::int32_t>(rim.first), orders = static_cast<std::int32_t>(rim.orders);
        rim.real.assign(rim.count() * radii() * rim_orders, 0.0f);
        rim.imaginary = rim.real;
        for (std::size_t i = 0; i < rim.count(); ++i) {
            for_tiles(radii(), rim_radii_tile, [&](std::size_t from, std::size_t size) {
                for (std::size_t k = 0; k < rim_orders; ++k) {
                    const std::int32_t mu = static_cast<std::int32_t>(i) - first + static_cast<std::int32_t>(k);
                    for (std::size_t r = 0; std::abs(mu) <= orders && r < size; ++r) {
                        const double power = std::pow(rule.places[from + r] / nearest, static_cast<double>(k)) * rim_scale(k);
                        const std::complex<double> h = (k % 2 == 0 ? rim.weight : -rim.weight) * power * wave(from + r, mu + 1);
                        const std::size_t at = (i * radii() + from) * rim_orders + k * size + r;
                        rim.real[at] = static_cast<float>(h.real());
                        rim.imaginary[at] = static_cast<float>(h.imag());
                    }
                }
            });
        }
        // Bounds sup[n] on |v^(1/2) e^-iv H1_n(v)| for x = R / v in an ellipse, R = nearest: Hankel's integral over t of the modulus
        // of exp(-t) t^(n - 1/2) (1 + i t x / (2 R))^(n - 1/2), in equal steps of ln t, whose error the factor 1.02 covers.
        for (std::size_t ellipse = 0; ellipse < 2; ++ellipse) {
            const double bend = rule.bend(rule.rho(ellipse)), largest = rule.largest(rule.rho(ellipse));
            std::vector<double> sup(most + 2, 0.0);
            for (std::size_t n = 1; n < sup.size(); ++n) {
                const double power = static_cast<double>(n) - 0.5, gamma = std::lgamma(power + 1.0), apart = 0.05;
                for (double log = -6.0; log < 7.0; log += apart) {
                    const double t = std::exp(log), wide = 0.5 * t * largest / nearest;
                    const double grown = 0.5 * std::log1p(t * bend / nearest + wide * wide);
                    sup[n] += apart * std::exp(-t + power * (log + grown) + log - gamma);
                }
                sup[n] *= 1.02 * std::sqrt(2.0 / pi);
            }
            sup[0] = 2.0 * largest / nearest * sup[1] + sup[2];
            for (std::size_t k = 0; k < rim_orders; ++k) {
                for (std::int32_t mu = -orders; mu <= orders; ++mu) {
                    const double size = 1.00001 * std::abs(rim.weight) * rim_scale(k) *
                                        std::pow(largest / nearest, static_cast<double>(k)) *
                                        sup[static_cast<std::size_t>(std::abs(mu + 1))];
                    rim.size[ellipse].push_back(static_cast<float>(size));
                    if (!window.fields() || ellipse == 1) {
                        continue;
                    }
                    double most_of = 0.0;  // modulus of the wave at the radii
                    for (std::size_t r = 0; r < radii(); ++r) {
                        most_of = std::max(
                            most_of, std::pow(rule.places[r] / nearest, static_cast<double>(k)) * std::abs(wave(r, mu + 1)));
                    }
                    most_of *= 1.00001 * std::abs(rim.weight) * rim_scale(k);
                    for (std::size_t n = 0; n < rim_most_turns; ++n) {
                        rim.turned[n].push_back(
                            static_cast<float>(most_of * std::pow(std::abs(mu - static_cast<std::int32_t>(k)), n + 1)));
                    }
                }
            }
        }
        for (std::size_t kind = 0; kind < 4; ++kind) {
            const std::size_t odd = kind / 2;
            const auto value = [&](std::size_t n, double angle) {
                return static_cast<float>(kind % 2 == 0 ? std::cos(static_cast<double>(n) * angle)
                                                        : std::sin(static_cast<double>(n) * angle));
            };
            const std::size_t quarter = rim.angles / 4, forth = (rim.angles / 2 + 2 - odd) / 2;
            rim.forward[kind].resize(quarter * forth);
            for_tiles(forth, rim_orders_tile, [&](std::size_t from, std::size_t size) {
                for (std::size_t l = 0; l < quarter; ++l) {
                    const double angle = 2.0 * pi * (static_cast<double>(l) + 0.5) / static_cast<double>(rim.angles);
                    for (std::size_t r = 0; r < size; ++r) {
                        rim.forward[kind][from * quarter + l * size + r] = value(2 * (from + r) + odd, angle);
                    }
                }
            });
            const std::size_t halves = rim.halves(odd);
            rim.back[kind].resize(halves * (around / 4));
            for_tiles(around / 4, rim_angles_tile, [&](std::size_t from, std::size_t size) {
                for (std::size_t i = 0; i < halves; ++i) {
                    for (std::size_t r = 0; r < size; ++r) {
                        const double angle = 2.0 * pi * (static_cast<double>(from + r) + 0.5) / static_cast<double>(around);
                        rim.back[kind][from * halves + i * size + r] = value(2 * i + odd, angle);
                    }
                }
            });
        }
    }
    // Highest order, in the polar angle, of the channels of rim_channels(), each a product of two waves.
    double order() const { return static_cast<double>(2 * rims[0].orders + rim_orders - 1); }
    double apart() const { return 2.0 * pi / static_cast<double>(around); }
    // Bound on (sum of the moduli of all channels of rim_channels()) / (channel 0).
    double together() const { return channels() == 3 ? 2.0 : 5.0; }
    // Rule of fewest points that meets window.error for all pixels. The farthest pixels may be outside its interval, as their
    // intensity falls with the cube of the distance.
    RadiusRule chosen_rule() const {
        const double nearest = window.nearest(),
                     farthest = window.step * std::sqrt(2.0) * (static_cast<double>(window.reach) + 0.5);
        const double last = nearest / farthest;
        RadiusRule best(last, 40);
        for (double low = last; low < 0.6; low += 0.05) {
            for (std::size_t points = 3; points < best.places.size(); ++points) {
                const RadiusRule rule(low, points);
                double worst = 0.0, of_field = 0.0;
                for (double x = last; x < 1.0; x *= 1.05) {
                    worst = std::max(worst, x * x * x * rule.error(x, rule.rho(0)));
                    of_field = std::max(of_field, x * std::sqrt(x) * rule.error(x, rule.rho(0)));
                }
                // Estimated squared modulus of the waves in the ellipse of rule.rho(0): 1.2 * nearest, and more if `nearest` and the
                // box are large, because pupils that need large boxes have large phases.
                const double large = std::pow(nearest / 55.0, 4), squares = 1.2 * nearest * (1.0 + large);
                if (4.0 * squares * worst <= 0.2 * window.error * nearest * nearest * nearest &&
                    (!window.fields() || 2.0 * std::sqrt(squares) * of_field <= field_error() * nearest * std::sqrt(nearest))) {
                    best = rule;
                }
            }
        }
        return best;
    }
    void choose_angles() {
        for (double many = 3.4; many < 8.0; many *= 1.25) {
            around = 8 * static_cast<std::size_t>(std::ceil(many * (order() + 1.0) / 8.0));
            for (taps = 4; taps <= AngleWeights::most_taps; taps += 2) {
                const double off = std::sqrt(AngleWeights(taps, order(), apart()).find(0.5));
                if (4.0 * together() * off <= 0.15 * window.error * std::pow(window.nearest(), 3)) {
                    return;
                }
            }
        }
        taps = AngleWeights::most_taps;
    }
    // Allowed error of fields, for each of its causes. Fields count times those of strips, at most their area / pi.
    double field_error() const {
        double cut = 0.0;
        for (const Strip& strip : window.strips) {
            cut += strip.area();
        }
        return std::min(100.0, 0.4 / cut) * window.error;
    }
    void choose_points() {
        for (std::size_t count = 4; count <= 64; ++count) {
            const WindowNodes nodes(window.step, 1, count);
            point_places = nodes.places;
            point_weights = nodes.weights;
            for (std::size_t i = 0; i < count; ++i) {
                point_places[i] *= 2.0 / window.step;
                point_weights[i] *= 2.0 / nodes.gain;
            }
            find_point_errors();
            if (off_strips <= 0.3 * window.error) {
                break;
            }
        }
        const double most = static_cast<double>(rims[0].orders + rim_orders - 1);
        for (field_taps = 4; field_taps < taps; field_taps += 2) {
            const double off = std::sqrt(AngleWeights(field_taps, most, apart()).find(0.5));
            if (3.5 * off <= field_error() * std::pow(window.nearest(), 1.5)) {
                break;
            }
        }
    }
    // Set off_points and off_strips (certificate, section 10, "Other pixels").
    void find_point_errors() {
        const auto off = [&](double w) {
            const double angle = 0.5 * window.step * w;
            double sum = angle == 0.0 ? -1.0 : -std::sin(angle) / angle;
            for (std::size_t i = 0; i < point_places.size(); ++i) {
                sum += 0.5 * point_weights[i] * std::cos(angle * point_places[i]);
            }
            return sum;
        };
        const std::vector<double> band = band_points(0.5 * window.step);
        off_points = 0.0;
        for (const double w : band) {
            off_points = std::max(off_points, std::sqrt(2.0) * std::abs(off(w)) + 1e-14);
        }
        // Bound on the mean, over the disc, of the error at the frequencies between its points and one at most `out` from the axis.
        const std::size_t count = band.size() + 3;
        const auto mean = [&](double out) {
            const double wide = 1.0 + std::min(out, 1.0);
            double sum = 0.0;
            for (std::size_t i = 1; i < count; ++i) {
                const double angle = pi * static_cast<double>(i) / static_cast<double>(count), e = off(wide * std::cos(angle));
                sum += pi / static_cast<double>(count) * std::pow(std::sin(angle), 4) * e * e;
            }
            return 2.0 / pi * wide * std::sqrt(2.0 * pi * wide * sum) + 1e-14;
        };
        // The weights of root mean squares are positive.
        off_strips = *std::min_element(point_weights.begin(), point_weights.end()) > 0.0 ? 0.0 : 1e30;
        for (const Strip& strip : window.strips) {
            const double c = std::abs(strip.cosine), s = std::abs(strip.sine), far = strip.farthest();
            off_strips += 2.0 * strip.area() * ((1.0 + off_points) * mean(c + far * s) + mean(s + far * c));
        }
    }
    // Largest rho of an ellipse around [low, high] that is within the ellipse of rule.rho(e); 1 if there is none.
    double rho_within(double low, double high, std::size_t e) const {
        const double own = rule.rho(e), sum = 0.5 * (1.0 - rule.low) * (own + 1.0 / own);
        double rho = 1.0;
        for (double next = 1.05;; next *= 1.05) {
            const double wide = 0.25 * (high - low) * (next + 1.0 / next), tall = 0.25 * (high - low) * (next - 1.0 / next);
            for (const double x : {0.5 * (low + high) - wide, 0.5 * (low + high) + wide}) {
                if (std::hypot(x - rule.low, tall) + std::hypot(x - 1.0, tall) > sum) {
                    return rho;
                }
            }
            rho = next;
        }
    }
    // Set what the fields at the points of some pixels follow from.
    void make_fields(RimPixels& own) {
        const double nearest = window.nearest(), middle = std::atan2(static_cast<double>(own.q), static_cast<double>(own.p));
        const std::size_t points = point_places.size() * point_places.size();
        std::vector<double> v, angles;
        double half = 0.0;  // half width in angle
        for (std::size_t i = 0; i < points; ++i) {
            const double y = static_cast<double>(own.q) + 0.5 * point_places[i / point_places.size()],
                         x = static_cast<double>(own.p) + 0.5 * point_places[i % point_places.size()];
            v.push_back(window.step * std::hypot(y, x));
            angles.push_back(std::atan2(y, x));
            half = std::max(half, std::abs(angles[i] - middle));
        }
        const auto [least, most] = std::minmax_element(v.begin(), v.end());
        const double top = nearest / *least, bottom = nearest / *most, nearer = std::pow(*least, -1.5);
        const double rho[2] = {rho_within(bottom, top, 0), rho_within(bottom, top, 1)};
        // Chebyshev points in x = nearest / v, and in angle. The estimated moduli of waves are those of chosen_rule().
        double along = 0.0, between = 0.0;  // largest sums of moduli of weights
        Doubles wanted;  // [point][radius]
        for (const double radius : v) {
            along = std::max(along, rule.at(nearest / radius));
            wanted.insert(wanted.end(), rule.shares.begin(), rule.shares.end());
        }
        // [point][place], [place][radius], [point][angle]; all: [point], v^(-3/2) times the largest sum of moduli of weights of radii
        std::vector<double> of_places, to_places, of_turns, all(points);
        bool enough = false;
        for (own.places = 2; !enough && own.places < 2 * radii(); ++own.places) {
            RadiusRule here(bottom / top, own.places);
            of_places.clear();
            to_places.clear();
            for (const double place : here.places) {
                along = std::max(along, rule.at(top * place));
                to_places.insert(to_places.end(), rule.shares.begin(), rule.shares.end());
            }
            own.off_places.fill(0.0);
            between = 0.0;
            for (std::size_t i = 0; i < points; ++i) {
                between = std::max(between, here.at(nearest / v[i] / top));
                of_places.insert(of_places.end(), here.shares.begin(), here.shares.end());
                double sum = 0.0, moduli = 0.0, before = 0.0;
                for (std::size_t r = 0; r < radii(); ++r) {
                    double share = 0.0;
                    for (std::size_t l = 0; l < own.places; ++l) {
                        share += here.shares[l] * to_places[l * radii() + r];
                    }
                    sum += std::abs(wanted[i * radii() + r] - share);
                    moduli += std::abs(share);
                    before += std::abs(wanted[i * radii() + r]);
                }
                all[i] = std::pow(v[i], -1.5) * std::max(moduli, before);
                own.off_places[2] = std::max(own.off_places[2], nearer * sum);
            }
            for (std::size_t e = 0; e < 2; ++e) {
                own.off_places[e] =
                    rho[e] > 1.0 ? 8.0 * nearer * std::pow(rho[e], -static_cast<double>(own.places)) / (1.0 - 1.0 / rho[e])
                                 : 1e30;
            }
            enough = std::min(std::min(own.off_places[0], own.off_places[1]) * std::sqrt(1.2 * nearest),
                              3.5 * own.off_places[2]) <= 0.5 * field_error();
        }
        --own.places;
        own.place = local.size();
        local.insert(local.end(), to_places.begin(), to_places.end());
        for (std::size_t e = 0; e < 2; ++e) {
            field_radii[e] =
                std::max(field_radii[e],
                         2.0 * nearer * between * std::max(rule.error(top, rule.rho(e)), rule.error(bottom, rule.rho(e))));
        }
        // Derivatives of high orders n are often larger than the power n of the slope.
        double guess = 0.0;
        do {
            ++own.turns;
            const double order = static_cast<double>(own.turns);
            own.off_turns =
                4.0 * *std::max_element(all.begin(), all.end()) * std::pow(0.5 * half, order) / std::tgamma(order + 1.0);
            guess = 3.5 * own.off_turns * std::pow(window.slope, order) * std::exp2(std::max(0.0, order - 3.0));
        } while (guess > 0.5 * field_error() && own.turns < rim_most_turns);
        AngleWeights ring(field_taps, static_cast<double>(rims[0].orders + rim_orders - 1), apart());
        own.turn = starts.size();
        double around_ring = 0.0, between_turns = 0.0;  // largest sums of moduli of weights
        std::vector<double> turns, misfits;
        for (std::size_t a = 0; a < own.turns; ++a) {
            turns.push_back(middle + half * chebyshev_point(a, own.turns));
            const double angle = turns[a] / apart() - 0.5, before = std::floor(angle);
            misfits.push_back(std::sqrt(ring.find(angle - before)));
            double moduli = 0.0;
            for (std::size_t t = 0; t < field_taps; ++t) {
                shares.push_back(static_cast<float>(ring.shares[t]));
                moduli += std::abs(ring.shares[t]);
            }
            around_ring = std::max(around_ring, moduli);
            starts.push_back(
                static_cast<std::int16_t>(before - static_cast<double>(field_taps / 2 - 1) - static_cast<double>(own.begin)));
        }
        for (std::size_t i = 0; i < points; ++i) {
            double moduli = 0.0, misfit = 0.0;
            for (std::size_t a = 0; a < own.turns; ++a) {
                double share = 1.0;
                for (std::size_t b = 0; b < own.turns; ++b) {
                    share *= b == a ? 1.0 : (angles[i] - turns[b]) / (turns[a] - turns[b]);
                }
                of_turns.push_back(share);
                moduli += std::abs(share);
                misfit += std::abs(share) * misfits[a];
            }
            between_turns = std::max(between_turns, moduli);
            field_angles = std::max(field_angles, all[i] * misfit);
        }
        own.off_places[2] *= around_ring * between_turns;
        field_gain = std::max(field_gain, nearer * along * between * around_ring * between_turns);
        own.part = parts.size();
        const std::size_t each = own.places * rims.size() * 2, count = own.turns * each;
        most_parts = std::max(most_parts, count);
        parts.resize(own.part + points * count);
        for_tiles(points, rim_points_tile, [&](std::size_t from, std::size_t size) {
            for (std::size_t i = from; i < from + size; ++i) {
                for (std::size_t j = 0; j < count; ++j) {
                    const double angle = rims[j / 2 % rims.size()].radius * v[i];
                    parts[own.part + from * count + j * size + i - from] =
                        static_cast<float>(2.0 * std::pow(v[i], -1.5) * of_turns[i * own.turns + j / each] *
                                           of_places[i * own.places + j % each / (2 * rims.size())] *
                                           (j % 2 == 0 ? std::cos(angle) : -std::sin(angle)));
                }
            }
        });
    }
    void make_pixels() {
        const double nearest = window.nearest();
        AngleWeights angles(taps, order(), apart());
        constexpr std::size_t most_points = 64, padded = most_points + row_lanes;
        std::size_t points = 4;
        while (3.0 * pixel_error(window.step, points) > 0.02 * window.error && points < most_points) {
            ++points;
        }
        off_pixels = 3.0 * pixel_error(window.step, points);
        off_field = std::min(1.0, 4.0 * pi / (window.step * window.step) + std::max(off_pixels, 3.0 * off_points));
        std::vector<double> x(points), w(points);
        gauss_legendre(points, x.data(), w.data());
        std::vector<double> frequencies{2.0};
        if (rims.size() > 1) {
            const double eps = rims[1].radius;
            frequencies = {2.0 * eps, 1.0 - eps, 1.0 + eps, 2.0};
        }
        const std::size_t half = window.box / 2;
        Doubles lights, spread, sums;
        weights.resize(radii());
        for (std::size_t p = half + 1; p <= window.reach; ++p) {
            for (std::size_t q = 0; q <= p; ++q) {
                look();
                const double down = static_cast<double>(q), right = static_cast<double>(p);
                // Lowest and highest polar angle of the pixel's corners, in units of apart().
                const double low = std::atan2(down - 0.5, right + (q == 0 ? -0.5 : 0.5)) / apart(),
                             high = std::atan2(down + 0.5, right - 0.5) / apart();
                // Index `begin` of the first angle with a weight; angle l of a ring is (l + 1/2) apart().
                const double begin = std::floor(low - 0.5) - static_cast<double>(taps / 2 - 1);
                const std::size_t count =
                    static_cast<std::size_t>(std::floor(high - 0.5) + static_cast<double>(taps / 2) - begin) + 1;
                // Weights sums[radius][channel][angle]: matrix product of lights[radius][channel][point] and spread[point][angle].
                lights.resize(radii() * channels() * points * points);
                spread.assign(points * points * count, 0.0);
                sums.resize(radii() * channels() * count);
                RimPixels own{p, q, weights[0].size(), channels(), static_cast<std::ptrdiff_t>(begin), count};
                // The error of interpolation between radii is largest at the least or the largest radius v of the pixel.
                const double first = window.step * std::hypot(std::max(0.0, down - 0.5), right - 0.5),
                             last = window.step * std::hypot(down + 0.5, right + 0.5);
                for (std::size_t e = 0; e < 2; ++e) {
                    const double worst =
                        std::max(rule.error(nearest / first, rule.rho(e)), rule.error(nearest / last, rule.rho(e)));
                    off_radii[e] = std::max(off_radii[e], 4.0 / (first * first * first) * worst);
                    own.off_radii[e] = 4.0 / (first * first * first) * worst;
                }
                dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                    using I = decltype(isa);
                    using V = typename I::pack;
                    double v[padded], turn[padded], before[padded], half[2][padded], fast[2][padded];
                    std::array<std::array<double, padded>, 8> waves;  // cosine and sine of frequency times v
                    for (std::size_t i = 0; i < points; ++i) {
                        // A row of Gauss points in the pixel, padded to whole vectors.
                        const double y = down + 0.5 * x[i];
                        for (std::size_t j = 0; j < points + I::lanes; ++j) {
                            const double z = right + 0.5 * x[std::min(j, points - 1)];
                            v[j] = window.step * std::sqrt(y * y + z * z);
                            const double angle = std::atan2(y, z) / apart() - 0.5;
                            before[j] = std::floor(angle);
                            turn[j] = angles.angle(angle - before[j]);
                        }
                        const auto turned = [&](const double* of, double times, double* sine, double* cosine)
                                                LOMMEL_INLINE_LAMBDA {
                                                    for (std::size_t j = 0; j < points; j += I::lanes) {
                                                        V s, c;
                                                        sincos(isa, splat<V>(times) * load<V>(of + j), s, c);
                                                        store(sine + j, s);
                                                        store(cosine + j, c);
                                                    }
                                                };
                        turned(turn, 0.5, half[0], half[1]);
                        turned(turn, order() + 0.5, fast[0], fast[1]);
                        for (std::size_t f = 0; f < frequencies.size(); ++f) {
                            turned(v, frequencies[f], waves[2 * f + 1].data(), waves[2 * f].data());
                        }
                        for (std::size_t j = 0; j < points; ++j) {
                            const double misfit = std::sqrt(angles.find(isa, {half[0][j], half[1][j], fast[0][j], fast[1][j]})),
                                         along = rule.at(nearest / v[j]), size = 1.0 / (v[j] * v[j] * v[j]);
                            double moduli = 0.0;
                            for (std::size_t t = 0; t < taps; ++t) {
                                moduli += std::abs(angles.shares[t]);
                            }
                            own.off_angles = std::max(own.off_angles, together() * size * along * misfit);
                            own.gain = std::max(own.gain, static_cast<double>(channels()) * size * along * moduli);
                            const double by = 0.25 * w[i] * w[j] * size;
                            const std::size_t at =
                                static_cast<std::size_t>(before[j] - static_cast<double>(taps / 2 - 1) - begin);
                            const std::size_t point = i * points + j;
                            std::copy_n(angles.shares, taps, spread.data() + point * count + at);
                            for (std::size_t r = 0; r < radii(); ++r) {
                                for (std::size_t k = 0; k < channels(); ++k) {
                                    lights[(r * channels() + k) * points * points + point] =
                                        by * rule.shares[r] * (k == 0 ? 1.0 : waves[k - 1][j]);
                                }
                            }
                        }
                    }
                });
                product(lights.data(), radii() * channels(), points * points, spread.data(), count, 1, sums.data());
                margin = std::max(margin, count + taps);
                // Omit pairs of channels (of cos(f v) and sin(f v), see rim_channels()), the last one first, while their weights sum to
                // little: a pair's amplitude is at most channel 0.
                const auto sum_of = [&](std::size_t radius, std::size_t channel, std::size_t angle) {
                    return sums[(radius * channels() + channel) * count + angle];
                };
                std::size_t& used = own.used;
                for (; used > 1; used -= 2) {
                    double more = own.dropped;
                    for (std::size_t r = 0; r < radii(); ++r) {
                        for (std::size_t t = 0; t < count; ++t) {
                            more += std::hypot(sum_of(r, used - 2, t), sum_of(r, used - 1, t));
                        }
                    }
                    if (3.0 * more > 0.15 * window.error) {
                        break;
                    }
                    own.dropped = more;
                }
                off_angles = std::max(off_angles, own.off_angles);
                gain = std::max(gain, own.gain);
                dropped = std::max(dropped, own.dropped);
                if (window.fields()) {
                    make_fields(own);
                }
                pixels.push_back(own);
                for (std::size_t r = 0; r < radii(); ++r) {
                    for (std::size_t t = 0; t < count; ++t) {
                        for (std::size_t c = 0; c < used; ++c) {
                            weights[r].push_back(static_cast<float>(sum_of(r, c, t)));
                        }
                    }
                }
            }
        }
    }
};

}  // namespace lommel
