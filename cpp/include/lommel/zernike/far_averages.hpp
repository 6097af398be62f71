// Pixel averages far from the axis, for any Zernike terms: there, the field consists of waves from the edges of the aperture.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "lommel/base/pi.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/base/tasks.hpp"
#include "lommel/base/watch.hpp"
#include "lommel/zernike/disk_stack.hpp"
#include "lommel/zernike/field.hpp"

namespace lommel {

// Intensity I far from the axis (docs/certificate.md, section 10, "Far from the axis"). The field U is a sum of waves exp(+-i v)
// and, with an obscuration ratio eps, exp(+-i eps v); their amplitudes are series in 1 / v (Hankel's expansion) and vary slowly
// with the azimuth. I is the smooth sum of the squared moduli plus interference rings, whose pixel averages are small and bounded.
class FarLight {
   public:
    // Construct from an expanded pupil; degrees and orders that add at most `spare` to U are omitted.
    FarLight(const ZernikeField& field, double spare) : base_(field.base()) {
        const double radius = field.obscuration(), area = radius * radius;
        choose(field.outer(), 1.0, spare);
        if (field.obscured()) {
            choose(field.inner(), area, spare);
        }
        angles_ = std::max<std::size_t>(64, (8 * orders_ + 15) / 16 * 16);
        for (std::size_t i = 0; i < angles_; ++i) {
            const double angle = 2.0 * pi * static_cast<double>(i) / static_cast<double>(angles_);
            cosine_.push_back(std::cos(angle));
            sine_.push_back(std::sin(angle));
        }
        add(field.outer(), 1.0, 1.0);
        if (field.obscured()) {
            add(field.inner(), radius, area);
        }
    }

