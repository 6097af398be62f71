// Mean modulus of the pupil integrand on complex curves, bounded by samples. For strong aberrations it is much less than the
// product of the maxima of all factors (docs/certificate.md, section 8, "Means by samples").
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numeric>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/base/pi.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/bounds/chords.hpp"
#include "lommel/chordal/tables.hpp"
#include "lommel/chordal/transform.hpp"
#include "lommel/special/exponential.hpp"
#include "lommel/special/radial_polynomials.hpp"

namespace lommel {

// Samples (x, y) = (cos(a), sin(a) cos(tau)) at equal steps of two angles a, tau from 0 to pi/2. One angle is shifted by i b, with
// b = chord_curves.b[curve]: a to bound the error of the sum over chords, tau to bound the error of the sums over the nodes of a
// chord. Stored at each sample: imaginary parts of the Zernike terms and, for each corner of the window, weights for the mean of
// |integrand|. A sample also represents its mirror images (+-x, +-y) and their complex conjugates.
struct SharpTable {
    static constexpr std::size_t images = 4, corners = 4, places = images * 2 * corners;  // places: weights per sample
    static constexpr std::size_t tile = 16;  // samples per tile: a multiple of the lanes of any SIMD vector
    static constexpr double single = 5.9604644775390625e-08;  // unit roundoff of float

    std::vector<ZernikeTerm> terms;
    Sum sum;
    std::size_t curve;
    double b;
    VBox box;
    TermClasses classes;
    std::size_t samples;
    double step;  // angle between samples, rad
    double scale = 0.0;  // log of the factor by which all weights `shares` are divided
    Floats values;  // imaginary parts of the Zernike terms at the samples, [tile][term][sample]
    Floats shares;  // weights of the samples: [tile][mirror image][sample or conjugate][corner][sample]; 0 for padding
    std::vector<double> most;  // [term]: bound on |imaginary part| of the term at all samples

    SharpTable(const std::vector<ZernikeTerm>& list, Sum which, std::size_t at, const VBox& window)
        : terms(list), sum(which), curve(at), b(chord_curves.b[at]), box(window), classes(list) {
        const std::size_t degree = TermPairs(list).degree, last = quarter(degree), side = last + 1;
        samples = side * side;
        step = pi / static_cast<double>(2 * last);
        for (const ZernikeTerm& term : list) {
            most.push_back(std::sinh(static_cast<double>(term.n) * b));
        }
        values.resize(tiles() * tile * list.size());
        const ZernikeValues polynomials(list, classes.order);
        std::vector<double> exponents(samples * places);
        const double tips[corners][2] = {
            {box.left, box.top}, {box.right, box.top}, {box.left, box.bottom}, {box.right, box.bottom}};
        for (std::size_t p = 0; p < side; ++p) {
            for (std::size_t q = 0; q < side; ++q) {
                look();
                const std::size_t s = p * side + q;
                const std::complex<wide> one(step * static_cast<double>(p), sum == Sum::chords ? b : 0.0);
                const std::complex<wide> two(step * static_cast<double>(q), sum == Sum::nodes ? b : 0.0);
                const std::complex<wide> x = std::cos(one), y = std::sin(one) * std::cos(two);
                const double rise_x = static_cast<double>(x.imag()), rise_y = static_cast<double>(y.imag());
                polynomials.at(x, y, [&](std::size_t j, const std::complex<wide>& value) {
                    values[place(s, list.size()) + j * tile] = static_cast<float>(value.imag());
                });
                for (std::size_t k = 0; k < places; ++k) {
                    const std::size_t corner = k % corners, sign = k / corners % 2, image = k / corners / 2;
                    const double here = (image < 2 ? 1.0 : -1.0) * tips[corner][0] * rise_x +
                                        (image % 2 == 0 ? 1.0 : -1.0) * tips[corner][1] * rise_y;
                    exponents[s * places + k] = sign == 0 ? -here : here;
                    scale = std::max(scale, std::abs(here));
                }
            }
        }
        const std::vector<double> first = firsts(last), second = seconds(last);
        shares.resize(tiles() * tile * places);
        for (std::size_t j = 0; j < exponents.size(); ++j) {
            const std::size_t s = j / places;
            const double share = first[s / side] * second[s % side] * std::exp(exponents[j] - scale);
            shares[place(s, places) + j % places * tile] = static_cast<float>(std::max(share, 1e-35));
        }
    }

