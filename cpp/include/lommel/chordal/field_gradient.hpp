// Reverse-mode derivatives of S = sum over pixels v and over several fields E of weight(v) x |E(v)|^2 (docs/certificate.md, section
// 16, "Gradients"). The adjoint field of E at a node r of the pupil is G(r) = sum over v of weight x conj(E) x exp(-i v r). The
// derivatives by all Zernike coefficients take one sum over the fields of (pupil function x G); those by other parameters are inner
// products with G.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/base/parallel.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/base/watch.hpp"
#include "lommel/chordal/fields.hpp"

namespace lommel {

// values, per plane: S = sum over pixels of weights[plane][pixel] x intensity; then dS/dp for each parameter p (the derivatives of
// set 0's fields by the first p are set 1, by the second p set 2, and so on); then dS/dc for the `terms` Zernike coefficients c.
struct NodeGradient {
    std::size_t terms;
    const double* weights;
    double* values;
    double* largest;  // per plane: maximum of the intensity, then maximum of |E| for each field
};

// Imaginary part of (pupil function) x (adjoint field) at the `within` nodes of a pair of chords, split by its parity in x and y:
// sums[parity][node][lane]. `pupil` and `adjoint` have the layout of place_field().
template <class I>
LOMMEL_INLINE void multiply_nodes(I, std::size_t within, const double* pupil, const double* adjoint, double* sums) {
    using V = typename Waves<I, double>::V;
    constexpr std::size_t lanes = Waves<I, double>::lanes;
    const auto part = [&](std::size_t k, std::size_t j) { return (j / 2 * within * 4 + 4 * k + j % 2 * 2) * lanes; };
    for (std::size_t k = 0; k < within; ++k) {
        V sum[4] = {};
        for (std::size_t j = 0; j < 4; ++j) {
            const V p = load<V>(pupil + part(k, j)), q = load<V>(pupil + part(k, j) + lanes);
            for (std::size_t parity = 0; parity < 4; ++parity) {
                const double* g = adjoint + part(k, (j / 2 ^ parity % 2) * 2 + (j % 2 ^ parity / 2));
                sum[parity] = sum[parity] + p * load<V>(g + lanes) + q * load<V>(g);
            }
        }
        for (std::size_t parity = 0; parity < 4; ++parity) {
            store(sums + (parity * within + k) * lanes, sum[parity]);
        }
    }
}

// Transpose of place_field() for one field of a plane. The field's pupil function is linear in the parts of the amplitude series,
// the sums over ranges of its terms (sum_series()). Add to sums[part][re, im][node] the derivative of the sum over nodes of
// (pupil function x G) by the value of each part at each node of a pair of chords. adjoint: adjoint field G at these nodes, its
// values `lanes` apart; room: working memory.
inline void take_field(Level level, const NodeSeries& given, std::size_t plane, const FieldSet& set, std::size_t field,
                       const double* adjoint, std::size_t chord, std::size_t lanes, double* room, double* sums) {
    const std::size_t all = given.nodes(), within = given.count.half_nodes(), from = chord * within;
    const double* waves = given.waves_of(set, plane);
    for (std::size_t parity = 0; parity < 4; ++parity) {
        const double* g = adjoint + (parity % 2 * within * 4 + parity / 2 * 2) * lanes;
        for (std::size_t k = 0; k < within; ++k, g += 4 * lanes) {
            room[2 * parity * within + k] = g[0];
            room[(2 * parity + 1) * within + k] = g[lanes];
        }
    }
    dispatch(level, [&](auto) LOMMEL_INLINE_LAMBDA {
        double *const re = room + 8 * within, *const im = re + within;
        for (std::size_t s = 0; s < given.shares.size(); ++s) {
            const FieldShare& share = given.shares[s];
            if (static_cast<std::size_t>(share.field) != field) {
                continue;
            }
            std::fill_n(re, 2 * within, 0.0);
            for (std::size_t own = 0; own < 4; ++own) {
                const double* wave = waves + 2 * (own * all + from);
                const double *a = room + 2 * (static_cast<std::size_t>(share.parity) ^ own) * within, *b = a + within;
                for (std::size_t k = 0; k < within; ++k) {
                    re[k] += a[k] * wave[2 * k] - b[k] * wave[2 * k + 1];
                    im[k] += a[k] * wave[2 * k + 1] + b[k] * wave[2 * k];
                }
            }
            const auto* factor = reinterpret_cast<const double*>(given.factors + s * all + from);
            double *const to = sums + 2 * static_cast<std::size_t>(share.part) * all + from, *const other = to + all;
            for (std::size_t k = 0; k < within; ++k) {
                to[k] += re[k] * factor[2 * k] - im[k] * factor[2 * k + 1];
                other[k] += re[k] * factor[2 * k + 1] + im[k] * factor[2 * k];
            }
        }
    });
}

template <std::size_t C, class I>
LOMMEL_INLINE void inner_products(I, const double* row, const double* const (&vectors)[C], std::size_t count,
                                  double (&sums)[C]) {
    using V = typename Waves<I, double>::V;
    constexpr std::size_t lanes = Waves<I, double>::lanes, side = C < 4 ? 4 : 2;
    V total[C][side] = {};
    std::size_t k = 0;
    for (; k + side * lanes <= count; k += side * lanes) {
        for (std::size_t j = 0; j < side; ++j) {
            const V r = load<V>(row + k + j * lanes);
            for (std::size_t c = 0; c < C; ++c) {
                total[c][j] = total[c][j] + r * load<V>(vectors[c] + k + j * lanes);
            }
        }
    }
    for (std::size_t c = 0; c < C; ++c) {
        for (std::size_t j = 1; j < side; ++j) {
            total[c][0] = total[c][0] + total[c][j];
        }
        alignas(64) double part[lanes];
        store(part, total[c][0]);
        sums[c] = 0.0;
        for (std::size_t at = k; at < count; ++at) {
            sums[c] += row[at] * vectors[c][at];
        }
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            sums[c] += part[lane];
        }
    }
}

