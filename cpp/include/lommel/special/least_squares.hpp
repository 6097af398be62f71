// Linear least squares with some hundred unknowns, on one thread: the threads of linear algebra libraries wait for one another,
// up to seconds if other programs use the processors.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "lommel/base/simd.hpp"

namespace lommel {

// Regularised least squares by Householder reflections. Unknowns x are added one at a time, each with a regularising equation
// small * x = 0. The solution has no error bound; callers compute its residuals.
class LeastSquares {
   public:
    // `wanted`[side][equation]: right-hand sides; `most`: maximum number of unknowns; `small`: factor of the regularisation.
    LeastSquares(std::vector<std::vector<double>> wanted, std::size_t most, double small)
        : equations_(wanted[0].size()), small_(small), rest_(std::move(wanted)) {
        for (std::vector<double>& side : rest_) {
            side.resize(equations_ + most, 0.0);
        }
    }

    // Add an unknown; `factors`: its matrix column, one factor per equation.
    template <class I = Portable>
    LOMMEL_INLINE void add(const std::vector<double>& factors) {
        const std::size_t k = columns_.size();
        std::vector<double> column(factors);
        column.resize(equations_ + k, 0.0);
        column.push_back(small_);
        for (std::size_t j = 0; j < k; ++j) {
            reflect<I>(j, column);
        }
        const double square = dot<I>(&column[k], &column[k], equations_ + 1);
        const double diagonal = column[k] > 0.0 ? -std::sqrt(square) : std::sqrt(square);
        scales_.push_back(square - column[k] * diagonal);  // half of the squared norm of the Householder vector
        diagonals_.push_back(diagonal);
        column[k] -= diagonal;
        columns_.push_back(std::move(column));
        for (std::vector<double>& side : rest_) {
            reflect<I>(k, side);
        }
    }

    std::vector<double> solution(std::size_t side = 0) const {
        std::vector<double> x(rest_[side].begin(), rest_[side].begin() + static_cast<std::ptrdiff_t>(columns_.size()));
        for (std::size_t k = x.size(); k-- > 0;) {
            x[k] /= diagonals_[k];
            for (std::size_t i = 0; i < k; ++i) {
                x[i] -= columns_[k][i] * x[k];
            }
        }
        return x;
    }

   private:
    // Apply Householder reflection k. Its vector is 0 above row k and below the regularising equation of unknown k.
    template <class I>
    LOMMEL_INLINE void reflect(std::size_t k, std::vector<double>& of) const {
        const std::size_t count = equations_ + 1;
        const double* const by = &columns_[k][k];
        double* const to = &of[k];
        const double sum = dot<I>(by, to, count) / scales_[k];
        for (std::size_t i = 0; i < count; ++i) {
            to[i] -= sum * by[i];
        }
    }
    template <class I>
    LOMMEL_INLINE static double dot(const double* a, const double* b, std::size_t count) {
        using V = typename I::pack;
        constexpr std::size_t lanes = I::lanes, at_once = 4;
        V sums[at_once] = {};  // independent chains of additions
        std::size_t i = 0;
        for (; i + at_once * lanes <= count; i += at_once * lanes) {
            for (std::size_t s = 0; s < at_once; ++s) {
                sums[s] = sums[s] + load<V>(a + i + s * lanes) * load<V>(b + i + s * lanes);
            }
        }
        double parts[lanes];
        store(parts, (sums[0] + sums[1]) + (sums[2] + sums[3]));
        return std::inner_product(a + i, a + count, b + i, std::accumulate(parts, parts + lanes, 0.0));
    }

    std::size_t equations_;
    double small_;
    std::vector<std::vector<double>> rest_;
    std::vector<double> scales_, diagonals_;
    std::vector<std::vector<double>>
        columns_;  // [unknown][row]: triangular factor R above the diagonal, Householder vector from the diagonal on
};

// Find x[unknown][side] (`found`) that minimise |A x - b| for A[row][unknown] (`matrix`) and each column of b[row][side]
// (`wanted`), ignoring directions in which A is below about 1e-14 of its maximum: each unknown is regularised by 1e-14 times
// the norm of the largest column times sqrt(number of columns).
inline void least_squares(std::size_t rows, std::size_t unknowns, std::size_t sides, const double* matrix, const double* wanted,
                          double* found) {
    const auto columns = [&](const double* from, std::size_t count) {
        std::vector<std::vector<double>> made(count, std::vector<double>(rows));
        for (std::size_t i = 0; i < rows * count; ++i) {
            made[i % count][i / count] = from[i];
        }
        return made;
    };
    const auto given = columns(matrix, unknowns);
    double largest = 0.0;
    for (const std::vector<double>& column : given) {
        largest = std::max(largest, std::inner_product(column.begin(), column.end(), column.begin(), 0.0));
    }
    if (largest == 0.0) {
        std::fill_n(found, unknowns * sides, 0.0);
        return;
    }
    LeastSquares fit(columns(wanted, sides), unknowns, 1e-14 * std::sqrt(largest * static_cast<double>(unknowns)));
    dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
        for (const std::vector<double>& column : given) {
            fit.add<decltype(isa)>(column);
        }
    });
    for (std::size_t side = 0; side < sides; ++side) {
        const std::vector<double> x = fit.solution(side);
        for (std::size_t j = 0; j < unknowns; ++j) {
            found[j * sides + side] = x[j];
        }
    }
}

}  // namespace lommel