    // Error bound of the averages over pixels of width `step` (in v) that lie entirely beyond the radius of the last fit().
    double left_out(double step) const {
        const double inverse = 1.0 / from_, root = inverse * std::sqrt(inverse);
        double size = 0.0, sum = misfit_;
        for (std::size_t i = 0; i < waves_.size(); ++i) {
            const Wave& wave = waves_[i];
            size += wave.largest;
            for (std::size_t j = 0; j < i; ++j) {
                // Bound on the pixel average of the product of two waves, by the divergence theorem: flux through the pixel's edges for
                // constant amplitudes, plus the integral over the pixel that is due to the slopes of the amplitudes.
                const Wave& other = waves_[j];
                const double product = wave.largest * other.largest, frequency = std::abs(wave.frequency - other.frequency);
                const double sloping = wave.slope * other.largest + wave.largest * other.slope + 2.0 * product;
                sum += 2.0 * std::min(product, product * edges(i, j, step) + sloping * inverse / frequency);
            }
        }
        const double spacing = 2.0 * pi / static_cast<double>(angles_), wide = step * inverse;
        for (std::size_t k = 0; k < smooth; ++k) {
            const Harmonics& h = harmonics_[k];
            const double p = static_cast<double>(k + 3);
            const double along = p * (p + 1.0) * h.value + (p + 1.0) * h.slope,
                         around = (p + 1.0) * h.slope + h.bend + p * h.value;
            sum += wide * wide / 12.0 * std::max(along, around) + 0.125 * spacing * spacing * h.bend + angle_error * h.slope +
                   64.0 * unit_roundoff * h.value;
        }
        return root * root * sum + off_ * (2.0 * size * root + off_);
    }
    // Fit polynomials in 1 / radius to the smooth part of radius^3 I (without interference rings), for all radii of at least v.
    void fit(double v) {
        prepare(v);
        // Sum of the squared moduli of all waves at radii v / x, for samples of x between 0 and 1: squares[sample][angle].
        std::vector<double> squares((points + smooth) * angles_, 0.0);
        std::array<double, points + smooth> places;
        for (std::size_t i = 0; i < points; ++i) {
            places[i] = 0.5 + 0.5 * std::cos(pi * (static_cast<double>(i) + 0.5) / static_cast<double>(points));
        }
        for (std::size_t i = 0; i < smooth; ++i) {
            places[points + i] = 0.5 + 0.5 * std::cos(pi * (static_cast<double>(i) + 0.5) / static_cast<double>(smooth));
        }
        const double turn = pi * static_cast<double>(orders_) / static_cast<double>(angles_);
        // Bounds on (maximum of a polynomial) / (its maximum at the samples) (Ehlich and Zeller, 1964). once: for the waves; twice: for
        // their squares, of twice the degree.
        const double once = 1.0 / (std::cos(turn) * std::cos(0.5 * pi * (kept - 1.0) / points)),
                     twice = 1.0 / (std::cos(2.0 * turn) * std::cos(pi * (kept - 1.0) / points));
        std::vector<double> most(angles_);
        for (Wave& wave : waves_) {
            std::fill(most.begin(), most.end(), 0.0);
            for (std::size_t i = 0; i < places.size(); ++i) {
                look();
                const double x = places[i] / v;
                double* const square = &squares[i * angles_];
                dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
                    const double *const from_re = wave.re.data(), *const from_im = wave.im.data();
                    const std::size_t count = angles_;
                    for (std::size_t first = 0; first < count; first += 16) {
                        double re[16] = {}, im[16] = {};
                        for (std::size_t k = kept; k-- > 0;) {
                            for (std::size_t l = 0; l < 16; ++l) {
                                re[l] = re[l] * x + from_re[k * count + first + l];
                                im[l] = im[l] * x + from_im[k * count + first + l];
                            }
                        }
                        for (std::size_t l = 0; l < 16; ++l) {
                            const double size = re[l] * re[l] + im[l] * im[l];
                            square[first + l] += size;
                            most[first + l] = std::max(most[first + l], size);
                        }
                    }
                });
            }
            double power = 1.0;
            wave.slope = 0.0;
            wave.largest = once * std::sqrt(*std::max_element(most.begin(), most.end()));
            for (std::size_t k = 0; k < kept; ++k) {
                wave.slope += static_cast<double>(k) * wave.sizes[k] * power;
                power /= v;
            }
        }
        // Coefficients of the polynomial in x through the last `smooth` samples of `squares`, by divided differences.
        const double* const at = places.data() + points;
        std::vector<double> terms_of(smooth * angles_);
        for (std::size_t l = 0; l < angles_; ++l) {
            std::array<double, smooth> c, sum{};
            for (std::size_t i = 0; i < smooth; ++i) {
                c[i] = squares[(points + i) * angles_ + l];
            }
            for (std::size_t j = 1; j < smooth; ++j) {
                for (std::size_t i = smooth; i-- > j;) {
                    c[i] = (c[i] - c[i - 1]) / (at[i] - at[i - j]);
                }
            }
            for (std::size_t j = smooth; j-- > 0;) {
                for (std::size_t i = smooth; i-- > 1;) {
                    sum[i] = sum[i - 1] - at[j] * sum[i];
                }
                sum[0] = c[j] - at[j] * sum[0];
            }
            for (std::size_t j = 0; j < smooth; ++j) {
                terms_of[j * angles_ + l] = sum[j];
            }
        }
        std::fill(most.begin(), most.end(), 0.0);
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
            const double* const of = terms_of.data();
            double* const worst = most.data();
            const std::size_t count = angles_;
            for (std::size_t i = 0; i < points; ++i) {
                const double x = places[i];
                const double* const square = &squares[i * count];
                for (std::size_t l = 0; l < count; ++l) {
                    double sum = 0.0;
                    for (std::size_t j = smooth; j-- > 0;) {
                        sum = sum * x + of[j * count + l];
                    }
                    worst[l] = std::max(worst[l], std::abs(sum - square[l]));
                }
            }
        });
        misfit_ = *std::max_element(most.begin(), most.end());
        misfit_ *= twice;
        // Fourier coefficients, in the azimuth, of the smooth part, from every other sample, which suffices. At most 96 orders are
        // computed; the mean square of the samples minus that of these orders bounds the higher orders.
        constexpr std::size_t lanes = 8;
        const std::size_t half = angles_ / 2, all = 2 * orders_, known = std::min<std::size_t>(all, 96);
        std::vector<double> rows(half * lanes, 0.0), sums(2 * lanes * known, 0.0);
        for (std::size_t j = 0; j < smooth; ++j) {
            for (std::size_t l = 0; l < half; ++l) {
                rows[l * lanes + j] = terms_of[j * angles_ + 2 * l];
            }
        }
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
            for (std::size_t h = 0; h < known; ++h) {
                double c[lanes] = {}, s[lanes] = {};
                for (std::size_t l = 0, place = 0; l < half; ++l) {
                    const double cosine = cosine_[place], sine = sine_[place];
                    for (std::size_t j = 0; j < lanes; ++j) {
                        c[j] += rows[l * lanes + j] * cosine;
                        s[j] += rows[l * lanes + j] * sine;
                    }
                    place = place + 2 * h < angles_ ? place + 2 * h : place + 2 * h - angles_;
                }
                std::copy_n(c, lanes, &sums[2 * h * lanes]);
                std::copy_n(s, lanes, &sums[(2 * h + 1) * lanes]);
            }
        });
        constexpr std::size_t numbers = 2 * smooth;
        const double angles = static_cast<double>(half);
        table_.resize((angles_ + 1) * numbers);
        for (std::size_t j = 0; j < smooth; ++j) {
            const double* const sum = &terms_of[j * angles_];
            double mean = 0.0;
            for (std::size_t l = 0; l < angles_; l += 2) {
                mean += sum[l] * sum[l] / angles;
            }
            double others = (1.0 + 1e-13) * mean;
            Harmonics& largest = harmonics_[j] = {};
            const auto count = [&](double size, double order) {
                largest.value += size;
                largest.slope += order * size;
                largest.bend += order * order * size;
            };
            for (std::size_t h = 0; h < known; ++h) {
                const double c = sums[2 * h * lanes + j], s = sums[(2 * h + 1) * lanes + j],
                             square = (c * c + s * s) / (angles * angles);
                others -= (h == 0 ? 1.0 : 2.0) * square;
                count((h == 0 ? 1.0 : 2.0) * std::sqrt(square), static_cast<double>(h));
            }
            count(std::sqrt(2.0 * static_cast<double>(all - known) * std::max(others, 1e-13 * mean)), static_cast<double>(all));
            for (std::size_t l = 0; l <= angles_; ++l) {
                const double here = sum[l % angles_];
                table_[l * numbers + j] = here;
                table_[l * numbers + smooth + j] = sum[(l + 1) % angles_] - here;
            }
        }
    }
    // About the smallest v for which averages over pixels of width `step` beyond the radius v have an error of at most `requested`
    // after fit(v). The result exceeds `most` if no radius up to `most` suffices.
    double nearest(double step, double requested, double most) {
        // Lower limit of v: here, the bound on pixel averages of an unaberrated pupil's rings, which falls as v^-3, is `requested`.
        double rings = 0.0;
        for (std::size_t i = 0; i < waves_.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                rings += 2.0 * disks_[i / 2].factor * disks_[j / 2].factor * edges(i, j, step);
            }
        }
        double v = std::cbrt(rings / requested);
        for (double growth = 1.05; v <= most; v *= growth) {
            prepare(v);
            growth = 1.05;
            // An error e of U changes I by at most e (2 |U| + e), with 2 |U| about 4 / v^(3/2): allow 0.4 * requested for it.
            if (off_ * (4.0 / (v * std::sqrt(v)) + off_) <= 0.4 * requested) {
                fit(v);
                const double left = left_out(step);
                if (left <= requested) {
                    break;
                }
                growth = std::clamp(std::cbrt(left / requested), 1.02, 1.3);
            }
        }
        return v;
    }

    // Averages of `count` pixels of one row, which lies `down` pixels below the axis and begins `right` pixels to the right of it.
    void row(double right, double down, double step, std::size_t count, double* out) const {
        constexpr std::size_t numbers = 2 * smooth;
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
            const double turns = static_cast<double>(angles_) / (2.0 * pi), tall = std::abs(down), square = down * down;
            const double* const table = table_.data();
            constexpr std::size_t together = 16;
            for (std::size_t first = 0; first < count; first += together) {
                double inverse[together], place[together];
                const std::size_t here = std::min(together, count - first);
                for (std::size_t i = 0; i < together; ++i) {
                    const double x = right + static_cast<double>(first + i), wide = std::abs(x);
                    inverse[i] = 1.0 / (step * std::sqrt(x * x + square));
                    const double low = std::min(wide, tall), high = std::max(wide, tall), t = low / (high + 1e-300), z = t * t;
                    double angle = 0.0208351;
                    angle = t * (0.9998660 + z * (-0.3302995 + z * (0.1801410 + z * (-0.0851330 + z * angle))));
                    angle = tall > wide ? 0.5 * pi - angle : angle;
                    angle = x < 0.0 ? pi - angle : angle;
                    angle = down < 0.0 ? 2.0 * pi - angle : angle;
                    place[i] = std::max(0.0, angle * turns);
                }
                for (std::size_t i = 0; i < here; ++i) {
                    const std::size_t at = std::min(angles_, static_cast<std::size_t>(place[i]));
                    const double way = place[i] - static_cast<double>(at), part = from_ * inverse[i],
                                 cube = inverse[i] * inverse[i] * inverse[i];
                    const double* const sums = table + at * numbers;
                    double sum = 0.0;
                    for (std::size_t k = smooth; k-- > 0;) {
                        sum = sum * part + (sums[k] + way * sums[smooth + k]);
                    }
                    // Averages of an intensity are not negative, and clamping to 0 does not increase the error.
                    out[first + i] = std::max(0.0, sum * cube);
                }
            }
        });
    }

   private:
    // terms: number of terms of Hankel's expansion; kept: number of these that are summed (the others are bounded as an error);
    // smooth: number of coefficients of the polynomial in 1 / v for the smooth part of I.
    static constexpr std::size_t terms = 24, kept = 12, smooth = 5;
    // Error bound, in radians, of the polynomial for the arc tangent (Abramowitz and Stegun, 4.4.49) and of its rounding.
    static constexpr double angle_error = 1.2e-5;
    // Number of points at which a polynomial in 1 / v is sampled to bound its maximum (docs/certificate.md, section 10).
    static constexpr std::size_t points = 3 * kept;

    // Wave exp(i frequency v), times an amplitude that depends on the azimuth and is a series in 1 / v.
    struct Wave {
        double frequency;
        std::vector<double> re, im;        // coefficients of v^(-3/2 - k), [k][angle]
        std::array<double, terms> sizes;   // [k]: bound on the modulus of coefficient k at all angles
        double largest = 0.0, slope = 0.0;  // bounds on a = v^(3/2) * amplitude: largest on |a|, slope on v |da/dv|
    };
    struct Disk {
        double radius, weight, factor;  // radius / full disk's radius; factor of the disk's field; factor of both its waves
        std::size_t orders;
        std::vector<double> size;  // [degree]: sum of the moduli of its coefficients over all orders
        std::array<double, terms> rounding;  // [k]: rounding error of term k of the waves
    };
    // Bounds on a trigonometric polynomial in the azimuth and on its derivatives.
    struct Harmonics {
        double value = 0.0, slope = 0.0, bend = 0.0;  // maximum moduli of the polynomial, its first and its second derivative
    };

    // Choose the orders and degrees of a disk, whose field has the factor `weight`; those omitted add at most `spare` to the field U.
    void choose(const ZernikeSeries& series, double weight, double spare) {
        Disk disk{0.0, weight, 0.0, 0, std::vector<double>(series.degrees, 0.0), {}};
        std::vector<double> by_order(series.orders, 0.0);
        const auto each = [&](std::size_t orders, const auto& take) {
            for (std::size_t m = 0; m < orders; ++m) {
                for (std::size_t i = 0; i < series.used[m]; ++i) {
                    const std::size_t at = series.start[m] + i;
                    const double c = series.size(at, 0), s = series.size(at, 1);
                    take(m, m + 2 * i, std::sqrt(c * c + s * s));
                }
            }
        };
        // Reduce `count`, a number of orders or degrees, as far as the omitted ones add at most spare / 2 to U; add their sum to base_.
        const auto fewest = [&](std::size_t count, const auto& adds) {
            for (double sum = 0.0; count > 1 && sum + adds(count - 1) <= 0.5 * spare; --count) {
                sum += adds(count - 1);
                base_ += adds(count - 1);
            }
            return count;
        };
        each(series.orders,
             [&](std::size_t m, std::size_t n, double size) { by_order[m] += weight * size / static_cast<double>(n + 1); });
        disk.orders = fewest(series.orders, [&](std::size_t m) { return by_order[m]; });
        each(disk.orders, [&](std::size_t, std::size_t n, double size) { disk.size[n] += size; });
        disk.size.resize(
            fewest(series.degrees, [&](std::size_t n) { return weight * disk.size[n] / static_cast<double>(n + 1); }));
        orders_ = std::max(orders_, disk.orders);
        disks_.push_back(std::move(disk));
    }
    void add(const ZernikeSeries& series, double radius, double weight) {
        Disk& disk = disks_[waves_.size() / 2];
        const std::size_t half = angles_ / 2, degrees = disk.size.size();
        // Coefficients a_k(n + 1) of Hankel's expansion of J_{n+1}: hankel[k][n].
        std::vector<double> hankel(terms * degrees);
        for (std::size_t n = 0; n < degrees; ++n) {
            double here = 1.0;
            const double order = 2.0 * static_cast<double>(n + 1);
            for (std::size_t k = 0; k < terms; ++k) {
                hankel[k * degrees + n] = here;
                const double odd = static_cast<double>(2 * k + 1);
                here *= (order * order - odd * odd) / (8.0 * static_cast<double>(k + 1));
            }
        }
        // Sums D_k(psi) = sum over n of a_k(n + 1) b_n(psi), with a_k in `hankel`, b_n the terms of degree n at the edge of the pupil.
        // Even and odd orders are separate, as they differ in sign after half a turn: sums[k][parity][re, im][angle].
        std::vector<double> sums(kept * 4 * half, 0.0), cosine(half, 1.0), sine(half, 0.0);
        std::array<double, terms> largest{};  // [k]: bound on |D_k|, for the terms k >= kept
        for (std::size_t m = 0; m < std::min(disk.orders, degrees); ++m) {
            look();
            double at[terms][4] = {};
            for (std::size_t i = 0; i < series.used[m] && m + 2 * i < degrees; ++i) {
                const std::size_t n = m + 2 * i, j = series.start[m] + i;
                for (std::size_t k = 0; k < terms; ++k) {
                    for (std::size_t c = 0; c < 4; ++c) {
                        at[k][c] += hankel[k * degrees + n] * series.parts[c][j];
                    }
                }
            }
            for (std::size_t k = kept; k < terms; ++k) {
                largest[k] += std::sqrt(at[k][0] * at[k][0] + at[k][1] * at[k][1] + at[k][2] * at[k][2] + at[k][3] * at[k][3]);
            }
            dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
                for (std::size_t k = 0; k < kept; ++k) {
                    // Coefficients of odd orders are stored with a factor -i (ZernikeAnalysis::run()).
                    const bool odd = m % 2 == 1;
                    const double cr = odd ? -at[k][1] : at[k][0], ci = odd ? at[k][0] : at[k][1],
                                 sr = odd ? -at[k][3] : at[k][2], si = odd ? at[k][2] : at[k][3];
                    double* const re = &sums[(4 * k + (odd ? 2 : 0)) * half];
                    double* const im = re + half;
                    for (std::size_t l = 0; l < half; ++l) {
                        re[l] += cosine[l] * cr + sine[l] * sr;
                        im[l] += cosine[l] * ci + sine[l] * si;
                    }
                }
                for (std::size_t l = 0; l < half; ++l) {
                    const double next = cosine[l] * cosine_[l] - sine[l] * sine_[l];
                    sine[l] = sine[l] * cosine_[l] + cosine[l] * sine_[l];
                    cosine[l] = next;
                }
            });
        }
        // Waves exp(+-i radius v) v^(-3/2) * sum over k of factor (+-i)^k D_k / (radius v)^k, apart from constant phases. At the
        // azimuth psi, the wave exp(-i radius v) contains D_k(psi), the wave exp(+i radius v) contains D_k(psi + pi).
        disk.radius = radius;
        disk.factor = std::sqrt(2.0 / pi) * weight / (radius * std::sqrt(radius));
        // Bound on maximum over angles / maximum at samples: a Fourier sum is >= M cos(orders_ s) at a distance s from its maximum M.
        const double between = 1.0 / std::cos(pi * static_cast<double>(orders_) / static_cast<double>(angles_));
        const double roundings = unit_roundoff * static_cast<double>(2 * degrees + 8 * orders_ + 64);
        for (const double sign : {1.0, -1.0}) {
            Wave wave{sign * radius, std::vector<double>(kept * angles_), std::vector<double>(kept * angles_), {}};
            double power = disk.factor;
            for (std::size_t k = 0; k < terms; ++k) {
                double most = 0.0, all = 0.0;
                for (std::size_t l = 0; l < angles_ && k < kept; ++l) {
                    const bool turned = (l >= half) != (sign > 0.0);
                    const double* const at = &sums[4 * k * half + l % half];
                    const double re = turned ? at[0] - at[2 * half] : at[0] + at[2 * half],
                                 im = turned ? at[half] - at[3 * half] : at[half] + at[3 * half];
                    // Multiplication by (+-i)^k.
                    const double turn = k % 4 < 2 ? power : -power, side = sign * turn;
                    wave.re[k * angles_ + l] = k % 2 == 0 ? turn * re : -side * im;
                    wave.im[k * angles_ + l] = k % 2 == 0 ? turn * im : side * re;
                    most = std::max(most, re * re + im * im);
                }
                for (std::size_t n = 0; n < degrees; ++n) {
                    all += std::abs(hankel[k * degrees + n]) * disk.size[n];
                }
                disk.rounding[k] = roundings * all;
                wave.sizes[k] = power * (largest[k] + std::sqrt(most) * between + disk.rounding[k]);
                power /= radius;
            }
            waves_.push_back(std::move(wave));
        }
    }
    // Bound on |pixel average of the interference term of waves i and j| / (product of their amplitudes, taken as constant), by the
    // divergence theorem.
    double edges(std::size_t i, std::size_t j, double step) const {
        return std::min(1.0, 2.8284271247461903 / (step * std::abs(waves_[i].frequency - waves_[j].frequency)));
    }
    // Set off_, the error bound of U for radii of at least v.
    void prepare(double v) {
        const double inverse = 1.0 / v, root = inverse * std::sqrt(inverse);
        double rest = 0.0;
        for (const Disk& disk : disks_) {
            const double place = disk.radius * v;
            double left = 0.0, power = 1.0;
            for (const double part : disk.rounding) {
                left += part * power;
                power /= place;
            }
            for (std::size_t n = 0; n < disk.size.size(); ++n) {
                // Remainder of Hankel's series for degree n after `terms` terms, by the smaller of two bounds: sum of the next terms up
                // to k = n (`after`) plus the one that follows (`here`); or sum of the first terms (`before`) plus bound on the series'
                // exact sum, from |2 (n+1) J_{n+1}(v) / v| <= 1.
                const double order = static_cast<double>(n + 1);
                double here = 1.0, before = 0.0, after = 0.0;
                for (std::size_t k = 0; k < std::max(terms, n + 1); ++k) {
                    (k < terms ? before : after) += here;
                    const double odd = static_cast<double>(2 * k + 1);
                    here *= std::abs(4.0 * order * order - odd * odd) / (8.0 * static_cast<double>(k + 1) * place);
                }
                left += disk.size[n] * std::min(after + here, before + 0.5 * disk.weight / (order * disk.factor * root));
            }
            rest += 2.0 * disk.factor * left;
        }
        for (const Wave& wave : waves_) {
            for (std::size_t k = kept; k < terms; ++k) {
                rest += wave.sizes[k] * std::pow(inverse, static_cast<double>(k));
            }
        }
        from_ = v;
        off_ = base_ + root * rest;
    }

    double base_, from_ = 1.0, off_ = 0.0, misfit_ = 0.0;
    std::size_t orders_ = 1, angles_ = 0;
    std::vector<double> cosine_, sine_;  // cosines and sines of the sampled azimuths
    std::vector<Wave> waves_;
    std::vector<Disk> disks_;
    std::array<Harmonics, smooth> harmonics_{};
    std::vector<double> table_;  // [angle]: coefficients of the powers of from_ / v, then their differences to the next angle
};

