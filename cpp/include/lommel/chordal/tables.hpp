// The chordal Gauss rule on the unit disk: tables of Zernike terms at its nodes, and of the Fourier kernel for a window.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/base/once.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/bounds/amplitude.hpp"
#include "lommel/special/legendre.hpp"
#include "lommel/special/radial_polynomials.hpp"

namespace lommel {

// Calls f(first, size) for tiles of at most `most` that cover 0 .. count - 1 and differ by one at most.
template <class F>
LOMMEL_INLINE void for_tiles(std::size_t count, std::size_t most, const F& f) {
    const std::size_t tiles = (count + most - 1) / most;
    for (std::size_t t = 0, first = 0; t < tiles; ++t) {
        const std::size_t size = (count - first + tiles - t - 1) / (tiles - t);
        f(first, size);
        first += size;
    }
}

constexpr std::size_t node_tile = 4, row_tile = 3, column_tile = 6;

// N chords and K nodes on each, both even.
struct ChordCount {
    std::size_t chords = 0, nodes = 0;
    std::size_t half_chords() const { return chords / 2; }
    std::size_t half_nodes() const { return nodes / 2; }
    bool operator==(const ChordCount& other) const { return chords == other.chords && nodes == other.nodes; }
    void include(const ChordCount& other) {
        chords = std::max(chords, other.chords);
        nodes = std::max(nodes, other.nodes);
    }
};

// Nodes x_i = cos(i pi / (N+1)), y = s_i eta_k with s_i = sqrt(1 - x_i^2), of the quadrant x, y > 0: weights rise along both, so
// that sums begin with what is small.
struct ChordRule {
    std::vector<wide> x, s, eta, gauss;

    explicit ChordRule(const ChordCount& count)
        : x(count.half_chords()), s(x.size()), eta(count.half_nodes()), gauss(eta.size()) {
        const wide pi = std::acos(wide(-1));
        for (std::size_t i = 0; i < x.size(); ++i) {
            const wide angle = pi * static_cast<wide>(i + 1) / static_cast<wide>(count.chords + 1);
            x[i] = std::cos(angle);
            s[i] = std::sin(angle);
        }
        std::vector<wide> nodes(count.nodes), weights(count.nodes);
        gauss_legendre(count.nodes, nodes.data(), weights.data());
        for (std::size_t k = 0; k < eta.size(); ++k) {
            eta[k] = nodes[count.nodes - 1 - k];
            gauss[k] = weights[count.nodes - 1 - k];
        }
    }
    // Weights sum to 1 over the disk.
    wide weight(std::size_t i, std::size_t k) const { return s[i] * s[i] * gauss[k] / static_cast<wide>(2 * x.size() + 1); }
};

// Terms sorted into four classes: even or odd in x (second bit), in y (first bit).
struct TermClasses {
    std::vector<std::size_t> order;  // of the terms, class by class
    std::size_t ends[4];             // of the classes

    explicit TermClasses(const std::vector<ZernikeTerm>& list) {
        for (std::size_t parity = 0; parity < 4; ++parity) {
            for (std::size_t j = 0; j < list.size(); ++j) {
                const std::size_t odd_y = list[j].m < 0 ? 1 : 0;
                const std::size_t odd_x = (static_cast<std::size_t>(std::abs(list[j].m)) + odd_y) % 2;
                if (2 * odd_x + odd_y == parity) {
                    order.push_back(j);
                }
            }
            ends[parity] = order.size();
        }
    }
};

// Terms at the nodes of a quadrant.
struct TermTable {
    ChordCount count;
    std::vector<ZernikeTerm> terms;
    Amplitude amplitude;
    TermClasses classes;
    Doubles values;   // [chord][tile of nodes][term, in the order of classes][node of the tile]
    Doubles weights;  // [chord][node], with the amplitude

