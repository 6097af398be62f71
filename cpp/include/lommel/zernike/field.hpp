// Field of a pupil without radial symmetry: for each azimuthal order a polynomial in the radius v, with an error bound.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "lommel/base/once.hpp"
#include "lommel/base/parallel.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/special/bessel_table.hpp"
#include "lommel/zernike/disk.hpp"
#include "lommel/zernike/expansion.hpp"
#include "lommel/zernike/orders.hpp"
#include "lommel/zernike/rings.hpp"

namespace lommel {

constexpr double max_coefficients = 134217728.0;  // maximum number of coefficients for all pieces of an image: 1 GiB

// Directions at which the field is sampled, equally spaced; none is a symmetry axis of a Zernike term of low azimuthal order.
struct Directions {
    static constexpr std::size_t count = 32;
    std::array<double, count> cosine, sine;

    Directions() {
        for (std::size_t i = 0; i < count; ++i) {
            const double psi = 6.283185307179586 * (static_cast<double>(i) + 0.37) / count;
            cosine[i] = std::cos(psi);
            sine[i] = std::sin(psi);
        }
    }
};
inline const Directions directions;

// Field U of one pupil: on radial pieces, a polynomial in v for each azimuthal order of the full disk and of the obscuration.
class ZernikeField {
   public:
    // Expand the pupil for an error of U of about `error` at v <= reach. outer: phase on the full disk; inner: phase within the
    // obscuration, a function of (radius / its radius); lost: error of U from rounding in the coefficients of both phases.
    void expand(const ZernikePhase& outer, const ZernikePhase& inner, double obscuration, double reach, double error,
                double lost = 0.0, int threads = 1) {
        // An obscuration is neglected if its area is below rounding.
        obscuration_ = obscuration < 1e-9 ? 0.0 : obscuration;
        const double area = obscuration_ * obscuration_;
        reach_ = reach;
        weight_ = 1.0 + area;
        // The rounding error of v is at most 6 v u, u being the unit roundoff; as |dU/dv| < 1/2, that of U is at most 3 v u.
        base_ = lost + expand(outer, reach, ZernikeBudget::outer * error, threads, outer_) + 3.0 * unit_roundoff * reach;
        inner_.degrees = inner_.orders = 0;
        if (area > 0.0) {
            base_ += area * expand(inner, obscuration_ * reach, ZernikeBudget::inner * error, threads, inner_);
        }
        base_ += trim(outer_, 1.0, ZernikeBudget::small * error) + trim(inner_, area, ZernikeBudget::small * error);
    }

    // Mean of I over all azimuths at the radius v; different orders are orthogonal.
    double mean(double v) const {
        const std::vector<double>& orders = all_orders(v);
        double sum = 0.0;
        for (std::size_t i = 0; i < orders.size(); ++i) {
            sum += (i < 4 ? 1.0 : 0.5) * orders[i] * orders[i];
        }
        return sum;
    }

    // Largest I over the sampled directions at the radius v, from Bessel functions without interpolation.
    double look(double v) const;

