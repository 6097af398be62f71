// Pixel averages of the intensity from samples at nodes; vector lanes are pupils (docs/certificate.md, section 10).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/base/simd.hpp"
#include "lommel/chordal/tables.hpp"
#include "lommel/chordal/transform.hpp"
#include "lommel/zernike/disk_stack.hpp"

namespace lommel {

// Rows and columns of sampling nodes. down, across: weights of the nodes in a pixel's average along y, along x, [pixel][node].
struct PixelNodes {
    WindowAxis rows, columns;
    std::size_t height, width;  // size of the window in pixels
    const double *down, *across;
    double* averages;  // result: pixel averages, [pupil][row][column]
    double *largest, *together;  // results, [pupil]: largest pixel average; sum of all pixel averages
};

// Return PixelNodes with the pointers given; `places` (rows, columns), given relative to the window's middle, become relative to
// the axis. In each direction, if the axis is within `near` pixels of the middle, the middle becomes the axis, and a tilt of the
// pupils keeps the image where it is: nodes at opposite distances from the axis then share their sums.
inline PixelNodes nodes_about_axis(DiskStack& stack, const DiskWindow& window, const std::array<std::vector<double>, 2>& places,
                                   const std::array<const double*, 2>& weights, double* averages, double* largest,
                                   double* together) {
    constexpr double near = 2.0;  // distance in pixels
    DiskWindow centred = window;
    std::array<std::vector<double>, 2> about = places;
    for (std::size_t axis = 0; axis < 2; ++axis) {
        const double middle = 0.5 * static_cast<double>((axis == 0 ? window.height : window.width) - 1);
        double& at = axis == 0 ? centred.row : centred.column;
        if (std::abs(at - middle) <= near) {
            at = middle;
            continue;
        }
        for (double& v : about[axis]) {
            v += (middle - at) * window.step;
        }
    }
    if (centred.row != window.row || centred.column != window.column) {
        std::vector<double> centers;
        for (std::size_t p = 0; p < stack.count; ++p) {
            centers.insert(centers.end(), {window.row, window.column});
        }
        stack.tilt_to(centers.data(), centred);
        stack.shrink();
    }
    return {WindowAxis(about[0]),
            WindowAxis(about[1]),
            window.height,
            window.width,
            weights[0],
            weights[1],
            averages,
            largest,
            together};
}

// Samples are summed in their own precision in blocks of this many nodes; the sums of blocks are added in double precision.
constexpr std::size_t node_block = 8;

// Weights of the sampling nodes in the pixel averages, in the precision and memory layout of average_along() and average_down().
template <class Real>
struct NodeWeights {
    using Values = std::vector<Real, AlignedAllocator<Real>>;

    std::size_t height, width, rows, columns;  // size of the window in pixels, and in sampling nodes
    std::size_t side;  // number of vector lanes if they are columns of one pupil; 1 if they are pupils
    std::size_t vectors;  // number of SIMD vectors in a row of pixels
    Values across;  // weights along x: [tile of pixels][node][pixel of the tile]; for one pupil [node][vector of pixels]
    Values down;  // weights along y: [block of nodes][tile of pixels][node of the block][pixel of the tile]

    NodeWeights(const PixelNodes& nodes, const ChordLanes& in)
        : height(nodes.height), width(nodes.width), rows(nodes.rows.count), columns(nodes.columns.count), side(in.side),
          vectors(in.vectors(width)), across(columns * vectors * in.side),
          down((rows + node_block - 1) / node_block * node_block * height) {
        if (side > 1) {
            for (std::size_t k = 0; k < columns; ++k) {
                for (std::size_t pixel = 0; pixel < width; ++pixel) {
                    across[k * vectors * side + pixel] = static_cast<Real>(nodes.across[pixel * columns + k]);
                }
            }
        } else {
            lay(nodes.across, width, columns, 0, columns, columns, across.data());
        }
        for (std::size_t from = 0; from < rows; from += node_block) {
            lay(nodes.down, height, rows, from, std::min(rows, from + node_block), node_block, down.data() + from * height);
        }
    }

