// Table of the images of a molecule: interpolation of pixel averages and their derivatives at any position
// (certificate, section 19).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "lommel/base/aligned.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/base/tasks.hpp"

namespace lommel {

// Row length of an image in floats: its width padded to whole vectors.
constexpr std::size_t image_lanes = 16;
constexpr std::size_t image_stride(std::size_t width) { return (width + image_lanes - 1) / image_lanes * image_lanes; }

// Position of a molecule: row and column in pixels, 0 at the centre of the first pixel; z in the unit of the table.
struct Place {
    double row, column, z;
};

// Table of a molecule's images. Along z: `pieces` equal intervals from `low` to `high`, with `terms` Chebyshev coefficients
// each. Along rows and columns: `per` filtered samples per pixel; to interpolate, the weight of a sample (tap) is a polynomial in
// 2 t - 1 with coefficients polynomials[power, highest first][tap], with t from 0 to 1 between two samples.
// coefficients[piece * terms + term][row][phase][column] belongs to sample per * column + phase of a row. first_row,
// first_column: distance, in samples, from the molecule to coefficient (0, 0). Up to `beyond` floats past the last one may be read.
struct MoleculeTable {
    static constexpr std::size_t terms = 8, beyond = 256, most_taps = 16;
    const float* coefficients;
    std::size_t pieces, rows, per, columns, height, width;
    const double* polynomials;
    std::size_t powers, taps;
    double first_row, first_column, low, high;
    double least_row, largest_row, least_column, largest_column;  // valid range (pixels)

    std::size_t stride() const { return image_stride(width); }
    std::size_t pixels() const { return height * stride(); }
    Place within(const Place& place) const {
        return {std::clamp(place.row, least_row, largest_row), std::clamp(place.column, least_column, largest_column),
                std::clamp(place.z, low, high)};
    }
};

// Number of images per position: the image of the molecule, and its derivatives with respect to row, column and z.
constexpr std::size_t molecule_images = 4;

// Interpolation of the image of a molecule and its derivatives, with reused memory.
class MoleculeImages {
   public:
    explicit MoleculeImages(const MoleculeTable& table)
        : table_(table), between_(2 * (needed() + MoleculeTable::beyond)),
          across_(3 * (table.height * line() + MoleculeTable::beyond)) {}

    // Write the image and its derivatives with respect to row, column and z, pixels() floats each, for a position in the table.
    void write(const Place& place, float* images) {
        dispatch_widest([&](auto isa) LOMMEL_INLINE_LAMBDA { write<decltype(isa)>(place, images); });
    }

   private:
    template <class I>
    LOMMEL_INLINE void write(const Place& place, float* images) {
        using V = typename I::floats;
        constexpr std::size_t lanes = 2 * I::lanes;
        const MoleculeTable& table = table_;
        Weights z, down, right;
        const std::size_t piece = along_z(place.z, z);
        const std::size_t top = taps_at(place.row, table.first_row, down);
        const std::size_t left = taps_at(place.column, table.first_column, right);
        // Interpolate along z first, then over rows, then over columns, in separate loops.
        const float* const from = table.coefficients + piece * MoleculeTable::terms * table.rows * line() + top * line();
        const std::size_t plane = table.rows * line(), all = needed();
        float* const value = between_.data();
        float* const slope = value + all + MoleculeTable::beyond;
        constexpr std::size_t together = 4;
        for (std::size_t i = 0; i < all; i += together * lanes) {
            V sum[together] = {}, rate[together] = {};
            // Sum from the highest Chebyshev term down: term 0, usually the largest, is then rounded only once (certificate,
            // section 19).
            for (std::size_t n = MoleculeTable::terms; n-- > 0;) {
                const V weight = splat<V>(z.value[n]), change = splat<V>(z.slope[n]);
                for (std::size_t k = 0; k < together; ++k) {
                    const V at = load<V>(from + n * plane + i + k * lanes);
                    sum[k] = sum[k] + weight * at;
                    rate[k] = rate[k] + change * at;
                }
            }
            for (std::size_t k = 0; k < together; ++k) {
                store(value + i + k * lanes, sum[k]);
                store(slope + i + k * lanes, rate[k]);
            }
        }
        const std::size_t slope_stride = table.height * line() + MoleculeTable::beyond;
        float* const across = across_.data();
        for (std::size_t p = 0; p < table.height; ++p) {
            const float* const v = value + p * table.per * line();
            const float* const s = slope + p * table.per * line();
            float* const to = across + p * line();
            for (std::size_t x = 0; x < line(); x += 2 * lanes) {
                V sum[2] = {}, moved[2] = {}, rate[2] = {};
                for (std::size_t j = 0; j < table.taps; ++j) {
                    const V weight = splat<V>(down.value[j]), change = splat<V>(down.slope[j]);
                    for (std::size_t k = 0; k < 2; ++k) {
                        const V at = load<V>(v + j * line() + x + k * lanes);
                        sum[k] = sum[k] + weight * at;
                        moved[k] = moved[k] + change * at;
                        rate[k] = rate[k] + weight * load<V>(s + j * line() + x + k * lanes);
                    }
                }
                for (std::size_t k = 0; k < 2; ++k) {
                    store(to + x + k * lanes, sum[k]);
                    store(to + slope_stride + x + k * lanes, moved[k]);
                    store(to + 2 * slope_stride + x + k * lanes, rate[k]);
                }
            }
        }
        std::size_t phase[MoleculeTable::most_taps];
        for (std::size_t j = 0; j < table.taps; ++j) {
            phase[j] = (left + j) % table.per * table.columns + (left + j) / table.per;
        }
        const std::size_t pixels = table.pixels(), stride = table.stride();
        constexpr std::size_t pair = 2;
        for (std::size_t p = 0; p < table.height; p += pair) {
            // If the number of rows is odd, the last row is computed twice.
            const std::size_t own[pair] = {p, std::min(p + 1, table.height - 1)};
            for (std::size_t x = 0; x < stride; x += lanes) {
                V sum[pair] = {}, moved[pair] = {}, aside[pair] = {}, rate[pair] = {};
                for (std::size_t j = 0; j < table.taps; ++j) {
                    const V weight = splat<V>(right.value[j]), change = splat<V>(right.slope[j]);
                    for (std::size_t k = 0; k < pair; ++k) {
                        const float* const at = across + own[k] * line() + phase[j] + x;
                        const V here = load<V>(at);
                        sum[k] = sum[k] + weight * here;
                        aside[k] = aside[k] + change * here;
                        moved[k] = moved[k] + weight * load<V>(at + slope_stride);
                        rate[k] = rate[k] + weight * load<V>(at + 2 * slope_stride);
                    }
                }
                for (std::size_t k = 0; k < pair; ++k) {
                    float* const to = images + own[k] * stride + x;
                    store(to, sum[k]);
                    store(to + pixels, moved[k]);
                    store(to + 2 * pixels, aside[k]);
                    store(to + 3 * pixels, rate[k]);
                }
            }
        }
    }

