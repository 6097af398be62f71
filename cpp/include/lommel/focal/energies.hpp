// Products of pairs of residual images, summed over blocks of pixels; the energy of each depth candidate is linear in them.
#pragma once

#include <cstddef>
#include <vector>

#include "lommel/base/aligned.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/focal/polynomials.hpp"

namespace lommel {

// Linear combinations of filtered frames: image k is the sum over frames i and orders m of factors[k][i][m] T_m y_i, with y_i
// frame i and T_m the Chebyshev filter of order m (polynomials.hpp).
class FocalMixture {
   public:
    // Uses `frames` frames of a FocalRows, from index `first` on, and orders m < terms. factors[image][frame][order m].
    FocalMixture(const float* factors, std::size_t images, std::size_t first, std::size_t frames, std::size_t terms)
        : images_(images), first_(first), frames_(frames), terms_(terms), factors_(factors, factors + images * frames * terms) {
    }

    std::size_t images() const { return images_; }

    // Write row y of image k to out[k], for all k. Up to two vectors are written past the end of a row.
    template <class I>
    LOMMEL_INLINE void operator()(I isa, FocalRows& rows, std::size_t y, float* const* out) const {
        std::size_t k = 0;
        while (k < images_) {
            const std::size_t left = images_ - k;
            if (left >= 6 && left != 7) {
                combine<6>(isa, rows, y, k, out), k += 6;
            } else if (left == 5) {
                combine<5>(isa, rows, y, k, out), k += 5;
            } else if (left >= 4) {
                combine<4>(isa, rows, y, k, out), k += 4;
            } else {
                combine<1>(isa, rows, y, k, out), k += 1;
            }
        }
    }

   private:
    template <std::size_t Count, class I>
    LOMMEL_INLINE void combine(I, FocalRows& rows, std::size_t y, std::size_t first, float* const* out) const {
        using V = typename I::floats;
        constexpr std::size_t lanes = 2 * I::lanes;
        const std::size_t each = frames_ * terms_;
        for (std::size_t x = 0; x < rows.width(); x += 2 * lanes) {
            V sums[Count][2] = {};
            const float* factor = factors_.data() + first * each;
            for (std::size_t image = 0; image < frames_; ++image) {
                for (std::size_t m = 0; m < terms_; ++m, ++factor) {
                    const float* const row = rows.row(first_ + image, m, y) + x;
                    const V a = load<V>(row), b = load<V>(row + lanes);
                    for (std::size_t k = 0; k < Count; ++k) {
                        const V f = splat<V>(factor[k * each]);
                        sums[k][0] = sums[k][0] + f * a;
                        sums[k][1] = sums[k][1] + f * b;
                    }
                }
            }
            for (std::size_t k = 0; k < Count; ++k) {
                store(out[first + k] + x, sums[k][0]);
                store(out[first + k] + x + lanes, sums[k][1]);
            }
        }
    }

    std::size_t images_, first_, frames_, terms_;
    Floats factors_;
};

// Window over which products are averaged: blocks of `side` x `side` pixels (side = 1, 2 or 4). Weights are symmetric along either
// axis, and their sum along an axis is 1.
struct FocalWindow {
    std::size_t side;
    std::vector<float> weights;  // weights of blocks at distances of 0, 1, 2, ... from the centre
};

// Sums over the pixels of each block, for one row of blocks: of products e_k e_l of the residual images e_k (k <= l), of the
// mean of the frames, and of trust (the number of trusted pixels).
class FocalProducts {
   public:
    FocalProducts(std::size_t images, std::size_t width, std::size_t side)
        : images_(images), side_(side), blocks_(width / side), groups_((blocks_ + most_lanes - 1) / most_lanes),
          grouped_((images + 2) * groups_ * most_lanes * side * side) {}

    // Number of pairs of images, including each image with itself.
    std::size_t count() const { return images_ * (images_ + 1) / 2; }

    // Add one row of pixels, with index `within` in its blocks: residual images, mean of the frames, trust (1 or 0) of pixels.
    template <class I>
    LOMMEL_INLINE void take(I isa, std::size_t within, float* const* images, float* mean, const float* trust) {
        for (std::size_t k = 0; k < images_ + 2; ++k) {
            const float* const from = k < images_ ? images[k] : k == images_ ? mean : trust;
            side_ == 1   ? group<1>(isa, within, k, from, trust)
            : side_ == 2 ? group<2>(isa, within, k, from, trust)
                         : group<4>(isa, within, k, from, trust);
        }
    }

    // Write the sums of products to count() rows of `out`, `pitch` values apart, and the sums of the mean and of trust.
    template <class I>
    LOMMEL_INLINE void sum(I isa, float* out, std::size_t pitch, float* mean, float* trust) {
        side_ == 1   ? sums<1>(isa, out, pitch, mean, trust)
        : side_ == 2 ? sums<2>(isa, out, pitch, mean, trust)
                     : sums<4>(isa, out, pitch, mean, trust);
    }

   private:
    static constexpr std::size_t most_lanes = 16;

    float* place(std::size_t group, std::size_t k, std::size_t lanes) {
        return grouped_.data() + (group * (images_ + 2) + k) * side_ * side_ * lanes;
    }

