// Inner loops of the quadrature along chords of the pupil, compiled once for each real type and instruction set.
#pragma once

#include <cstddef>

#include "lommel/base/simd.hpp"
#include "lommel/chordal/averages.hpp"
#include "lommel/chordal/factors.hpp"
#include "lommel/chordal/strips.hpp"
#include "lommel/chordal/tables.hpp"
#include "lommel/chordal/transform.hpp"
#include "lommel/chordal/transpose.hpp"

namespace lommel {

constexpr std::size_t most_pupils = 2 * row_lanes;  // largest number of pupils in a SIMD vector

// Dispatch of the inner loops by instruction set (level). The templates that these functions call describe the arguments.
template <class Real>
struct ChordKernels {
    static constexpr double unit = Waves<Portable, Real>::unit;
    static constexpr std::size_t lanes(Level level) { return widest_lanes(level) * sizeof(double) / sizeof(Real); }
    // Return whether `pupils` is so small that pupils are computed faster one by one, with chords in the vector lanes.
    static bool lone(Level level, std::size_t pupils) { return 2 * pupils <= lanes(level); }
    static ChordLanes chord_lanes(Level level, bool lone) {
        return {lone ? lanes(level) : 1, sizeof(Real) == sizeof(float), level == Level::avx512 ? row_tile + 1 : row_tile};
    }

    static void nodes(Level level, const TermTable& table, std::size_t chord, const double* coefficients, Real* to);
    static void rows(Level level, const KernelTable<Real>& kernel, std::size_t chord, const Real* nodes, Real* chords);
    static void columns(Level level, const KernelTable<Real>& kernel, const Real* chords, Real* row);
    static void parity_rows(Level level, const KernelTable<Real>& kernel, std::size_t chord, bool odd, const Real* nodes,
                            Real* chords);
    static void parity_columns(Level level, const KernelTable<Real>& kernel, bool odd, const Real* chords, Real* row);
    static void intensities(Level level, const Real* u, std::size_t columns, Real* values, Real* top);
    static void subtract(Level level, const Real* inner, Real area, std::size_t count, Real* u);
    static void average_along(Level level, const NodeWeights<Real>& weights, std::size_t y, const Real* samples, Real* lines);
    static void average_down(Level level, const NodeWeights<Real>& weights, const Real* lines, double* sums);
    static void include_largest(Level level, const Real* values, std::size_t nodes, std::size_t block, std::size_t side,
                                Real* largest);
    static void times_factors(Level level, const FactorLanes& given, std::size_t chord, const Real* nodes, Real* room,
                              Real* to);
    static void slopes(Level level, const Real* u, const Real* d, std::size_t columns, Real* values, Real* top);
    static void weigh(Level level, const Real* weights, std::size_t pixels, Real* u);
    static void columns_transposed(Level level, const KernelTable<Real>& kernel, const Real* pixels, Real* chords);
    static void rows_transposed(Level level, const KernelTable<Real>& kernel, std::size_t chord, const Real* chords,
                                Real* nodes);
    static void add_products(Level level, const FactorTable& table, std::size_t chord, const Real* pupil, const Real* adjoint,
                             Real share, Real* room, Real* sums);
    static void strip_nodes(Level level, const StripLine& line, const StripTerms& terms, const double* weights,
                            const double* coefficients, Real* kept, Real* sums);
    static void strip_products(Level level, const StripLine& line, const Real* kept, const Real* factors, Real* sums);
    static void strip_line(Level level, const StripTable<Real>& table, std::size_t line, const Real* nodes, Real* to);
    static void subtract_strips(Level level, const StripTable<Real>& table, const Real* fields, std::size_t row, Real* u);
    static void lone_strip_line(Level level, const LoneStripTable<Real>& table, std::size_t line, const Real* nodes, Real* to);
    static void lone_subtract_strips(Level level, const LoneStripTable<Real>& table, const Real* fields, std::size_t row,
                                     Real* band, Real* u);

