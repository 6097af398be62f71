// Gauss quadrature along chords of a disk: tables of Zernike terms and of the Fourier kernel (docs/certificate.md, section 8).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/bounds/amplitude.hpp"
#include "lommel/special/legendre.hpp"
#include "lommel/special/radial_polynomials.hpp"

namespace lommel {

// Divide 0 .. count - 1 into tiles of at most `most`, with sizes that differ by at most one; call f(first, size) for each tile.
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

// Size of a quadrature on the disk: number of chords, and number of nodes on each chord. Both are even.
struct ChordCount {
    std::size_t chords = 0, nodes = 0;
    std::size_t half_chords() const { return chords / 2; }
    std::size_t half_nodes() const { return nodes / 2; }
    double size() const { return static_cast<double>(chords) * static_cast<double>(nodes); }
    bool operator==(const ChordCount& other) const { return chords == other.chords && nodes == other.nodes; }
    void include(const ChordCount& other) {
        chords = std::max(chords, other.chords);
        nodes = std::max(nodes, other.nodes);
    }
    // Both numbers rounded up to multiples of 16, unless this multiplies their product by more than `most`.
    ChordCount rounded(double most) const {
        const ChordCount up{(chords + 15) / 16 * 16, (nodes + 15) / 16 * 16};
        return up.size() <= most * size() ? up : *this;
    }
};

// Nodes, in the quadrant x, y > 0, of a quadrature with N chords of the whole disk: x_i = cos(i pi / (N+1)), i = 1 .. N/2, stored
// at index i - 1; y = s_i eta_k, s_i = sqrt(1 - x_i^2). eta, gauss: positive Gauss-Legendre nodes and their weights. The weights of
// the nodes increase with both indices, so that sums begin with the smallest terms.
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
    // Quadrature weight of node k on chord i. The weights of all nodes of the disk sum to 1.
    wide weight(std::size_t i, std::size_t k) const { return s[i] * s[i] * gauss[k] / static_cast<wide>(2 * x.size() + 1); }
};

// Zernike terms sorted into four parity classes. Number of a class: 2 (odd in x) + (odd in y).
struct TermClasses {
    std::vector<std::size_t> order;  // indices of the Zernike terms, class by class
    std::size_t ends[4];             // end of each class in `order`

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

// Contents of the vector lanes: one pupil in each lane (side = 1) or, for a single pupil, one of `side` chords in each.
struct ChordLanes {
    std::size_t side = 1;
    bool single = false;  // single precision, in which Waves<I, float> packs the phases of two vectors into one
    std::size_t rows = row_tile;  // rows in a tile: one more where there are 32 registers

    bool operator==(const ChordLanes& other) const {
        return side == other.side && single == other.single && rows == other.rows;
    }
    std::size_t vectors(std::size_t count) const { return (count + side - 1) / side; }
    // Position, in its vector, of the chord that belongs in a lane: packing of two vectors in single precision permutes the lanes.
    std::size_t place(std::size_t lane) const { return single && side > 1 ? lane % 2 * (side / 2) + lane / 2 : lane; }
};

// Zernike terms and quadrature weights at the nodes of the quadrant x, y > 0. Chords that pad a vector have the weight 0.
struct TermTable {
    ChordCount count;
    ChordLanes lanes;
    std::vector<ZernikeTerm> terms;
    Amplitude amplitude;
    TermClasses classes;
    Doubles values;   // Zernike terms: [vector of chords][tile of nodes][index in classes.order][node of the tile][chord]
    Doubles weights;  // [vector of chords][node][chord]: quadrature weight times pupil amplitude
    Doubles own;  // weights set by weigh(): [vector of chords][node][signs of x, y: ++, +-, -+, --][re, im][chord]

    TermTable(const ChordCount& n, const std::vector<ZernikeTerm>& list, const Amplitude& light, const ChordLanes& in)
        : count(n), lanes(in), terms(list), amplitude(light), classes(list),
          values(in.vectors(n.half_chords()) * in.side * n.half_nodes() * list.size()),
          weights(in.vectors(n.half_chords()) * in.side * n.half_nodes()) {
        const ChordRule rule(n);
        const ZernikeValues polynomials(list, classes.order);
        const std::size_t half = n.half_nodes();
        for (std::size_t i = 0; i < n.half_chords(); ++i) {
            const std::size_t from = i / in.side * half, lane = i % in.side;
            for_tiles(half, node_tile, [&](std::size_t first, std::size_t size) {
                look();
                double* tile = values.data() + (from + first) * list.size() * in.side + in.place(lane);
                for (std::size_t r = 0; r < size; ++r) {
                    polynomials.at(rule.x[i], rule.s[i] * rule.eta[first + r], [&](std::size_t j, wide value) {
                        tile[(j * size + r) * in.side] = static_cast<double>(value);
                    });
                }
            });
            for (std::size_t k = 0; k < half; ++k) {
                const wide y = rule.s[i] * rule.eta[k];
                weights[(from + k) * in.side + lane] =
                    static_cast<double>(rule.weight(i, k) * light.at(rule.x[i] * rule.x[i] + y * y));
            }
        }
    }
    bool is(const ChordCount& n, const std::vector<ZernikeTerm>& list, const Amplitude& light, const ChordLanes& in) const {
        return count == n && lanes == in && amplitude == light && terms == list;
    }
    bool is(const ChordCount& n, const ChordLanes& in) const { return count == n && lanes == in; }
    std::size_t bytes() const { return (values.size() + weights.size() + own.size()) * sizeof(double); }

