// Depth of each block of pixels: the candidate of least energy (mean squared residual), its standard error and misfit.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "lommel/base/aligned.hpp"
#include "lommel/base/simd.hpp"

namespace lommel {

// Depth candidates, at equal steps of vergence (1 / distance). The energy E of a candidate is the sum of forms[candidate][product]
// times products of residual images. E', E'': derivatives of E with respect to the index of the candidate; kappa = E'' / 2.
// statistics[row][candidate]; row 0: E of white noise; 1: (variance of E' / 2 due to texture) / kappa; 2: variance of E' / 2 due to
// noise; 3: kappa / (mean of E over candidates - minimum of E); 4: variance of kappa due to noise; 5: concentration (see
// FocalSearch) of a texture of all frequencies; 6: leak, the part of the mean E of a single frequency that the filters of its
// own candidate let through; 7: bias of the candidate of least E, of a texture of all frequencies.
struct FocalCandidates {
    static constexpr std::size_t rows = 8;

    std::size_t count;  // number of candidates, 4 n + 1 with an integer n >= 2
    const float *forms, *statistics;
    float read_variance;  // variance of a dark pixel after binning, electrons^2
    float pixels;  // effective number of binned pixels in an averaging window
    float first, step;  // vergence of the first candidate, and step between candidates, 1 / m
    float low, high;  // valid range of depth positions, in candidates
    float largest;  // depths with a larger standard error are unknown, in candidates
};

// Depth estimate of one block. position: index of the candidate, fractional, NaN if unknown; error: standard error of position,
// infinite if unknown; misfit: 1 on average if the frames fit a single depth; texture: mean energy of the candidates. Both are NaN
// where few pixels of the window are trusted.
struct FocalPlace {
    float position, error, misfit, texture;
};

// Depth search for blocks: energies at every fourth candidate, then the exact minimum around the lowest of them.
//
// A single frequency, as of a periodic texture, determines the ratio of two transfer functions, which several depths can share.
// Energies of these depths differ by the leak of the fitted filters, and the lowest may be of another depth than the true one. The
// concentration of a texture is tr(P^2) / (tr P)^2, where P is the matrix of the products of the residual images of a channel: 1 for
// a single frequency, and about 1 / images for a texture of all frequencies, because the tables make such images uncorrelated. The
// more concentrated a texture is, the more of its energy may be leak.
class FocalSearch {
    static constexpr std::size_t lanes_ = 16;

   public:
    // Products of the residual images k <= l of each channel, in the order of FocalStream.
    FocalSearch(const FocalCandidates& given, std::size_t channels, std::size_t images)
        : given_(given), channels_(channels), images_(images), products_(channels * images * (images + 1) / 2),
          padded_((products_ + 3) / 4 * 4), width_(given.count + near),
          rough_width_((roughs() + several - 1) / several * several), forms_(padded_ * width_),
          rough_(products_ * rough_width_), noise_(given.count + near),
          statistics_(given.statistics, given.statistics + given.rows * given.count) {
        const std::size_t products = products_;
        for (std::size_t q = 0; q < products; ++q) {
            for (std::size_t c = 0; c < given.count; ++c) {
                forms_[q * width_ + c] = given.forms[c * products + q];
            }
            for (std::size_t c = 0; c < roughs(); ++c) {
                rough_[q * rough_width_ + c] = given.forms[rough_step * c * products + q];
            }
        }
        std::copy_n(given.statistics, given.count, noise_.begin());
        given_.forms = given_.statistics = nullptr;
    }

    const FocalCandidates& candidates() const { return given_; }

    // The lowest rough candidate of each block, the first and last one of its valley, and the lowest energy of those outside.
    struct Valley {
        float best[lanes_], low[lanes_], high[lanes_], second[lanes_];
    };
    // Working memory of one thread.
    struct Scratch {
        explicit Scratch(const FocalSearch& of) : energies(of.rough_width_ * lanes_) {}
        Floats energies;
        float concentration[lanes_], mean[lanes_];
        Valley valley;
    };

