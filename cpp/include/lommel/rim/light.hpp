// Intensity far from the axis, computed from the pupil function on its rims (certificate, section 10, "From the rim").
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lommel/base/pi.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/chordal/transform.hpp"
#include "lommel/rim/slopes.hpp"
#include "lommel/rim/table.hpp"

namespace lommel {

// Tables of one rim that do not depend on the window: derivatives of the phase, and Zernike terms at equally spaced angles.
struct RimLine {
    RimSlopes slopes;
    RimTurns turns;
    std::vector<std::int32_t> orders;  // azimuthal order m of each column of `phases`
    std::vector<std::size_t> columns;  // [term]: its column in `phases`
    Doubles phases;                    // cos or sin of order times angle: [tile of angles][column][angle in the tile]

    RimLine(const std::vector<ZernikeTerm>& terms, const Amplitude& light, std::size_t angles)
        : slopes(terms, light, {1.0}), turns(angles, slopes.degree) {
        for (const ZernikeTerm& term : terms) {
            const std::size_t at = static_cast<std::size_t>(std::find(orders.begin(), orders.end(), term.m) - orders.begin());
            if (at == orders.size()) {
                orders.push_back(term.m);
            }
            columns.push_back(at);
        }
        phases.resize(angles * orders.size());
        for_tiles(angles, node_tile, [&](std::size_t from, std::size_t size) {
            for (std::size_t c = 0; c < orders.size(); ++c) {
                for (std::size_t r = 0; r < size; ++r) {
                    const double angle =
                        2.0 * pi * std::abs(orders[c]) * (static_cast<double>(from + r) + 0.5) / static_cast<double>(angles);
                    phases[from * orders.size() + c * size + r] = orders[c] < 0 ? std::sin(angle) : std::cos(angle);
                }
            }
        });
    }
    bool is(const std::vector<ZernikeTerm>& terms, const Amplitude& light, std::size_t angles) const {
        return turns.count == angles && slopes.is(terms, light, {1.0});
    }
    std::size_t bytes() const {
        return slopes.bytes() + (turns.turns.size() + turns.beside.size()) * sizeof(float) + phases.size() * sizeof(double);
    }
    static constexpr std::size_t most_bytes = std::size_t{16} << 20;
};

// Quantities summed over the Fourier coefficients of derivatives of the pupil function on one rim. k: order; a lane is a pupil.
struct RimSums {
    Floats left;    // [k][lane]: sum of squared moduli of the omitted Fourier coefficients
    Floats energy;  // [k][lane]: sum of squared moduli of all Fourier coefficients
    std::array<Floats, 2> size;  // [ellipse][lane]: bound on waves at complex radii in an ellipse (certificate, section 10)
    Floats turned[rim_most_turns];  // if fields are wanted, [n][lane]: bound on derivatives n + 1 of waves by the polar angle
};

struct RimScratch {
    Floats coefficients, e, points, folded, sums, values[2], waves[2], light, out;
    Doubles phases, turned;
    std::array<RimSums, 2> of;
    Floats squares, largest, mean;
    Floats kept;  // if RimWindow::fields(): [angle of the padded ring][radius][rim][re X, im X, re Y, im Y][lane]
};

// Combine values a, b, c, d at the angles theta, pi - theta, theta + pi and -theta, so that Fourier sums need a quarter of the
// angles. put(kind, value): kinds 0, 1 are for cosines, sines of even orders, kinds 2, 3 for those of odd orders.
template <class V, class Put>
LOMMEL_INLINE void fold(V a, V b, V c, V d, const Put& put) {
    put(0, (a + c) + (b + d));
    put(1, (a + c) - (b + d));
    put(2, (a - c) - (b - d));
    put(3, (a - c) + (b - d));
}

// Fourier coefficients of order mu of dbar^k P / rim_scale(k) on a rim, dbar = d/dx + i d/dy, P = pupil function, |P| = amplitude,
// from the Zernike coefficients in `scratch`: values[rim.first + mu - k][k][re, im][lane], 0 for |mu| > rim.orders; sums in `of`.
template <std::size_t Degree, class I>
LOMMEL_INLINE void rim_coefficients(I isa, const RimWaves& rim, const RimLine& line, double amplitude, RimScratch& scratch,
                                    Floats& values, RimSums& of) {
    using Wave = Waves<I, float>;
    using V = typename Wave::V;
    constexpr std::size_t lanes = Wave::lanes, K = rim_orders;
    const std::size_t angles = rim.angles, quarter = angles / 4, columns = line.orders.size();
    scratch.e.resize(2 * line.slopes.orders.size() * lanes);
    slopes_of_circle(isa, line.slopes, 0, scratch.coefficients.data(), scratch.e.data());
    scratch.points.resize(K * angles * 2 * lanes);
    float* const points = scratch.points.data();
    const V edge = splat<V>(static_cast<float>(amplitude));
    for_fixed_tiles<node_tile>(angles, [&](std::size_t from, auto size) LOMMEL_INLINE_LAMBDA {
        constexpr std::size_t R = decltype(size)::value;
        typename I::pack sums[R][Wave::vectors];
        for (auto& sum : sums) {
            for (auto& part : sum) {
                part = Wave::zero();
            }
        }
        multiply<R, Wave::vectors>(line.phases.data() + from * columns, scratch.phases.data(), columns, sums);
        for (std::size_t r = 0; r < R; ++r) {
            V sine, cosine;
            Wave::wave(Wave::phase(sums[r]), sine, cosine);
            store(points + 2 * (from + r) * lanes, edge * cosine);
            store(points + (2 * (from + r) + 1) * lanes, edge * sine);
        }
    });
    for (std::size_t l = 0; l < angles / 2; ++l) {
        V q[2][K + 1][2];
        const std::size_t at[2] = {l, l + angles / 2};
        for (std::size_t point = 0; point < 2; ++point) {
            for (std::size_t part = 0; part < 2; ++part) {
                q[point][0][part] = load<V>(points + (2 * at[point] + part) * lanes);
            }
        }
        rim_powers<Degree, K - 1, false>(isa, line.slopes, line.turns.at(l), scratch.e.data(), q);
        for (std::size_t k = 1; k < K; ++k) {
            for (std::size_t point = 0; point < 2; ++point) {
                for (std::size_t part = 0; part < 2; ++part) {
                    store(points + (2 * (k * angles + at[point]) + part) * lanes, q[point][k][part]);
                }
            }
        }
    }
    values.assign(rim.count() * K * 2 * lanes, 0.0f);
    of.left.assign(K * lanes, 0.0f);
    of.energy.assign(K * lanes, 0.0f);
    const std::size_t most = angles / 4 + 1;
    scratch.folded.resize(4 * quarter * 2 * lanes);
    scratch.sums.resize(4 * most * 2 * lanes);
    float *const folded = scratch.folded.data(), *const sums = scratch.sums.data();
    const V by = splat<V>(1.0f / static_cast<float>(angles));
    V whole[2] = {}, turned[rim_most_turns] = {};
    const bool fields = !rim.turned[0].empty();
    for (std::size_t k = 0; k < K; ++k) {
        for (std::size_t l = 0; l < quarter; ++l) {
            for (std::size_t part = 0; part < 2; ++part) {
                const auto at = [&](std::size_t angle) LOMMEL_INLINE_LAMBDA {
                    return load<V>(points + (2 * (k * angles + angle) + part) * lanes);
                };
                fold(at(l), at(2 * quarter - 1 - l), at(l + 2 * quarter), at(4 * quarter - 1 - l),
                     [&](std::size_t kind, V value)
                         LOMMEL_INLINE_LAMBDA { store(folded + (2 * (kind * quarter + l) + part) * lanes, value); });
            }
        }
        for (std::size_t kind = 0; kind < 4; ++kind) {
            const std::size_t forth = (angles / 2 + 2 - kind / 2) / 2;
            for_fixed_tiles<rim_orders_tile>(forth, [&](std::size_t from, auto size) LOMMEL_INLINE_LAMBDA {
                constexpr std::size_t R = decltype(size)::value;
                V sum[R][2] = {};
                multiply<R, 2>(rim.forward[kind].data() + from * quarter, folded + kind * quarter * 2 * lanes, quarter, sum);
                for (std::size_t r = 0; r < R; ++r) {
                    store(sums + 2 * (kind * most + from + r) * lanes, sum[r][0]);
                    store(sums + (2 * (kind * most + from + r) + 1) * lanes, sum[r][1]);
                }
            });
        }
        V left = splat<V>(0.0f), energy = left;
        for (std::size_t mu = 0; mu <= angles / 2; ++mu) {
            const float *const cosine = sums + 2 * (2 * (mu % 2) * most + mu / 2) * lanes, *const sine =
                                                                                               cosine + 2 * most * lanes;
            const V cr = load<V>(cosine), ci = load<V>(cosine + lanes), sr = load<V>(sine), si = load<V>(sine + lanes);
            const V both[2][2] = {{by * (cr + si), by * (ci - sr)}, {by * (cr - si), by * (ci + sr)}};
            for (std::size_t side = 0; side < (mu == 0 ? 1 : 2); ++side) {
                const V re = both[side][0], im = both[side][1], square = re * re + im * im;
                energy = energy + square;
                if (mu > rim.orders) {
                    left = left + square;
                    continue;
                }
                const std::size_t i = side == 0 ? rim.first + mu - k : rim.first - mu - k;
                float* const to = values.data() + (i * K + k) * 2 * lanes;
                store(to, re);
                store(to + lanes, im);
                const std::size_t at = k * (2 * rim.orders + 1) + (side == 0 ? rim.orders + mu : rim.orders - mu);
                // max + 3/7 min of |re| and |im| is an upper bound of the modulus, at most 9 % too large.
                const V zero = splat<V>(0.0f), a = larger(re, zero - re), b = larger(im, zero - im);
                const V modulus = larger(a, b) + splat<V>(0.4286f) * (a + b - larger(a, b));
                whole[0] = whole[0] + splat<V>(rim.size[0][at]) * modulus;
                whole[1] = whole[1] + splat<V>(rim.size[1][at]) * modulus;
                for (std::size_t n = 0; fields && n < rim_most_turns; ++n) {
                    turned[n] = turned[n] + splat<V>(rim.turned[n][at]) * modulus;
                }
            }
        }
        store(of.left.data() + k * lanes, left);
        store(of.energy.data() + k * lanes, energy);
    }
    for (std::size_t ellipse = 0; ellipse < 2; ++ellipse) {
        of.size[ellipse].resize(lanes);
        store(of.size[ellipse].data(), whole[ellipse]);
    }
    for (std::size_t n = 0; fields && n < rim_most_turns; ++n) {
        of.turned[n].resize(lanes);
        store(of.turned[n].data(), turned[n]);
    }
}

// Pupil function of one pupil at the angles of a rim, where its amplitude is `edge`: out[angle][re, im].
template <class I>
LOMMEL_INLINE void rim_edge(I, const RimLine& line, float edge, RimScratch& scratch, float* out) {
    using Wave = Waves<I, float>;
    using V = typename Wave::V;
    using Pack = typename I::pack;
    constexpr std::size_t lanes = Wave::lanes, each = lanes / Wave::vectors;
    const ChordLanes order{lanes, true};
    const std::size_t angles = line.turns.count, columns = line.orders.size();
    scratch.turned.assign((angles + lanes - 1) / lanes * lanes, 0.0);
    for_tiles(angles, node_tile, [&](std::size_t from, std::size_t size) LOMMEL_INLINE_LAMBDA {
        for (std::size_t c = 0; c < columns; ++c) {
            for (std::size_t r = 0; r < size; ++r) {
                const std::size_t angle = from + r, first = angle / lanes * lanes;
                scratch.turned[first + order.place(angle % lanes)] +=
                    scratch.phases[c * lanes] * line.phases[from * columns + c * size + r];
            }
        }
    });
    for (std::size_t l = 0; l < angles; l += lanes) {
        Pack sums[Wave::vectors];
        for (std::size_t i = 0; i < Wave::vectors; ++i) {
            sums[i] = Wave::zero() + load<Pack>(scratch.turned.data() + l + i * each);
        }
        V wave[2];
        Wave::wave(Wave::phase(sums), wave[1], wave[0]);
        for (std::size_t part = 0; part < 2; ++part) {
            float values[lanes];
            store(values, splat<V>(edge) * wave[part]);
            for (std::size_t i = 0; i < std::min(lanes, angles - l); ++i) {
                out[2 * (l + i) + part] = values[i];
            }
        }
    }
}

// Like rim_coefficients(), for one pupil: vector lanes are angles in rim_powers() and, in the Fourier sums that follow, the real
// and imaginary parts of the derivatives of all orders k.
template <std::size_t Degree, class I>
LOMMEL_INLINE void rim_coefficients_of_pupil(I isa, const RimWaves& rim, const RimLine& line, double amplitude,
                                             RimScratch& scratch, Floats& values, RimSums& of) {
    using V = typename I::floats;
    constexpr std::size_t lanes = sizeof(V) / sizeof(float), K = rim_orders, numbers = 2 * K, vectors = numbers / lanes;
    static_assert(K % lanes == 0, "k fill vectors");
    const std::size_t angles = rim.angles, half = angles / 2, quarter = angles / 4, most = angles / 4 + 1;
    scratch.e.resize(2 * line.slopes.orders.size() * lanes);
    slopes_of_circle(isa, line.slopes, 0, scratch.coefficients.data(), scratch.e.data());
    scratch.folded.resize(std::max(4 * quarter * numbers, 2 * angles));
    rim_edge(isa, line, static_cast<float>(amplitude), scratch, scratch.folded.data());
    scratch.points.resize(angles * numbers);
    float* const points = scratch.points.data();
    for (std::size_t l = 0; l < half; l += lanes) {
        const std::size_t here = std::min(lanes, half - l);
        V q[2][K + 1][2];
        for (std::size_t point = 0; point < 2; ++point) {
            for (std::size_t part = 0; part < 2; ++part) {
                float first[lanes] = {};
                for (std::size_t i = 0; i < here; ++i) {
                    first[i] = scratch.folded[2 * (point * half + l + i) + part];
                }
                q[point][0][part] = load<V>(first);
            }
        }
        rim_powers<Degree, K - 1, true>(isa, line.slopes, line.turns.from(l), scratch.e.data(), q);
        for (std::size_t point = 0; point < 2; ++point) {
            for (std::size_t number = 0; number < numbers; ++number) {
                float at[lanes];
                store(at, q[point][number % K][number / K]);
                for (std::size_t i = 0; i < here; ++i) {
                    points[(point * half + l + i) * numbers + number] = at[i];
                }
            }
        }
    }
    scratch.sums.resize(4 * most * numbers);
    float *const folded = scratch.folded.data(), *const sums = scratch.sums.data();
    for (std::size_t l = 0; l < quarter; ++l) {
        for (std::size_t i = 0; i < numbers; i += lanes) {
            const auto at = [&](std::size_t angle) LOMMEL_INLINE_LAMBDA { return load<V>(points + angle * numbers + i); };
            fold(at(l), at(half - 1 - l), at(l + half), at(angles - 1 - l),
                 [&](std::size_t kind, V value)
                     LOMMEL_INLINE_LAMBDA { store(folded + (kind * quarter + l) * numbers + i, value); });
        }
    }
    for (std::size_t kind = 0; kind < 4; ++kind) {
        const std::size_t forth = (half + 2 - kind / 2) / 2;
        for_fixed_tiles<rim_orders_tile>(forth, [&](std::size_t from, auto size) LOMMEL_INLINE_LAMBDA {
            constexpr std::size_t R = decltype(size)::value;
            V sum[R][vectors] = {};
            multiply<R, vectors>(rim.forward[kind].data() + from * quarter, folded + kind * quarter * numbers, quarter, sum);
            for (std::size_t r = 0; r < R; ++r) {
                for (std::size_t i = 0; i < vectors; ++i) {
                    store(sums + (kind * most + from + r) * numbers + i * lanes, sum[r][i]);
                }
            }
        });
    }
    values.assign(rim.count() * K * 2 * lanes, 0.0f);
    of.left.assign(K * lanes, 0.0f);
    of.energy.assign(K * lanes, 0.0f);
    const float by = 1.0f / static_cast<float>(angles);
    float left[K] = {}, energy[K] = {}, whole[2] = {};
    for (std::size_t mu = 0; mu <= half; ++mu) {
        const float *const cosine = sums + (2 * (mu % 2) * most + mu / 2) * numbers, *const sine = cosine + most * numbers;
        for (std::size_t side = 0; side < (mu == 0 ? 1 : 2); ++side) {
            const float sign = side == 0 ? by : -by;
            float re[K], im[K];
            for (std::size_t k = 0; k < K; ++k) {
                re[k] = by * cosine[k] + sign * sine[K + k];
                im[k] = by * cosine[K + k] - sign * sine[k];
                const float square = re[k] * re[k] + im[k] * im[k];
                energy[k] += square;
                left[k] += mu > rim.orders ? square : 0.0f;
            }
            for (std::size_t k = 0; k < K && mu <= rim.orders; ++k) {
                const std::size_t i = side == 0 ? rim.first + mu - k : rim.first - mu - k;
                float* const to = values.data() + (i * K + k) * 2 * lanes;
                store(to, splat<V>(re[k]));
                store(to + lanes, splat<V>(im[k]));
                const std::size_t at = k * (2 * rim.orders + 1) + (side == 0 ? rim.orders + mu : rim.orders - mu);
                const float a = std::abs(re[k]), b = std::abs(im[k]), modulus = std::max(a, b) + 0.4286f * std::min(a, b);
                whole[0] += rim.size[0][at] * modulus;
                whole[1] += rim.size[1][at] * modulus;
            }
        }
    }
    for (std::size_t k = 0; k < K; ++k) {
        of.left[k * lanes] = left[k];
        of.energy[k * lanes] = energy[k];
    }
    for (std::size_t ellipse = 0; ellipse < 2; ++ellipse) {
        of.size[ellipse].assign(lanes, whole[ellipse]);
    }
}

// Copy of the RimTable of a window for one pupil at a time: lanes are radii, in blocks of as many radii as lanes.
struct RimLone {
    std::size_t lanes;
    RimWindow window;
    std::vector<Floats> real[2], imaginary[2];  // parts of waves: [rim][block of radii], each [wave][k][lane]
    std::vector<Floats> weights;  // [block of radii], each [weight of a pixel][lane]