    // Number of sampling steps in a quarter turn; degree: largest radial degree of the Zernike terms.
    static std::size_t quarter(std::size_t degree) { return (5 * std::max<std::size_t>(2, degree) + 1) / 2; }
    // Return whether the imaginary parts of Zernike terms, at most sinh(degree * b) for this curve, are well within float's range.
    static bool serves(std::size_t degree, std::size_t curve) {
        return static_cast<double>(degree) * chord_curves.b[curve] <= 15.0;
    }
    // Minimum number of chords for which sampled bounds on the sums over the nodes of a chord are valid.
    static constexpr std::size_t least_chords = 16;

    // log of the mean |integrand|; top, mean: results of sharp_means().
    double logarithm(float top, float mean) const {
        return static_cast<double>(top) + std::log(static_cast<double>(mean)) + scale;
    }
    // Error bound of logarithm(), from rounding and the distance of samples. bend: bound on second derivatives of log(integrand).
    double margin(double bend, const double* coefficients) const {
        double size = 0.0;
        for (std::size_t j = 0; j < terms.size(); ++j) {
            size += std::abs(coefficients[j]) * most[j];
        }
        return 0.25 * step * step * bend + 1e-3 +
               single * (static_cast<double>(terms.size() + 10) * size + static_cast<double>(8 * samples));
    }
    // Estimated cost of sharp_means() for one vector of pupils, in vector operations.
    static double work(const TermPairs& list) {
        const double side = static_cast<double>(quarter(list.degree) + 1);
        return 0.5 * side * side * (static_cast<double>(list.terms.size()) + 110.0);
    }
    bool is(const std::vector<ZernikeTerm>& list, Sum which, std::size_t at, const VBox& window) const {
        return sum == which && curve == at && box == window && terms == list;
    }
    std::size_t tiles() const { return (samples + tile - 1) / tile; }
    std::size_t room() const { return tiles() * tile * images; }  // vectors of working memory: one per mirror image of a sample
    // Index of a sample's first value in memory. Each sample has `numbers` values, which are `tile` elements apart.
    static std::size_t place(std::size_t sample, std::size_t numbers) { return sample / tile * tile * numbers + sample % tile; }
    std::size_t bytes() const { return (values.size() + shares.size()) * sizeof(float); }
    static constexpr std::size_t most_bytes = std::size_t{32} << 20;