    // Estimate the depths of up to one vector of blocks. sums[product * pitch + block]: products of residual images, averaged
    // over the window and divided by the noise variance. trust[block]: fraction of the window's pixels that are trusted (known,
    // and far from unknown pixels and from the border). wider[block] * more: effective pixels of this window / of one of a block.
    template <class I>
    LOMMEL_INLINE void operator()(I, const float* sums, std::size_t pitch, const float* trust, const float* wider, float more,
                                  std::size_t blocks, Scratch& scratch, FocalPlace* out) const {
        using V = typename I::floats;
        constexpr std::size_t lanes = 2 * I::lanes;
        const std::size_t count = roughs();
        float* const energies = scratch.energies.data();
        // Energies at every fourth candidate, for all blocks at once. Eight parallel sums hide the latency of additions.
        for (std::size_t c = 0; c < count; c += several) {
            V total[several] = {};
            for (std::size_t q = 0; q < products_; ++q) {
                const V sum = load<V>(sums + q * pitch);
                const float* const form = rough_.data() + q * rough_width_ + c;
                for (std::size_t t = 0; t < several; ++t) {
                    total[t] = total[t] + splat<V>(form[t]) * sum;
                }
            }
            for (std::size_t t = 0; t < several; ++t) {
                store(energies + (c + t) * lanes, total[t]);
            }
        }
        concentrate<V>(sums, pitch, scratch.concentration);
        scan<V>(energies, scratch.valley, scratch.mean);
        for (std::size_t l = 0; l < std::min(lanes, blocks); ++l) {
            // Energies of `near` candidates, each in four partial sums to hide the latency of additions.
            const auto energy = [&](std::size_t start, float* to) LOMMEL_INLINE_LAMBDA {
                constexpr std::size_t vectors = near / lanes, chains = 4;
                V sum[chains][vectors] = {};
                for (std::size_t q = 0; q < padded_; q += chains) {
                    for (std::size_t k = 0; k < chains; ++k) {
                        const V one = splat<V>(sums[std::min(q + k, products_ - 1) * pitch + l]);
                        const float* const form = forms_.data() + (q + k) * width_ + start;
                        for (std::size_t v = 0; v < vectors; ++v) {
                            sum[k][v] = sum[k][v] + one * load<V>(form + v * lanes);
                        }
                    }
                }
                for (std::size_t v = 0; v < vectors; ++v) {
                    const V total = (sum[0][v] + sum[1][v]) + (sum[2][v] + sum[3][v]);
                    store(to + v * lanes, total - load<V>(noise_.data() + start + v * lanes));
                }
            };
            const auto rough = [&](std::size_t c) { return energies[c * lanes + l]; };
            out[l] = trust[l] >= least_trust ? place(energy, rough, scratch.valley, l, scratch.mean[l],
                                                     given_.pixels * more * wider[l] * trust[l], scratch.concentration[l])
                                             : FocalPlace{unknown, infinite, unknown, unknown};
        }
    }

   private:
    enum Row { ByTexture = 1, ByNoise, Steepness, OfCurvature, Concentration, Leak, Bias };
    static float square(float x) { return x * x; }
    static constexpr std::size_t rough_step = 4, near = 16, several = 8;
    static constexpr float unknown = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
    // Minimum fraction of trusted pixels in the window of a block; below it, the depth is unknown.
    static constexpr float least_trust = 0.5f;
    static constexpr float wide = 1.0f;  // variance (candidates^2) above which the likelihood's second moment is used
    static constexpr float unlike = 0.4f;  // relative standard deviation of the curvature between textures
    static constexpr float drop = 9.0f, sure = 3.0f,
                           distinct = 6.0f;  // thresholds: drop, distinct in log-likelihood, sure in standard deviations
    // A texture counts as one of few frequencies from this excess of concentration on, and fully as one after `concentrating` more.
    static constexpr float concentrated = 0.15f, concentrating = 0.4f;
    // Multiples of the leak, of textures of all frequencies and in addition of few: difference of energy from other valleys that are
    // excluded, and difference below which a candidate may be the true one.
    static constexpr float apart = 5.0f, apart_of_few = 50.0f, alike = 1.3f, alike_of_few = 10.0f;
    // Largest excess of concentration; (twice the mean of an energy >= 0 that is measured as 0 / its standard error)^2, 8 / pi.
    static constexpr float single = 0.95f, of_chance = 2.546f;
    static constexpr float narrower = 0.6f;  // for few frequencies: reduction of the largest extent of a valley, relative to it
    static constexpr float hidden = 0.3f;  // drop of a valley between rough candidates / energy of wrong candidates, at most

