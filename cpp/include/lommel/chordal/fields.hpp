// Intensities sum |E|^2 of fields E whose pupil amplitudes are series of radial polynomials, and their derivatives, by quadrature
// along chords of the pupil with one field per vector lane (docs/certificate.md, section 16, "Small windows").
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/base/parallel.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/base/watch.hpp"
#include "lommel/chordal/batch.hpp"
#include "lommel/chordal/kernels.hpp"
#include "lommel/chordal/tables.hpp"
#include "lommel/special/sincos.hpp"

namespace lommel {

// Contribution to a field's amplitude: part `part` (a range of terms) of an amplitude series, times a factor. The factor is odd in
// y if parity & 1, odd in x if parity & 2.
struct FieldShare {
    std::int32_t field, parity, part;
};

// Pupil functions of a set of fields. series: index of their amplitude series; term: index of a Zernike term Z for a factor i Z,
// negative for none; kind: first index of NodeSeries::waves, 0 for exp(i W), 1 for i W exp(i W) / (bound on |W|), W being the phase
// of the plane (fold_waves()).
struct FieldSet {
    std::int32_t series, term, kind;
};

// Pupil functions at the nodes [chord][node] of the quadrant x, y > 0. The first set are those of the fields E; each further set,
// of fields F, gives one derivative of the intensity sum |E|^2: the sum of 2 Re(conj(E) F).
struct NodeSeries {
    ChordCount count;
    std::size_t planes, fields, total;  // numbers of planes, of fields, and of terms in a series
    std::vector<std::size_t> ends;  // [part]: index after its last term in the series
    const double* radial;  // radial polynomials at the nodes, [term][node]
    const std::complex<double>* coefficients;  // of the radial polynomials: [series][plane][term]
    std::vector<FieldShare> shares;
    const std::complex<double>* factors;  // factors of `shares` at the nodes, [share][node]
    std::vector<FieldSet> sets;
    const double* terms;  // Zernike polynomials at the nodes, [term][node]
    const std::int32_t* term_parity;
    std::size_t wave_count;
    const std::complex<double>* waves;  // results of fold_waves(): [kind][wave][parity][node]
    const std::int32_t* wave;  // [plane]: index of the plane's wave in `waves`

