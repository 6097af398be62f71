// What tables lose that are made in double, as they are where no wider numbers are: against the same tables in extended
// precision, where there is that, and what docs/certificate.md counts for it. Returns 1 and says where if it is more.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <vector>

#include "lommel/chordal/tables.hpp"
#include "lommel/special/bessel_table.hpp"
#include "lommel/special/chebyshev.hpp"
#include "lommel/special/legendre.hpp"

#include "check.hpp"

namespace {

using extended = long double;
constexpr double unit = 0.5 * std::numeric_limits<double>::epsilon();

double units(extended difference) { return std::abs(static_cast<double>(difference)) / unit; }

// sqrt(2n+1) sum |w P_n - its value|, the largest of all n; and the root mean square of the errors of P_n for the phase.
void legendre_rule(std::size_t nodes) {
    std::vector<double> x(nodes), w(nodes), p(nodes);
    std::vector<extended> exact_x(nodes), exact_w(nodes), sums(nodes), squares(31);
    lommel::gauss_legendre<double, double>(nodes, x.data(), w.data());
    lommel::gauss_legendre<extended, extended>(nodes, exact_x.data(), exact_w.data());
    double off = 0.0;
    for (std::size_t q = nodes / 2; q < nodes; ++q) {
        off = std::max(off, units(x[q] - exact_x[q]));
        lommel::legendre_sequence<double>(x[q], nodes, p.data());
        lommel::each_legendre(1 - static_cast<extended>(x[q]), nodes, [&](std::size_t n, extended exact) {
            sums[n] += std::abs(w[q] * static_cast<extended>(p[n]) - exact_w[q] * exact);
            if (n < squares.size()) {
                squares[n] += exact_w[q] * (p[n] - exact) * (p[n] - exact);
            }
        });
    }
    double worst = 0.0, phase = 0.0;
    for (std::size_t n = 0; n < nodes; ++n) {
        worst = std::max(worst, units(sums[n] * std::sqrt(static_cast<extended>(2 * n + 1))));
    }
    for (const extended square : squares) {
        phase = std::max(phase, units(std::sqrt(square)));
    }
    std::printf("%5zu nodes: off by %.2f, sums by %.2f of the root, P_n by %.2f\n", nodes, off,
                worst / std::sqrt(static_cast<double>(nodes)), phase);
    check(off < 2.0, "nodes", off);
    check(worst < 1.5 * std::sqrt(static_cast<double>(nodes)), "sums of weighted polynomials", worst);
    check(phase < 1.0, "polynomials of the phase", phase);
}

// By Cauchy, as the size of the coefficients is counted, over places in a piece: the Bessel functions at its points, against
// Miller's recurrence in extended precision; and what becomes of them.
void bessel_piece(double width, std::size_t s) {
    constexpr std::size_t m = lommel::degree_count, places = 81;
    const lommel::ChebyshevToMonomials<m, extended> exactly;
    const std::size_t terms = lommel::Piece::most(width, s);
    const lommel::Piece piece = lommel::made_piece(width, s, terms);
    for (std::size_t fewer : {terms / 8, terms / 3, terms / 2, terms - 1}) {
        const lommel::Piece first = lommel::made_piece(width, s, fewer);
        check(std::equal(first.rows.begin(), first.rows.end(), piece.rows.begin()), "rows that depend on their number",
              static_cast<double>(fewer));
    }
    double points[m];
    for (std::size_t j = 0; j < m; ++j) {
        points[j] = width * (static_cast<double>(s) + 0.5 * (1.0 + lommel::piece_rule.point(j)));
    }
    lommel::Doubles values(m * (terms + lommel::row_lanes));
    lommel::dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA { lommel::piece_values(isa, points, terms, terms, values.data()); });
    double off = 0.0;
    for (std::size_t j = 0; j < m; ++j) {
        std::vector<extended> orders(2 * terms + 300);
        std::size_t k = orders.size() - 1;
        for (orders[k - 1] = 1e-2000L; --k > 0;) {
            orders[k - 1] = 2 * static_cast<extended>(k) / points[j] * orders[k] - orders[k + 1];
        }
        extended sum = orders[0], square = 0;
        for (k = 2; k < orders.size(); k += 2) {
            sum += 2 * orders[k];
        }
        for (std::size_t n = 0; n < terms; ++n) {
            const extended exact = (n % 2 == 0 ? 2 : -2) * orders[2 * n + 1] / (sum * points[j]);
            square += static_cast<extended>(2 * n + 1) * (values[n * m + j] - exact) * (values[n * m + j] - exact);
        }
        off = std::max(off, units(std::sqrt(square)));
    }
    std::vector<extended> errors(places);
    for (std::size_t n = 0; n < terms; ++n) {
        extended exact[m];
        exactly(&values[n * m], 1, exact);
        for (std::size_t i = 0; i < places; ++i) {
            const extended x = -1 + 2 * static_cast<extended>(i) / (places - 1);
            extended error = 0;
            for (std::size_t k = m; k-- > 0;) {
                error = error * x + (piece.rows[n * m + k] - exact[k]);
            }
            errors[i] += static_cast<extended>(2 * n + 1) * error * error;
        }
    }
    const double worst = units(std::sqrt(*std::max_element(errors.begin(), errors.end())) / piece.magnitude);
    std::printf("width %4.1f, piece %3zu: off by %.2f, then by %.2f units of size %.3g\n", width, s, off, worst,
                piece.magnitude);
    check(off < 4.0, "Bessel functions of a piece", off);
    check(worst < 1.0, "conversion of a piece", worst);
}