    // Regroup a row of pixels so that lane b of vector c holds pixel column c of block b; untrusted residuals become 0.
    template <std::size_t Side, class I>
    LOMMEL_INLINE void group(I, std::size_t within, std::size_t k, const float* from, const float* trust) {
        using V = typename I::floats;
        constexpr std::size_t lanes = 2 * I::lanes;
        const std::size_t inside = blocks_ * Side;
        for (std::size_t g = 0; g * lanes < blocks_; ++g) {
            float* const to = place(g, k, lanes) + within * Side * lanes;
            const std::size_t start = g * lanes * Side;
            V in[Side], out[Side];
            for (std::size_t c = 0; c < Side; ++c) {
                in[c] = load<V>(from + start + c * lanes);
                if (k < images_) {
                    in[c] = in[c] * load<V>(trust + start + c * lanes);
                }
            }
            by_columns<Side>(in, out);
            for (std::size_t c = 0; c < Side; ++c) {
                store(to + c * lanes, out[c]);
            }
            if (start + lanes * Side > inside) {  // lanes without a block become 0
                for (std::size_t block = blocks_ - g * lanes; block < lanes; ++block) {
                    for (std::size_t c = 0; c < Side; ++c) {
                        to[c * lanes + lane_of<Side, lanes>(block)] = 0.0f;
                    }
                }
            }
        }
    }

    // Lane in which by_columns() puts the block of index `block`: the lane of the same index, unless shuffles permute eight lanes.
    template <std::size_t Side, std::size_t Lanes>
    static constexpr std::size_t lane_of(std::size_t block) {
#if defined(LOMMEL_VECTORS) && !defined(__clang__)
        if (Side == 4 && Lanes == 8) {
            return block / 2 + 4 * (block % 2);
        }
        if (Side == 2 && Lanes == 8) {
            return block % 2 + 2 * (block / 4) + 4 * (block / 2 % 2);
        }
#endif
        return block;
    }
    template <std::size_t Side>
    struct InOrder {
        static constexpr std::size_t at(std::size_t i, std::size_t lanes) {
            return lanes == 8 ? lane_of<Side, 8>(i) : lane_of<Side, 4>(i);
        }
    };

    template <std::size_t Side, class V>
    static LOMMEL_INLINE void by_columns(const V (&in)[Side], V (&out)[Side]) {
        if constexpr (Side == 1) {
            out[0] = in[0];
        } else {
#if defined(LOMMEL_VECTORS) && !defined(__clang__)
            if constexpr (Side == 2) {
                turned_pairs(in[0], in[1], out[0], out[1]);
            } else {
                turned_fours(in[0], in[1], in[2], in[3], out);
            }
#else
            constexpr std::size_t lanes = sizeof(V) / sizeof(float);
            float flat[Side * lanes], turned[lanes];
            for (std::size_t c = 0; c < Side; ++c) {
                store(flat + c * lanes, in[c]);
            }
            for (std::size_t c = 0; c < Side; ++c) {
                for (std::size_t block = 0; block < lanes; ++block) {
                    turned[block] = flat[block * Side + c];
                }
                out[c] = load<V>(turned);
            }
#endif
        }
    }

    template <std::size_t Side, class I>
    LOMMEL_INLINE void sums(I, float* out, std::size_t pitch, float* mean, float* trust) {
        using V = typename I::floats;
        constexpr std::size_t lanes = 2 * I::lanes, size = Side * Side;
        for (std::size_t g = 0; g * lanes < blocks_; ++g) {
            float* to = out + g * lanes;
            for (std::size_t k = 0; k < images_; ++k) {
                const float* const a = place(g, k, lanes);
                std::size_t l = k;
                for (; l + 4 <= images_; l += 4) {
                    const float* const b = place(g, l, lanes);
                    V total[4] = {};
                    for (std::size_t i = 0; i < size; ++i) {
                        const V one = load<V>(a + i * lanes);
                        for (std::size_t t = 0; t < 4; ++t) {
                            total[t] = total[t] + one * load<V>(b + (t * size + i) * lanes);
                        }
                    }
                    for (std::size_t t = 0; t < 4; ++t, to += pitch) {
                        store(to, permuted<InOrder<Side>, float>(total[t]));
                    }
                }
                for (; l < images_; ++l, to += pitch) {
                    const float* const b = place(g, l, lanes);
                    V total = {};
                    for (std::size_t i = 0; i < size; ++i) {
                        total = total + load<V>(a + i * lanes) * load<V>(b + i * lanes);
                    }
                    store(to, permuted<InOrder<Side>, float>(total));
                }
            }
            for (std::size_t k = 0; k < 2; ++k) {
                const float* const a = place(g, images_ + k, lanes);
                V total = {};
                for (std::size_t i = 0; i < size; ++i) {
                    total = total + load<V>(a + i * lanes);
                }
                store((k == 0 ? mean : trust) + g * lanes, permuted<InOrder<Side>, float>(total));
            }
        }
    }

    std::size_t images_, side_, blocks_, groups_;
    Floats grouped_;
};

}  // namespace lommel