// Averages over the pixels beyond a radius, the smallest at which the far field meets the tolerance; nearer pixels become 0.
// found[pupil]: this radius in pixels, error bound of the averages, estimate of the largest average, row and column of the axis.
class FarAverages {
   public:
    static constexpr std::size_t numbers = 5;

    FarAverages(const DiskStack& stack, const DiskWindow& window, double most, double tol, int threads, double* images,
                double* found)
        : stack_(stack), window_(window), most_(most), tol_(tol), threads_(threads), images_(images), found_(found),
          within_(stack.amplitude.scaled(stack.obscuration * stack.obscuration)), terms_(stack.terms) {}

    void run() {
        for_pupils(stack_.count, threads_, [&](std::size_t pupil, int) { render(pupil); });
    }

   private:
    void render(std::size_t pupil) {
        thread_local ZernikeField field;
        const double step = window_.step, row = stack_.centers[2 * pupil], column = stack_.centers[2 * pupil + 1];
        const double height = static_cast<double>(window_.height), width = static_cast<double>(window_.width);
        double* const found = found_ + numbers * pupil;
        double* const image = images_ + pupil * window_.height * window_.width;
        std::fill_n(image, window_.height * window_.width, 0.0);
        const double far = std::hypot(std::max(std::abs(row), std::abs(height - 1.0 - row)),
                                      std::max(std::abs(column), std::abs(width - 1.0 - column)));
        const double reach = step * (far + 1.0);
        const ZernikePhase outer{terms_, stack_.outer.data() + pupil * terms_.terms.size(), stack_.amplitude},
            inner{terms_, stack_.inner.data() + (stack_.inner.empty() ? 0 : pupil * terms_.terms.size()), within_};
        const double none[] = {far + 1.0, 0.0, 0.0, row, column};
        std::copy_n(none, numbers, found);
        // Series in 1 / v are inaccurate up to about three times the radius of the geometrical blur: here, the root of the sum of
        // squares of the terms' largest slopes, amplitude * n^2.
        double rays = 0.0;
        outer.amplitudes([&](double amplitude, std::size_t n, std::size_t) {
            const double slope = amplitude * static_cast<double>(n * n);
            rays += slope * slope;
        });
        if (std::min(reach, most_) < 3.0 * std::sqrt(rays)) {
            return;
        }
        const double light = stack_.amplitude.raised(2.0).integral(stack_.obscuration);
        const double usual = 0.2 * tol_ * std::min(1.0, 4.0 * pi * light / (step * step));
        const double error = std::max(1e-12, 0.04 * std::sqrt(usual / step));
        field.expand(outer, inner, stack_.obscuration, reach, error, stack_.lost[pupil]);
        const double peak = likely_peak(field, reach, 2.0 * light);
        FarLight tail(field, 0.5 * error);
        const double nearest = tail.nearest(step, tol_ * peak, std::min(reach, most_)),
                     limit = nearest / step + 0.70710678118654752;
        found[2] = peak;
        if (nearest > most_ || limit > far) {
            return;
        }
        found[0] = limit;
        found[1] = 1.000001 * tail.left_out(step);  // the factor covers the rounding of distances
        for (std::size_t y = 0; y < window_.height; ++y) {
            look();
            const double down = static_cast<double>(y) - row, rest = limit * limit - down * down;
            double* const values = image + y * window_.width;
            // Columns [0, left) lie left of the circle of radius `limit`, columns from `right` on lie right of it.
            const double half = rest > 0.0 ? std::sqrt(rest) : 0.0;
            const auto inside = [&](double x) { return static_cast<std::size_t>(std::clamp(x, 0.0, width)); };
            const std::size_t left = inside(std::floor(column - half) + 1.0),
                              right = rest > 0.0 ? std::max(left, inside(std::ceil(column + half))) : left;
            tail.row(-column, down, step, left, values);
            tail.row(static_cast<double>(right) - column, down, step, window_.width - right, values + right);
        }
    }