    std::size_t nodes() const { return count.half_chords() * count.half_nodes(); }
    const double* waves_of(const FieldSet& set, std::size_t plane) const {
        const std::size_t at = static_cast<std::size_t>(set.kind) * wave_count + static_cast<std::size_t>(wave[plane]);
        return reinterpret_cast<const double*>(waves + at * 4 * nodes());
    }
    // Parity of the part of a wave that, times the factor of `share` and the Zernike term of `set`, has `parity`. The parities of
    // factors add modulo 2, in y (bit 0) and in x (bit 1).
    std::size_t own_parity(const FieldShare& share, const FieldSet& set, std::size_t parity) const {
        const std::int32_t term = set.term < 0 ? 0 : term_parity[set.term];
        return parity ^ static_cast<std::size_t>(share.parity) ^ static_cast<std::size_t>(term);
    }
    std::size_t parts_size() const { return 2 * ends.size() * nodes(); }
};

// Waves exp(i W) x node weights, split into parts even or odd in x and in y: to[parity][node]. Phase W: sum over j < count of
// edge[j] x terms[j][node], where edge[j] is the coefficient of a Zernike term of parity parities[j]. If largest > 0, a bound on
// |W|, also i W exp(i W) / largest, from to[stride] on.
inline void fold_waves(Level level, std::size_t nodes, const double* terms, const std::int32_t* parities, std::size_t count,
                       const double* edge, const double* weights, double largest, std::complex<double>* to,
                       std::size_t stride) {
    dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA {
        using V = typename decltype(isa)::pack;
        constexpr std::size_t lanes = decltype(isa)::lanes;
        // Hadamard transform between values at (+-x, +-y) and four parities, along y, then along x: its own inverse up to a factor.
        const auto folded = [](const V(&p)[4], V(&q)[4]) LOMMEL_INLINE_LAMBDA {
            const V a = p[0] + p[1], b = p[0] - p[1], c = p[2] + p[3], d = p[2] - p[3];
            q[0] = a + c, q[1] = b + d, q[2] = a - c, q[3] = b - d;
        };
        for (std::size_t first = 0; first < nodes; first += lanes) {
            const std::size_t here = std::min(lanes, nodes - first);
            const auto taken = [&](const double* from) LOMMEL_INLINE_LAMBDA {
                double filled[lanes] = {};
                std::copy_n(from + first, here, filled);
                return load<V>(filled);
            };
            V sums[4] = {}, phases[4], re[4], im[4];
            for (std::size_t t = 0; t < count; ++t) {
                V& sum = sums[parities[t]];
                sum = sum + splat<V>(edge[t]) * taken(terms + t * nodes);
            }
            folded(sums, phases);
            const V weight = taken(weights);
            for (std::size_t image = 0; image < 4; ++image) {
                V sine, cosine;
                sincos(isa, phases[image], sine, cosine);
                re[image] = cosine * weight, im[image] = sine * weight;
            }
            const auto put = [&](std::complex<double>* at) LOMMEL_INLINE_LAMBDA {
                V a[4], b[4];
                folded(re, a), folded(im, b);
                for (std::size_t parity = 0; parity < 4; ++parity) {
                    for (std::size_t lane = 0; lane < here; ++lane) {
                        at[parity * nodes + first + lane] = {a[parity][lane], b[parity][lane]};
                    }
                }
            };
            put(to);
            if (largest > 0.0) {
                for (std::size_t image = 0; image < 4; ++image) {
                    const V phase = phases[image] * splat<V>(1.0 / largest), turned = splat<V>(0.0) - phase * im[image];
                    im[image] = phase * re[image], re[image] = turned;
                }
                put(to + stride);
            }
        }
    });
}

// Sum the amplitude series of one plane at nodes first .. first + count - 1; result: to[part][re, im][node].
inline void sum_series(Level level, const NodeSeries& given, const std::complex<double>* coefficients, std::size_t first,
                       std::size_t count, double* to) {
    const std::size_t nodes = given.nodes();
    dispatch(level, [&](auto) LOMMEL_INLINE_LAMBDA {
        for (std::size_t part = 0, term = 0; part < given.ends.size(); ++part) {
            double *re = to + 2 * part * nodes + first, *im = re + nodes;
            std::fill_n(re, count, 0.0);
            std::fill_n(im, count, 0.0);
            const auto add = [&](auto size) LOMMEL_INLINE_LAMBDA {
                constexpr std::size_t T = decltype(size)::value;
                const double* values[T];
                double a[T], b[T];
                for (std::size_t t = 0; t < T; ++t) {
                    values[t] = given.radial + (term + t) * nodes + first;
                    a[t] = coefficients[term + t].real(), b[t] = coefficients[term + t].imag();
                }
                for (std::size_t k = 0; k < count; ++k) {
                    double sum = re[k], other = im[k];
                    for (std::size_t t = 0; t < T; ++t) {
                        sum += a[t] * values[t][k];
                        other += b[t] * values[t][k];
                    }
                    re[k] = sum, im[k] = other;
                }
                term += T;
            };
            while (term + 4 <= given.ends[part]) {
                add(Size<4>{});
            }
            while (term < given.ends[part]) {
                add(Size<1>{});
            }
        }
    });
}

