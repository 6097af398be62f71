// Reverse-mode derivatives of the light of several fields: with weights w, G = sum w conj(E) e^(-i v r) at each node is the transpose
// of the transform, all Zernike terms share the sum of P G over the fields, and other series of amplitudes are one product each.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/base/parallel.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/base/watch.hpp"
#include "lommel/chordal/fields.hpp"

namespace lommel {

// Of the sum of weights times the light of each plane: itself, its derivatives by sets of fields but the first, then by terms.
struct NodeGradient {
    std::size_t terms;
    const double* weights;  // [plane][row][column]
    double* values;  // [plane][1 + sets - 1 + terms]
    double* largest;  // [plane][1 + fields]: the largest value of the light, and of the modulus of each field
};

// Adds the imaginary parts of P G at the nodes of a pair of chords to sums[parity][node][lane], by the parity of the product; P and
// G lie as place_field() puts them.
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

// Adds the real part of the sum of P G over a pair of chords to `sum`, [lane].
template <class I>
LOMMEL_INLINE void add_nodes(I, std::size_t within, const double* pupil, const double* adjoint, double* sum) {
    using V = typename Waves<I, double>::V;
    constexpr std::size_t lanes = Waves<I, double>::lanes;
    V total[4] = {};
    for (std::size_t at = 0; at < 8 * within; at += 2) {
        const double *p = pupil + at * lanes, *g = adjoint + at * lanes;
        V& one = total[at / 2 % 4];
        one = one + load<V>(p) * load<V>(g) - load<V>(p + lanes) * load<V>(g + lanes);
    }
    store(sum, load<V>(sum) + total[0] + total[1] + (total[2] + total[3]));
}

// The sum of products.
template <class I>
LOMMEL_INLINE double inner_product(I, const double* a, const double* b, std::size_t count) {
    using V = typename Waves<I, double>::V;
    constexpr std::size_t lanes = Waves<I, double>::lanes;
    V total[4] = {};
    std::size_t k = 0;
    for (; k + 4 * lanes <= count; k += 4 * lanes) {
        for (std::size_t j = 0; j < 4; ++j) {
            total[j] = total[j] + load<V>(a + k + j * lanes) * load<V>(b + k + j * lanes);
        }
    }
    alignas(64) double part[lanes];
    store(part, total[0] + total[1] + (total[2] + total[3]));
    double sum = 0.0;
    for (; k < count; ++k) {
        sum += a[k] * b[k];
    }
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        sum += part[lane];
    }
    return sum;
}

