// The field of a pupil that is not radially symmetric, made ready for the sum over azimuthal orders, and its proven error.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "lommel/azimuth.hpp"
#include "lommel/engine.hpp"
#include "lommel/pieces.hpp"
#include "lommel/zernike.hpp"

namespace lommel {

constexpr std::size_t max_degrees = 1600;  // of a Zernike series; it takes about 30 n^2 bytes

constexpr std::size_t ring_degree = 8;  // coefficients of a ring, a part of a piece

// Bound on the error of interpolation at 8 Chebyshev points on a ring, relative to sup|U|, as piece_error().
inline double ring_error(double width) { return 2.0 * std::pow(0.25 * width, ring_degree) / 40320.0; }

class ZernikeField {
   public:
    // Makes ready for v up to `reach`; returns the bound on the error of U. `inner` is the phase within the obscuration, as a
    // function of the radius over that of the obscuration.
    double prepare(const ZernikePhase& outer, const ZernikePhase& inner, double obscuration, double reach, double error) {
        obscuration_ = obscuration < 1e-9 ? 0.0 : obscuration;
        const double area = obscuration_ * obscuration_, weight = 1.0 + area;
        double bound = expand(outer, reach, 0.3 * error, outer_);
        if (area > 0.0) {
            bound += area * expand(inner, obscuration_ * reach, 0.3 * error, inner_);
        }
        bound += choose_orders(0.1 * error);
        // Radii in units of a ring are off by three roundings, and |U'| < 1.
        bound += 3.0 * unit_roundoff * reach;
        std::size_t width = 0;
        // Interpolation at 8 points magnifies the errors of the piece by 2.1 at most (its Lebesgue constant).
        while (width + 1 < widths.size() && 3.1 * piece_error(widths[width]) * weight > 0.1 * error) {
            ++width;
        }
        width_ = widths[width];
        rings_ = 1;
        while (rings_ < 256 && ring_error(width_ / static_cast<double>(rings_)) * weight > 0.1 * error) {
            ++rings_;
        }
        bound += weight * (3.1 * piece_error(width_) + ring_error(width_ / static_cast<double>(rings_)));
        pieces_ = static_cast<std::size_t>(reach / width_) + 1;
        double magnitude = 0.0;
        for (std::size_t parity = 0; parity < 2; ++parity) {
            table_[parity] = PieceTables::get(width, pieces_, (outer_.degrees + 2) / 2, parity);
            magnitude += table_[parity]->azimuthal;
            if (area > 0.0) {
                inner_table_[parity] =
                    PieceTables::get(width, inner_pieces(reach), (inner_.degrees + 2) / 2, parity);
            }
        }
        // By Cauchy and Parseval, sum |beta| |2 J_{n+1} / v| over all n and m is at most 1; cosines and sines double it.
        const double terms = static_cast<double>(std::max(outer_.degrees, inner_.degrees));
        bound += 2.0 * weight * unit_roundoff * (magnitude * (0.5 * terms + 60.0) + 6.0 * terms);
        if (area > 0.0) {
            combine_inner(inner_pieces(reach));
        }
        return bound;
    }

    std::size_t pieces() const { return pieces_; }
    std::size_t rings() const { return rings_; }  // a piece is divided into
    double width() const { return width_; }       // of a piece
    bool obscured() const { return obscuration_ > 0.0; }
    const ActiveOrders& orders() const { return orders_; }
    std::size_t parts() const { return orders_.sines ? 4 : 2; }

    // The coefficients of piece s: [order][part][power], 16 powers rising.
    template <class I>
    LOMMEL_INLINE void combine_piece(I isa, std::size_t s, Doubles& out) const {
        combine_orders(isa, outer_, table_, s, out);
    }