    // Estimate of the largest pixel average: largest mean of I over annuli as wide as a pixel, out to the radius v = `reach` or to
    // half of the total energy. light: total energy divided by 2 pi.
    double likely_peak(const ZernikeField& field, double reach, double light) const {
        const double step = window_.step, spacing = std::min(3.0, 0.5 * step);
        const std::size_t across = static_cast<std::size_t>(std::ceil(step / spacing));
        std::vector<double> within{0.0};  // encircled energy divided by 2 pi
        double most = 0.0;
        for (std::size_t i = 0; i < 96 && spacing * static_cast<double>(i) < reach; ++i) {
            const double v = spacing * (static_cast<double>(i) + 0.5);
            within.push_back(within.back() + field.mean(v) * v * spacing);
            if (2 * (i + 1) < across) {
                continue;
            }
            const std::size_t from = i + 1 > across ? i + 1 - across : 0;
            const double outer = spacing * static_cast<double>(i + 1), inner = spacing * static_cast<double>(from);
            most = std::max(most, 2.0 * (within.back() - within[from]) / (outer * outer - inner * inner));
            if (within.back() > 0.5 * light) {
                break;
            }
        }
        return most;
    }

    const DiskStack& stack_;
    DiskWindow window_;
    double most_, tol_;
    int threads_;
    double *images_, *found_;
    Amplitude within_;
    TermPairs terms_;
};

}  // namespace lommel