    // Compute the coefficients of the pieces in use: in_use(number of pieces) returns their indices, ascending. Omitted orders
    // and interpolation change U by at most about `error`. Afterwards, base() is the error of U that all pieces have in common.
    template <class InUse>
    void prepare(double error, int threads, const InUse& in_use) {
        orders_.measure(outer_, inner_, obscuration_);
        const double trimmed = ZernikeBudget::trimmed * error;
        base_ +=
            trim(outer_, 1.0, trimmed) + trim(inner_, weight_ - 1.0, trimmed) + orders_.keep(ZernikeBudget::dropped * error);
        std::size_t width = 0;
        // Interpolation at the 8 points of a ring multiplies the error of a piece by at most 2.3 (Lebesgue constant); 3.1 is used.
        while (width + 1 < widths.size() && 3.1 * piece_error(widths[width]) * weight_ > ZernikeBudget::pieces * error) {
            ++width;
        }
        width_ = widths[width];
        base_ += weight_ * 3.1 * piece_error(width_);
        const std::size_t pieces = static_cast<std::size_t>(reach_ / width_) + 1;
        WantedPieces wanted, within;
        wanted.others = in_use(pieces);
        if (obscured()) {
            inner_rows_.resize(static_cast<std::size_t>(obscuration_ * reach_ / width_) + 1);
            for (const std::size_t s : wanted.others) {
                for (std::size_t p = inner_piece(static_cast<double>(s)); p <= inner_piece(static_cast<double>(s + 1)); ++p) {
                    if (within.others.empty() || within.others.back() < p) {
                        within.others.push_back(p);
                    }
                }
            }
        }
        if (static_cast<double>(wanted.others.size() + within.others.size()) *
                static_cast<double>(orders_.kept().size() * 4 * degree_count) >
            max_coefficients) {
            throw LimitExceeded("aberrations and a window that reaches to v = " + std::to_string(reach_) +
                                " take more than 1 GiB of coefficients");
        }
        Tables tables, inner_tables;
        double magnitude = 0.0;
        for (std::size_t parity = 0; parity < 2; ++parity) {
            PieceTables& all = parity == 0 ? even_pieces : odd_pieces;
            tables[parity] = all.get(width, wanted, (outer_.degrees + 2) / 2);
            magnitude += tables[parity]->azimuthal;
            if (obscured()) {
                inner_tables[parity] = all.get(width, within, (inner_.degrees + 2) / 2);
            }
        }
        // Rounding. The sum over all Zernike terms of |2 beta J_{n+1}(v) / v|, beta being the coefficient of a term of degree n, is
        // at most 1 for terms with factors exp(i m psi) (Cauchy, Parseval), hence at most 2 with cos(m psi) and sin(m psi).
        const double terms = static_cast<double>(std::max(outer_.degrees, inner_.degrees));
        base_ += 2.0 * weight_ * unit_roundoff * (magnitude * (0.5 * terms + 60.0) + 6.0 * terms);
        rows_.resize(pieces);
        combine_all(outer_, tables, wanted.others, rows_, threads);
        if (obscured()) {
            combine_all(inner_, inner_tables, within.others, inner_rows_, threads);
        }
    }

    std::size_t pieces() const { return rows_.size(); }
    double width() const { return width_; }  // width of a piece, in v
    double base() const { return base_; }
    bool obscured() const { return obscuration_ > 0.0; }
    double obscuration() const { return obscuration_; }
    double reach() const { return reach_; }
    const ZernikeSeries& outer() const { return outer_; }
    const ZernikeSeries& inner() const { return inner_; }

    // Plan the evaluation of piece s with `groups` groups of mirrored pixels, for an error of U of about `error`.
    PiecePlan plan(std::size_t s, double error, std::size_t groups) const {
        PiecePlan made;
        const double spare = std::max(0.0, error - base_);
        made.error = base_ + orders_.select(width_ * static_cast<double>(s), ZernikeBudget::own_orders * spare, made);
        std::size_t rings = 1;
        // If base() takes nearly all of `error`, rings are allowed a share of base() instead, as `error` is a goal and not a limit.
        const double across = std::max(ZernikeBudget::rings * spare, ZernikeBudget::rings_least * base_);
        while (rings < 256 && ring_error(width_ / static_cast<double>(rings)) * weight_ > across) {
            ++rings;
        }
        // Dividing a piece into rings saves time only if the rings contain enough pixels to fill vectors.
        if (obscured() || groups > 20 * rings) {
            made.rings = rings;
            made.error += ring_error(width_ / static_cast<double>(rings)) * weight_;
        } else {
            made.rings = 0;
        }
        return made;
    }

    // Write to `out` the coefficients with which sum_orders<16> computes I on the undivided piece s; only for unobscured pupils.
    void whole(const PiecePlan& plan, std::size_t s, Doubles& out) const {
        const std::size_t parts = plan.orders.sines ? 4 : 2;
        out.resize(plan.rows.size() * parts * degree_count);
        double* to = out.data();
        for (const std::size_t row : plan.rows) {
            const double* from = &rows_[s][row * 4 * degree_count];
            for (std::size_t p = 0; p < parts; ++p, to += degree_count, from += degree_count) {
                std::reverse_copy(from, from + degree_count, to);
            }
        }
    }