    // The coefficients of ring r of piece s from those of the piece, for sum_orders<Degree>: [order][part][power], the highest
    // first.
    template <std::size_t Degree, class I>
    LOMMEL_INLINE void ring(I isa, const Doubles& piece, std::size_t s, std::size_t r, std::size_t rings, Doubles& out) const {
        const std::size_t rows = orders_.count() * parts();
        out.resize(rows * Degree);
        alignas(64) double onto[degree_count * Degree];
        resample<Degree>(onto, [&](double x, double* powers) {
            fill_powers((2.0 * static_cast<double>(r) + 1.0 + x) / static_cast<double>(rings) - 1.0, powers);
        });
        multiply<Degree, false>(isa, onto, piece.data(), rows, 1.0, out.data());
        if (obscuration_ == 0.0) {
            return;
        }
        // The inner disk has its own pieces, in v times the obscuration; a ring may lie on two of them.
        const auto at = [&](double x) {
            const double v = width_ * (static_cast<double>(s) +
                                       (static_cast<double>(r) + 0.5 * (1.0 + x)) / static_cast<double>(rings));
            return obscuration_ * v / width_;
        };
        const std::size_t low = std::min(inner_rows_.size() - 1, static_cast<std::size_t>(at(-1.0)));
        const std::size_t high = std::min(inner_rows_.size() - 1, static_cast<std::size_t>(at(1.0)));
        for (std::size_t p = low; p <= high; ++p) {
            resample<Degree>(onto, [&](double x, double* powers) {
                const std::size_t mine = std::min(inner_rows_.size() - 1, static_cast<std::size_t>(at(x)));
                if (mine == p) {
                    fill_powers(2.0 * (at(x) - static_cast<double>(p)) - 1.0, powers);
                } else {
                    std::fill(powers, powers + degree_count, 0.0);
                }
            });
            multiply<Degree, true>(isa, onto, inner_rows_[p].data(), rows, -obscuration_ * obscuration_, out.data());
        }
    }

   private:
    std::size_t inner_pieces(double reach) const { return static_cast<std::size_t>(obscuration_ * reach / width_) + 1; }

    double expand(const ZernikePhase& phase, double reach, double error, ZernikeSeries& series) {
        const double size = phase.size();
        if (!(size <= max_phase)) {
            throw PhaseTooLarge("phases of " + std::to_string(size) + " rad exceed the limit of 1e6 rad");
        }
        const DiskBounds bounds = phase.bounds();
        const std::size_t by_phase = bounds.degrees(0.8 * error), by_window = disk_window_degrees(reach, 0.8 * error);
        const std::size_t degrees = std::max<std::size_t>(2, std::min(by_phase, by_window));
        const std::size_t distance = bounds.degree(0.05 * error);
        const std::size_t exact = std::max(distance, degrees) + degrees;
        if (degrees > max_degrees || exact > 4 * max_degrees) {
            throw PhaseTooLarge("these aberrations take a Zernike series of degree " + std::to_string(degrees) +
                                " and a quadrature of degree " + std::to_string(exact) + ", more than the limits of " +
                                std::to_string(max_degrees) + " and " + std::to_string(4 * max_degrees));
        }
        const auto rule = DiskRule::get(exact, degrees);
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA { analysis_.run(isa, *rule, phase, degrees, series); });
        const double truncation = by_phase <= by_window ? bounds.tail(degrees) : disk_window_tail(degrees, reach);
        // Roundings of exp(i Phi) at the nodes reach U undiminished at most; those of the sums and of the recurrences are
        // those of each coefficient, and Cauchy over all of them gives sqrt(degrees^2 / 2).
        const double sums = static_cast<double>(rule->quarter + rule->rings + 4 * degrees);
        const double rounding = phase.sensitivity() + 8.0 + 0.71 * static_cast<double>(degrees) * sums;
        return truncation + 2.0 * bounds.distance(rule->degree - degrees) + unit_roundoff * rounding;
    }

    // Leaves out orders that add up to no more than `error`; returns what they do add up to.
    double choose_orders(double error) {
        struct Size {
            double sum;
            std::size_t order;
            bool sine;
        };
        std::vector<Size> sizes;
        const std::size_t degrees = std::max(outer_.degrees, obscuration_ > 0.0 ? inner_.degrees : 0);
        const double area = obscuration_ * obscuration_;
        for (std::size_t m = 0; m < degrees; ++m) {
            double cosine = size(outer_, m, outer_.cos_re, outer_.cos_im), sine = size(outer_, m, outer_.sin_re, outer_.sin_im);
            if (area > 0.0) {
                cosine += area * size(inner_, m, inner_.cos_re, inner_.cos_im);
                sine += area * size(inner_, m, inner_.sin_re, inner_.sin_im);
            }
            sizes.push_back({cosine, m, false});
            sizes.push_back({sine, m, true});
        }
        std::sort(sizes.begin(), sizes.end(), [](const Size& a, const Size& b) { return a.sum < b.sum; });
        double left = 0.0;
        std::vector<bool> active(degrees, false);
        orders_ = ActiveOrders();
        for (const Size& s : sizes) {
            if (left + s.sum <= error) {
                left += s.sum;
            } else {
                active[s.order] = true;
                orders_.sines = orders_.sines || s.sine;
                error = -1.0;  // the rest are larger
            }
        }
        for (std::size_t m = 0; m < degrees; ++m) {
            if (active[m]) {
                orders_.add(m);
            }
        }
        return left;
    }

