// Field in polar coordinates as a sum over azimuthal orders, U(v, psi) = sum over m of A_m(v) cos(m psi) + B_m(v) sin(m psi).
//
// On a ring (an interval of the radius v), A_m and B_m are polynomials with D coefficients. The eight pixels (+-x, +-y), (+-y, +-x)
// share A_m and B_m; their cos(m psi), sin(m psi) differ by signs and swaps. One order takes about 4 D + 10 multiply-adds for all.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/base/simd.hpp"

namespace lommel {

// Azimuthal orders in use, grouped by m modulo 4 and increasing within each group.
struct ActiveOrders {
    struct Order {
        std::size_t m;
        std::size_t turns;  // number of rotations by 4 psi that lead from the previous order of the group to m
    };
    std::array<std::vector<Order>, 4> of;
    bool sines = false;  // true if some sine coefficient B_m is not negligible

    void add(std::size_t m) {
        std::vector<Order>& list = of[m % 4];
        list.push_back({m, (m - (list.empty() ? m % 4 : list.back().m)) / 4});
    }

    std::size_t highest() const {
        std::size_t top = 0;
        for (const auto& list : of) {
            top = list.empty() ? top : std::max(top, list.back().m);
        }
        return top;
    }
};

// Compute out[direction][vector], the intensities of the eight mirrored pixels of each vector lane. x: position across the ring,
// -1 to 1; (cosine, sine) = (a, b): direction of the pixel in the first octant; the eight directions: (a, b), (a, -b), (-a, b),
// (-a, -b), (b, a), (b, -a), (-b, a), (-b, -a). coefficients[order in `orders`][part][power, highest first], `Degree` powers of x;
// parts: re A_m, im A_m and, if Sines, re B_m, im B_m.
template <std::size_t Degree, bool Sines, std::size_t Unroll, class V, class Real>
LOMMEL_INLINE void sum_orders(const ActiveOrders& orders, const Real* coefficients, const V* x, const V* cosine, const V* sine,
                              V (*out)[Unroll]) {
    constexpr std::size_t parts = Sines ? 4 : 2;
    // Partial sums over the orders: [m modulo 4][A_m cos(m psi), A_m sin(m psi), B_m cos(m psi), B_m sin(m psi)][re, im].
    V sums[4][4][2][Unroll];
    V turn_c[Unroll], turn_s[Unroll], start_c[Unroll], start_s[Unroll];
    for (std::size_t u = 0; u < Unroll; ++u) {
        const V c2 = cosine[u] * cosine[u] - sine[u] * sine[u], s2 = splat<V>(Real(2)) * cosine[u] * sine[u];
        turn_c[u] = c2 * c2 - s2 * s2;
        turn_s[u] = splat<V>(Real(2)) * c2 * s2;
        start_c[u] = splat<V>(Real(1));
        start_s[u] = splat<V>(Real(0));
    }
    const Real* from = coefficients;
    for (std::size_t remainder = 0; remainder < 4; ++remainder) {
        V c[Unroll], s[Unroll], total[4][2][Unroll];
        for (std::size_t u = 0; u < Unroll; ++u) {
            c[u] = start_c[u];
            s[u] = start_s[u];
            for (std::size_t j = 0; j < 4; ++j) {
                total[j][0][u] = total[j][1][u] = splat<V>(Real(0));
            }
        }
        for (const ActiveOrders::Order& order : orders.of[remainder]) {
            for (std::size_t turn = 0; turn < order.turns; ++turn) {
                for (std::size_t u = 0; u < Unroll; ++u) {
                    const V next = c[u] * turn_c[u] - s[u] * turn_s[u];
                    s[u] = s[u] * turn_c[u] + c[u] * turn_s[u];
                    c[u] = next;
                }
            }
            V value[parts][Unroll];
            for (std::size_t p = 0; p < parts; ++p) {
                const V top = splat<V>(from[p * Degree]);
                for (std::size_t u = 0; u < Unroll; ++u) {
                    value[p][u] = top;
                }
            }
            for (std::size_t k = 1; k < Degree; ++k) {
                for (std::size_t p = 0; p < parts; ++p) {
                    const V next = splat<V>(from[p * Degree + k]);
                    for (std::size_t u = 0; u < Unroll; ++u) {
                        value[p][u] = value[p][u] * x[u] + next;
                    }
                }
            }
            from += Degree * parts;
            for (std::size_t u = 0; u < Unroll; ++u) {
                for (std::size_t part = 0; part < 2; ++part) {
                    total[0][part][u] = total[0][part][u] + value[part][u] * c[u];
                    if constexpr (Sines) {
                        total[3][part][u] = total[3][part][u] + value[2 + part][u] * s[u];
                    }
                    if (remainder % 2 == 1) {
                        total[1][part][u] = total[1][part][u] + value[part][u] * s[u];
                        if constexpr (Sines) {
                            total[2][part][u] = total[2][part][u] + value[2 + part][u] * c[u];
                        }
                    }
                }
            }
        }
        for (std::size_t u = 0; u < Unroll; ++u) {
            for (std::size_t j = 0; j < 4; ++j) {
                for (std::size_t part = 0; part < 2; ++part) {
                    sums[remainder][j][part][u] = total[j][part][u];
                }
            }
            const V next = start_c[u] * cosine[u] - start_s[u] * sine[u];
            start_s[u] = start_s[u] * cosine[u] + start_c[u] * sine[u];
            start_c[u] = next;
        }
    }
    for (std::size_t u = 0; u < Unroll; ++u) {
        V square[8];
        for (std::size_t part = 0; part < 2; ++part) {
            const V a0 = sums[0][0][part][u], a1c = sums[1][0][part][u], a2 = sums[2][0][part][u], a3c = sums[3][0][part][u],
                    a1s = sums[1][1][part][u], a3s = sums[3][1][part][u];
            const V even = a0 + a2, odd = a1c + a3c, swap = a0 - a2, turned = a1s - a3s;
            V field[8] = {even + odd,    even + odd,    even - odd,    even - odd,
                          swap + turned, swap + turned, swap - turned, swap - turned};
            if constexpr (Sines) {
                const V b0 = sums[0][3][part][u], b1s = sums[1][3][part][u], b2 = sums[2][3][part][u],
                        b3s = sums[3][3][part][u], b1c = sums[1][2][part][u], b3c = sums[3][2][part][u];
                const V along = b0 + b2, across = b1s + b3s, back = b0 - b2, over = b1c - b3c;
                field[0] = field[0] + (along + across);
                field[1] = field[1] - (along + across);
                field[2] = field[2] - (along - across);
                field[3] = field[3] + (along - across);
                field[4] = field[4] + (over - back);
                field[5] = field[5] - (over - back);
                field[6] = field[6] + (over + back);
                field[7] = field[7] - (over + back);
            }
            for (std::size_t j = 0; j < 8; ++j) {
                square[j] = part == 0 ? field[j] * field[j] : square[j] + field[j] * field[j];
            }
        }
        for (std::size_t j = 0; j < 8; ++j) {
            out[j][u] = square[j];
        }
    }
}

}  // namespace lommel
