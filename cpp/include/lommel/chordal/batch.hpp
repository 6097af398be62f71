// Pupils side by side in the lanes of vectors, with what they share: tables for the whole disk and for the obscured one.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>

#include "lommel/chordal/factors.hpp"
#include "lommel/chordal/tables.hpp"
#include "lommel/chordal/transform.hpp"
#include "lommel/zernike/disk_stack.hpp"

namespace lommel {

template <class Real>
struct ChordalTables {
    std::shared_ptr<const TermTable> terms;
    std::shared_ptr<const KernelTable<Real>> kernel;
    std::shared_ptr<const FactorTable> factors;  // where derivatives are wanted

    // Of a disk of such a radius, for places `step` in v apart; kept for further images.
    template <class More>
    static ChordalTables of(const DiskStack& stack, const ChordCount& count, const WindowAxis& rows, const WindowAxis& columns,
                            double step, double radius, const More& more) {
        return {cache<TermTable>.get(count, stack.terms, stack.amplitude.scaled(radius * radius)),
                cache<KernelTable<Real>>.get(count, rows, columns, radius * step),
                More::wanted ? cache<FactorTable>.get(count, more.terms, radius) : nullptr};
    }
};

// The disks of an aperture: the whole one, and the obscured one, whose U is subtracted `area` times where that is not 0.
template <class Real>
struct ChordalBatch {
    const DiskStack& stack;
    const std::size_t* pupils;
    std::size_t here;  // of them
    double area;
    const std::array<ChordalTables<Real>, 2>& disks;
    ChordalScratch<Real>& scratch;

    std::size_t rows() const { return disks[0].kernel->rows.count; }
    std::size_t columns() const { return disks[0].kernel->columns.count; }
};

// Lays the coefficients of a disk into lanes: lanes without a pupil begin again with the first.
template <class I, class Real>
LOMMEL_INLINE void gather(I, const ChordalBatch<Real>& batch, std::size_t disk) {
    using Wave = Waves<I, Real>;
    const DiskStack& stack = batch.stack;
    const TermTable& table = *batch.disks[disk].terms;
    const std::size_t terms = stack.terms.size();
    Doubles& coefficients = batch.scratch.coefficients;
    coefficients.resize(terms * Wave::lanes);
    for (std::size_t lane = 0; lane < Wave::lanes; ++lane) {
        const double* own = (disk == 0 ? stack.outer : stack.inner).data() + batch.pupils[lane % batch.here] * terms;
        for (std::size_t j = 0; j < terms; ++j) {
            coefficients[j * Wave::lanes + Wave::place(lane)] = Wave::unit * own[table.classes.order[j]];
        }
    }
}

// U of the aperture, row by row, as chordal_fields() gives it: prepare(disk) before each disk, nodes_of(disk, chord).
template <class I, class Real, class Prepare, class Nodes, class Sink>
LOMMEL_INLINE void aperture_fields(I isa, const ChordalBatch<Real>& batch, const Prepare& prepare, const Nodes& nodes_of,
                                   const Sink& sink) {
    using V = typename Waves<I, Real>::V;
    constexpr std::size_t lanes = Waves<I, Real>::lanes;
    const bool obscured = batch.area > 0.0;
    const std::size_t line = batch.columns() * 2 * lanes;
    ChordalScratch<Real>& scratch = batch.scratch;
    scratch.inner.resize(obscured ? batch.rows() * line : 0);
    const V area = splat<V>(static_cast<Real>(batch.area));
    for (std::size_t disk = obscured ? 2 : 1; disk-- > 0;) {
        prepare(disk);
        const auto nodes = [&](std::size_t i) LOMMEL_INLINE_LAMBDA { return nodes_of(disk, i); };
        chordal_fields(isa, *batch.disks[disk].kernel, scratch, nodes, [&](std::size_t y, Real* u) LOMMEL_INLINE_LAMBDA {
            Real* inner = scratch.inner.data() + y * line;
            if (disk > 0) {
                for (std::size_t j = 0; j < line; j += lanes) {
                    store(inner + j, load<V>(u + j) * area);
                }
                return;
            }
            for (std::size_t j = 0; obscured && j < line; j += lanes) {
                store(u + j, load<V>(u + j) - load<V>(inner + j));
            }
            sink(y, u);
        });
    }
}

// Of the pupil function itself; its nodes are kept, all chords of them, where others follow.
template <class I, class Real, class Sink>
LOMMEL_INLINE void pupil_fields(I isa, const ChordalBatch<Real>& batch, bool keep, const Sink& sink) {
    constexpr std::size_t lanes = Waves<I, Real>::lanes;
    ChordalScratch<Real>& scratch = batch.scratch;
    const auto prepare = [&](std::size_t disk) LOMMEL_INLINE_LAMBDA {
        gather(isa, batch, disk);
        const ChordCount& n = batch.disks[disk].terms->count;
        scratch.kept[disk].resize((keep ? n.half_chords() : 1) * n.half_nodes() * 8 * lanes);
    };
    const auto nodes = [&](std::size_t disk, std::size_t i) LOMMEL_INLINE_LAMBDA {
        const TermTable& terms = *batch.disks[disk].terms;
        Real* to = scratch.kept[disk].data() + (keep ? i : 0) * terms.count.half_nodes() * 8 * lanes;
        pair_of_chords(isa, terms, i, scratch.coefficients.data(), to);
        return to;
    };
    aperture_fields(isa, batch, prepare, nodes, sink);
}

}  // namespace lommel