// Pupil amplitudes [series][plane][part][re, im][node] of `planes` planes from plane `first` on. A part is the sum of a range of
// terms (NodeSeries::ends). Computed in cache-sized blocks of nodes.
inline Doubles all_parts(Level level, const NodeSeries& given, std::size_t series, std::size_t first, std::size_t planes,
                         int threads) {
    constexpr std::size_t block = 64;
    const std::size_t nodes = given.nodes();
    Doubles parts(series * planes * given.parts_size());
    parallel_for((nodes + block - 1) / block, threads, [&](std::size_t, std::size_t b) {
        for (std::size_t p = 0; p < series * planes; ++p) {
            const std::size_t from = p / planes * given.planes + first + p % planes;
            sum_series(level, given, given.coefficients + from * given.total, b * block, std::min(block, nodes - b * block),
                       parts.data() + p * given.parts_size());
        }
    });
    return parts;
}

// Part of a field's pupil function with this `parity`: re[node], im[node]. own[p]: whether the plane's wave for this set (of the
// kind set.kind, see FieldSet) has a nonzero part with parity p; parts: results of sum_series().
inline void field_nodes(Level level, const NodeSeries& given, std::size_t plane, const FieldSet& set, std::size_t field,
                        std::size_t parity, const std::array<bool, 4>& own, const double* parts, double* re, double* im) {
    const std::size_t nodes = given.nodes();
    const double* z = set.term < 0 ? nullptr : given.terms + static_cast<std::size_t>(set.term) * nodes;
    dispatch(level, [&](auto) LOMMEL_INLINE_LAMBDA {
        std::fill_n(re, nodes, 0.0);
        std::fill_n(im, nodes, 0.0);
        for (std::size_t s = 0; s < given.shares.size(); ++s) {
            const FieldShare& share = given.shares[s];
            const std::size_t of = given.own_parity(share, set, parity);
            if (static_cast<std::size_t>(share.field) != field || !own[of]) {
                continue;
            }
            const double *const part = parts + 2 * static_cast<std::size_t>(share.part) * nodes, *const other = part + nodes;
            const auto* const factor = reinterpret_cast<const double*>(given.factors + s * nodes);
            const double* const wave = given.waves_of(set, plane) + 2 * of * nodes;
            for (std::size_t k = 0; k < nodes; ++k) {
                const double a = part[k] * factor[2 * k] - other[k] * factor[2 * k + 1];
                const double b = part[k] * factor[2 * k + 1] + other[k] * factor[2 * k];
                re[k] += a * wave[2 * k] - b * wave[2 * k + 1];
                im[k] += a * wave[2 * k + 1] + b * wave[2 * k];
            }
        }
        for (std::size_t k = 0; k < nodes && z; ++k) {
            const double turned = -im[k] * z[k];
            im[k] = re[k] * z[k];
            re[k] = turned;
        }
    });
}

// Write the pupil function of one field at a pair of chords at +-x to one vector lane of `nodes`, whose layout is
// [parity in y][node][parity in x][re, im][lane]. parts: results of sum_series(); room: working memory.
inline void place_field(Level level, const NodeSeries& given, std::size_t plane, const FieldSet& set, std::size_t field,
                        const double* parts, std::size_t chord, std::size_t lanes, double* room, double* nodes) {
    const std::size_t all = given.nodes(), within = given.count.half_nodes(), from = chord * within;
    const double* waves = given.waves_of(set, plane);
    std::fill_n(room, 8 * within, 0.0);
    dispatch(level, [&](auto) LOMMEL_INLINE_LAMBDA {
        double *const re = room + 8 * within, *const im = re + within;
        for (std::size_t s = 0; s < given.shares.size(); ++s) {
            const FieldShare& share = given.shares[s];
            if (static_cast<std::size_t>(share.field) != field) {
                continue;
            }
            const double *const part = parts + 2 * static_cast<std::size_t>(share.part) * all + from, *const other = part + all;
            const auto* factor = reinterpret_cast<const double*>(given.factors + s * all + from);
            for (std::size_t k = 0; k < within; ++k) {
                re[k] = part[k] * factor[2 * k] - other[k] * factor[2 * k + 1];
                im[k] = part[k] * factor[2 * k + 1] + other[k] * factor[2 * k];
            }
            std::size_t parity = static_cast<std::size_t>(share.parity);
            if (set.term >= 0) {
                const double* z = given.terms + static_cast<std::size_t>(set.term) * all + from;
                parity ^= static_cast<std::size_t>(given.term_parity[set.term]);
                for (std::size_t k = 0; k < within; ++k) {
                    const double turned = -im[k] * z[k];
                    im[k] = re[k] * z[k];
                    re[k] = turned;
                }
            }
            for (std::size_t own = 0; own < 4; ++own) {
                const double* wave = waves + 2 * (own * all + from);
                double *const a = room + 2 * (parity ^ own) * within, *const b = a + within;
                for (std::size_t k = 0; k < within; ++k) {
                    a[k] += re[k] * wave[2 * k] - im[k] * wave[2 * k + 1];
                    b[k] += re[k] * wave[2 * k + 1] + im[k] * wave[2 * k];
                }
            }
        }
    });
    for (std::size_t parity = 0; parity < 4; ++parity) {
        double* to = nodes + (parity % 2 * within * 4 + parity / 2 * 2) * lanes;
        for (std::size_t k = 0; k < within; ++k, to += 4 * lanes) {
            to[0] = room[2 * parity * within + k];
            to[lanes] = room[(2 * parity + 1) * within + k];
        }
    }
}

