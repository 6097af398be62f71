// Images of a star as counts of electrons: how likely they are, and what they say about the parameters of the image.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/base/aligned.hpp"
#include "lommel/base/simd.hpp"

namespace lommel {

// Of each pixel: the electrons counted, the variance of reading, the one that weights are made with, and 1 if it is valid, else 0.
struct StarCounts {
    const double* counted;
    const double* recorded;
    const double* read;
    const double* valid;
};

// Minus the logarithm of the likelihood, up to a constant; expectation and variance of Pearson's chi2.
struct StarLikelihood {
    double deviance = 0.0, expected = 0.0, spread = 0.0;
};

// The likelihood of counts that are Poisson's around flux images[0] + background, with noise of reading. Writes the products of
// images[1], ..., images[0], 1 and the residual, over the standard deviation of each pixel, with one another: a symmetric matrix.
template <class T>
StarLikelihood star_likelihood(const StarCounts& star, std::size_t pixels, const std::vector<const T*>& images, double flux,
                               double background, double* products) {
    constexpr std::size_t block = 1024, together = 4;
    const std::size_t slopes = images.size() - 1, rows = images.size() + 2;
    const std::size_t whole = (rows + together - 1) / together * together;
    Doubles all(whole * block), variance(block), exact(block);
    double* const psf = &all[slopes * block];
    double* const root = psf + block;
    double* const residual = root + block;
    StarLikelihood found;
    std::fill_n(products, rows * rows, 0.0);
    for (std::size_t first = 0; first < pixels; first += block) {
        const std::size_t count = std::min(block, pixels - first);
        const std::size_t padded = (count + widest_step - 1) / widest_step * widest_step;
        if (count < block) {  // what is beyond the last pixel is 0
            std::fill(all.begin(), all.end(), 0.0);
        }
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            using V = typename decltype(isa)::pack;
            constexpr std::size_t lanes = decltype(isa)::lanes;
            const double* const counted = star.counted + first;
            const double* const read = star.read + first;
            const double* const recorded = star.recorded + first;
            const double* const valid = star.valid + first;
            for (std::size_t i = 0; i < count; ++i) {
                const double mean = flux * static_cast<double>(images[0][first + i]) + background;
                const double above = mean + read[i], least = 0.25 * read[i], light = mean > 0.0 ? mean : 0.0;
                variance[i] = above > least ? above : least;
                root[i] = std::sqrt(valid[i] / variance[i]);
                residual[i] = (counted[i] - mean) * root[i];
                exact[i] = light + recorded[i];
                psf[i] = light;
            }
            // The square of Poisson(mu) + N(0, recorded) - mu has the mean v = mu + recorded and the variance mu + 2 v^2, exactly.
            double deviance = 0.0, expected = 0.0, spread = 0.0;
            for (std::size_t i = 0; i < count; ++i) {
                const double weight = root[i] * root[i];
                deviance += valid[i] * (variance[i] - (counted[i] + read[i]) * std::log(variance[i]));
                expected += weight * exact[i];
                spread += weight * weight * (psf[i] + 2.0 * exact[i] * exact[i]);
            }
            found.deviance += deviance;
            found.expected += expected;
            found.spread += spread;
            for (std::size_t row = 0; row <= slopes; ++row) {
                const T* const from = images[row < slopes ? row + 1 : 0] + first;
                double* const to = &all[row * block];
                for (std::size_t i = 0; i < count; ++i) {
                    to[i] = static_cast<double>(from[i]) * root[i];
                }
            }
            for (std::size_t a = 0; a < whole; a += together) {
                for (std::size_t b = a; b < whole; b += together) {
                    V sum[together][together] = {};
                    const double* const left = &all[a * block];
                    const double* const right = &all[b * block];
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
                    for (std::size_t k = a; k < std::min(a + together, rows); ++k) {
                        for (std::size_t j = b; j < std::min(b + together, rows); ++j) {
                            products[k * rows + j] += lane_sum(sum[k - a][j - b]);
                        }
                    }
                }
            }
        });
    }
    for (std::size_t k = 0; k < rows; ++k) {
        for (std::size_t j = 0; j < k; ++j) {
            products[k * rows + j] = products[j * rows + k];
        }
    }
    return found;
}

}  // namespace lommel