    // Store a row of one pupil's image: to[column] = by x values[column].
    template <class T>
    static void store_row(Level level, const Real* values, double by, std::size_t columns, T* to);
    // Store a row of the images of `used` pupils: to[lane][column] = by[lane] x values[column][lane].
    template <class T>
    static void store_lanes(Level level, const Real* values, std::size_t used, const double* by, std::size_t columns,
                            T* const* to);
};

template <class Real>
void ChordKernels<Real>::nodes(Level level, const TermTable& table, std::size_t chord, const double* coefficients, Real* to) {
    dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA {
        if (!table.own.empty()) {
            return table.lanes.side > 1 ? pair_of_chords<true, true>(isa, table, chord, coefficients, to)
                                        : pair_of_chords<false, true>(isa, table, chord, coefficients, to);
        }
        table.lanes.side > 1 ? pair_of_chords<true, false>(isa, table, chord, coefficients, to)
                             : pair_of_chords<false, false>(isa, table, chord, coefficients, to);
    });
}
template <class Real>
void ChordKernels<Real>::rows(Level level, const KernelTable<Real>& kernel, std::size_t chord, const Real* nodes,
                              Real* chords) {
    dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA {
        kernel.lanes.side > 1 ? rows_of_chords<true>(isa, kernel, chord, nodes, chords)
                              : rows_of_chords<false>(isa, kernel, chord, nodes, chords);
    });
}
template <class Real>
void ChordKernels<Real>::columns(Level level, const KernelTable<Real>& kernel, const Real* chords, Real* row) {
    dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA {
        kernel.lanes.side > 1 ? lone_columns_of_row(isa, kernel, chords, row) : columns_of_row(isa, kernel, chords, row);
    });
}
template <class Real>
void ChordKernels<Real>::parity_rows(Level level, const KernelTable<Real>& kernel, std::size_t chord, bool odd,
                                     const Real* nodes, Real* chords) {
    dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA { rows_of_parity(isa, kernel, chord, odd, nodes, chords); });
}
template <class Real>
void ChordKernels<Real>::parity_columns(Level level, const KernelTable<Real>& kernel, bool odd, const Real* chords, Real* row) {
    dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA { columns_of_parity(isa, kernel, odd, chords, row); });
}
template <class Real>
void ChordKernels<Real>::intensities(Level level, const Real* u, std::size_t columns, Real* values, Real* top) {
    dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA { intensities_of_row(isa, u, columns, values, top); });
}
template <class Real>
void ChordKernels<Real>::subtract(Level level, const Real* inner, Real area, std::size_t count, Real* u) {
    dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA { lommel::subtract(isa, inner, area, count, u); });
}
template <class Real>
void ChordKernels<Real>::average_along(Level level, const NodeWeights<Real>& weights, std::size_t y, const Real* samples,
                                       Real* lines) {
    dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA {
        weights.side > 1 ? lommel::average_along<true>(isa, weights, y, samples, lines)
                         : lommel::average_along<false>(isa, weights, y, samples, lines);
    });
}
template <class Real>
void ChordKernels<Real>::average_down(Level level, const NodeWeights<Real>& weights, const Real* lines, double* sums) {
    dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA { lommel::average_down(isa, weights, lines, sums); });
}
template <class Real>
void ChordKernels<Real>::include_largest(Level level, const Real* values, std::size_t nodes, std::size_t block,
                                         std::size_t side, Real* largest) {
    dispatch_widest(level,
                    [&](auto isa) LOMMEL_INLINE_LAMBDA { lommel::include_largest(isa, values, nodes, block, side, largest); });
}
template <class Real>
void ChordKernels<Real>::times_factors(Level level, const FactorLanes& given, std::size_t chord, const Real* nodes, Real* room,
                                       Real* to) {
    dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA { lommel::times_factors(isa, given, chord, nodes, room, to); });
}
template <class Real>
void ChordKernels<Real>::slopes(Level level, const Real* u, const Real* d, std::size_t columns, Real* values, Real* top) {
    dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA { slopes_of_row(isa, u, d, columns, values, top); });
}
template <class Real>
void ChordKernels<Real>::weigh(Level level, const Real* weights, std::size_t pixels, Real* u) {
    dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA { weigh_pixels(isa, weights, pixels, u); });
}
template <class Real>
void ChordKernels<Real>::columns_transposed(Level level, const KernelTable<Real>& kernel, const Real* pixels, Real* chords) {
    dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA { lommel::columns_transposed(isa, kernel, pixels, chords); });
}
template <class Real>
void ChordKernels<Real>::rows_transposed(Level level, const KernelTable<Real>& kernel, std::size_t chord, const Real* chords,
                                         Real* nodes) {
    dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA { lommel::rows_transposed(isa, kernel, chord, chords, nodes); });
}
template <class Real>
void ChordKernels<Real>::add_products(Level level, const FactorTable& table, std::size_t chord, const Real* pupil,
                                      const Real* adjoint, Real share, Real* room, Real* sums) {
    dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA {
        lommel::add_products(isa, table, chord, pupil, adjoint, share, room, sums);
    });
}

