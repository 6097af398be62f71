// Complex amplitudes U in the image for a batch of pupils, one pupil per vector lane, or for a single pupil with the chords of the
// quadrature in the vector lanes.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "lommel/base/reference.hpp"
#include "lommel/chordal/factors.hpp"
#include "lommel/chordal/kernels.hpp"
#include "lommel/chordal/tables.hpp"
#include "lommel/zernike/disk_stack.hpp"

namespace lommel {

// Tables for quadrature along chords of one disk, the full aperture or its obscuration: Zernike terms at the nodes, Fourier kernel,
// and Zernike terms to differentiate with respect to.
template <class Real>
struct ChordalTables {
    std::shared_ptr<const TermTable> terms;
    std::shared_ptr<const KernelTable<Real>> kernel;
    std::shared_ptr<const FactorTable> factors;  // Zernike terms of the derivatives; null without derivatives

    // Get the tables from the cache. radius: radius of the disk / radius of the aperture; step: pixel pitch in units of lambda/(2
    // pi NA).
    template <class More>
    static ChordalTables of(const DiskStack& stack, const ChordCount& count, const WindowAxis& rows, const WindowAxis& columns,
                            double step, double radius, const More& more, const ChordLanes& lanes) {
        return {cache<TermTable>.get(count, stack.terms, stack.amplitude.scaled(radius * radius), lanes),
                cache<KernelTable<Real>>.get(count, rows, columns, radius * step, lanes),
                More::wanted ? cache<FactorTable>.get(count, more.terms, radius) : nullptr};
    }
};

// Working memory of a thread for one batch of pupils.
template <class Real>
struct ChordalScratch {
    using Values = std::vector<Real, AlignedAllocator<Real>>;
    Doubles coefficients;
    Values chords, row, inner, intensity;
    Values kept[2], factored, factors, fields;  // used for derivatives only
    Values lines;  // used for pixel averages only
    Doubles sums;
};

// Batch of pupils. area: relative area of the obscuration, 0 for none; the complex amplitude U in the image is that of the full
// disk minus `area` times that of the obscuration.
template <class Real>
struct ChordalBatch {
    using Kernels = ChordKernels<Real>;
    using Nodes = Reference<const Real*(std::size_t disk, std::size_t chord)>;
    using Sink = Reference<void(std::size_t row, Real* u)>;

    Level level;
    const DiskStack& stack;
    const std::size_t* pupils;
    std::size_t here;  // number of pupils in the batch
    double area;
    const std::array<ChordalTables<Real>, 2>& disks;
    ChordalScratch<Real>& scratch;

    std::size_t lanes() const { return Kernels::lanes(level); }
    std::size_t rows() const { return disks[0].kernel->rows.count; }
    std::size_t columns() const { return disks[0].kernel->columns.count; }
    bool lone() const { return disks[0].kernel->lanes.side > 1; }
    // Number of SIMD vectors in a row of the image: one per column or, for a single pupil, one per lanes() columns.
    std::size_t vectors() const { return disks[0].kernel->lanes.vectors(columns()); }
    // Number of reals that store the pupil function on a pair of chords at +-x (for a single pupil, on a vector of pairs): per
    // node, re and im of its four parts that are even or odd in x and in y.
    std::size_t room(std::size_t disk) const { return disks[disk].kernel->count.half_nodes() * 8 * lanes(); }

    void gather(std::size_t disk) const {
        const TermTable& table = *disks[disk].terms;
        const std::size_t terms = stack.terms.size(), all = lone() ? 1 : lanes();
        const ChordLanes order{all, sizeof(Real) == sizeof(float)};
        scratch.coefficients.resize(terms * all);
        for (std::size_t lane = 0; lane < all; ++lane) {
            const double* own = (disk == 0 ? stack.outer : stack.inner).data() + pupils[lane % here] * terms;
            double* to = scratch.coefficients.data() + order.place(lane);
            for (std::size_t j = 0; j < terms; ++j) {
                to[j * all] = Kernels::unit * own[table.classes.order[j]];
            }
        }
    }

    // Compute the complex amplitude U of one disk and pass it to `sink` row by row, as [column][re, im]. nodes_of(disk, chord):
    // returns the pupil function on a pair of chords.
    void disk_fields(std::size_t disk, const Nodes& nodes_of, const Sink& sink) const {
        const KernelTable<Real>& kernel = *disks[disk].kernel;
        const std::size_t line = 2 * kernel.vectors() * 2 * lanes();
        scratch.chords.resize(kernel.rows.count * line);
        scratch.row.resize(vectors() * 2 * lanes());
        for (std::size_t i = 0; i < kernel.vectors(); ++i) {
            look();
            Kernels::rows(level, kernel, i, nodes_of(disk, i), scratch.chords.data());
        }
        for (std::size_t y = 0; y < kernel.rows.count; ++y) {
            look();
            Kernels::columns(level, kernel, scratch.chords.data() + y * line, scratch.row.data());
            sink(y, scratch.row.data());
        }
    }

    // Compute the complex amplitude U of the aperture, obscuration subtracted; prepare(disk) is called before each disk.
    void fields(const Reference<void(std::size_t disk)>& prepare, const Nodes& nodes_of, const Sink& sink) const {
        const std::size_t all = 2 * vectors(), line = all * lanes();
        const bool obscured = area > 0.0;
        scratch.inner.resize(obscured ? rows() * line : 0);
        if (obscured) {
            prepare(1);
            disk_fields(1, nodes_of, [&](std::size_t y, Real* u) {
                Kernels::scale(level, u, static_cast<Real>(area), all, scratch.inner.data() + y * line);
            });
        }
        prepare(0);
        disk_fields(0, nodes_of, [&](std::size_t y, Real* u) {
            if (obscured) {
                Kernels::subtract(level, scratch.inner.data() + y * line, all, u);
            }
            sink(y, u);
        });
    }

    // Compute the complex amplitude U from the Zernike coefficients. keep: store the pupil function at all nodes in scratch.kept,
    // for derivatives.
    void pupil_fields(bool keep, const Sink& sink) const {
        const auto prepare = [&](std::size_t disk) {
            gather(disk);
            scratch.kept[disk].resize((keep ? disks[disk].terms->count.half_chords() : 1) * room(disk));
        };
        const auto nodes = [&](std::size_t disk, std::size_t i) {
            Real* to = scratch.kept[disk].data() + (keep ? i : 0) * room(disk);
            Kernels::nodes(level, *disks[disk].terms, i, scratch.coefficients.data(), to);
            return to;
        };
        fields(prepare, nodes, sink);
    }
};

}  // namespace lommel
