// Complex amplitudes in the image for a batch of pupils, one per vector lane, or for one pupil with its chords in the lanes.
#pragma once

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

// Tables of one disk (full aperture or obscuration): Zernike terms at the nodes, Fourier kernel, Zernike terms of derivatives.
template <class Real>
struct ChordalTables {
    std::shared_ptr<const TermTable> terms;
    std::shared_ptr<const KernelTable<Real>> kernel;
    std::shared_ptr<const FactorTable> factors;  // Zernike terms of the derivatives; null without derivatives

    // Get the tables from the cache. radius: disk's radius / aperture's radius; step: pixel pitch in units of lambda/(2 pi NA).
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
    Doubles coefficients, strip_coefficients;
    Values chords[2], row, inner, intensity;
    Values kept[2], factored, factors, fields;  // used for derivatives only
    Values lines;  // used for pixel averages only
    Values strip_sums, strip_kept, strip_factors, strip_fields, strip_band;  // used for strips only
    Doubles sums;
};

// Tables of the strips that are cut out of the aperture; null without strips, and `factors` without derivatives. Of a window there
// is one table: `lone` for pupils that are computed one by one.
template <class Real>
struct StripTables {
    std::shared_ptr<const StripTable<Real>> window;
    std::shared_ptr<const LoneStripTable<Real>> lone;
    std::shared_ptr<const StripTerms> terms, factors;

    const std::vector<double>& weights() const { return lone != nullptr ? lone->weights : window->weights; }
    double misfit() const { return lone != nullptr ? lone->misfit : window->misfit; }
};

// Batch of pupils. Complex amplitude of a pupil = that of the full disk - area * that of the obscuration, of relative area `area`.
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
    StripTables<Real> strips = {};

    std::size_t lanes() const { return Kernels::lanes(level); }
    std::size_t rows() const { return disks[0].kernel->rows.count; }
    std::size_t columns() const { return disks[0].kernel->columns.count; }
    bool lone() const { return disks[0].kernel->lanes.side > 1; }
    // Number of SIMD vectors in a row of the image: one per column or, for a single pupil, one per lanes() columns.
    std::size_t vectors() const { return disks[0].kernel->lanes.vectors(columns()); }
    // Number of reals at the nodes of a pair of chords (or of a vector of pairs): four parities in x and y, each with re and im.
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

    // Transform one disk along y, to scratch.chords[disk]. nodes_of(disk, i): pupil function at the nodes of the i-th pair of chords
    // (or vector of pairs).
    void disk_rows(std::size_t disk, const Nodes& nodes_of) const {
        const KernelTable<Real>& kernel = *disks[disk].kernel;
        scratch.chords[disk].resize(kernel.rows.count * line(disk));
        for (std::size_t i = 0; i < kernel.vectors(); ++i) {
            look();
            Kernels::rows(level, kernel, i, nodes_of(disk, i), scratch.chords[disk].data());
        }
    }
    // Number of reals of one row in scratch.chords[disk].
    std::size_t line(std::size_t disk) const { return 4 * disks[disk].kernel->vectors() * lanes(); }

    // Compute the fields of all lines of the strips at the places of their tables. fold(line, sums): sums of the pupil function over
    // the points of each node, see fold_points().
    void strip_fields(const Reference<void(std::size_t line, Real* sums)>& fold) const {
        const StripTable<Real>* const window = strips.window.get();
        const LoneStripTable<Real>* const alone = strips.lone.get();
        const std::vector<StripLine>& lines = strips.terms->points.lines;
        const std::size_t room = alone != nullptr ? alone->room : window->room(lanes());
        scratch.strip_fields.resize((alone != nullptr ? alone->sums : window->sums) * room);
        Real* to = scratch.strip_fields.data();
        for (std::size_t i = 0; i < lines.size(); ++i) {
            look();
            const std::size_t each = 4 * lines[i].nodes * lanes();
            scratch.strip_sums.resize(2 * each);
            fold(i, scratch.strip_sums.data());
            for (std::size_t sum = 0; sum < lines[i].sums; ++sum, to += room) {
                const Real* const nodes = scratch.strip_sums.data() + sum * each;
                alone != nullptr ? Kernels::lone_strip_line(level, *alone, i, nodes, to)
                                 : Kernels::strip_line(level, *window, i, nodes, to);
            }
        }
    }

    // Compute the complex amplitude U of the aperture, obscuration and strips subtracted, row by row: U[column][re, im] goes to `sink`.
    // prepare(disk) is called before each disk, cut() before the strips, from the same coefficients as disk 0.
    void fields(const Reference<void(std::size_t disk)>& prepare, const Nodes& nodes_of, const Reference<void()>& cut,
                const Sink& sink) const {
        const std::size_t all = 2 * vectors();
        const bool obscured = area > 0.0;
        if (obscured) {
            prepare(1);
            disk_rows(1, nodes_of);
        }
        prepare(0);
        if (strips.terms != nullptr) {
            cut();
        }
        disk_rows(0, nodes_of);
        scratch.row.resize(all * lanes());
        scratch.inner.resize(obscured ? all * lanes() : 0);
        scratch.strip_band.resize(strips.lone != nullptr ? all * lanes() * lanes() : 0);
        Real* const u = scratch.row.data();
        for (std::size_t y = 0; y < rows(); ++y) {
            look();
            Kernels::columns(level, *disks[0].kernel, scratch.chords[0].data() + y * line(0), u);
            if (obscured) {
                Kernels::columns(level, *disks[1].kernel, scratch.chords[1].data() + y * line(1), scratch.inner.data());
                Kernels::subtract(level, scratch.inner.data(), static_cast<Real>(area), all, u);
            }
            if (strips.window != nullptr) {
                Kernels::subtract_strips(level, *strips.window, scratch.strip_fields.data(), y, u);
            } else if (strips.lone != nullptr) {
                Kernels::lone_subtract_strips(level, *strips.lone, scratch.strip_fields.data(), y, scratch.strip_band.data(),
                                              u);
            }
            sink(y, u);
        }
    }

    // Compute the complex amplitude U from Zernike coefficients. keep: store the pupil function in scratch.kept, for derivatives.
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
        const auto cut = [&] {
            const double* coefficients = scratch.coefficients.data();
            if (lone()) {  // strips have pupils in the lanes, here the same one in all
                scratch.strip_coefficients.resize(scratch.coefficients.size() * lanes());
                for (std::size_t i = 0; i < scratch.strip_coefficients.size(); ++i) {
                    scratch.strip_coefficients[i] = coefficients[i / lanes()];
                }
                coefficients = scratch.strip_coefficients.data();
            }
            scratch.strip_kept.resize(keep ? 2 * strips.terms->points.x.size() * lanes() : 0);
            strip_fields([&](std::size_t i, Real* sums) {
                const StripLine& line = strips.terms->points.lines[i];
                Real* const kept = keep ? scratch.strip_kept.data() + 2 * line.first * lanes() : nullptr;
                Kernels::strip_nodes(level, line, *strips.terms, strips.weights().data() + line.first_node, coefficients, kept,
                                     sums);
            });
        };
        fields(prepare, nodes, cut, sink);
    }
};

}  // namespace lommel
