// The transforms 2 J_{n+1}(v) / v of Zernike polynomials at equal steps of v, made ready for interpolation between them.
//
// It depends on the step and on the kernel alone: one table serves every pupil, wavelength and pixel.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/special/bessel.hpp"
#include "lommel/special/gridding.hpp"
#include "lommel/special/sincos.hpp"

namespace lommel {

// A kernel between circles, `step` in v apart: its taps, and what its aliases do.
struct PolarKernel {
    double step;
    GriddingKernel kernel;
    GriddingKernel::Aliasing aliasing;
    double weight, chain, largest;  // of the taps; and the largest 1 / transform
    SingleTaps singles;
    DoubleTaps doubles;

    PolarKernel(double apart, std::size_t taps, double beta)
        : step(apart), kernel(taps, beta), aliasing(kernel.aliasing(step)), weight(kernel.weight()), chain(kernel.chain()),
          largest(1.0 / kernel.transform(step)), singles(kernel), doubles(kernel) {}

    bool is(double apart, std::size_t taps, double beta) const { return step == apart && kernel.w == taps && kernel.beta() == beta; }
    std::size_t bytes() const { return sizeof(PolarKernel); }
    static constexpr std::size_t most_bytes = std::size_t{1} << 20;
};

// F_n(j) = 2 / (pi (n+1)) int_0^pi sin(a) sin((n+1) a) C(j h cos a) / t(h cos a) da, C the cosine for even n and the sine for odd
// n, t the transform of the kernel: sum_j phi(v/h - j) F_n(j) is what zernike_transforms() gives, but for aliases. Sixteen
// distances, of j rising, stand together: [block][n][distance], j = -16 the first.
struct PolarTable {
    static constexpr std::size_t block = 16, before = 16;

    double step;
    GriddingKernel kernel;
    std::size_t blocks, degrees;
    Doubles values;
    std::vector<std::size_t> reached;  // of each block, the degrees that matter; the others add less than `left_out`
    // The root of sum (n+1)^2 F_n^2, at most, and what roundings do to it.
    double magnitude, rounding;

    // What degrees that a block leaves out can add to U, whatever the pupil.
    static constexpr double left_out = 1e-13;

    PolarTable(double apart, std::size_t taps, double beta, std::size_t block_count, std::size_t degree_count)
        : step(apart), kernel(taps, beta), blocks((block_count + 3) / 4 * 4), degrees((degree_count + 15) / 16 * 16),
          values(blocks * degrees * block), reached(blocks) {
        const std::size_t nodes = half_nodes();
        constexpr double pi = 3.14159265358979323846;
        const std::size_t turn = 8 * nodes;  // in units of half an angle between nodes, a_k = (2k + 1) units
        std::vector<double> sines(turn);
        for (std::size_t i = 0; i < turn; ++i) {
            sines[i] = std::sin(2.0 * pi * static_cast<double>(i) / static_cast<double>(turn));
        }
        Doubles weights(nodes * degrees), waves(2 * nodes * block), places(nodes), shares(nodes);
        for (std::size_t k = 0; k < nodes; ++k) {
            places[k] = sines[2 * nodes + 2 * k + 1];
            shares[k] = 2.0 * sines[2 * k + 1] / (static_cast<double>(nodes) * kernel.transform(step * places[k]));
            for (std::size_t n = 0; n < degrees; ++n) {
                weights[k * degrees + n] = sines[(n + 1) * (2 * k + 1) % turn] / static_cast<double>(n + 1);
            }
        }
        for (std::size_t b = 0; b < blocks; ++b) {
            look();
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA { fill(isa, b, weights, places, shares, waves); });
        }
        // 1 / transform is largest at the edge; roundings of arguments of up to v are v units.
        rounding = 2.3e-16 / kernel.transform(step) * std::sqrt(static_cast<double>(degrees)) *
                   (static_cast<double>(nodes + 40) + 2.0 * step * static_cast<double>(blocks * block));
        magnitude = 0.0;
        measure();
    }

    bool is(double apart, std::size_t taps, double beta, std::size_t block_count, std::size_t degree_count) const {
        return step == apart && kernel.w == taps && kernel.beta() == beta && blocks >= block_count && degrees >= degree_count;
    }
    std::size_t bytes() const { return sizeof(double) * values.size(); }
    static constexpr std::size_t most_bytes = std::size_t{96} << 20;

    const double* at(std::size_t b) const { return &values[b * degrees * block]; }

   private:
    // Half the points of the midpoint rule in a, N: on the strip |Im a| <= b the integrand, without its factors in front, is at
    // most cosh(b) cosh((n+1) b) exp(v sinh b) / t(h cosh b), for t, whose zeros are real, is least on the real line; the rule
    // errs by twice that over exp(2 N b) - 1.
    std::size_t half_nodes() const {
        const double v = step * static_cast<double>(blocks * block), n = static_cast<double>(degrees);
        double best = 1e300;
        for (double b = 0.05; b < 1.5 && step * std::cosh(b) < 3.1; b *= 1.1) {
            const double size = v * std::sinh(b) + (n + 1.0) * b - std::log(kernel.transform(step * std::cosh(b)));
            best = std::min(best, (size + 38.0) / (2.0 * b));
        }
        return static_cast<std::size_t>(0.5 * best) + 1;
    }