    // Set complex weights of the nodes, for apertures of any shape: given[chord][node][signs of x, y: ++, +-, -+, --][re, im].
    // Chords and nodes of the quadrant x, y > 0 and the four signs together give the nodes of the whole disk.
    void weigh(const double* given) {
        const std::size_t half = count.half_nodes();
        own.assign(weights.size() * 8, 0.0);
        for (std::size_t i = 0; i < count.half_chords(); ++i) {
            for (std::size_t k = 0; k < half; ++k) {
                for (std::size_t part = 0; part < 8; ++part) {
                    own[((i / lanes.side * half + k) * 8 + part) * lanes.side + i % lanes.side] =
                        given[(i * half + k) * 8 + part];
                }
            }
        }
    }
    static constexpr std::size_t most_bytes = std::size_t{96} << 20;
};

// Rows or columns of a window. at[entry]: signed distance from the optical axis, in pixels or, for sampling nodes, in units of
// lambda/(2 pi NA). Two rows or columns at opposite distances share one entry.
struct WindowAxis {
    static constexpr std::size_t none = ~std::size_t{0};
    std::size_t count;
    double center;  // position of the optical axis in pixels; 0 for sampling nodes
    std::vector<double> at;
    std::vector<std::size_t> plus, minus;  // [entry]: index of the row or column at distance +at, at -at (or `none`)

    WindowAxis(std::size_t pixels, double axis)
        : count(pixels), center(axis), low_(-axis), high_(static_cast<double>(pixels - 1) - axis) {
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
    // For sampling nodes at increasing signed distances from the axis; opposite nodes are paired if all are symmetric about it.
    explicit WindowAxis(const std::vector<double>& places)
        : count(places.size()), center(0.0), low_(places.front()), high_(places.back()) {
        const bool mirrored =
            std::equal(places.begin(), places.end(), places.rbegin(), [](double a, double b) { return a == -b; });
        for (std::size_t j = mirrored ? count / 2 : 0; j < count; ++j) {
            at.push_back(places[j]);
            plus.push_back(j);
            minus.push_back(mirrored && places[j] != 0.0 ? count - 1 - j : none);
        }
    }
    bool operator==(const WindowAxis& other) const { return count == other.count && center == other.center && at == other.at; }
    double low() const { return low_; }
    double high() const { return high_; }
    // Signed distances from the axis times `step`, in order.
    std::vector<double> places(double step) const {
        std::vector<double> found(count);
        for (std::size_t i = 0; i < at.size(); ++i) {
            found[plus[i]] = step * at[i];
            if (minus[i] != none) {
                found[minus[i]] = -step * at[i];
            }
        }
        return found;
    }

   private:
    double low_, high_;
};

// Fourier kernel in the precision of the sums: cosines and sines of the phases v_y y and v_x x. (x, y): node of the pupil; (v_x,
// v_y): column and row of pixels, in units of lambda/(2 pi NA).
template <class Real>
struct KernelTable {
    using Values = std::vector<Real, AlignedAllocator<Real>>;

    ChordCount count;
    ChordLanes lanes;
    WindowAxis rows, columns;
    double step;
    Values row_cos, row_sin;  // of v_y y: [vector of chords][tile of rows][node][row of the tile][chord]
    Values column_cos, column_sin;  // of v_x x: [tile of columns][chord][column of the tile]