// [kind][wave][parity]: true if the part of the wave with this parity is nonzero. For a wavefront even in x or in y, two of four
// parts vanish. kind: 0 for exp(i W), 1 for i W exp(i W) / (bound on |W|), see fold_waves().
using Parities = std::vector<std::array<bool, 4>>;

inline Parities wave_parities(const NodeSeries& given) {
    std::size_t kinds = 0;
    for (const FieldSet& set : given.sets) {
        kinds = std::max(kinds, static_cast<std::size_t>(set.kind) + 1);
    }
    Parities waves(kinds * given.wave_count);
    for (std::size_t i = 0; i < waves.size(); ++i) {
        for (std::size_t parity = 0; parity < 4; ++parity) {
            const std::complex<double>* from = given.waves + (4 * i + parity) * given.nodes();
            waves[i][parity] = std::any_of(from, from + given.nodes(), [](std::complex<double> w) { return w != 0.0; });
        }
    }
    return waves;
}

struct FieldPart {
    std::size_t plane, set, field, parity;
};

// Nonzero parts, each of one parity, of all fields in `planes` planes from plane `first` on: sorted by parity, in batches of at
// most one SIMD vector.
struct FieldParts {
    static constexpr std::size_t none = WindowAxis::none;
    const Parities& waves;
    std::size_t first, planes;
    std::vector<FieldPart> list;
    // Elements list[first] .. list[first + count - 1], one per vector lane, all of the same parity.
    struct Batch {
        std::size_t first, count;
    };
    std::vector<Batch> batches;
    std::vector<std::size_t> place;  // [plane][set][field][parity]: index in `list`, or `none`

    FieldParts(const NodeSeries& given, const Parities& all, std::size_t begin, std::size_t count, std::size_t lanes)
        : waves(all), first(begin), planes(count), place(count * given.sets.size() * given.fields * 4, none) {
        for (std::size_t parity = 0; parity < 4; ++parity) {
            std::size_t room = 0;  // free lanes in the last batch
            for (std::size_t plane = 0; plane < planes; ++plane) {
                for (std::size_t set = 0; set < given.sets.size(); ++set) {
                    const std::array<bool, 4>& has = waves_of(given, given.sets[set], first + plane);
                    for (const FieldShare& share : given.shares) {
                        const auto field = static_cast<std::size_t>(share.field);
                        std::size_t& at = place[((plane * given.sets.size() + set) * given.fields + field) * 4 + parity];
                        if (at == none && has[given.own_parity(share, given.sets[set], parity)]) {
                            if (room == 0) {
                                batches.push_back({list.size(), 0});
                                room = lanes;
                            }
                            ++batches.back().count;
                            --room;
                            at = list.size();
                            list.push_back({first + plane, set, field, parity});
                        }
                    }
                }
            }
        }
    }
    const std::array<bool, 4>& waves_of(const NodeSeries& given, const FieldSet& set, std::size_t plane) const {
        return waves[static_cast<std::size_t>(set.kind) * given.wave_count + static_cast<std::size_t>(given.wave[plane])];
    }
};