    // Write to `out` the coefficients with which sum_orders<8> computes the intensity on ring r (an interval of v) of piece s.
    template <class I>
    LOMMEL_INLINE void ring(I isa, const PiecePlan& plan, std::size_t s, std::size_t r, Doubles& out) const {
        const std::size_t parts = plan.orders.sines ? 4 : 2;
        out.resize(plan.rows.size() * parts * ring_degree);
        const double rings = static_cast<double>(plan.rings), start = static_cast<double>(r);
        alignas(64) double onto[degree_count * ring_degree];
        resample(onto, [&](double x, double* powers) { fill_powers((2.0 * start + 1.0 + x) / rings - 1.0, powers); });
        resample_rows<false>(isa, onto, rows_[s].data(), plan.rows, parts, 1.0, out.data());
        if (!obscured()) {
            return;
        }
        // Pieces of the obscuration are intervals of eps v, with eps the obscuration ratio; a ring may overlap two of them.
        const auto at = [&](double x) { return obscuration_ * (static_cast<double>(s) + (start + 0.5 * (1.0 + x)) / rings); };
        const auto piece_at = [&](double x) { return inner_piece(static_cast<double>(s) + (start + 0.5 * (1.0 + x)) / rings); };
        for (std::size_t p = piece_at(-1.0); p <= piece_at(1.0); ++p) {
            resample(onto, [&](double x, double* powers) {
                if (piece_at(x) == p) {
                    fill_powers(2.0 * (at(x) - static_cast<double>(p)) - 1.0, powers);
                } else {
                    std::fill(powers, powers + degree_count, 0.0);
                }
            });
            resample_rows<true>(isa, onto, inner_rows_[p].data(), plan.rows, parts, -obscuration_ * obscuration_, out.data());
        }
    }

   private:
    // Index of the obscuration's piece that contains obscuration() * v, for v = at * width(). Its pieces, too, are width() wide.
    std::size_t inner_piece(double at) const {
        return std::min(inner_rows_.size() - 1, static_cast<std::size_t>(obscuration_ * at));
    }

    using Tables = std::array<std::shared_ptr<const PieceTable>, 2>;

    double expand(const ZernikePhase& phase, double reach, double error, int threads, ZernikeSeries& series);

    // Factors A_m, B_m of cos(m psi), sin(m psi) in U at the radius v: [order m][re A, im A, re B, im B].
    const std::vector<double>& all_orders(double v) const {
        thread_local std::vector<double> orders;
        orders.assign(4 * std::max(outer_.orders, inner_.orders), 0.0);
        add_orders(outer_, v, 1.0, orders.data());
        if (obscured()) {
            add_orders(inner_, obscuration_ * v, -obscuration_ * obscuration_, orders.data());
        }
        return orders;
    }

    // Add A_m(v), B_m(v) of one disk, times `weight`, to the four numbers of each order m in `orders`.
    static void add_orders(const ZernikeSeries& series, double v, double weight, double* orders);

    // Compute polynomial coefficients of pieces: rows[piece][order kept][re A, im A, re B, im B][power, increasing].
    void combine_all(const ZernikeSeries& series, const Tables& tables, const std::vector<std::size_t>& pieces,
                     std::vector<Doubles>& rows, int threads) const;

