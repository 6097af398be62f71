// Weighted sums of many profiles: averages over pixels, from intensities at radii that are few.
#pragma once

#include <cstddef>

#include "lommel/base/simd.hpp"
#include "lommel/imaging/product.hpp"
#include "lommel/radial/profiles.hpp"

namespace lommel {

// out[pupil * sums + j] = sum over i of I(v[i]) matrix[i * sums + j], bounds as those of profiles().
inline void profile_sums(const Stack& stack, const double* v, std::size_t count, double tol, const double* matrix,
                         std::size_t sums, int threads, double* out, double* bounds) {
    const auto fill = [&](std::size_t first, std::size_t some, double* values) {
        Stack part = stack;
        part.coefficients += first * stack.terms;
        part.count = some;
        Doubles peaks(some);
        profiles(part, v, count, tol, values, bounds + first, peaks.data());
    };
    product(stack.count, count, matrix, sums, threads, fill, out);
}

}  // namespace lommel