    KernelTable(const ChordCount& n, const WindowAxis& down, const WindowAxis& across, double pixel_step, const ChordLanes& in)
        : count(n), lanes(in), rows(down), columns(across), step(pixel_step),
          row_cos(in.vectors(n.half_chords()) * in.side * n.half_nodes() * rows.at.size()), row_sin(row_cos.size()),
          column_cos(n.half_chords() * in.vectors(columns.at.size()) * in.side), column_sin(column_cos.size()) {
        const ChordRule rule(n);
        for (std::size_t i = 0; i < n.half_chords(); ++i) {
            const std::size_t from = i / in.side * in.side * n.half_nodes() * rows.at.size() + i % in.side;
            fill(rows.at, in.rows, false, rule.eta, rule.s[i], in.side, row_cos.data() + from, row_sin.data() + from);
        }
        // If vector lanes are chords in the sums along y, they are columns of pixels in the sums along x.
        fill(columns.at, in.side > 1 ? in.side : column_tile, in.side > 1, rule.x, 1, 1, column_cos.data(), column_sin.data());
    }
    bool is(const ChordCount& n, const WindowAxis& down, const WindowAxis& across, double pixel_step,
            const ChordLanes& in) const {
        return count == n && lanes == in && step == pixel_step && rows == down && columns == across;
    }
    std::size_t vectors() const { return lanes.vectors(count.half_chords()); }
    std::size_t bytes() const { return 2 * (row_cos.size() + column_cos.size()) * sizeof(Real); }
    static constexpr std::size_t most_bytes = std::size_t{96} << 20, of_stack = most_bytes / 3;  // limit for one stack
    static double bytes(double nodes, std::size_t rows) { return 0.5 * sizeof(Real) * nodes * static_cast<double>(rows); }

   private:
    // Write cosines and sines of the phases at[i] x step x factor x nodes[k]. Distances `at` are stored in tiles of at most `tile`
    // distances (`padded`: all tiles have the length `tile`). stride: spacing of the stored values.
    void fill(const std::vector<double>& at, std::size_t tile, bool padded, const std::vector<wide>& nodes, wide factor,
              std::size_t stride, Real* cosines, Real* sines) const {
        look();
        std::vector<std::size_t> first(at.size()), size(at.size(), tile);
        if (padded) {
            std::generate(first.begin(), first.end(), [&, i = std::size_t{0}]() mutable { return i++ / tile * tile; });
        } else {
            for_tiles(at.size(), tile, [&](std::size_t begin, std::size_t length) {
                std::fill_n(first.begin() + static_cast<std::ptrdiff_t>(begin), length, begin);
                std::fill_n(size.begin() + static_cast<std::ptrdiff_t>(begin), length, length);
            });
        }
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            const auto put = [&](std::size_t i, auto cosine, auto sine) {
                const std::size_t place = (first[i] * nodes.size() + k * size[i] + i - first[i]) * stride;
                cosines[place] = static_cast<Real>(cosine);
                sines[place] = static_cast<Real>(sine);
            };
            turn(at, static_cast<wide>(step) * factor * nodes[k], put);
        }
    }

    // Cosine and sine of an angle in extended precision. Its remainder modulo a quarter turn is rounded to double, for which cosine
    // and sine are much faster; this loses one unit roundoff (docs/certificate.md, section 8, "Rounding").
    static void turn_once(wide angle, wide& cosine, wide& sine) {
        constexpr wide quarter = static_cast<wide>(1.57079632679489661923132169163975144L);
        const wide turns = std::nearbyint(angle / quarter);
        const double left = static_cast<double>(angle - turns * quarter), c = std::cos(left), s = std::sin(left);
        const std::size_t place = static_cast<std::size_t>(static_cast<std::int64_t>(turns) & 3);
        const double around[] = {c, -s, -c, s, c};
        cosine = static_cast<wide>(around[place]);
        sine = static_cast<wide>(-around[place + 1]);
    }

    // Cosines and sines of at[i] x angle, by rotation from one pixel to the next. To keep the error below the rounding of stored
    // values, they are computed anew every `most` pixels.
    template <class Put>
    static void turn(const std::vector<double>& at, wide angle, const Put& put) {
        constexpr std::size_t most = wider || sizeof(Real) == sizeof(float) ? 32 : 1;
        const wide along = std::cos(angle), up = std::sin(angle);
        wide cosine = 1, sine = 0;
        for (std::size_t i = 0; i < at.size(); ++i) {
            const bool uneven = i > 0 && at[i] - at[i - 1] != 1.0;
            if (uneven && wider) {
                turn_once(static_cast<wide>(at[i]) * angle, cosine, sine);
            } else if (uneven || i % most == 0) {
                cosine = std::cos(static_cast<wide>(at[i]) * angle);
                sine = std::sin(static_cast<wide>(at[i]) * angle);
            } else {
                const wide turned = cosine * along - sine * up;
                sine = sine * along + cosine * up;
                cosine = turned;
            }
            put(i, cosine, sine);
        }
    }
};

}  // namespace lommel