// Number of distinct distances of pixel columns from the optical axis, rounded up to whole SIMD vectors.
inline std::size_t padded(const WindowAxis& columns) { return (columns.at.size() + row_lanes - 1) / row_lanes * row_lanes; }

// Fourier transform of each element of wanted.list (the part of a field with one parity), at all distances of rows and columns from
// the optical axis: to[element][row][re, im][column], rows padded with zeros.
inline void part_fields(Level level, const NodeSeries& given, const FieldParts& wanted, const KernelTable<double>& kernel,
                        int threads, double* to) {
    using Kernels = ChordKernels<double>;
    const std::size_t down = kernel.rows.at.size(), width = padded(kernel.columns);
    std::size_t series = 0;
    for (const FieldSet& set : given.sets) {
        series = std::max(series, static_cast<std::size_t>(set.series) + 1);
    }
    const Doubles amplitudes = all_parts(level, given, series, wanted.first, wanted.planes, threads);
    parallel_for(wanted.batches.size(), threads, [&](std::size_t, std::size_t b) {
        thread_local Doubles own, at, chords, row;
        const auto [first, here] = wanted.batches[b];
        const std::size_t parity = wanted.list[first].parity;
        const std::size_t lanes = Kernels::lanes(level), nodes = given.nodes(), half = given.count.half_chords();
        const std::size_t each = given.count.half_nodes() * 2 * lanes, line = half * 2 * lanes;
        own.resize(2 * lanes * nodes);
        at.resize(2 * lanes * nodes);
        chords.resize(down * line);
        row.assign(width * 2 * lanes, 0.0);
        for (std::size_t lane = 0; lane < here; ++lane) {
            look();
            const FieldPart& part = wanted.list[first + lane];
            const FieldSet& set = given.sets[part.set];
            const std::size_t from = static_cast<std::size_t>(set.series) * wanted.planes + part.plane - wanted.first;
            double* re = own.data() + 2 * lane * nodes;
            field_nodes(level, given, part.plane, set, part.field, parity, wanted.waves_of(given, set, part.plane),
                        amplitudes.data() + from * given.parts_size(), re, re + nodes);
        }
        std::fill(own.begin() + static_cast<std::ptrdiff_t>(2 * here * nodes), own.end(), 0.0);
        dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA {
            constexpr std::size_t side = decltype(isa)::lanes;
            double* put = at.data();
            for (std::size_t k = 0; k < nodes; ++k) {
                for (std::size_t part = 0; part < 2; ++part, put += side) {
                    for (std::size_t lane = 0; lane < side; ++lane) {
                        put[lane] = own[(2 * lane + part) * nodes + k];
                    }
                }
            }
        });
        for (std::size_t i = 0; i < half; ++i) {
            look();
            Kernels::parity_rows(level, kernel, i, parity % 2 == 1, at.data() + i * each, chords.data());
        }
        for (std::size_t y = 0; y < down; ++y) {
            look();
            Kernels::parity_columns(level, kernel, parity / 2 == 1, chords.data() + y * line, row.data());
            for (std::size_t lane = 0; lane < here; ++lane) {
                double* put = to + 2 * ((first + lane) * down + y) * width;
                const double* from = row.data() + lane;
                for (std::size_t x = 0; x < width; ++x, from += 2 * lanes) {
                    put[x] = from[0];
                    put[width + x] = from[lanes];
                }
            }
        }
    });
}

// Computes the intensity of one plane and its derivatives from the parts of the fields that are even or odd in x and in y.
struct PlaneLight {
    const NodeSeries& given;
    const WindowAxis &rows, &columns;
    const double* parts;  // results of part_fields()
    const std::size_t* place;  // [set][field][parity]: index in `parts`
    double *values, *largest;  // results of node_light(), from this plane on