    std::size_t roughs() const { return (given_.count + rough_step - 1) / rough_step; }

    // Concentration of the textures of the blocks of one vector; of several channels, with their energies as weights.
    template <class V>
    LOMMEL_INLINE void concentrate(const float* sums, std::size_t pitch, float* to) const {
        V trace{}, diagonal{}, others{};
        std::size_t q = 0;
        for (std::size_t channel = 0; channel < channels_; ++channel) {
            for (std::size_t k = 0; k < images_; ++k, ++q) {
                const V own = load<V>(sums + q * pitch);
                trace = trace + own, diagonal = diagonal + own * own;
                for (std::size_t l = k + 1; l < images_; ++l) {
                    const V product = load<V>(sums + ++q * pitch);
                    others = others + product * product;
                }
            }
        }
        const V tiny = splat<V>(1e-30f);
        store(to, splat<V>(static_cast<float>(channels_)) * (diagonal + others + others) / (trace * trace + tiny));
    }

    // Subtract the energies of noise from those of the rough candidates, and find the valleys and means of one vector of blocks.
    template <class V>
    LOMMEL_INLINE void scan(float* energies, Valley& valley, float* mean) const {
        constexpr std::size_t lanes = sizeof(V) / sizeof(float);
        const V zero{}, half = splat<V>(0.5f), one = splat<V>(1.0f), none = splat<V>(infinite);
        V least{}, sum{}, previous{}, best{}, low{}, high{};
        V start{};  // first candidate of the fall that leads to this one
        V before = none, left = none, right = none;  // lowest energies: before `start`, and on either side of the valley
        V past{};  // 1 beyond the crest that follows the lowest candidate
        for (std::size_t c = 0; c < roughs(); ++c) {
            const V e = load<V>(energies + c * lanes) - splat<V>(noise_[rough_step * c]), at = splat<V>(static_cast<float>(c));
            store(energies + c * lanes, e);
            sum = sum + e;
            if (c == 0) {
                least = previous = e;
                continue;
            }
            start = below(previous, e, at, start), before = below(previous, e, least, before);
            past = below(e, previous, one, past);
            high = below(past, half, at, high), right = below(half, past, smaller(e, right), right);
            best = below(e, least, at, best), past = below(e, least, zero, past);
            low = below(e, least, start, low), left = below(e, least, before, left);
            high = below(e, least, at, high), right = below(e, least, none, right);
            least = smaller(e, least), previous = e;
        }
        store(valley.best, best), store(valley.low, low), store(valley.high, high);
        store(valley.second, smaller(left, right));
        store(mean, sum / splat<V>(static_cast<float>(roughs())));
    }