    RimLone(const RimTable& table, std::size_t side) : lanes(side), window(table.window) {
        const std::size_t radii = table.radii(), blocks = (radii + lanes - 1) / lanes;
        for (std::size_t b = 0; b < blocks; ++b) {
            const std::size_t here = std::min(lanes, radii - b * lanes), size = table.weights[0].size();
            Floats all(size * lanes, 0.0f);
            for (std::size_t lane = 0; lane < here; ++lane) {
                const Floats& from = table.weights[b * lanes + lane];
                for (std::size_t i = 0; i < size; ++i) {
                    all[i * lanes + lane] = from[i];
                }
            }
            weights.push_back(std::move(all));
        }
        for (std::size_t d = 0; d < table.rims.size(); ++d) {
            const RimWaves& rim = table.rims[d];
            for (std::size_t b = 0; b < blocks; ++b) {
                Floats both[2] = {Floats(rim.count() * rim_orders * lanes, 0.0f),
                                  Floats(rim.count() * rim_orders * lanes, 0.0f)};
                for_tiles(radii, rim_radii_tile, [&](std::size_t from, std::size_t size) {
                    for (std::size_t r = 0; r < size; ++r) {
                        const std::size_t lane = from + r - b * lanes;
                        for (std::size_t i = 0; lane < lanes && i < rim.count() * rim_orders; ++i) {
                            const std::size_t nu = i / rim_orders, k = i % rim_orders;
                            const std::size_t at = (nu * radii + from) * rim_orders + k * size + r;
                            both[0][i * lanes + lane] = rim.real[at];
                            both[1][i * lanes + lane] = rim.imaginary[at];
                        }
                    }
                });
                real[d].push_back(std::move(both[0]));
                imaginary[d].push_back(std::move(both[1]));
            }
        }
    }
    bool is(const RimTable& table, std::size_t side) const { return lanes == side && window == table.window; }
    std::size_t bytes() const {
        std::size_t sum = weights.size() * weights[0].size();
        for (std::size_t d = 0; d < 2; ++d) {
            sum += real[d].empty() ? 0 : 2 * real[d].size() * real[d][0].size();
        }
        return sum * sizeof(float);
    }
    static constexpr std::size_t most_bytes = std::size_t{32} << 20;
};

// Fourier series of X, Y (RimWaves) in the polar angle at `size` radii, the first of index `from`, or, if `Lone`, one per lane in
// the block `from` of radii: waves[radius][kind of fold()][order][re X, im X, re Y, im Y][lane]. values: see rim_coefficients().
template <bool Lone, class I>
LOMMEL_INLINE void rim_waves(I, const RimTable& table, std::size_t disk, const RimLone* lone, std::size_t from,
                             std::size_t size, const float* values, Floats& waves) {
    const RimWaves& rim = table.rims[disk];
    const std::size_t radii = table.radii();
    using V = typename I::floats;
    constexpr std::size_t lanes = sizeof(V) / sizeof(float), K = rim_orders;
    const std::size_t most = rim.halves(0), each = 4 * most * 4 * lanes;
    waves.resize(rim_radii_tile * each);
    const V zero = splat<V>(0.0f);
    const auto tile = [&](auto fixed) LOMMEL_INLINE_LAMBDA {
        constexpr std::size_t R = decltype(fixed)::value;
        for (std::size_t n = 0; n < rim.orders + K; ++n) {
            V parts[2][2][R][2] = {};  // [order n, order -n][X, Y][radius][re, im]
            for (std::size_t side = 0; side < 2; ++side) {
                const std::size_t i = side == 0 ? rim.first + n : rim.first - n;
                if (i < rim.count() && (n > 0 || side == 0)) {
                    const float* const data = values + i * K * 2 * lanes;
                    if constexpr (Lone) {
                        const std::size_t at = i * K * lanes;
                        multiply_lanes<R, 2>(lone->real[disk][from].data() + at, data, K, parts[side][0]);
                        multiply_lanes<R, 2>(lone->imaginary[disk][from].data() + at, data, K, parts[side][1]);
                    } else {
                        const std::size_t at = (i * radii + from) * K;
                        multiply_both<R, 2>(rim.real.data() + at, rim.imaginary.data() + at, data, K, parts[side][0],
                                            parts[side][1]);
                    }
                }
            }
            for (std::size_t r = 0; r < R; ++r) {
                float* const to = waves.data() + r * each + (2 * (n % 2) * most + n / 2) * 4 * lanes;
                for (std::size_t k = 0; k < 2; ++k) {
                    // Multiply order n by (-i)^n, and order -n by (-i)^-n = i^n.
                    V re[2], im[2];
                    for (std::size_t side = 0; side < 2; ++side) {
                        const V a = parts[side][k][r][0], b = parts[side][k][r][1];
                        const std::size_t turns = (side == 0 ? n : 3 * n) % 4;
                        re[side] = turns == 0 ? a : turns == 1 ? b : turns == 2 ? zero - a : zero - b;
                        im[side] = turns == 0 ? b : turns == 1 ? zero - a : turns == 2 ? zero - b : a;
                    }
                    store(to + 2 * k * lanes, re[0] + re[1]);
                    store(to + (2 * k + 1) * lanes, im[0] + im[1]);
                    // Coefficient of sin(n psi), psi being the polar angle: i * (coefficient of order n - coefficient of order -n).
                    float* const sine = to + most * 4 * lanes;
                    store(sine + 2 * k * lanes, im[1] - im[0]);
                    store(sine + (2 * k + 1) * lanes, re[0] - re[1]);
                }
            }
        }
    };
    if constexpr (Lone) {
        tile(Size<1>{});
    } else {
        size == 3 ? tile(Size<3>{}) : size == 2 ? tile(Size<2>{}) : tile(Size<1>{});
    }
}

// Channels of v^3 I at one polar angle, with radius v and intensity I, from x[rim][re X, im X, re Y, im Y] (RimWaves). Each rim has
// two waves, of amplitudes X + i Y and X - i Y. Channel 0: sum of the squared moduli of all amplitudes; then pairs of coefficients
// of cos(f v) and sin(f v), one pair for each frequency f of interference rings.
template <std::size_t Rims, class V>
LOMMEL_INLINE void rim_channels(const V (&x)[Rims][4], V* out) {
    const auto two = splat<V>(2.0f), four = splat<V>(4.0f), zero = splat<V>(0.0f);
    V smooth = zero;
    for (std::size_t d = 0; d < Rims; ++d) {
        const V xs = x[d][0] * x[d][0] + x[d][1] * x[d][1], ys = x[d][2] * x[d][2] + x[d][3] * x[d][3];
        smooth = smooth + two * (xs + ys);
        V* const ring = out + (Rims == 2 && d == 0 ? 7 : 1);
        ring[0] = two * (xs - ys);
        ring[1] = zero - four * (x[d][0] * x[d][2] + x[d][1] * x[d][3]);
    }
    out[0] = smooth;
    if constexpr (Rims == 2) {
        // For each rim, of radius R: amplitudes A = X + i Y of the wave exp(i R v), and B = X - i Y of the wave exp(-i R v).
        V a[2][2], b[2][2];
        for (std::size_t d = 0; d < 2; ++d) {
            a[d][0] = x[d][0] - x[d][3];
            a[d][1] = x[d][1] + x[d][2];
            b[d][0] = x[d][0] + x[d][3];
            b[d][1] = x[d][1] - x[d][2];
        }
        // Coefficients of cosine and sine: 2 Re and -2 Im of p conj(q) + r conj(s).
        const auto pair = [&](const V(&p)[2], const V(&q)[2], const V(&r)[2], const V(&s)[2], V* to) LOMMEL_INLINE_LAMBDA {
            to[0] = two * ((p[0] * q[0] + p[1] * q[1]) + (r[0] * s[0] + r[1] * s[1]));
            to[1] = two * ((p[0] * q[1] - p[1] * q[0]) + (r[0] * s[1] - r[1] * s[0]));
        };
        pair(a[0], a[1], b[1], b[0], out + 3);
        pair(a[0], b[1], a[1], b[0], out + 5);
    }
}

// One to four pixels with the same weights, at quarter turns about the axis; their averages are computed together.
struct RimJob {
    const RimPixels* pixels;
    std::array<std::size_t, 4> at, to;  // at: index of the first angle in the padded ring; to: index of the average
    std::array<std::uint8_t, 4> quarters;  // number of quarter turns
    std::uint8_t count;
    bool turned;  // the pixels are mirror images: their angles descend
};

template <bool Lone, std::size_t R, std::size_t Used, class I>
LOMMEL_INLINE void rim_pixel(I, const RimPixels& pixels, const float* weights, const float* ring, std::ptrdiff_t line,
                             const std::size_t* at, const std::size_t* to, bool turned, float* out) {
    using V = typename I::floats;
    constexpr std::size_t lanes = sizeof(V) / sizeof(float);
    const std::ptrdiff_t next = turned ? -line : line;
    V sum[R];
    const float* places[R];
    for (std::size_t r = 0; r < R; ++r) {
        sum[r] = load<V>(out + to[r]);
        places[r] = ring + static_cast<std::ptrdiff_t>(at[r]) * line;
    }
    constexpr std::size_t side = Lone ? lanes : 1;
    for (std::size_t t = 0; t < pixels.count; ++t, weights += Used * side) {
        for (std::size_t c = 0; c < Used; ++c) {
            V weight;
            if constexpr (Lone) {
                weight = load<V>(weights + c * lanes);
            } else {
                weight = splat<V>(weights[c]);
            }
            for (std::size_t r = 0; r < R; ++r) {
                sum[r] = sum[r] + weight * load<V>(places[r] + c * lanes);
            }
        }
        for (std::size_t r = 0; r < R; ++r) {
            places[r] += next;
        }
    }
    for (std::size_t r = 0; r < R; ++r) {
        store(out + to[r], sum[r]);
    }
}

// Add the channels of one radius, ring[angle][channel][lane], times their weights `all`, to the averages `out` of pixels.
template <bool Lone, std::size_t Rims, class I>
LOMMEL_INLINE void rim_pixels(I isa, const Floats& all, const std::vector<RimJob>& jobs, const float* ring, float* out) {
    using V = typename I::floats;
    constexpr std::ptrdiff_t line = (Rims == 1 ? 3 : 9) * sizeof(V) / sizeof(float);
    for (const RimJob& job : jobs) {
        const RimPixels& pixels = *job.pixels;
        const float* const weights = all.data() + pixels.from * (Lone ? sizeof(V) / sizeof(float) : 1);
        const auto some = [&](auto used) LOMMEL_INLINE_LAMBDA {
            constexpr std::size_t Used = decltype(used)::value;
            if (job.count == 4) {
                return rim_pixel<Lone, 4, Used>(isa, pixels, weights, ring, line, job.at.data(), job.to.data(), job.turned,
                                                out);
            }
            for (std::size_t i = 0; i < job.count; ++i) {
                rim_pixel<Lone, 1, Used>(isa, pixels, weights, ring, line, &job.at[i], &job.to[i], job.turned, out);
            }
        };
        if (pixels.used == 1) {
            some(Size<1>{});
        } else if (pixels.used == 3) {
            some(Size<3>{});
        } else if constexpr (Rims == 2) {
            pixels.used == 5 ? some(Size<5>{}) : pixels.used == 7 ? some(Size<7>{}) : some(Size<9>{});
        }
    }
}

// Compute the channels of the intensity (rim_channels()) at one radius after the other, and add them to the averages of pixels.
template <bool Lone, std::size_t Rims, class I>
LOMMEL_INLINE void rim_light(I isa, const RimTable& table, const RimLone* lone, const std::vector<RimJob>& jobs,
                             RimScratch& scratch) {
    using V = typename I::floats;
    constexpr std::size_t lanes = sizeof(V) / sizeof(float), channels = Rims == 1 ? 3 : 9;
    const std::size_t around = table.around, quarter = around / 4, line = channels * lanes;
    scratch.light.resize(table.ring() * line);
    const std::size_t block = table.radii() * Rims * 4 * lanes;
    scratch.kept.resize(table.window.fields() ? table.ring() * block : 0);
    float* const kept = scratch.kept.empty() ? nullptr : scratch.kept.data();
    scratch.squares.assign(lanes, 0.0f);
    scratch.largest.assign(lanes, 0.0f);
    const std::size_t steps = Lone ? lone->weights.size() : table.radii();  // number of radii, or of blocks of radii
    for_tiles(steps, Lone ? 1 : rim_radii_tile, [&](std::size_t from, std::size_t size) LOMMEL_INLINE_LAMBDA {
        for (std::size_t d = 0; d < Rims; ++d) {
            rim_waves<Lone>(isa, table, d, lone, from, size, scratch.values[d].data(), scratch.waves[d]);
        }
        for (std::size_t radius = 0; radius < size; ++radius) {
            float* const ring = scratch.light.data();
            V squares = splat<V>(0.0f), largest = load<V>(scratch.largest.data());
            for_fixed_tiles<rim_angles_tile>(quarter, [&](std::size_t first, auto fixed) LOMMEL_INLINE_LAMBDA {
                constexpr std::size_t R = decltype(fixed)::value;
                V sums[Rims][4][R][4];
                for (std::size_t d = 0; d < Rims; ++d) {
                    const RimWaves& rim = table.rims[d];
                    const std::size_t most = rim.halves(0);
                    for (std::size_t kind = 0; kind < 4; ++kind) {
                        V sum[R][4] = {};
                        multiply<R, 4>(rim.back[kind].data() + first * rim.halves(kind / 2),
                                       scratch.waves[d].data() + (radius * 4 + kind) * most * 4 * lanes, rim.halves(kind / 2),
                                       sum);
                        for (std::size_t r = 0; r < R; ++r) {
                            std::copy_n(sum[r], 4, sums[d][kind][r]);
                        }
                    }
                }
                for (std::size_t r = 0; r < R; ++r) {
                    const std::size_t l = first + r;
                    const std::size_t angles[4] = {l, l + 2 * quarter, 2 * quarter - 1 - l, around - 1 - l};
                    V x[4][Rims][4];
                    for (std::size_t d = 0; d < Rims; ++d) {
                        for (std::size_t part = 0; part < 4; ++part) {
                            const V ec = sums[d][0][r][part], es = sums[d][1][r][part], oc = sums[d][2][r][part],
                                    os = sums[d][3][r][part];
                            const V plus = ec + es, minus = ec - es, odd = oc + os, other = oc - os;
                            x[0][d][part] = plus + odd;
                            x[1][d][part] = plus - odd;
                            x[2][d][part] = minus - other;
                            x[3][d][part] = minus + other;
                        }
                    }
                    for (std::size_t i = 0; i < 4; ++i) {
                        V out[channels];
                        rim_channels<Rims>(x[i], out);
                        squares = squares + out[0] * out[0];
                        largest = larger(largest, out[0]);
                        float* const to = ring + (table.margin + angles[i]) * line;
                        for (std::size_t c = 0; c < channels; ++c) {
                            store(to + c * lanes, out[c]);
                        }
                        for (std::size_t part = 0; kept != nullptr && part < 4 * Rims; ++part) {
                            float* const at = kept + (table.margin + angles[i]) * block + (from + radius) * Rims * 4 * lanes;
                            store(at + part * lanes, x[i][part / 4][part % 4]);
                        }
                    }
                }
            });
            // Pad `ring`, the values at all angles, periodically at both ends.
            std::copy_n(ring + around * line, table.margin * line, ring);
            std::copy_n(ring + table.margin * line, table.margin * line, ring + (table.margin + around) * line);
            store(scratch.largest.data(), largest);
            store(scratch.squares.data(), larger(load<V>(scratch.squares.data()), squares));
            const Floats& weights = Lone ? lone->weights[from + radius] : table.weights[from + radius];
            rim_pixels<Lone, Rims>(isa, weights, jobs, ring, scratch.out.data());
        }
    });
    if (kept != nullptr) {
        std::copy_n(kept + around * block, table.margin * block, kept);
        std::copy_n(kept + table.margin * block, table.margin * block, kept + (table.margin + around) * block);
    }
}

// Call f(Size<N>) with an N for rim_powers(): 4 or rim_orders, of which the latter alone where processors without AVX2 are rare.
template <class I, class F>
LOMMEL_INLINE void with_degree(I, std::size_t degree, const F& f) {
    if constexpr (is_fallback<I>) {
        f(Size<rim_orders>{});
    } else {
        degree <= 4 ? f(Size<4>{}) : f(Size<rim_orders>{});
    }
}

// Kernels, compiled for each instruction set and chosen at run time by `level`.
struct RimKernels {
    // Number of pupils per vector of floats.
    static constexpr std::size_t lanes(Level level) { return 2 * widest_lanes(level); }
    // Instruction set for one pupil, with radii in the lanes: wider vectors would have idle lanes.
    static constexpr Level narrow(Level level) { return std::min(level, Level::avx2); }