    // Return whether each field and its derivatives have parts of only one parity in y (odd = 1) or in x (odd = 2): then images are
    // symmetric.
    bool alike(std::size_t odd) const {
        for (std::size_t field = 0; field < given.fields; ++field) {
            bool seen[2] = {};
            for (std::size_t set = 0; set < given.sets.size(); ++set) {
                for (std::size_t parity = 0; parity < 4; ++parity) {
                    const bool there = place[(set * given.fields + field) * 4 + parity] != FieldParts::none;
                    seen[(parity & odd) != 0] = seen[(parity & odd) != 0] || there;
                }
            }
            if (seen[0] && seen[1]) {
                return false;
            }
        }
        return true;
    }
    // Part of a field with one parity, on a row of one quadrant: (by_re * re[column], by_im * im[column]). by_re and by_im include
    // the sign of the part in that quadrant. A part odd in x gets a factor -i, a part odd in y another: one -i exchanges the
    // pointers re and im and changes the sign of by_im, two change both signs.
    struct Share {
        const double *re, *im;
        double by_re, by_im;
    };
    std::size_t shares(std::size_t field, std::size_t y, bool below, bool left, Share (&to)[4]) const {
        const std::size_t width = padded(columns);
        std::size_t count = 0;
        for (std::size_t parity = 0; parity < 4; ++parity) {
            const std::size_t part = place[field * 4 + parity];
            if (part != FieldParts::none) {
                const double *re = parts + 2 * (part * rows.at.size() + y) * width, *im = re + width;
                const double sign = (parity % 2 == 1 && below) != (parity / 2 == 1 && left) ? -1.0 : 1.0;
                const double both = parity == 3 ? -sign : sign;
                to[count++] = parity == 1 || parity == 2 ? Share{im, re, sign, -sign} : Share{re, im, both, both};
            }
        }
        return count;
    }
    // Compute intensity and derivatives on row y of the quadrant given by `below` and `left`: light[set][column].
    // there[column]: 1 if the pixel exists, else 0; squares[set][field][lane]: running maximum of |field|^2; first: memory for the
    // field of set 0.
    template <class I>
    LOMMEL_INLINE void row(I, std::size_t y, bool below, bool left, const double* there, double* first, double* squares,
                           double* light) const {
        using V = typename I::pack;
        constexpr std::size_t lanes = I::lanes;
        const std::size_t width = padded(columns), fields = given.fields, sets = given.sets.size();
        std::fill_n(light, sets * width, 0.0);
        for (std::size_t c = 0; c < fields; ++c) {
            for (std::size_t set = 0; set < sets; ++set) {
                Share own[4];
                const std::size_t count = shares(set * fields + c, y, below, left, own);
                double *to = light + set * width, *const square = squares + (set * fields + c) * row_lanes;
                V top = load<V>(square);
                for (std::size_t x = 0; x < width; x += lanes) {
                    V re = splat<V>(0.0), im = re;
                    for (std::size_t s = 0; s < count; ++s) {
                        re = re + splat<V>(own[s].by_re) * load<V>(own[s].re + x);
                        im = im + splat<V>(own[s].by_im) * load<V>(own[s].im + x);
                    }
                    const V size = re * re + im * im;
                    top = larger(top, size * load<V>(there + x));
                    if (set == 0) {
                        store(first + x, re), store(first + width + x, im);
                        store(to + x, load<V>(to + x) + size);
                    } else {
                        const V product = load<V>(first + x) * re + load<V>(first + width + x) * im;
                        store(to + x, load<V>(to + x) + splat<V>(2.0) * product);
                    }
                }
                store(square, top);
            }
        }
    }
    void run(Level level) const {
        thread_local Doubles room;
        const std::size_t width = padded(columns), sets = given.sets.size(), pixels = rows.count * columns.count;
        const std::size_t each = sets * width, all = sets * given.fields;
        const bool same[2] = {alike(1), alike(2)};
        room.assign(4 * each + 4 * width + all * row_lanes, 0.0);
        double *const light = room.data(), *const there = light + 4 * each, *const first = there + 2 * width;
        double* const squares = first + 2 * width;
        for (std::size_t x = 0; x < columns.at.size(); ++x) {
            there[x] = 1.0;
            there[width + x] = columns.minus[x] == WindowAxis::none ? 0.0 : 1.0;
        }
        dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA {
            for (std::size_t y = 0; y < rows.at.size(); ++y) {
                for (std::size_t side = 0; side < 4; ++side) {
                    const bool below = side / 2 == 1, left = side % 2 == 1;
                    const std::size_t at = (below ? rows.minus : rows.plus)[y];
                    if (at == WindowAxis::none) {
                        continue;
                    }
                    const std::size_t like = (below && !same[0] ? 2 : 0) + (left && !same[1] ? 1 : 0);
                    if (like == side) {
                        row(isa, y, below, left, there + (left ? width : 0), first, squares, light + side * each);
                    }
                    const std::vector<std::size_t>& places = left ? columns.minus : columns.plus;
                    for (std::size_t set = 0; set < sets; ++set) {
                        double* to = values + set * given.planes * pixels + at * columns.count;
                        const double* from = light + like * each + set * width;
                        for (std::size_t x = 0; x < places.size(); ++x) {
                            if (places[x] != WindowAxis::none) {
                                to[places[x]] = from[x];
                            }
                        }
                    }
                }
            }
        });
        for (std::size_t i = 0; i < all; ++i) {
            const double* lanes = squares + i * row_lanes;
            largest[i / given.fields * given.planes * given.fields + i % given.fields] =
                std::sqrt(*std::max_element(lanes, lanes + row_lanes));
        }
    }
};