// Terms at the nodes of the chordal rule, against the rule and the terms in extended precision.
void zernike_terms(std::size_t chords) {
    std::vector<double> eta(chords), w(chords);
    std::vector<extended> exact_eta(chords), exact_w(chords);
    lommel::gauss_legendre<double, double>(chords, eta.data(), w.data());
    lommel::gauss_legendre<extended, extended>(chords, exact_eta.data(), exact_w.data());
    double weights = 0.0, worst = 0.0, off = 0.0;
    for (std::size_t k = 0; k < chords; ++k) {
        weights += units(w[k] - exact_w[k]);
    }
    for (std::int32_t n = 1; n <= 60; ++n) {
        for (std::int32_t m = -n; m <= n; m += 2) {
            const lommel::ZernikeValues polynomial({{n, m}}, {0});
            for (std::size_t i = 0; i < chords / 2; i += 3) {
                const double angle = std::acos(-1.0) * static_cast<double>(i + 1) / static_cast<double>(chords + 1);
                const extended turn =
                    std::acos(extended(-1)) * static_cast<extended>(i + 1) / static_cast<extended>(chords + 1);
                for (std::size_t k = chords / 2; k < chords; k += 3) {
                    const double x = std::cos(angle), y = std::sin(angle) * eta[k];
                    const extended exact_x = std::cos(turn), exact_y = std::sin(turn) * exact_eta[k];
                    double value = 0.0;
                    extended exact = 0.0;
                    polynomial.at(x, y, [&](std::size_t, double found) { value = found; });
                    polynomial.at(exact_x, exact_y, [&](std::size_t, extended found) { exact = found; });
                    worst = std::max(worst, units(value - exact) / static_cast<double>(n * n));
                    off = std::max({off, units(x - exact_x), units(y - exact_y)});
                }
            }
        }
    }
    std::printf("%5zu chords: weights off by %.1f, terms by %.2f n^2, places by %.2f\n", chords, weights, worst, off);
    check(weights < static_cast<double>(chords + 24), "weights", weights);
    check(worst < 3.0, "terms", worst);
    check(off < 3.0, "places", off);
}

}  // namespace

int main() {
    if (std::numeric_limits<extended>::digits == std::numeric_limits<double>::digits) {
        std::printf("no extended precision here\n");
        return 0;
    }
    for (std::size_t nodes = 8; nodes < 4096; nodes += nodes < 256 ? 8 : nodes / 4 / 64 * 64) {
        legendre_rule(nodes);
    }
    for (const double width : lommel::widths) {
        for (const std::size_t s : {1, 4, 30, 200}) {
            bessel_piece(width, s);
        }
    }
    for (const std::size_t chords : {4, 16, 64, 256}) {
        zernike_terms(chords);
    }
    return finished();
}