    static void mean(Level level, bool lone, const RimDisk& disk, RimScratch& scratch) {
        if (lone) {
            return dispatch(level, [&](auto isa) LOMMEL_INLINE_LAMBDA {
                with_degree(isa, disk.slopes.degree, [&](auto degree) LOMMEL_INLINE_LAMBDA {
                    mean_of_disk<decltype(degree)::value, true>(isa, disk, scratch.coefficients.data(), scratch.e.data(),
                                                                scratch.mean.data(), scratch.largest.data());
                });
            });
        }
        dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA {
            with_degree(isa, disk.slopes.degree, [&](auto degree) LOMMEL_INLINE_LAMBDA {
                mean_of_disk<decltype(degree)::value, false>(isa, disk, scratch.coefficients.data(), scratch.e.data(),
                                                             scratch.mean.data(), scratch.largest.data());
            });
        });
    }
    static void coefficients(Level level, bool lone, const RimWaves& rim, const RimLine& line, double amplitude,
                             std::size_t disk, RimScratch& scratch) {
        if (lone) {
            return dispatch(level, [&](auto isa) LOMMEL_INLINE_LAMBDA {
                with_degree(isa, line.slopes.degree, [&](auto degree) LOMMEL_INLINE_LAMBDA {
                    rim_coefficients_of_pupil<decltype(degree)::value>(isa, rim, line, amplitude, scratch, scratch.values[disk],
                                                                       scratch.of[disk]);
                });
            });
        }
        dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA {
            with_degree(isa, line.slopes.degree, [&](auto degree) LOMMEL_INLINE_LAMBDA {
                rim_coefficients<decltype(degree)::value>(isa, rim, line, amplitude, scratch, scratch.values[disk],
                                                          scratch.of[disk]);
            });
        });
    }
    static void light(Level level, const RimTable& table, const RimLone* lone, const std::vector<RimJob>& jobs,
                      RimScratch& scratch) {
        const bool one = table.rims.size() == 1;
        if (lone != nullptr) {
            return dispatch(level, [&](auto isa) LOMMEL_INLINE_LAMBDA {
                one ? rim_light<true, 1>(isa, table, lone, jobs, scratch) : rim_light<true, 2>(isa, table, lone, jobs, scratch);
            });
        }
        dispatch_widest(level, [&](auto isa) LOMMEL_INLINE_LAMBDA {
            one ? rim_light<false, 1>(isa, table, lone, jobs, scratch) : rim_light<false, 2>(isa, table, lone, jobs, scratch);
        });
    }
};

}  // namespace lommel