// Largest number of values of complex amplitudes of a tile of planes, unless a single plane has more.
constexpr std::size_t full_light_values = std::size_t{1} << 20;

// As node_light(), for waves with more than two nonzero parts on average: parts of all four parities are transformed together.
inline void full_light(const NodeSeries& given, const DiskWindow& window, int threads, double* values, double* largest) {
    using Kernels = ChordKernels<double>;
    const Level level = processor_level();
    const std::size_t lanes = Kernels::lanes(level), pixels = window.height * window.width;
    const std::size_t sets = given.sets.size(), fields = given.fields, each = given.parts_size();
    const WindowAxis rows(window.height, window.row), columns(window.width, window.column);
    const auto kernel = cache<KernelTable<double>>.get(given.count, rows, columns, window.step, ChordLanes{});
    std::size_t series = 0;
    for (const FieldSet& set : given.sets) {
        series = std::max(series, static_cast<std::size_t>(set.series) + 1);
    }
    const Doubles parts = all_parts(level, given, series, 0, given.planes, threads);
    const std::size_t of_plane = sets * fields, most = std::max<std::size_t>(1, full_light_values / (2 * of_plane * pixels));
    thread_local Doubles scratch;
    for_tiles(given.planes, most, [&](std::size_t tile, std::size_t planes) {
        // u: complex amplitudes in the image, [plane of the tile][set][field][row][column][re, im].
        const std::size_t jobs = planes * of_plane;
        scratch.resize(2 * jobs * pixels);
        double* const u = scratch.data();  // memory of the calling thread, filled by all threads
        parallel_for((jobs + lanes - 1) / lanes, threads, [&](std::size_t, std::size_t b) {
            thread_local Doubles at, room, chords, row;
            const std::size_t first = b * lanes, here = std::min(lanes, jobs - first);
            const std::size_t line = given.count.half_chords() * 4 * lanes;
            at.assign(given.count.half_nodes() * 8 * lanes, 0.0);
            room.resize(given.count.half_nodes() * 10);
            chords.resize(rows.count * line);
            row.resize(columns.count * 2 * lanes);
            for (std::size_t i = 0; i < given.count.half_chords(); ++i) {
                look();
                for (std::size_t lane = 0; lane < here; ++lane) {
                    const std::size_t job = first + lane, plane = tile + job / of_plane;
                    const FieldSet& set = given.sets[job / fields % sets];
                    const double* from = parts.data() + (static_cast<std::size_t>(set.series) * given.planes + plane) * each;
                    place_field(level, given, plane, set, job % fields, from, i, lanes, room.data(), at.data() + lane);
                }
                Kernels::rows(level, *kernel, i, at.data(), chords.data());
            }
            for (std::size_t y = 0; y < rows.count; ++y) {
                look();
                Kernels::columns(level, *kernel, chords.data() + y * line, row.data());
                for (std::size_t lane = 0; lane < here; ++lane) {
                    double* to = u + 2 * ((first + lane) * pixels + y * window.width);
                    for (std::size_t x = 0; x < 2 * window.width; ++x) {
                        to[x] = row[x * lanes + lane];
                    }
                }
            }
        });
        parallel_for(planes * sets, threads, [&](std::size_t, std::size_t k) {
            const std::size_t plane = tile + k / sets, set = k % sets;
            const double* own = u + 2 * (k - set) * fields * pixels;
            dispatch(level, [&](auto) LOMMEL_INLINE_LAMBDA {
                double* to = values + (set * given.planes + plane) * pixels;
                std::fill_n(to, pixels, 0.0);
                for (std::size_t c = 0; c < fields; ++c) {
                    const double* e = own + 2 * c * pixels;
                    const double* f = own + 2 * (set * fields + c) * pixels;
                    const double by = set == 0 ? 1.0 : 2.0;
                    double top = 0.0;
                    for (std::size_t q = 0; q < pixels; ++q) {
                        const double square = f[2 * q] * f[2 * q] + f[2 * q + 1] * f[2 * q + 1];
                        top = square > top ? square : top;
                        to[q] += by * (e[2 * q] * f[2 * q] + e[2 * q + 1] * f[2 * q + 1]);
                    }
                    largest[(set * given.planes + plane) * fields + c] = std::sqrt(top);
                }
            });
        });
    });
}