    struct Weights {
        float value[MoleculeTable::most_taps], slope[MoleculeTable::most_taps];
    };

    std::size_t line() const { return table_.per * table_.columns; }
    std::size_t needed() const { return (table_.per * (table_.height - 1) + table_.taps) * line(); }

    std::size_t along_z(double z, Weights& weights) const {
        const double length = (table_.high - table_.low) / static_cast<double>(table_.pieces);
        const double at = (z - table_.low) / length;
        const auto piece = std::min(static_cast<std::size_t>(std::max(at, 0.0)), table_.pieces - 1);
        const double x = 2.0 * (at - static_cast<double>(piece)) - 1.0, scale = 2.0 / length;
        double last = 1.0, now = x, before = 0.0, rate = 1.0;  // Chebyshev T_{n-1}, T_n, U_{n-2}, U_{n-1} at x
        weights.value[0] = 1.0F;
        weights.slope[0] = 0.0F;
        for (std::size_t n = 1; n < MoleculeTable::terms; ++n) {
            weights.value[n] = static_cast<float>(now);
            weights.slope[n] = static_cast<float>(static_cast<double>(n) * rate * scale);
            const double next = 2.0 * x * now - last, faster = 2.0 * x * rate - before;
            last = now;
            now = next;
            before = rate;
            rate = faster;
        }
        return piece;
    }

    // Weights of the taps, and their derivatives by `at`, for a molecule at the row (or column) `at`, in pixels. first: first_row
    // (or first_column). Returns the index of the first tap.
    std::size_t taps_at(double at, double first, Weights& weights) const {
        const double per = static_cast<double>(table_.per), place = -per * at - first, whole = std::floor(place);
        const double x = 2.0 * (place - whole) - 1.0;
        double value[MoleculeTable::most_taps] = {}, slope[MoleculeTable::most_taps] = {};
        for (std::size_t k = 0; k < table_.powers; ++k) {
            const double* const power = table_.polynomials + k * table_.taps;
            for (std::size_t j = 0; j < table_.taps; ++j) {
                slope[j] = slope[j] * x + value[j];
                value[j] = value[j] * x + power[j];
            }
        }
        for (std::size_t j = 0; j < table_.taps; ++j) {
            weights.value[j] = static_cast<float>(value[j]);
            weights.slope[j] = static_cast<float>(-2.0 * per * slope[j]);
        }
        return static_cast<std::size_t>(whole) + 1 - table_.taps / 2;
    }

    MoleculeTable table_;
    Floats between_, across_;
};

// Write to[place][image][row][column] without gaps: molecule images and their derivatives at places[count][row, column, z].
inline void molecule_stack(const MoleculeTable& table, const double* places, std::size_t count, int threads, float* to) {
    for_blocks(count, threads, 2.0, [&](std::size_t first, std::size_t last) {
        MoleculeImages images(table);
        Floats four(molecule_images * table.pixels());
        for (std::size_t i = first; i < last; ++i) {
            const double* const p = places + 3 * i;
            images.write({p[0], p[1], p[2]}, four.data());
            float* at = to + i * molecule_images * table.height * table.width;
            for (std::size_t row = 0; row < molecule_images * table.height; ++row) {
                at = std::copy_n(&four[row * table.stride()], table.width, at);
            }
        }
    });
}

}  // namespace lommel
