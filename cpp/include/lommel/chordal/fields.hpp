// Light of pupil functions whose amplitudes are series of radial polynomials: sums of squares of several fields, and their
// derivatives, by the chordal rule with fields in the lanes of a vector.
#pragma once

#include <algorithm>
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

// One summand of a field: a part of the amplitude times a factor, even or odd in x and y by `parity`, 2 odd in x + odd in y.
struct FieldShare {
    std::int32_t field, parity, part;
};

// A set of fields: which series their amplitudes have, the term i Z that these are multiplied by, if any, and the kind of waves.
struct FieldSet {
    std::int32_t series, term, kind;
};

// At the nodes of a quadrant, [chord][node] of so many chords and nodes. The first set has the fields E themselves, all others F
// make derivatives of the sum of |E|^2, 2 Re conj(E) F.
struct NodeSeries {
    ChordCount count;
    std::size_t planes, fields, total;  // total of terms of a series
    std::vector<std::size_t> ends;      // of the terms of each part
    const double* radial;               // [term][node]
    const std::complex<double>* coefficients;  // [series][plane][term]
    std::vector<FieldShare> shares;
    const std::complex<double>* factors;  // [share][node]
    std::vector<FieldSet> sets;
    const double* terms;                 // [term][node], of Z
    const std::int32_t* term_parity;
    std::size_t wave_count;
    const std::complex<double>* waves;  // [kind][wave][parity][node], weighted sums of a wave over the images of a node
    const std::int32_t* wave;           // of each plane

    std::size_t nodes() const { return count.half_chords() * count.half_nodes(); }
    std::size_t jobs() const { return planes * sets.size() * fields; }
    const double* waves_of(const FieldSet& set, std::size_t plane) const {
        const std::size_t at = static_cast<std::size_t>(set.kind) * wave_count + static_cast<std::size_t>(wave[plane]);
        return reinterpret_cast<const double*>(waves + at * 4 * nodes());
    }
    std::size_t parts_size() const { return 2 * ends.size() * nodes(); }
};

// exp(i W) at the four images of each node of a quadrant, weighted, as sums of these by parity, [parity][node]; then, for a `largest`
// W above 0, i W exp(i W) over it likewise, `apart` numbers on. W is a sum of `count` terms, [term][node], each of a parity.
inline void fold_waves(Level level, std::size_t nodes, const double* terms, const std::int32_t* parities, std::size_t count,
                       const double* edge, const double* weights, double largest, std::complex<double>* to, std::size_t apart) {
    dispatch(level, [&](auto isa) LOMMEL_INLINE_LAMBDA {
        using V = typename decltype(isa)::pack;
        constexpr std::size_t lanes = decltype(isa)::lanes;
        // Of even and odd parts, from four images to four parities and back: the first two odd in y, then in x.
        const auto folded = [](const V(&p)[4], V(&q)[4]) LOMMEL_INLINE_LAMBDA {
            const V a = p[0] + p[1], b = p[0] - p[1], c = p[2] + p[3], d = p[2] - p[3];
            q[0] = a + c, q[1] = b + d, q[2] = a - c, q[3] = b - d;
        };
        for (std::size_t first = 0; first < nodes; first += lanes) {
            const std::size_t here = std::min(lanes, nodes - first);
            const auto taken = [&](const double* from) LOMMEL_INLINE_LAMBDA {
                double some[lanes] = {};
                std::copy_n(from + first, here, some);
                return load<V>(some);
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
                put(to + apart);
            }
        }
    });
}

// Parts of the amplitudes of one plane by one series: to[part][re, im][node].
inline void sum_series(Level level, const NodeSeries& given, const std::complex<double>* coefficients, double* to) {
    const std::size_t nodes = given.nodes();
    std::fill_n(to, 2 * given.ends.size() * nodes, 0.0);
    dispatch(level, [&](auto) LOMMEL_INLINE_LAMBDA {
        for (std::size_t part = 0, term = 0; part < given.ends.size(); ++part) {
            double *re = to + 2 * part * nodes, *im = re + nodes;
            for (; term < given.ends[part]; ++term) {
                const double a = coefficients[term].real(), b = coefficients[term].imag();
                const double* values = given.radial + term * nodes;
                for (std::size_t k = 0; k < nodes; ++k) {
                    re[k] += a * values[k];
                    im[k] += b * values[k];
                }
            }
        }
    });
}

// Of all planes by the first so many series: [series][plane], each as above.
inline Doubles all_parts(Level level, const NodeSeries& given, std::size_t series, int threads) {
    Doubles parts(series * given.planes * given.parts_size());
    parallel_for(series * given.planes, threads, [&](std::size_t, std::size_t p) {
        sum_series(level, given, given.coefficients + p * given.total, parts.data() + p * given.parts_size());
    });
    return parts;
}

// The pupil function of one field in a lane, at a pair of chords: [even, odd in y][node][even, odd in x][re, im]. `parts` as above.
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

// values[set][plane][row][column]: the sum of squares of the first set of fields, then its derivatives; largest[set][plane][field] is
// the largest |E| or |F| in the window.
inline void node_light(const NodeSeries& given, const DiskWindow& window, int threads, double* values, double* largest) {
    using Kernels = ChordKernels<double>;
    const Level level = processor_level();
    const std::size_t lanes = Kernels::lanes(level), pixels = window.height * window.width;
    const std::size_t sets = given.sets.size(), fields = given.fields, jobs = given.jobs(), each = given.parts_size();
    const WindowAxis rows(window.height, window.row), columns(window.width, window.column);
    const auto kernel = cache<KernelTable<double>>.get(given.count, rows, columns, window.step, ChordLanes{});
    std::size_t series = 0;
    for (const FieldSet& set : given.sets) {
        series = std::max(series, static_cast<std::size_t>(set.series) + 1);
    }
    const Doubles parts = all_parts(level, given, series, threads);
    // Of all fields of a plane, [plane][set][field].
    thread_local Doubles scratch;
    scratch.resize(2 * jobs * pixels);
    double* const u = scratch.data();  // of this thread, whoever computes them
    parallel_for((jobs + lanes - 1) / lanes, threads, [&](std::size_t, std::size_t b) {
        thread_local Doubles at, room, chords, row;
        const std::size_t first = b * lanes, here = std::min(lanes, jobs - first), line = given.count.half_chords() * 4 * lanes;
        at.assign(given.count.half_nodes() * 8 * lanes, 0.0);
        room.resize(given.count.half_nodes() * 10);
        chords.resize(rows.count * line);
        row.resize(columns.count * 2 * lanes);
        for (std::size_t i = 0; i < given.count.half_chords(); ++i) {
            look();
            for (std::size_t lane = 0; lane < here; ++lane) {
                const std::size_t job = first + lane, plane = job / (sets * fields);
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
    parallel_for(given.planes, threads, [&](std::size_t, std::size_t plane) {
        const double* own = u + 2 * plane * sets * fields * pixels;
        dispatch(level, [&](auto) LOMMEL_INLINE_LAMBDA {
            for (std::size_t set = 0; set < sets; ++set) {
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
            }
        });
    });
}

}  // namespace lommel