   private:
    static void lay(const double* weights, std::size_t pixels, std::size_t nodes, std::size_t from, std::size_t to,
                    std::size_t room, Real* into) {
        for_tiles(pixels, column_tile, [&](std::size_t first, std::size_t size) {
            for (std::size_t k = from; k < to; ++k) {
                for (std::size_t r = 0; r < size; ++r) {
                    into[first * room + (k - from) * size + r] = static_cast<Real>(weights[(first + r) * nodes + k]);
                }
            }
        });
    }
};

// Sums of R vectors in double precision, to which vectors of the samples' precision are added.
template <class I, class Real, std::size_t R>
struct WideSums {
    static constexpr std::size_t lanes = Waves<I, Real>::lanes, parts = lanes / I::lanes;
    typename I::pack sums[R][parts] = {};

    LOMMEL_INLINE void add(const typename Waves<I, Real>::V (&more)[R][1]) {
        for (std::size_t r = 0; r < R; ++r) {
            Real part[lanes];
            store(part, more[r][0]);
            for (std::size_t p = 0; p < parts; ++p) {
                sums[r][p] = sums[r][p] + widened<I>(part + p * I::lanes);
            }
        }
    }
    LOMMEL_INLINE void store_to(std::size_t r, double* to) const {
        for (std::size_t p = 0; p < parts; ++p) {
            store(to + p * I::lanes, sums[r][p]);
        }
    }
};

// Average row y of samples[node][pupil] along x, to lines[vector of pixels][row][lane]. `Lone`: samples[node], lanes are pixels.
template <bool Lone, class I, class Real>
LOMMEL_INLINE void average_along(I, const NodeWeights<Real>& weights, std::size_t y, const Real* samples, Real* lines) {
    using V = typename Waves<I, Real>::V;
    constexpr std::size_t lanes = Waves<I, Real>::lanes;
    const std::size_t nodes = weights.columns, stride = weights.vectors * lanes;
    for_fixed_tiles<column_tile>(weights.vectors, [&](std::size_t first, auto size) LOMMEL_INLINE_LAMBDA {
        constexpr std::size_t R = decltype(size)::value;
        WideSums<I, Real, R> total;
        for (std::size_t from = 0; from < nodes; from += node_block) {
            const std::size_t here = std::min(node_block, nodes - from);
            V sum[R][1] = {};
            if constexpr (Lone) {
                for (std::size_t k = from; k < from + here; ++k) {
                    const V sample = splat<V>(samples[k]);
                    for (std::size_t r = 0; r < R; ++r) {
                        sum[r][0] = sum[r][0] + load<V>(weights.across.data() + k * stride + (first + r) * lanes) * sample;
                    }
                }
            } else {
                multiply<R, 1>(weights.across.data() + first * nodes + from * R, samples + from * lanes, here, sum);
            }
            total.add(sum);
        }
        for (std::size_t r = 0; r < R; ++r) {
            double line[lanes];
            total.store_to(r, line);
            Real* const to = lines + ((first + r) * weights.rows + y) * lanes;
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                to[lane] = static_cast<Real>(line[lane]);
            }
        }
    });
}

// Average lines[vector][row][lane] along y, to sums[row of pixels][vector][lane].
template <class I, class Real>
LOMMEL_INLINE void average_down(I, const NodeWeights<Real>& weights, const Real* lines, double* sums) {
    using V = typename Waves<I, Real>::V;
    constexpr std::size_t lanes = Waves<I, Real>::lanes;
    for (std::size_t v = 0; v < weights.vectors; ++v) {
        for_fixed_tiles<column_tile>(weights.height, [&](std::size_t first, auto size) LOMMEL_INLINE_LAMBDA {
            constexpr std::size_t R = decltype(size)::value;
            WideSums<I, Real, R> total;
            for (std::size_t from = 0; from < weights.rows; from += node_block) {
                V sum[R][1] = {};
                multiply<R, 1>(weights.down.data() + from * weights.height + first * node_block,
                               lines + (v * weights.rows + from) * lanes, std::min(node_block, weights.rows - from), sum);
                total.add(sum);
            }
            for (std::size_t r = 0; r < R; ++r) {
                total.store_to(r, sums + ((first + r) * weights.vectors + v) * lanes);
            }
        });
    }
}

// Include a row of values[node][lane] in the largest value of each block of nodes, `side` lanes of each.
template <class I, class Real>
LOMMEL_INLINE void include_largest(I, const Real* values, std::size_t nodes, std::size_t block, std::size_t side,
                                   Real* largest) {
    for (std::size_t k = 0; k < nodes; ++k) {
        Real* const to = largest + k / block * side;
        for (std::size_t lane = 0; lane < side; ++lane) {
            to[lane] = to[lane] < values[k * side + lane] ? values[k * side + lane] : to[lane];
        }
    }
}

}  // namespace lommel