    TermTable(const ChordCount& n, const std::vector<ZernikeTerm>& list, const Amplitude& light);
    bool is(const ChordCount& n, const std::vector<ZernikeTerm>& list, const Amplitude& light) const {
        return count == n && amplitude == light && terms == list;
    }
    std::size_t bytes() const { return (values.size() + weights.size()) * sizeof(double); }
    static constexpr std::size_t most_bytes = std::size_t{96} << 20;
};

#if defined(LOMMEL_DEFINES)
LOMMEL_ONCE TermTable::TermTable(const ChordCount& n, const std::vector<ZernikeTerm>& list, const Amplitude& light)
    : count(n), terms(list), amplitude(light), classes(list), values(n.half_chords() * n.half_nodes() * list.size()),
      weights(n.half_chords() * n.half_nodes()) {
    const ChordRule rule(n);
    const std::size_t half = n.half_nodes();
    for (std::size_t i = 0; i < n.half_chords(); ++i) {
        for_tiles(half, node_tile, [&](std::size_t first, std::size_t size) {
            look();
            double* tile = values.data() + (i * half + first) * list.size();
            for (std::size_t j = 0; j < list.size(); ++j) {
                for (std::size_t r = 0; r < size; ++r) {
                    tile[j * size + r] =
                        static_cast<double>(zernike_value(list[classes.order[j]], rule.x[i], rule.s[i] * rule.eta[first + r]));
                }
            }
        });
        for (std::size_t k = 0; k < half; ++k) {
            const wide y = rule.s[i] * rule.eta[k];
            weights[i * half + k] = static_cast<double>(rule.weight(i, k) * light.at(rule.x[i] * rule.x[i] + y * y));
        }
    }
}
#endif

// Rows or columns of a window: distances from the axis in pixels, those at +v and -v as one.
struct WindowAxis {
    static constexpr std::size_t none = ~std::size_t{0};
    std::size_t count;
    double center;
    std::vector<double> at;
    std::vector<std::size_t> plus, minus;  // the pixels at +at and at -at

    WindowAxis(std::size_t pixels, double axis) : count(pixels), center(axis) {
        for (std::size_t j = 0; j < pixels; ++j) {
            const double here = static_cast<double>(j) - axis, mirrored = axis - here;
            const bool paired = here != 0.0 && mirrored >= 0.0 && mirrored <= static_cast<double>(pixels - 1) &&
                                mirrored == std::floor(mirrored);
            if (paired && here < 0.0) {
                continue;
            }
            at.push_back(here);
            plus.push_back(j);
            minus.push_back(paired ? static_cast<std::size_t>(mirrored) : none);
        }
    }
    bool operator==(const WindowAxis& other) const { return count == other.count && center == other.center; }
    double low() const { return -center; }
    double high() const { return static_cast<double>(count - 1) - center; }
};

// The kernel in the precision of the sums, at the nodes: cos and sin of v_y y for each pair of chords at +-x, and of v_x x.
template <class Real>
struct KernelTable {
    using Values = std::vector<Real, AlignedAllocator<Real>>;

    ChordCount count;
    WindowAxis rows, columns;
    double step;
    Values row_cos, row_sin;        // [chord][tile of rows][node][row of the tile]
    Values column_cos, column_sin;  // [tile of columns][chord][column of the tile]

    KernelTable(const ChordCount& n, const WindowAxis& down, const WindowAxis& across, double pixel_step)
        : count(n), rows(down), columns(across), step(pixel_step), row_cos(n.half_chords() * n.half_nodes() * rows.at.size()),
          row_sin(row_cos.size()), column_cos(n.half_chords() * columns.at.size()), column_sin(column_cos.size()) {
        const ChordRule rule(n);
        for (std::size_t i = 0; i < n.half_chords(); ++i) {
            const std::size_t from = i * n.half_nodes() * rows.at.size();
            fill(rows.at, row_tile, rule.eta, rule.s[i], row_cos.data() + from, row_sin.data() + from);
        }
        fill(columns.at, column_tile, rule.x, 1, column_cos.data(), column_sin.data());
    }
    bool is(const ChordCount& n, const WindowAxis& down, const WindowAxis& across, double pixel_step) const {
        return count == n && step == pixel_step && rows == down && columns == across;
    }
    std::size_t bytes() const { return 2 * (row_cos.size() + column_cos.size()) * sizeof(Real); }
    static constexpr std::size_t most_bytes = std::size_t{96} << 20;
    static double bytes(const ChordCount& n, std::size_t rows) {
        return 0.5 * sizeof(Real) * static_cast<double>(n.chords) * static_cast<double>(n.nodes) * static_cast<double>(rows);
    }

   private:
    void fill(const std::vector<double>& at, std::size_t tile, const std::vector<wide>& nodes, wide factor, Real* cosines,
              Real* sines) const {
        for_tiles(at.size(), tile, [&](std::size_t first, std::size_t size) {
            look();
            for (std::size_t k = 0; k < nodes.size(); ++k) {
                for (std::size_t r = 0; r < size; ++r) {
                    const wide angle = static_cast<wide>(at[first + r] * step) * factor * nodes[k];
                    const std::size_t place = first * nodes.size() + k * size + r;
                    cosines[place] = static_cast<Real>(std::cos(angle));
                    sines[place] = static_cast<Real>(std::sin(angle));
                }
            }
        });
    }
};

}  // namespace lommel