   private:
    // Weights of samples along the first angle a (x = cos(a)), halved where a sample is its own mirror image. For the sum over
    // chords, they are proportional to |sin(a + ib)|^2. For the sum over nodes, each chord's weight is divided between the two
    // nearest samples; a sample's weight is the maximum over all numbers of chords.
    std::vector<double> firsts(std::size_t last) const {
        std::vector<double> found(last + 1);
        if (sum == Sum::chords) {
            const double level = 0.5 * std::cosh(2.0 * b), hat = std::sin(step) / step;
            for (std::size_t p = 0; p <= last; ++p) {
                const double falls = 0.5 * std::cos(2.0 * step * static_cast<double>(p)) * hat * hat;
                found[p] = (p % last == 0 ? 0.5 : 1.0) / static_cast<double>(4 * last) * (level - falls) / level;
            }
            return found;
        }
        for (std::size_t chords = least_chords; chords <= max_chords;
             chords = rounded_size(Sum::chords, static_cast<double>(chords + 1))) {
            std::vector<double> here(2 * last + 2);
            for (std::size_t i = 1; i <= chords; ++i) {
                const double angle = pi * static_cast<double>(i) / static_cast<double>(chords + 1);
                const double weight = 2.0 * std::sin(angle) * std::sin(angle) / static_cast<double>(chords + 1);
                const double place = angle / step, whole = std::floor(place), part = place - whole;
                here[static_cast<std::size_t>(whole)] += (1.0 - part) * weight;
                here[static_cast<std::size_t>(whole) + 1] += part * weight;
            }
            for (std::size_t p = 0; p <= last; ++p) {
                found[p] = std::max(found[p], (p == last ? 0.5 : 1.0) * here[p]);
            }
        }
        return found;
    }
    // Weights of samples along tau, the second angle. For the sum over chords, they give a mean over y, which is proportional to
    // cos(tau); for the sum over nodes, they give a mean over tau.
    std::vector<double> seconds(std::size_t last) const {
        std::vector<double> found(last + 1);
        const double hat = std::sin(0.5 * step) / (0.5 * step);
        for (std::size_t q = 0; q <= last; ++q) {
            if (sum == Sum::nodes) {
                found[q] = (q % last == 0 ? 0.5 : 1.0) / static_cast<double>(4 * last);
            } else if (q == 0) {
                found[q] = 0.5 * (1.0 - std::sin(step) / step);
            } else {
                found[q] = (q == last ? 0.5 : 1.0) * 0.5 * step * std::sin(step * static_cast<double>(q)) * hat * hat;
            }
        }
        return found;
    }
};

// Compute two numbers for each pupil, of phase Phi, over the samples r. tops: maximum of |Im Phi|. means: mean modulus of
// exp(i Phi - i (v . r)) for the corner v of the window that gives the largest mean, divided by exp(tops + table.scale) so that it
// is in the range of single precision. coefficients[term][pupil]: Zernike coefficients, in the order table.classes.order. Vector
// lanes are pupils or, with `Lone`, samples of one pupil. room: working memory, table.room() vectors.
template <bool Lone, class I>
LOMMEL_INLINE void sharp_means(I, const SharpTable& table, const float* coefficients, float* room, float* tops, float* means) {
    using V = typename I::floats;
    constexpr std::size_t lanes = 2 * I::lanes, together = Lone ? lanes : 1;
    static_assert(SharpTable::tile % lanes == 0, "a tile is some vectors");
    const auto size = [](V x) LOMMEL_INLINE_LAMBDA { return larger(x, splat<V>(0.0f) - x); };
    const auto of_table = [](const float* at) LOMMEL_INLINE_LAMBDA {
        if constexpr (Lone) {
            return load<V>(at);
        } else {
            return splat<V>(*at);
        }
    };
    const std::size_t terms = table.terms.size(), vectors = Lone ? table.tiles() * SharpTable::tile / lanes : table.samples;
    V top = splat<V>(0.0f);
    // Six independent multiply-adds at a time hide the latency of one.
    for_fixed_tiles<6>(vectors, [&](std::size_t first, auto size_of) LOMMEL_INLINE_LAMBDA {
        constexpr std::size_t R = decltype(size_of)::value;
        const float* value[R];
        for (std::size_t r = 0; r < R; ++r) {
            value[r] = table.values.data() + SharpTable::place((first + r) * together, terms);
        }
        V part[4][R] = {};
        for (std::size_t parity = 0, j = 0; parity < 4; ++parity) {
            V total[R] = {};
            for (; j < table.classes.ends[parity]; ++j) {
                V c;
                if constexpr (Lone) {
                    c = splat<V>(coefficients[j]);
                } else {
                    c = load<V>(coefficients + j * lanes);
                }
                for (std::size_t r = 0; r < R; ++r) {
                    total[r] = total[r] + of_table(value[r] + j * SharpTable::tile) * c;
                }
            }
            std::copy_n(total, R, part[parity]);
        }
        for (std::size_t r = 0; r < R; ++r) {
            const V a = part[0][r] + part[2][r], b = part[1][r] + part[3][r], c = part[0][r] - part[2][r],
                    d = part[1][r] - part[3][r];
            const V image[SharpTable::images] = {a + b, a - b, c + d, c - d};
            for (std::size_t k = 0; k < SharpTable::images; ++k) {
                store(room + ((first + r) * SharpTable::images + k) * lanes, image[k]);
                top = larger(top, size(image[k]));
            }
        }
    });
    store(tops, top);
    if constexpr (Lone) {
        top = splat<V>(*std::max_element(tops, tops + lanes));
        store(tops, top);
    }
    // The order of summation is the same for one pupil as for many: an error bound must not depend on the other pupils of a batch.
    V all[SharpTable::corners] = {};
    const std::size_t stride = Lone ? 1 : lanes;
    for (std::size_t lane = 0; lane < stride; ++lane) {
        V sums[2][SharpTable::corners] = {};
        for (std::size_t v = lane; v < vectors; v += stride) {
            const float* share = table.shares.data() + SharpTable::place(v * together, SharpTable::places);
            for (std::size_t image = 0; image < SharpTable::images; ++image) {
                const V h = load<V>(room + (v * SharpTable::images + image) * lanes);
                const V exponentials[2] = {chord_of_exp(h - top), chord_of_exp(splat<V>(0.0f) - h - top)};
                for (std::size_t sign = 0; sign < 2; ++sign) {
                    for (std::size_t k = 0; k < SharpTable::corners; ++k, share += SharpTable::tile) {
                        sums[sign][k] = sums[sign][k] + of_table(share) * exponentials[sign];
                    }
                }
            }
        }
        for (std::size_t k = 0; k < SharpTable::corners; ++k) {
            all[k] = all[k] + (sums[0][k] + sums[1][k]);
        }
    }
    V most = splat<V>(0.0f);
    for (std::size_t k = 0; k < SharpTable::corners; ++k) {
        if constexpr (Lone) {
            float each[lanes];
            store(each, all[k]);
            all[k] = splat<V>(std::accumulate(each, each + lanes, 0.0f));
        }
        most = larger(most, all[k]);
    }
    store(means, most);
}

}  // namespace lommel
