// Shrinkage of gradients, for the total variation of photographs, and of the coefficients of frames by their local energy.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

#include "lommel/base/aligned.hpp"
#include "lommel/base/simd.hpp"

namespace lommel {

// Planes [count][height][width] in memory. `periodic`: the last row and column are neighbours of the first ones, otherwise the
// differences to the next row and column are 0 there.
struct Planes {
    std::size_t count, height, width;
    bool periodic = false;

    std::size_t size() const { return height * width; }

    // Differences of a row of a plane to the next row, and of its pixels to the next ones.
    LOMMEL_INLINE void differences(const float* plane, std::size_t y, float* down, float* across) const {
        const float* const row = plane + y * width;
        const float* const next = y + 1 < height ? row + width : periodic ? plane : row;
        for (std::size_t x = 0; x < width; ++x) {
            down[x] = next[x] - row[x];
        }
        for (std::size_t x = 0; x + 1 < width; ++x) {
            across[x] = row[x + 1] - row[x];
        }
        across[width - 1] = periodic ? row[0] - row[width - 1] : 0.0F;
    }
};

// Sum over the pixels of the length of the gradient of all planes together.
inline double gradient_sum(const Planes& planes, const float* light) {
    Floats room(4 * planes.width);
    float *const down = room.data(), *const across = down + planes.width, *const squares = across + planes.width,
                 *const columns = squares + planes.width;
    dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
        for (std::size_t y = 0; y < planes.height; ++y) {
            std::fill_n(squares, planes.width, 0.0F);
            for (std::size_t c = 0; c < planes.count; ++c) {
                planes.differences(light + c * planes.size(), y, down, across);
                for (std::size_t x = 0; x < planes.width; ++x) {
                    squares[x] += down[x] * down[x] + across[x] * across[x];
                }
            }
            for (std::size_t x = 0; x < planes.width; ++x) {
                columns[x] += std::sqrt(squares[x]);
            }
        }
    });
    return std::accumulate(columns, columns + planes.width, 0.0);
}

// One step of the alternating direction method of multipliers for the total variation: d = factor * dual + the gradient of
// `light`, the part p of d of length `limit` at most, for all planes together, becomes the new dual, and the transpose of the
// gradient of d - 2 p is written to `out`. dual[down or across][plane].
inline void shrink_gradient(const Planes& planes, const float* light, float* dual, float factor, float limit, float* out) {
    const std::size_t width = planes.width, size = planes.size();
    // Of each plane a row of d - 2 p down and across, and the row of the former above it; beside them the part that is kept.
    Floats room((3 * planes.count + 3) * width);
    dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
        float *const kept = room.data(), *const step_down = kept + width, *const step_across = step_down + width;
        for (std::size_t y = 0; y < planes.height; ++y) {
            std::fill_n(kept, width, 0.0F);
            for (std::size_t c = 0; c < planes.count; ++c) {
                float *const down = dual + c * size + y * width, *const across = down + planes.count * size;
                planes.differences(light + c * size, y, step_down, step_across);
                for (std::size_t x = 0; x < width; ++x) {
                    down[x] = factor * down[x] + step_down[x];
                    across[x] = factor * across[x] + step_across[x];
                    kept[x] += down[x] * down[x] + across[x] * across[x];
                }
            }
            for (std::size_t x = 0; x < width; ++x) {
                kept[x] = limit / std::max(std::sqrt(kept[x]), limit);
            }
            for (std::size_t c = 0; c < planes.count; ++c) {
                float *const down = dual + c * size + y * width, *const across = down + planes.count * size;
                float *const above = step_across + (1 + c) * width, *const to = out + c * size + y * width;
                for (std::size_t x = 0; x < width; ++x) {
                    const float shrunk = 1.0F - 2.0F * kept[x];
                    step_down[x] = shrunk * down[x];
                    step_across[x] = shrunk * across[x];
                    down[x] *= kept[x];
                    across[x] *= kept[x];
                }
                for (std::size_t x = 0; x < width; ++x) {
                    to[x] = above[x] - step_down[x] - step_across[x];
                    above[x] = step_down[x];
                }
                to[0] += step_across[width - 1];  // 0 unless periodic
                for (std::size_t x = 1; x < width; ++x) {
                    to[x] += step_across[x - 1];
                }
                if (y + 1 == planes.height) {
                    for (std::size_t x = 0; x < width; ++x) {
                        out[c * size + x] += above[x];
                    }
                }
            }
        }
    });
}