    template <class Energy, class Rough>
    LOMMEL_INLINE FocalPlace place(const Energy& energy, const Rough& rough, const Valley& valleys, std::size_t l, float mean,
                                   float pixels, float concentration) const {
        const std::size_t count = roughs(), last = given_.count - 1;
        const auto best = static_cast<std::size_t>(valleys.best[l]);
        // Exact energies at the coarse minimum and five candidates on either side.
        const std::size_t middle = rough_step * best, start = middle > 5 ? middle - 5 : 0, end = std::min(middle + 5, last);
        float around[near];
        energy(start, around);
        std::size_t at = start;
        for (std::size_t c = start; c <= end; ++c) {
            at = around[c - start] < around[at - start] ? c : at;
        }
        const float noise = noise_[at];
        // The negative log-likelihood is pixels * energy / 2. Its minimum is below its value at the true depth by half a
        // chi-squared variable of one degree of freedom, on average by 1/2, which is 1 / pixels in energy.
        FocalPlace found{unknown, infinite, 1.0f + (around[at - start] + 1.0f / pixels) / noise, mean};
        if (at == 0 || at == last || at == start || at == end) {
            return found;
        }
        float g[5];
        const float* const e = around + (at - start);
        if (at >= start + 2 && at + 2 <= end) {
            std::copy_n(e - 2, 5, g);
        } else {  // one of the five energies is missing: extrapolate by a cubic
            std::copy_n(e - 1, 3, g + 1);
            const bool low = at < start + 2;
            g[low ? 4 : 0] = low ? e[2] : e[-2];
            g[low ? 0 : 4] =
                low ? 4.0f * g[1] - 6.0f * g[2] + 4.0f * g[3] - g[4] : 4.0f * g[3] - 6.0f * g[2] + 4.0f * g[1] - g[0];
        }
        const float e1 = (g[0] - 8.0f * g[1] + 8.0f * g[3] - g[4]) / 12.0f;
        const float e2 = (-g[0] + 16.0f * g[1] - 30.0f * g[2] + 16.0f * g[3] - g[4]) / 12.0f;
        const float e3 = 0.5f * (-g[0] + 2.0f * g[1] - 2.0f * g[3] + g[4]);
        const float e4 = g[0] - 4.0f * g[1] + 6.0f * g[2] - 4.0f * g[3] + g[4];
        float x = 0.0f;
        for (int step = 0; step < 3; ++step) {
            const float slope = e1 + x * (e2 + x * (0.5f * e3 + x * e4 / 6.0f)), bend = e2 + x * (e3 + 0.5f * x * e4);
            if (!(bend > 0.0f)) {
                break;
            }
            x = std::min(1.0f, std::max(-1.0f, x - std::min(0.6f, std::max(-0.6f, slope / bend))));
        }
        const float measured = 0.5f * (e2 + x * (e3 + 0.5f * x * e4));
        if (!(measured > 0.0f)) {
            return found;
        }
        const float worse = std::max(1.0f, found.misfit), likelihood = 0.5f * pixels / worse, here = g[2];
        // Accept the minimum only if its energy is well below the mean over all candidates, and below that of any other valley.
        const float valley = mean - here, better = likelihood * valley;
        if (!(better >= drop && better >= sure * std::sqrt(0.5f * noise * pixels))) {
            return found;
        }
        // Other valleys must be higher than the minimum by more than noise and leak can make them.
        const auto statistic = [&](std::size_t row) { return statistics_[row * given_.count + at]; };
        const float excess = std::min(single, std::max(0.0f, concentration - statistic(Concentration)));
        const float few = std::min(1.0f, std::max(0.0f, (excess - concentrated) / concentrating));
        const float strength = valley + std::max(0.0f, here), leak = statistic(Leak) * strength;
        const float least_second = here + distinct / likelihood + (apart + apart_of_few * few) * leak;
        const auto low = static_cast<std::size_t>(valleys.low[l]), high = static_cast<std::size_t>(valleys.high[l]);
        float second = valleys.second[l];
        const float low_valley = least_second + hidden * strength;
        // A low valley can be lower between rough candidates.
        for (std::size_t c = 0; second < low_valley && second >= least_second && c < count; ++c) {
            if ((c < low || c > high) && rough(c) < low_valley) {
                second = std::min(second, lowest_near(energy, c++, rough_step * low, rough_step * high));
            }
        }
        if (!(second >= least_second)) {
            return found;
        }
        // Noise makes the measured curvature too large: average it with the curvature expected from the depth of the valley. The
        // weights are inverse variances: by noise for the measured curvature, by texture for the expected curvature.
        const float expected = statistic(Steepness) * valley, by_noise = worse * std::sqrt(statistic(OfCurvature) / pixels);
        const float share = 1.0f / (1.0f + by_noise * by_noise / std::max(square(unlike * expected), 1e-30f));
        const float curvature = share * measured + (1.0f - share) * expected;
        float variance =
            (statistic(ByTexture) * curvature + statistic(ByNoise) * worse) * worse / (curvature * curvature * pixels);
        found.position = static_cast<float>(at) + x;
        const auto away = [&](std::size_t c) { return std::abs(static_cast<float>(rough_step * c) - found.position); };
        // If the likelihood is several candidates wide, take its second moment as the variance instead of the inverse curvature,
        // which noise makes too small.
        if (variance > wide) {
            float total = 0.0f, moment = 0.0f;
            for (std::size_t c = 0; c < count; ++c) {
                const float chance = std::exp(likelihood * std::min(0.0f, here - rough(c)));
                total += chance;
                moment += chance * square(std::max(0.0f, away(c) - 1.0f));  // less 1, for the spread that steps of 4 add
            }
            variance = std::max(variance, moment / std::max(total, 1e-3f));
        }
        // What filters let through shifts the minimum by the square root of (its energy / curvature), as far as it is parallel to the
        // derivative of the residual; the rest remains as energy of the minimum. The part that is parallel, of the energy of n
        // frequencies, is 1 / n on average: the excess of concentration.
        const float odds = excess / (1.0f - excess), by_chance = noise * std::sqrt(2.0f / pixels);
        // Nearly the mean of an energy >= 0 that is measured as `here` with this standard error: 0.8 of the error at 0.
        const float remains = 0.5f * (here + std::sqrt(square(here) + of_chance * square(by_chance)));
        const float shifts = std::min(std::max(few * leak, odds * std::max(0.0f, here - by_chance)), odds * remains);
        variance += shifts / curvature + square(statistic(Bias));
        // The distance of the farthest candidate that leak could have made higher than the minimum, as two standard errors; a valley
        // that is too wide has no position.
        const float level = here + (alike + alike_of_few * few) * leak;
        float reach = 0.5f * rough_step;  // less this, for the spread that steps of 4 add
        for (std::size_t c = best; rough(c) < level; --c) {
            reach = std::max(reach, away(c));
            if (c == low) {
                break;
            }
        }
        for (std::size_t c = best + 1; c <= high && rough(c) < level; ++c) {
            reach = std::max(reach, away(c));
        }
        if (reach - 0.5f * rough_step > (1.0f - narrower * few) * given_.largest) {
            found.position = unknown;
            return found;
        }
        found.error = std::sqrt(std::max(variance, square(0.5f * (reach - 0.5f * rough_step))));
        return found;
    }

    // Lowest energy of the candidates around rough candidates c and c + 1, less those next to or between `low` and `high`.
    template <class Energy>
    LOMMEL_INLINE float lowest_near(const Energy& energy, std::size_t c, std::size_t low, std::size_t high) const {
        const std::size_t start = std::max<std::size_t>(rough_step * c, 5) - 5, end = std::min(start + near, given_.count);
        float around[near], lowest = infinite;
        energy(start, around);
        for (std::size_t k = start; k < end; ++k) {
            lowest = k + 1 < low || k > high + 1 ? std::min(lowest, around[k - start]) : lowest;
        }
        return lowest;
    }

    FocalCandidates given_;
    std::size_t channels_, images_, products_, padded_, width_,
        rough_width_;  // forms_ is padded_ x width_, with zeros as padding
    Floats forms_, rough_, noise_, statistics_;
};

}  // namespace lommel