    template <class I>
    LOMMEL_INLINE void fill(I isa, std::size_t b, const Doubles& weights, const Doubles& places, const Doubles& shares,
                            Doubles& waves) {
        using V = typename I::pack;
        constexpr std::size_t packs = block / I::lanes, together = 2;
        const std::size_t nodes = places.size();
        alignas(64) double v[block];
        for (std::size_t i = 0; i < block; ++i) {
            v[i] = step * (static_cast<double>(b * block + i) - static_cast<double>(before));
        }
        for (std::size_t k = 0; k < nodes; ++k) {
            for (std::size_t i = 0; i < block; i += I::lanes) {
                V sine, cosine;
                sincos(isa, splat<V>(places[k]) * load<V>(v + i), sine, cosine);
                store(&waves[k * block + i], cosine * splat<V>(shares[k]));
                store(&waves[(nodes + k) * block + i], sine * splat<V>(shares[k]));
            }
        }
        double* to = &values[b * degrees * block];
        for (std::size_t n = 0; n < degrees; n += 2 * together) {
            for (std::size_t parity = 0; parity < 2; ++parity) {
                V sums[together][packs];
                for (std::size_t i = 0; i < together; ++i) {
                    for (std::size_t p = 0; p < packs; ++p) {
                        sums[i][p] = splat<V>(0.0);
                    }
                }
                for (std::size_t k = 0; k < nodes; ++k) {
                    const double* wave = &waves[(parity * nodes + k) * block];
                    const double* weight = &weights[k * degrees + n + parity];
                    for (std::size_t i = 0; i < together; ++i) {
                        const V here = splat<V>(weight[2 * i]);
                        for (std::size_t p = 0; p < packs; ++p) {
                            sums[i][p] = sums[i][p] + here * load<V>(wave + p * I::lanes);
                        }
                    }
                }
                for (std::size_t i = 0; i < together; ++i) {
                    for (std::size_t p = 0; p < packs; ++p) {
                        store(to + (n + parity + 2 * i) * block + p * I::lanes, sums[i][p]);
                    }
                }
            }
        }
    }

    // By Cauchy, as sum |beta|^2 / (n+1) is at most 1: the root of sum (n+1)^2 F_n^2, over all degrees and over the last ones.
    void measure() {
        std::vector<double> sums(block);
        for (std::size_t b = 0; b < blocks; ++b) {
            std::fill(sums.begin(), sums.end(), 0.0);
            reached[b] = 0;
            for (std::size_t n = degrees; n-- > 0;) {
                double most = 0.0;
                for (std::size_t i = 0; i < block; ++i) {
                    const double each = static_cast<double>(n + 1) * at(b)[n * block + i];
                    sums[i] += each * each;
                    most = std::max(most, sums[i]);
                }
                if (reached[b] == 0 && most > left_out * left_out) {
                    reached[b] = n + 1;
                }
            }
            magnitude = std::max(magnitude, std::sqrt(*std::max_element(sums.begin(), sums.end())));
        }
    }
};

// The transforms themselves, at distances that are looked at to see how bright it is there: 40 sinh(k/18), times `shrunk`.
struct LookTable {
    static constexpr std::size_t block = PolarTable::block;

    double shrunk;
    std::size_t blocks, degrees;
    Doubles values;
    std::vector<std::size_t> reached;

    LookTable(double part, std::size_t block_count, std::size_t degree_count)
        : shrunk(part), blocks(block_count), degrees((degree_count + 31) / 32 * 32), values(blocks * degrees * block),
          reached(blocks, degrees) {
        std::vector<double> one(degrees), scratch;
        for (std::size_t i = 0; i < blocks * block; ++i) {
            look();
            const double v = shrunk * at(i);
            for (std::size_t parity = 0; parity < 2; ++parity) {
                zernike_transforms(parity, v, degrees / 2, one.data(), scratch);
                for (std::size_t k = 0; k < degrees / 2; ++k) {
                    values[((i / block) * degrees + 2 * k + parity) * block + i % block] = one[k];
                }
            }
            reached[i / block] = std::min(degrees, static_cast<std::size_t>(v + 6.0 * std::cbrt(v) + 14.0));
        }
    }

    static double at(std::size_t i) { return 40.0 * std::sinh(static_cast<double>(i) / 18.0); }
    // Blocks up to one that holds a distance of at least v.
    static std::size_t blocks_to(double v) { return static_cast<std::size_t>(18.0 * std::asinh(v / 40.0) + 1.0) / block + 1; }

    bool is(double part, std::size_t block_count, std::size_t degree_count) const {
        return shrunk == part && blocks >= block_count && degrees >= degree_count;
    }
    std::size_t bytes() const { return sizeof(double) * values.size(); }
    static constexpr std::size_t most_bytes = std::size_t{16} << 20;
};

}  // namespace lommel
