// Linear least squares of matrices of some hundred columns, on one thread: libraries of linear algebra share such among threads
// that wait for one another, up to seconds where other programs have the processors.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/base/once.hpp"
#include "lommel/base/simd.hpp"

namespace lommel {

// The x that make |A x - b|^2 + |r x|^2 least, of each column b, by Householder's reflections: r is 1e-13 of the norm of A at most,
// so that directions in which A is smaller do not make x large. A[row][unknown], b[row][side], x[unknown][side].
class LeastSquares {
   public:
    LeastSquares(std::size_t rows, std::size_t unknowns, std::size_t sides, const double* matrix, const double* wanted);
    void solve(double* found);

   private:
    static constexpr double ridge = 1e-13;
    double* column(std::size_t j) { return columns_.data() + j * height_; }

    std::size_t rows_, unknowns_, sides_, height_;
    std::vector<double> columns_;  // of A above r, then b above 0
};

#if defined(LOMMEL_DEFINES)
LOMMEL_ONCE LeastSquares::LeastSquares(std::size_t rows, std::size_t unknowns, std::size_t sides, const double* matrix,
                                       const double* wanted)
    : rows_(rows), unknowns_(unknowns), sides_(sides), height_(rows + unknowns), columns_((unknowns + sides) * height_, 0.0) {
    double largest = 0.0;
    for (std::size_t j = 0; j < unknowns_ + sides_; ++j) {
        const bool of_matrix = j < unknowns_;
        const double* const from = of_matrix ? matrix + j : wanted + (j - unknowns_);
        double square = 0.0;
        for (std::size_t i = 0; i < rows_; ++i) {
            column(j)[i] = from[i * (of_matrix ? unknowns_ : sides_)];
            square += column(j)[i] * column(j)[i];
        }
        largest = of_matrix ? std::max(largest, square) : largest;
    }
    for (std::size_t j = 0; j < unknowns_; ++j) {
        column(j)[rows_ + j] = ridge * std::sqrt(largest * static_cast<double>(unknowns_));
    }
}

LOMMEL_ONCE void LeastSquares::solve(double* found) {
    dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
        using V = typename decltype(isa)::pack;
        constexpr std::size_t lanes = sizeof(V) / sizeof(double);
        const auto dot = [](const double* a, const double* b, std::size_t count) LOMMEL_INLINE_LAMBDA {
            V sums[4] = {};
            std::size_t i = 0;
            for (; i + 4 * lanes <= count; i += 4 * lanes) {
                for (std::size_t s = 0; s < 4; ++s) {
                    sums[s] = sums[s] + load<V>(a + i + s * lanes) * load<V>(b + i + s * lanes);
                }
            }
            double parts[lanes], sum = 0.0;
            store(parts, (sums[0] + sums[1]) + (sums[2] + sums[3]));
            for (const double part : parts) {
                sum += part;
            }
            for (; i < count; ++i) {
                sum += a[i] * b[i];
            }
            return sum;
        };
        for (std::size_t j = 0; j < unknowns_; ++j) {
            // From the diagonal to the j-th row of r; below, r has not been touched.
            const std::size_t count = rows_ + 1;
            double* const own = column(j) + j;
            const double norm = std::sqrt(dot(own, own, count)), first = own[0];
            if (norm == 0.0) {
                continue;
            }
            const double head = first + std::copysign(norm, first), scale = 1.0 / (norm * std::abs(head));
            own[0] = head;
            for (std::size_t k = j + 1; k < unknowns_ + sides_; ++k) {
                double* const other = column(k) + j;
                const double by = dot(own, other, count) * scale;
                for (std::size_t i = 0; i < count; ++i) {
                    other[i] -= by * own[i];
                }
            }
            own[0] = -std::copysign(norm, first);
        }
        for (std::size_t side = 0; side < sides_; ++side) {
            double* const from = column(unknowns_ + side);
            for (std::size_t j = unknowns_; j-- > 0;) {
                const double* const own = column(j);
                const double x = own[j] == 0.0 ? 0.0 : from[j] / own[j];
                found[j * sides_ + side] = x;
                for (std::size_t i = 0; i < j; ++i) {
                    from[i] -= x * own[i];
                }
            }
        }
    });
}
#endif

}  // namespace lommel