// Call found(j, c, product) with the inner product of row(j) and vector(j, c), both of length `count`, for all j and c.
template <class Row, class Of, class Found>
void all_products(Level level, std::size_t rows, std::size_t vectors, std::size_t count, int threads, const Row& row,
                  const Of& vector, const Found& found) {
    constexpr std::size_t block = 16;
    parallel_for((rows + block - 1) / block, threads, [&](std::size_t, std::size_t b) {
        const std::size_t last = std::min(rows, (b + 1) * block);
        dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA {
            std::size_t c = 0;
            for (; c + 4 <= vectors; c += 4) {
                for (std::size_t j = b * block; j < last; ++j) {
                    const double* const four[] = {vector(j, c), vector(j, c + 1), vector(j, c + 2), vector(j, c + 3)};
                    double sums[4];
                    inner_products(isa, row(j), four, count, sums);
                    for (std::size_t i = 0; i < 4; ++i) {
                        found(j, c + i, sums[i]);
                    }
                }
            }
            for (; c < vectors; ++c) {
                for (std::size_t j = b * block; j < last; ++j) {
                    const double* const one[] = {vector(j, c)};
                    double sum[1];
                    inner_products(isa, row(j), one, count, sum);
                    found(j, c, sum[0]);
                }
            }
        });
    });
}