// Coefficients of a frame, shrunk by their energy, which `taps` average over neighbours: taps[0] is the weight of a pixel, taps[k]
// that of its neighbours at the distance k, along each axis. The noise is noise[plane] * relative[y][x].
class Shrinkage {
   public:
    Shrinkage(const Planes& planes, const float* relative, const float* noise, const float* taps, std::size_t reach)
        : planes_(planes), relative_(relative), noise_(noise), taps_(taps), reach_(reach), rows_(2 * planes.size()),
          line_(planes.width + 2 * reach) {}

    // values *= max(E - noise, 0) / E with their own energy E.
    void by_own_energy(float* values) {
        run(values, values, values, [](float energy, float, float noise) LOMMEL_INLINE_LAMBDA {
            return std::max(energy - noise, 0.0F) / std::max(energy, tiny);
        });
    }

    // values *= <seen sharp> / (<seen^2> + noise), averages <> over neighbours, where `sharp` are coefficients of an estimate and
    // `seen` those of its filtered image.
    void by_estimate(float* values, const float* seen, const float* sharp) {
        run(values, seen, sharp, [](float energy, float product, float noise) LOMMEL_INLINE_LAMBDA {
            return product / std::max(energy + noise, tiny);
        });
    }

   private:
    static constexpr float tiny = 1e-30F;

    // Index of a row or column beyond an edge, at which planes are mirrored.
    static std::size_t mirrored(std::ptrdiff_t at, std::size_t count) {
        const auto period = static_cast<std::ptrdiff_t>(2 * count);
        const auto place = static_cast<std::size_t>((at % period + period) % period);
        return place < count ? place : 2 * count - 1 - place;
    }

    // Average a line of products of a row of two planes over its neighbours.
    LOMMEL_INLINE void along(const float* one, const float* other, float* to) {
        const std::size_t width = planes_.width;
        float* const line = line_.data() + reach_;
        for (std::size_t x = 0; x < width; ++x) {
            line[x] = one[x] * other[x];
        }
        for (std::size_t k = 1; k <= reach_; ++k) {
            line[-static_cast<std::ptrdiff_t>(k)] = line[mirrored(-static_cast<std::ptrdiff_t>(k), width)];
            line[width - 1 + k] = line[mirrored(static_cast<std::ptrdiff_t>(width - 1 + k), width)];
        }
        for (std::size_t x = 0; x < width; ++x) {
            to[x] = taps_[0] * line[x];
        }
        for (std::size_t k = 1; k <= reach_; ++k) {
            const float* const left = line - k;
            const float* const right = line + k;
            for (std::size_t x = 0; x < width; ++x) {
                to[x] += taps_[k] * (left[x] + right[x]);
            }
        }
    }

    // Average a row over its neighbours above and below.
    LOMMEL_INLINE void across(const float* plane, std::size_t y, float* to) const {
        const std::size_t width = planes_.width;
        for (std::size_t x = 0; x < width; ++x) {
            to[x] = taps_[0] * plane[y * width + x];
        }
        for (std::size_t k = 1; k <= reach_; ++k) {
            const auto at = static_cast<std::ptrdiff_t>(y), away = static_cast<std::ptrdiff_t>(k);
            const float* const above = plane + mirrored(at - away, planes_.height) * width;
            const float* const below = plane + mirrored(at + away, planes_.height) * width;
            for (std::size_t x = 0; x < width; ++x) {
                to[x] += taps_[k] * (above[x] + below[x]);
            }
        }
    }

    template <class Gain>
    void run(float* values, const float* seen, const float* sharp, const Gain& gain) {
        const std::size_t width = planes_.width, size = planes_.size();
        Floats room(2 * width);
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
            float *const energies = rows_.data(), *const products = energies + size;
            float *const energy = room.data(), *const product = energy + width;
            for (std::size_t c = 0; c < planes_.count; ++c) {
                const std::size_t first = c * size;
                for (std::size_t at = 0; at < size; at += width) {
                    along(seen + first + at, seen + first + at, energies + at);
                    if (seen != sharp) {
                        along(seen + first + at, sharp + first + at, products + at);
                    }
                }
                for (std::size_t y = 0; y < planes_.height; ++y) {
                    across(energies, y, energy);
                    if (seen != sharp) {
                        across(products, y, product);
                    }
                    float* const to = values + first + y * width;
                    const float* const relative = relative_ + y * width;
                    for (std::size_t x = 0; x < width; ++x) {
                        to[x] *= gain(energy[x], product[x], noise_[c] * relative[x]);
                    }
                }
            }
        });
    }

    Planes planes_;
    const float *relative_, *noise_, *taps_;
    std::size_t reach_;
    Floats rows_, line_;
};

}  // namespace lommel