inline void node_gradient(const NodeSeries& given, const DiskWindow& window, int threads, const NodeGradient& wanted) {
    using Kernels = ChordKernels<double>;
    const Level level = processor_level();
    const std::size_t lanes = Kernels::lanes(level), pixels = window.height * window.width, nodes = given.nodes();
    const std::size_t fields = given.fields, jobs = given.planes * fields, rates = given.sets.size() - 1;
    const std::size_t half = given.count.half_chords(), within = given.count.half_nodes(), chord = 8 * within * lanes;
    const WindowAxis rows(window.height, window.row), columns(window.width, window.column);
    const auto kernel = cache<KernelTable<double>>.get(given.count, rows, columns, window.step, ChordLanes{});
    const Doubles parts = all_parts(level, given, threads);
    // Of each field of a plane.
    Doubles squares(jobs * pixels), products(jobs * 4 * nodes);
    std::vector<double> slopes(jobs * rates);
    parallel_for((jobs + lanes - 1) / lanes, threads, [&](std::size_t, std::size_t b) {
        thread_local Doubles pupil, other, adjoint, room, chords, light, weights;
        const std::size_t first = b * lanes, here = std::min(lanes, jobs - first), line = half * 4 * lanes;
        const auto place = [&](std::size_t set, std::size_t i, double* to) {
            for (std::size_t lane = 0; lane < here; ++lane) {
                const std::size_t job = first + lane, plane = job / fields;
                const std::size_t from = static_cast<std::size_t>(given.sets[set].series) * given.planes + plane;
                place_field(level, given, plane, given.sets[set], job % fields, parts.data() + from * given.parts_size(), i,
                            lanes, room.data(), to + lane);
            }
        };
        pupil.assign(half * chord, 0.0);
        other.assign(chord, 0.0);
        adjoint.resize(chord);
        room.resize(std::max<std::size_t>(10, 4 * lanes) * within);
        chords.resize(rows.count * line);
        light.resize(pixels * 2 * lanes);
        weights.assign(pixels * lanes, 0.0);
        for (std::size_t i = 0; i < half; ++i) {
            look();
            place(0, i, pupil.data() + i * chord);
            Kernels::rows(level, *kernel, i, pupil.data() + i * chord, chords.data());
        }
        for (std::size_t y = 0; y < rows.count; ++y) {
            look();
            Kernels::columns(level, *kernel, chords.data() + y * line, light.data() + y * columns.count * 2 * lanes);
        }
        for (std::size_t lane = 0; lane < here; ++lane) {
            const double *own = wanted.weights + (first + lane) / fields * pixels, *u = light.data() + lane;
            double* square = squares.data() + (first + lane) * pixels;
            for (std::size_t q = 0; q < pixels; ++q, u += 2 * lanes) {
                square[q] = u[0] * u[0] + u[lanes] * u[lanes];
                weights[q * lanes + lane] = own[q];
            }
        }
        Kernels::weigh(level, weights.data(), pixels, light.data());
        Kernels::columns_transposed(level, *kernel, light.data(), chords.data());
        alignas(64) double sums[most_pupils];
        for (std::size_t i = 0; i < half; ++i) {
            look();
            Kernels::rows_transposed(level, *kernel, i, chords.data(), adjoint.data());
            dispatch(level, [&](auto isa) LOMMEL_INLINE_LAMBDA {
                multiply_nodes(isa, within, pupil.data() + i * chord, adjoint.data(), room.data());
            });
            for (std::size_t lane = 0; lane < here; ++lane) {
                double* to = products.data() + (first + lane) * 4 * nodes + i * within;
                for (std::size_t parity = 0; parity < 4; ++parity, to += nodes) {
                    for (std::size_t k = 0; k < within; ++k) {
                        to[k] = room[(parity * within + k) * lanes + lane];
                    }
                }
            }
            for (std::size_t set = 1; set <= rates; ++set) {
                place(set, i, other.data());
                std::fill_n(sums, lanes, 0.0);
                dispatch(level,
                         [&](auto isa) LOMMEL_INLINE_LAMBDA { add_nodes(isa, within, other.data(), adjoint.data(), sums); });
                for (std::size_t lane = 0; lane < here; ++lane) {
                    slopes[(first + lane) * rates + set - 1] += sums[lane];
                }
            }
        }
    });
    parallel_for(given.planes, threads, [&](std::size_t, std::size_t plane) {
        const std::size_t first = plane * fields;
        double *light = squares.data() + first * pixels, *shared = products.data() + first * 4 * nodes;
        double *largest = wanted.largest + plane * (1 + fields), *to = wanted.values + plane * (1 + rates + wanted.terms);
        dispatch(level, [&](auto isa) LOMMEL_INLINE_LAMBDA {
            for (std::size_t c = 0; c < fields; ++c) {
                const double* square = light + c * pixels;
                largest[1 + c] = std::sqrt(*std::max_element(square, square + pixels));
                for (std::size_t q = 0; q < pixels && c > 0; ++q) {
                    light[q] += square[q];
                }
                const double* product = shared + c * 4 * nodes;
                for (std::size_t k = 0; k < 4 * nodes && c > 0; ++k) {
                    shared[k] += product[k];
                }
                for (std::size_t k = 0; k < rates; ++k) {
                    to[1 + k] = (c > 0 ? to[1 + k] : 0.0) + 2.0 * slopes[(first + c) * rates + k];
                }
            }
            largest[0] = *std::max_element(light, light + pixels);
            to[0] = inner_product(isa, light, wanted.weights + plane * pixels, pixels);
            for (std::size_t j = 0; j < wanted.terms; ++j) {
                const double* own = shared + static_cast<std::size_t>(given.term_parity[j]) * nodes;
                to[1 + rates + j] = -2.0 * inner_product(isa, own, given.terms + j * nodes, nodes);
            }
        });
    });
}

}  // namespace lommel