    // What an order can add to U: |2 (n+1) J_{n+1}(v) / v| <= 1.
    static double size(const ZernikeSeries& series, std::size_t m, const Doubles& re, const Doubles& im) {
        double sum = 0.0;
        for (std::size_t j = 0; m < series.degrees && j < series.count(m); ++j) {
            const std::size_t at = series.start[m] + j;
            sum += std::hypot(re[at], im[at]) / static_cast<double>(m + 2 * j + 1);
        }
        return sum;
    }

    using Tables = std::array<std::shared_ptr<const PieceTable>, 2>;

    template <class I>
    LOMMEL_INLINE void combine_orders(I isa, const ZernikeSeries& series, const Tables& tables, std::size_t s, Doubles& out) const {
        out.resize(orders_.count() * parts() * degree_count);
        double* to = out.data();
        for (const auto& list : orders_.of) {
            for (const ActiveOrders::Order& order : list) {
                const std::size_t m = order.m;
                if (m >= series.degrees) {
                    std::fill(to, to + parts() * degree_count, 0.0);
                } else {
                    const Piece& piece = *tables[m % 2]->pieces[s];
                    const std::size_t at = series.start[m], count = series.count(m);
                    combine(isa, piece, count, &series.cos_re[at], &series.cos_im[at], to, to + degree_count, m / 2);
                    if (orders_.sines) {
                        combine(isa, piece, count, &series.sin_re[at], &series.sin_im[at], to + 2 * degree_count,
                                to + 3 * degree_count, m / 2);
                    }
                }
                to += parts() * degree_count;
            }
        }
    }

    void combine_inner(std::size_t pieces) {
        inner_rows_.resize(pieces);
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            for (std::size_t p = 0; p < inner_rows_.size(); ++p) {
                combine_orders(isa, inner_, inner_table_, p, inner_rows_[p]);
            }
        });
    }

    static void fill_powers(double x, double* powers) {
        double power = 1.0;
        for (std::size_t l = 0; l < degree_count; ++l) {
            powers[l] = power;
            power *= x;
        }
    }

    // The matrix from 16 coefficients of a piece to those of its interpolant at Degree points: [power][highest first].
    template <std::size_t Degree, class Powers>
    static void resample(double* onto, const Powers& powers_at) {
        static const auto matrix = [] {
            std::array<std::array<double, Degree>, Degree> m;
            for (std::size_t k = 0; k < Degree; ++k) {
                for (std::size_t j = 0; j < Degree; ++j) {
                    m[k][j] = static_cast<double>(chebyshev_to_monomials<Degree>()[k][j]);
                }
            }
            return m;
        }();
        std::fill(onto, onto + degree_count * Degree, 0.0);
        double powers[degree_count];
        for (std::size_t j = 0; j < Degree; ++j) {
            powers_at(chebyshev_point(j, Degree), powers);
            for (std::size_t l = 0; l < degree_count; ++l) {
                for (std::size_t k = 0; k < Degree; ++k) {
                    onto[l * Degree + Degree - 1 - k] += powers[l] * matrix[k][j];
                }
            }
        }
    }

    template <std::size_t Degree, bool Add, class I>
    static LOMMEL_INLINE void multiply(I, const double* onto, const double* rows, std::size_t count, double weight, double* out) {
        using V = typename I::pack;
        constexpr std::size_t packs = Degree / I::lanes;
        for (std::size_t i = 0; i < count; ++i, rows += degree_count, out += Degree) {
            V sums[2][packs];
            for (std::size_t p = 0; p < packs; ++p) {
                sums[0][p] = sums[1][p] = splat<V>(0.0);
            }
            for (std::size_t l = 0; l < degree_count; l += 2) {
                for (std::size_t j = 0; j < 2; ++j) {
                    const V c = splat<V>(rows[l + j]);
                    for (std::size_t p = 0; p < packs; ++p) {
                        sums[j][p] = sums[j][p] + c * load<V>(onto + (l + j) * Degree + p * I::lanes);
                    }
                }
            }
            for (std::size_t p = 0; p < packs; ++p) {
                V total = sums[0][p] + sums[1][p];
                if constexpr (Add) {
                    total = load<V>(out + p * I::lanes) + splat<V>(weight) * total;
                }
                store(out + p * I::lanes, total);
            }
        }
    }

    ZernikeSeries outer_, inner_;
    ZernikeAnalysis analysis_;
    ActiveOrders orders_;
    Tables table_, inner_table_;
    std::vector<Doubles> inner_rows_;
    double obscuration_ = 0.0, width_ = 1.0;
    std::size_t pieces_ = 0, rings_ = 1;
};

}  // namespace lommel