inline void node_gradient(const NodeSeries& given, const DiskWindow& window, int threads, const NodeGradient& wanted) {
    using Kernels = ChordKernels<double>;
    const Level level = processor_level();
    const std::size_t lanes = Kernels::lanes(level), pixels = window.height * window.width, nodes = given.nodes();
    const std::size_t fields = given.fields, jobs = given.planes * fields, rates = given.sets.size() - 1;
    const std::size_t half = given.count.half_chords(), within = given.count.half_nodes(), chord = 8 * within * lanes;
    const std::size_t batches = (jobs + lanes - 1) / lanes, parts_size = given.parts_size();
    const WindowAxis rows(window.height, window.row), columns(window.width, window.column);
    const auto kernel = cache<KernelTable<double>>.get(given.count, rows, columns, window.step, ChordLanes{});
    const Doubles parts = all_parts(level, given, 1, 0, given.planes, threads);
    // Contributions of a batch's fields to each of its planes, shares[batch][plane][number]. Numbers: intensities of the pixels,
    // then the sums of multiply_nodes() [parity][node], then, if rates > 0, those of take_field().
    const std::size_t span = (lanes + fields - 2) / fields + 1, each = pixels + 4 * nodes + (rates > 0 ? parts_size : 0);
    Doubles shares(batches * span * each);
    std::vector<double> largest(jobs);
    parallel_for(batches, threads, [&](std::size_t, std::size_t b) {
        thread_local Doubles pupil, adjoint, room, chords, light, weights;
        const std::size_t first = b * lanes, here = std::min(lanes, jobs - first), line = half * 4 * lanes;
        const auto share_of = [&](std::size_t lane) {
            return shares.data() + (b * span + (first + lane) / fields - first / fields) * each;
        };
        pupil.assign(half * chord, 0.0);
        adjoint.resize(chord);
        room.resize(std::max<std::size_t>(10, 4 * lanes) * within);
        chords.resize(rows.count * line);
        light.resize(pixels * 2 * lanes);
        weights.assign(pixels * lanes, 0.0);
        for (std::size_t i = 0; i < half; ++i) {
            look();
            for (std::size_t lane = 0; lane < here; ++lane) {
                const std::size_t plane = (first + lane) / fields;
                place_field(level, given, plane, given.sets[0], (first + lane) % fields, parts.data() + plane * parts_size, i,
                            lanes, room.data(), pupil.data() + i * chord + lane);
            }
            Kernels::rows(level, *kernel, i, pupil.data() + i * chord, chords.data());
        }
        for (std::size_t y = 0; y < rows.count; ++y) {
            look();
            Kernels::columns(level, *kernel, chords.data() + y * line, light.data() + y * columns.count * 2 * lanes);
        }
        for (std::size_t lane = 0; lane < here; ++lane) {
            const double *own = wanted.weights + (first + lane) / fields * pixels, *u = light.data() + lane;
            double *to = share_of(lane), top = 0.0;
            for (std::size_t q = 0; q < pixels; ++q, u += 2 * lanes) {
                const double square = u[0] * u[0] + u[lanes] * u[lanes];
                top = std::max(top, square);
                to[q] += square;
                weights[q * lanes + lane] = own[q];
            }
            largest[first + lane] = std::sqrt(top);
        }
        Kernels::weigh(level, weights.data(), pixels, light.data());
        Kernels::columns_transposed(level, *kernel, light.data(), chords.data());
        for (std::size_t i = 0; i < half; ++i) {
            look();
            Kernels::rows_transposed(level, *kernel, i, chords.data(), adjoint.data());
            dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA {
                multiply_nodes(isa, within, pupil.data() + i * chord, adjoint.data(), room.data());
            });
            for (std::size_t lane = 0; lane < here; ++lane) {
                double* to = share_of(lane) + pixels + i * within;
                for (std::size_t parity = 0; parity < 4; ++parity, to += nodes) {
                    for (std::size_t k = 0; k < within; ++k) {
                        to[k] += room[(parity * within + k) * lanes + lane];
                    }
                }
            }
            for (std::size_t lane = 0; lane < here && rates > 0; ++lane) {
                take_field(level, given, (first + lane) / fields, given.sets[0], (first + lane) % fields, adjoint.data() + lane,
                           i, lanes, room.data(), share_of(lane) + pixels + 4 * nodes);
            }
        }
    });
    const std::size_t found = 1 + rates + wanted.terms;
    std::vector<const double*> sums(given.planes);
    parallel_for(given.planes, threads, [&](std::size_t, std::size_t plane) {
        const std::size_t low = plane * fields / lanes, high = (plane * fields + fields - 1) / lanes;
        double* total = nullptr;
        dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA {
            for (std::size_t b = low; b <= high; ++b) {
                double* share = shares.data() + (b * span + plane - b * lanes / fields) * each;
                total = b == low ? share : total;
                for (std::size_t k = 0; k < each && b > low; ++k) {
                    total[k] += share[k];
                }
            }
            const double* const light[] = {total};
            double sum[1];
            inner_products(isa, wanted.weights + plane * pixels, light, pixels, sum);
            wanted.values[plane * found] = sum[0];
        });
        sums[plane] = total + pixels;
        double* top = wanted.largest + plane * (1 + fields);
        top[0] = *std::max_element(total, total + pixels);
        std::copy_n(largest.data() + plane * fields, fields, top + 1);
    });
    all_products(
        level, wanted.terms, given.planes, nodes, threads, [&](std::size_t j) { return given.terms + j * nodes; },
        [&](std::size_t j, std::size_t plane) { return sums[plane] + static_cast<std::size_t>(given.term_parity[j]) * nodes; },
        [&](std::size_t j, std::size_t plane, double sum) { wanted.values[plane * found + 1 + rates + j] = -2.0 * sum; });
    if (rates == 0) {
        return;
    }
    std::vector<std::size_t> part_of(given.total);
    for (std::size_t part = 0, term = 0; part < given.ends.size(); ++part) {
        for (; term < given.ends[part]; ++term) {
            part_of[term] = part;
        }
    }
    std::vector<double> by_term(given.planes * 2 * given.total);
    all_products(
        level, given.total, 2 * given.planes, nodes, threads, [&](std::size_t n) { return given.radial + n * nodes; },
        [&](std::size_t n, std::size_t at) { return sums[at / 2] + (4 + 2 * part_of[n] + at % 2) * nodes; },
        [&](std::size_t n, std::size_t at, double sum) { by_term[at * given.total + n] = sum; });
    for (std::size_t plane = 0; plane < given.planes; ++plane) {
        const double *re = by_term.data() + 2 * plane * given.total, *im = re + given.total;
        for (std::size_t set = 1; set <= rates; ++set) {
            const std::size_t series = static_cast<std::size_t>(given.sets[set].series);
            const std::complex<double>* c = given.coefficients + (series * given.planes + plane) * given.total;
            double sum = 0.0;
            for (std::size_t n = 0; n < given.total; ++n) {
                sum += c[n].real() * re[n] - c[n].imag() * im[n];
            }
            wanted.values[plane * found + set] = 2.0 * sum;
        }
    }
}

}  // namespace lommel
