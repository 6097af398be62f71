// Likelihood of star images recorded as electron counts, and its derivatives with respect to the parameters of the image.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/base/aligned.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/special/log.hpp"

namespace lommel {

// Arrays over pixels. counted: electrons; recorded, read: variances of the read noise, the actual one and the one assumed by the
// fit; valid: 0 or 1.
struct StarCounts {
    const double* counted;
    const double* recorded;
    const double* read;
    const double* valid;
};

// deviance: negative log-likelihood up to a constant; expected, spread: expectation and variance of Pearson's chi^2.
struct StarLikelihood {
    double deviance = 0.0, expected = 0.0, spread = 0.0;
};

// Likelihood of electron counts with the mean flux x images[0] + background, Poisson noise and read noise. images[0]: image of the
// star for unit flux; images[1], images[2], ...: its derivatives. products[j][k]: inner product of rows j and k; rows: images[1],
// images[2], ..., images[0], 1 and the residual, all divided by each pixel's standard deviation.
template <class T>
StarLikelihood star_likelihood(const StarCounts& star, std::size_t pixels, const std::vector<const T*>& images, double flux,
                               double background, double* products) {
    constexpr std::size_t block = 4 * widest_step, most_together = 4;  // pixels per block: its rows fit in the L1 cache
    const std::size_t slopes = images.size() - 1, rows = images.size() + 2;
    Doubles all((rows + most_together) * block), sums;  // zeros beyond the last row
    StarLikelihood found;
    dispatch_widest([&](auto isa) LOMMEL_INLINE_LAMBDA {
        using V = typename decltype(isa)::pack;
        // Number of rows in a tile for which the sums of the tile stay in registers.
        constexpr std::size_t lanes = decltype(isa)::lanes, together = lanes == Avx512::lanes ? most_together : 3;
        constexpr std::size_t tile = together * together * lanes;
        const std::size_t across = (rows + together - 1) / together;
        sums.assign(across * (across + 1) / 2 * tile, 0.0);
        alignas(64) double deviance[block], expected[block], spread[block];
        V total[3] = {};
        for (std::size_t first = 0; first < pixels; first += block) {
            const std::size_t count = std::min(block, pixels - first), padded = (count + lanes - 1) / lanes * lanes;
            double* const root = &all[(slopes + 1) * block];
            double* const residual = root + block;
            for (std::size_t i = 0; i < count; ++i) {
                const double counted = star.counted[first + i], read = star.read[first + i], valid = star.valid[first + i];
                const double mean = flux * static_cast<double>(images[0][first + i]) + background;
                const double above = mean + read, least = 0.25 * read, light = mean > 0.0 ? mean : 0.0;
                const double variance = above > least ? above : least, weight = valid / variance;
                root[i] = std::sqrt(weight);
                residual[i] = (counted - mean) * root[i];
                deviance[i] = valid * (variance - (counted + read) * logarithm(variance));
                // x = Poisson(mu) + N(0, recorded) - mu, mu = light: x^2 has the mean v = mu + recorded, the variance mu + 2 v^2.
                const double exact = light + star.recorded[first + i];
                expected[i] = weight * exact;
                spread[i] = weight * weight * (light + 2.0 * exact * exact);
            }
            for (std::size_t row = 0; row <= slopes; ++row) {
                const T* const from = images[row < slopes ? row + 1 : 0] + first;
                double* const to = &all[row * block];
                for (std::size_t i = 0; i < count; ++i) {
                    to[i] = static_cast<double>(from[i]) * root[i];
                }
            }
            for (std::size_t i = count; i < padded; ++i) {  // zero padding beyond the last pixel
                deviance[i] = expected[i] = spread[i] = 0.0;
                for (std::size_t row = 0; row < rows; ++row) {
                    all[row * block + i] = 0.0;
                }
            }
            for (std::size_t i = 0; i < padded; i += lanes) {
                total[0] = total[0] + load<V>(deviance + i);
                total[1] = total[1] + load<V>(expected + i);
                total[2] = total[2] + load<V>(spread + i);
            }
            double* at = sums.data();
            for (std::size_t a = 0; a < across; ++a) {
                for (std::size_t b = a; b < across; ++b, at += tile) {
                    const double* const left = &all[a * together * block];
                    const double* const right = &all[b * together * block];
                    V sum[together][together];
                    for (std::size_t k = 0; k < together; ++k) {
                        for (std::size_t j = 0; j < together; ++j) {
                            sum[k][j] = load<V>(at + (k * together + j) * lanes);
                        }
                    }
                    for (std::size_t i = 0; i < padded; i += lanes) {
                        V one[together];
                        for (std::size_t j = 0; j < together; ++j) {
                            one[j] = load<V>(right + j * block + i);
                        }
                        for (std::size_t k = 0; k < together; ++k) {
                            const V other = load<V>(left + k * block + i);
                            for (std::size_t j = 0; j < together; ++j) {
                                sum[k][j] = sum[k][j] + other * one[j];
                            }
                        }
                    }
                    for (std::size_t k = 0; k < together; ++k) {
                        for (std::size_t j = 0; j < together; ++j) {
                            store(at + (k * together + j) * lanes, sum[k][j]);
                        }
                    }
                }
            }
        }
        found = {lane_sum(total[0]), lane_sum(total[1]), lane_sum(total[2])};
        const double* at = sums.data();
        for (std::size_t a = 0; a < across; ++a) {
            for (std::size_t b = a; b < across; ++b) {
                for (std::size_t k = a * together; k < (a + 1) * together; ++k) {
                    for (std::size_t j = b * together; j < (b + 1) * together; ++j, at += lanes) {
                        if (k < rows && j < rows) {
                            products[k * rows + j] = products[j * rows + k] = lane_sum(load<V>(at));
                        }
                    }
                }
            }
        }
    });
    return found;
}

#if defined(LOMMEL_COMPILED)
extern template StarLikelihood star_likelihood<float>(const StarCounts&, std::size_t, const std::vector<const float*>&, double,
                                                      double, double*);
extern template StarLikelihood star_likelihood<double>(const StarCounts&, std::size_t, const std::vector<const double*>&,
                                                       double, double, double*);
#endif

}  // namespace lommel