// Compute values[set][plane][row][column]: intensity sum |E|^2 (first set) and its derivatives (other sets), and
// largest[set][plane][field]: maximum modulus of the field in the window.
inline void node_light(const NodeSeries& given, const DiskWindow& window, int threads, double* values, double* largest) {
    const Level level = processor_level();
    const WindowAxis rows(window.height, window.row), columns(window.width, window.column);
    const auto kernel = cache<KernelTable<double>>.get(given.count, rows, columns, window.step, ChordLanes{});
    const Parities waves = wave_parities(given);
    std::size_t count = 0;
    for (const std::array<bool, 4>& has : waves) {
        count += static_cast<std::size_t>(std::count(has.begin(), has.end(), true));
    }
    if (count > 2 * waves.size()) {
        return full_light(given, window, threads, values, largest);
    }
    thread_local Doubles scratch;
    // Eight planes at a time: the complex amplitudes of their fields stay in the cache.
    for_tiles(given.planes, 8, [&](std::size_t first, std::size_t planes) {
        const FieldParts wanted(given, waves, first, planes, ChordKernels<double>::lanes(level));
        scratch.resize(wanted.list.size() * 2 * rows.at.size() * padded(columns));
        const double* const parts = scratch.data();  // memory of the calling thread, filled by all threads
        part_fields(level, given, wanted, *kernel, threads, scratch.data());
        parallel_for(planes, threads, [&](std::size_t, std::size_t p) {
            const std::size_t* place = wanted.place.data() + p * given.sets.size() * given.fields * 4;
            const std::size_t plane = first + p;
            PlaneLight{given,
                       rows,
                       columns,
                       parts,
                       place,
                       values + plane * window.height * window.width,
                       largest + plane * given.fields}
                .run(level);
        });
    });
}

}  // namespace lommel