template <class Real>
void ChordKernels<Real>::strip_nodes(Level level, const StripLine& line, const StripTerms& terms, const double* weights,
                                     const double* coefficients, Real* kept, Real* sums) {
    dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA {
        line.points == 4   ? lommel::strip_nodes<4>(isa, line, terms, weights, coefficients, kept, sums)
        : line.points == 2 ? lommel::strip_nodes<2>(isa, line, terms, weights, coefficients, kept, sums)
                           : lommel::strip_nodes<1>(isa, line, terms, weights, coefficients, kept, sums);
    });
}
template <class Real>
void ChordKernels<Real>::strip_products(Level level, const StripLine& line, const Real* kept, const Real* factors, Real* sums) {
    dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA { lommel::strip_products(isa, line, kept, factors, sums); });
}
template <class Real>
void ChordKernels<Real>::strip_line(Level level, const StripTable<Real>& table, std::size_t line, const Real* nodes, Real* to) {
    dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA { lommel::strip_line(isa, table, line, nodes, to); });
}
template <class Real>
void ChordKernels<Real>::subtract_strips(Level level, const StripTable<Real>& table, const Real* fields, std::size_t row,
                                         Real* u) {
    dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA { lommel::subtract_strips(isa, table, fields, row, u); });
}
template <class Real>
void ChordKernels<Real>::lone_strip_line(Level level, const LoneStripTable<Real>& table, std::size_t line, const Real* nodes,
                                         Real* to) {
    dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA { lommel::lone_strip_line(isa, table, line, nodes, to); });
}
template <class Real>
void ChordKernels<Real>::lone_subtract_strips(Level level, const LoneStripTable<Real>& table, const Real* fields,
                                              std::size_t row, Real* band, Real* u) {
    dispatch_widest(level,
                    [&](auto isa) LOMMEL_INLINE_LAMBDA { lommel::lone_subtract_strips(isa, table, fields, row, band, u); });
}

template <class Real>
template <class T>
void ChordKernels<Real>::store_row(Level level, const Real* values, double by, std::size_t columns, T* to) {
    dispatch(level, [&](auto) LOMMEL_INLINE_LAMBDA {
        for (std::size_t x = 0; x < columns; ++x) {
            to[x] = static_cast<T>(by * static_cast<double>(values[x]));
        }
    });
}

template <class Real>
template <class T>
void ChordKernels<Real>::store_lanes(Level level, const Real* values, std::size_t used, const double* by, std::size_t columns,
                                     T* const* to) {
    dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA {
        constexpr std::size_t stride = Waves<decltype(isa), Real>::lanes;
        for (std::size_t lane = 0; lane < used; ++lane) {
            for (std::size_t x = 0; x < columns; ++x) {
                to[lane][x] = static_cast<T>(by[lane] * static_cast<double>(values[x * stride + lane]));
            }
        }
    });
}

#if defined(LOMMEL_COMPILED)
extern template struct ChordKernels<float>;
extern template struct ChordKernels<double>;
extern template void ChordKernels<float>::store_row<float>(Level, const float*, double, std::size_t, float*);
extern template void ChordKernels<float>::store_lanes<float>(Level, const float*, std::size_t, const double*, std::size_t,
                                                             float* const*);
extern template void ChordKernels<double>::store_row<double>(Level, const double*, double, std::size_t, double*);
extern template void ChordKernels<double>::store_lanes<double>(Level, const double*, std::size_t, const double*, std::size_t,
                                                               double* const*);
extern template void ChordKernels<double>::store_row<float>(Level, const double*, double, std::size_t, float*);
extern template void ChordKernels<double>::store_lanes<float>(Level, const double*, std::size_t, const double*, std::size_t,
                                                              float* const*);
#endif

}  // namespace lommel