    ZernikeSeries outer_, inner_;
    ZernikeAnalysis analysis_;
    PupilOrders orders_;
    std::vector<Doubles> rows_, inner_rows_;
    double obscuration_ = 0.0, reach_ = 0.0, weight_ = 1.0, width_ = 1.0, base_ = 0.0;
};

#if defined(LOMMEL_DEFINES)
LOMMEL_ONCE double ZernikeField::expand(const ZernikePhase& phase, double reach, double error, int threads,
                                        ZernikeSeries& series) {
    check_phase(phase.size());
    const DiskExpansion plan(phase, reach, error);
    analysis_.run(*plan.rule, phase, plan.degrees, plan.orders, threads, series);
    return plan.error(phase);
}
#endif

#if defined(LOMMEL_DEFINES)
LOMMEL_ONCE double ZernikeField::look(double v) const {
    const std::vector<double>& orders = all_orders(v);
    const double *const begin = orders.data(), *const end = begin + orders.size();
    double top = 0.0;
    dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
        using I = decltype(isa);
        using V = typename I::pack;
        for (std::size_t first = 0; first < Directions::count; first += I::lanes) {
            const V turn_c = load<V>(directions.cosine.data() + first), turn_s = load<V>(directions.sine.data() + first);
            V c = splat<V>(1.0), s = splat<V>(0.0), re = s, im = s;
            for (const double* order = begin; order < end; order += 4) {
                re = re + c * splat<V>(order[0]) + s * splat<V>(order[2]);
                im = im + c * splat<V>(order[1]) + s * splat<V>(order[3]);
                const V next = c * turn_c - s * turn_s;
                s = s * turn_c + c * turn_s;
                c = next;
            }
            const V square = re * re + im * im;
            for (std::size_t i = 0; i < I::lanes; ++i) {
                top = std::max(top, square[i]);
            }
        }
    });
    return top;
}

LOMMEL_ONCE void ZernikeField::add_orders(const ZernikeSeries& series, double v, double weight, double* orders) {
    thread_local std::vector<double> bessel, transforms[2];
    // J_{n+1}(v) is negligible for degrees n far above v.
    const std::size_t reached = std::min(series.degrees, static_cast<std::size_t>(v + 6.0 * std::cbrt(v) + 12.0));
    for (std::size_t parity = 0; parity < 2; ++parity) {
        transforms[parity].assign((series.degrees + 2) / 2, 0.0);
        zernike_transforms(parity, v, (reached + 2) / 2, transforms[parity].data(), bessel);
    }
    dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
        using I = decltype(isa);
        using V = typename I::pack;
        for (std::size_t m = 0; m < std::min(reached, series.orders); ++m) {
            const double* row = transforms[m % 2].data() + m / 2;
            const std::size_t count = std::min(series.used[m], (reached - m) / 2 + 1), at = series.start[m];
            V sums[4] = {};
            std::size_t j = 0;
            for (; j + I::lanes <= count; j += I::lanes) {
                const V t = load<V>(row + j);
                for (std::size_t p = 0; p < 4; ++p) {
                    sums[p] = sums[p] + t * load<V>(&series.parts[p][at + j]);
                }
            }
            for (std::size_t p = 0; p < 4; ++p) {
                double total = lane_sum(sums[p]);
                for (std::size_t i = j; i < count; ++i) {
                    total += row[i] * series.parts[p][at + i];
                }
                orders[4 * m + p] += weight * total;
            }
        }
    });
}

LOMMEL_ONCE void ZernikeField::combine_all(const ZernikeSeries& series, const Tables& tables,
                                           const std::vector<std::size_t>& pieces, std::vector<Doubles>& rows,
                                           int threads) const {
    parallel_for(pieces.size(), threads, [&](std::size_t, std::size_t task) {
        const std::size_t s = pieces[task];
        rows[s].resize(orders_.kept().size() * 4 * degree_count);
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            double* to = rows[s].data();
            for (std::size_t i = 0; i < orders_.kept().size(); ++i, to += 4 * degree_count) {
                const std::size_t m = orders_.kept()[i];
                if (m >= series.orders) {
                    std::fill(to, to + 4 * degree_count, 0.0);
                    continue;
                }
                const Piece& piece = *tables[m % 2]->pieces[s];
                const std::size_t at = series.start[m], count = series.used[m];
                for (std::size_t p = 0; p < 4; p += 2) {
                    combine(isa, piece, count, &series.parts[p][at], &series.parts[p + 1][at], to + p * degree_count,
                            to + (p + 1) * degree_count, m / 2);
                }
            }
        });
    });
}
#endif

}  // namespace lommel
