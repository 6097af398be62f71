// Strips subtracted from the field of a disk far from the axis (certificate, section 10, "Behind vanes").
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <numeric>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/chordal/batch.hpp"
#include "lommel/chordal/strip_choice.hpp"
#include "lommel/rim/light.hpp"
#include "lommel/rim/table.hpp"
#include "lommel/special/bessel.hpp"
#include "lommel/zernike/disk_stack.hpp"

namespace lommel {

// Errors of averages of a pupil without strips: of Gauss quadrature over pixels; what errors of interpolation and rounding are
// relative to; these of all pixels, `averages`; `field`: of the field, its root mean square over the points of a pixel;
// fields: of interpolation and rounding of fields; turned: what those between polar angles near a pixel are relative to (RimSums).
struct RimErrors {
    double pixels, rms, squares[2], rounding, largest, averages, field, fields, turned[rim_most_turns];

    double of(double angles, const std::array<double, 2>& radii, double gain, double dropped) const {
        return angles * rms + std::min(radii[0] * squares[0], radii[1] * squares[1]) + gain * rounding + dropped * largest;
    }
    double of(const RimPixels& here) const { return of(here.off_angles, here.off_radii, here.gain, here.dropped); }
    // Bound on the error of an average.
    double of_average(double average, double off, double of_field) const {
        return pixels + off + 2.0 * of_field * std::sqrt(average + off) + of_field * of_field;
    }
    double of_averages(double top) const { return of_average(top, averages, field); }
};

// Image of a far pixel: of RimTable::pixels, turned and mirrored (RimPixels::image()); y, x: its distances from the axis in pixels.
struct RimImage {
    const RimPixels& pixels;
    std::int64_t y, x;
    bool turned;
    std::size_t quarters;

    // Row and column of point i of the RimTable, of g x g points in the pixel.
    std::array<std::size_t, 2> point(std::size_t i, std::size_t g) const {
        // Signs of the coordinates of the point (y, x) of a RimTable in the pixel, where they are exchanged if `across`.
        const bool across = quarters % 2 == 1, down = turned ? quarters == 0 || quarters == 3 : quarters > 1,
                   left = turned ? quarters > 1 : quarters == 1 || quarters == 2;
        const std::size_t p = across ? i % g : i / g, q = across ? i / g : i % g;
        return {down ? g - 1 - p : p, left ? g - 1 - q : q};
    }
};

// Tables of strips for the points of pixels within `reach` of the axis, of which each has `points` along an axis.
struct RimStripTable {
    static constexpr std::size_t fractions = 2048;  // number of fractions of a spacing, at which fields are interpolated
    static constexpr std::size_t most_waves = 8;

    StripTable<float> lines;
    RimWindow window;
    std::size_t reach, points;
    double step, misfit, gain = 0.0;  // gain: largest sum of the moduli of weights
    // Across a strip, cos and sin of s v have the Chebyshev series of `waves` terms in a pixel, and `rest` is what it leaves out.
    std::size_t waves = 0;
    double rest = 0.0;
    std::vector<double> places;  // coordinates of points, along either axis
    std::vector<double> taps;  // [tap]: mean modulus of its weight
    Floats weights;  // [fraction][tap]
    std::vector<double> wide;  // [direction]: half width of a pixel across it
    std::vector<double> bessel;  // [line][wave]: coefficients of its Chebyshev series
    std::vector<double> turns;  // [line][row or column of a pixel]: cosine, sine of s v along y, along x, at its middle
    std::size_t span;  // number of places of a direction from which the fields in a pixel are interpolated

    RimStripTable(const std::vector<Strip>& strips, const StripCount& count, const Amplitude& light, std::size_t terms,
                  const RimTable& table)
        : lines(strips, count, light, corners(table), corners(table), 1.0), window(table.window), reach(window.reach),
          points(table.point_places.size()), step(window.step), waves(terms), weights((fractions + 1) * count.taps),
          span(static_cast<std::size_t>(std::ceil(std::sqrt(2.0) * step / count.spacing)) + count.taps + 1) {
        for (std::size_t i = 0; i < (2 * reach + 1) * points; ++i) {
            const double pixel = static_cast<double>(i / points) - static_cast<double>(reach);
            places.push_back(step * (pixel + 0.5 * table.point_places[i % points]));
        }
        std::vector<double> parts, found((fractions + 1) * count.taps);
        for (std::size_t i = 0; i <= fractions; ++i) {
            parts.push_back(static_cast<double>(i) / static_cast<double>(fractions));
        }
        misfit = Interpolation(count.taps, count.spacing).find(parts, found.data());
        for (std::size_t i = 0; i < found.size(); i += count.taps) {
            double sum = 0.0;
            for (std::size_t k = i; k < i + count.taps; ++k) {
                weights[k] = static_cast<float>(found[k]);
                sum += std::abs(found[k]);
            }
            gain = std::max(gain, sum);
        }
        taps.assign(count.taps, 0.0);
        for (std::size_t i = 0; i + count.taps < found.size(); ++i) {
            taps[i % count.taps] += std::abs(found[i]) / static_cast<double>(fractions);
        }
        for (std::size_t d = 0; d < lines.directions.size(); ++d) {
            wide.push_back(0.5 * step * (std::abs(lines.points.cosines[d]) + std::abs(lines.points.sines[d])));
        }
        for (const StripLine& line : lines.points.lines) {
            const double of = std::abs(static_cast<double>(line.s)) * wide[line.direction];
            std::array<double, most_waves> series;
            bessel_sequence(of, most_waves, series.data());
            rest = std::max(rest, rest_of(of, waves));
            for (std::size_t k = 0; k < waves; ++k) {
                bessel.push_back((k == 0 ? 1.0 : 2.0) * (line.s < 0 && k % 2 == 1 ? -1.0 : 1.0) * series[k]);
            }
            const double c = static_cast<double>(line.s) * lines.points.cosines[line.direction],
                         s = -static_cast<double>(line.s) * lines.points.sines[line.direction];
            for (std::size_t i = 0; i <= 2 * reach; ++i) {
                const double at = step * (static_cast<double>(i) - static_cast<double>(reach));
                turns.insert(turns.end(), {std::cos(c * at), std::sin(c * at), std::cos(s * at), std::sin(s * at)});
            }
        }
    }
    bool is(const std::vector<Strip>& strips, const StripCount& count, const Amplitude& light, std::size_t terms,
            const RimTable& table) const {
        return lines.count == count && lines.strips == strips && lines.amplitude == light && waves == terms &&
               window == table.window;
    }
    std::size_t bytes() const {
        return lines.bytes() + weights.size() * sizeof(float) + (turns.size() + places.size()) * sizeof(double);
    }
    static constexpr std::size_t most_bytes = std::size_t{32} << 20;
    // Largest distance of a point along an axis.
    static double farthest(const RimTable& table) {
        return table.window.step * (static_cast<double>(table.window.reach) + 0.5);
    }
    // Bound on the error of the Chebyshev series of `terms` terms of the wave exp(i size x) over |x| <= 1.
    static double rest_of(double size, std::size_t terms) {
        double next = 2.0;  // twice the bound (size / 2)^k / k! on the Bessel function of order k
        for (std::size_t k = 1; k <= terms; ++k) {
            next *= 0.5 * size / static_cast<double>(k);
        }
        const double ratio = 0.5 * size / static_cast<double>(terms + 1);
        return ratio < 0.9 ? next / (1.0 - ratio) : 1e300;
    }
    // First of the `span` places of a direction for the pixel (y, x).
    std::size_t first(std::size_t d, std::int64_t y, std::int64_t x) const {
        const double across = step / lines.count.spacing;
        const double low =
            across * (lines.points.cosines[d] * static_cast<double>(x) + lines.points.sines[d] * static_cast<double>(y)) -
            wide[d] / lines.count.spacing;
        const std::size_t places_of = lines.directions[d].places;
        const double from = static_cast<double>(places_of - 1) + std::floor(low - 1e-6);
        return std::min(static_cast<std::size_t>(from) - (lines.count.taps / 2 - 1), 2 * places_of - 1 - span);
    }
    // Place of a point, in fractions.
    std::size_t place(std::size_t d, std::size_t row, std::size_t column) const {
        const double along = lines.points.cosines[d] * places[column] + lines.points.sines[d] * places[row];
        return static_cast<std::size_t>((along / lines.count.spacing + static_cast<double>(lines.directions[d].places - 1)) *
                                            static_cast<double>(fractions) +
                                        0.5);
    }
    // Coordinate of a point across a direction, from -1 to 1 in the pixel (y, x).
    double across(std::size_t d, std::size_t row, std::size_t column, std::int64_t y, std::int64_t x) const {
        const double c = lines.points.cosines[d], s = lines.points.sines[d];
        return (c * (places[row] - step * static_cast<double>(y)) - s * (places[column] - step * static_cast<double>(x))) /
               wide[d];
    }

   private:
    static WindowAxis corners(const RimTable& table) {
        return WindowAxis(std::vector<double>{-farthest(table), farthest(table)});
    }
};

// One pixel, and the index of its first angle in the ring.
struct RimCut {
    RimImage image;
    std::size_t at;
};

// Weight of point i in the average over a pixel.
template <class V>
LOMMEL_INLINE V point_weight(const RimTable& table, std::size_t i) {
    const std::size_t g = table.point_weights.size();
    return splat<V>(static_cast<float>(0.25 * table.point_weights[i / g] * table.point_weights[i % g]));
}

// Compute the field of strips at the points of a pixel, at[point][re, im][lane]; add its mean intensity to out[lane], and store it
// in square[lane]. fields: of lines, at the places of their tables.
template <std::size_t T, class I>
LOMMEL_INLINE void cut_pixel(I, const RimTable& table, const RimStripTable& strips, const float* fields, const RimCut& cut,
                             Floats& series, Floats& at, float* out, float* square) {
    using V = typename I::floats;
    constexpr std::size_t lanes = sizeof(V) / sizeof(float), most_directions = 16;
    const StripTable<float>& lines = strips.lines;
    const RimImage& image = cut.image;
    const std::size_t g = strips.points, room = lines.room(lanes);
    const std::size_t directions = lines.directions.size(), waves = strips.waves, wave = 2 * strips.span * lanes;
    const std::size_t row_of = static_cast<std::size_t>(image.y + static_cast<std::int64_t>(strips.reach)),
                      column_of = static_cast<std::size_t>(image.x + static_cast<std::int64_t>(strips.reach));
    // Chebyshev coefficients, across the strips, of the field of each direction at places near the pixel:
    // series[direction][wave][place][re, im][lane].
    std::size_t first[most_directions];
    for (std::size_t d = 0; d < directions; ++d) {
        first[d] = strips.first(d, image.y, image.x);
    }
    series.resize(directions * waves * wave);
    const float* field = fields;
    for (std::size_t l = 0; l < lines.points.lines.size(); ++l) {
        const StripLine& line = lines.points.lines[l];
        const double *const turns = strips.turns.data() + 4 * l * (2 * strips.reach + 1), *const y = turns + 4 * row_of,
                            *const x = turns + 4 * column_of + 2;
        const double cosine = y[0] * x[0] - y[1] * x[1], sine = y[1] * x[0] + y[0] * x[1];
        const double turned[4] = {cosine, -sine, -cosine, sine};
        V a[RimStripTable::most_waves], b[RimStripTable::most_waves];
        for (std::size_t k = 0; k < waves; ++k) {
            const double by = strips.bessel[l * waves + k];
            a[k] = splat<V>(static_cast<float>(by * turned[k % 4]));
            b[k] = splat<V>(static_cast<float>(by * turned[(k + 3) % 4]));
        }
        const float* from = field + first[line.direction] * 2 * lanes;
        float* to = series.data() + line.direction * waves * wave;
        const bool begins = l == 0 || lines.points.lines[l - 1].direction != line.direction;
        for (std::size_t n = 0; n < 2 * strips.span; ++n, from += lanes, to += lanes) {
            const V even = load<V>(from), odd = line.sums == 2 ? load<V>(from + room) : splat<V>(0.0f);
            for (std::size_t k = 0; k < waves; ++k) {
                const V before = begins ? splat<V>(0.0f) : load<V>(to + k * wave);
                store(to + k * wave, before + a[k] * even + b[k] * odd);
            }
        }
        field += line.sums * room;
    }
    V squares = splat<V>(0.0f);
    at.resize(2 * g * g * lanes);
    for (std::size_t i = 0; i < g * g; ++i) {
        const auto [down, right] = image.point(i, g);
        const std::size_t row = row_of * g + down, column = column_of * g + right;
        V u[2] = {splat<V>(0.0f), splat<V>(0.0f)};
        for (std::size_t d = 0; d < directions; ++d) {
            const std::size_t place = strips.place(d, row, column);
            const float across = static_cast<float>(strips.across(d, row, column, image.y, image.x));
            const float* const weights = strips.weights.data() + place % strips.fractions * T;
            const float* field_of =
                series.data() + d * waves * wave + (place / strips.fractions - (T / 2 - 1) - first[d]) * 2 * lanes;
            float before = 0.0f, now = 1.0f;  // Chebyshev polynomials
            for (std::size_t k = 0; k < waves; ++k, field_of += wave) {
                V a[2] = {splat<V>(0.0f), splat<V>(0.0f)};
                for (std::size_t n = 0; n < T; ++n) {
                    const V weight = splat<V>(weights[n]);
                    a[0] = a[0] + weight * load<V>(field_of + 2 * n * lanes);
                    a[1] = a[1] + weight * load<V>(field_of + (2 * n + 1) * lanes);
                }
                u[0] = u[0] + splat<V>(now) * a[0];
                u[1] = u[1] + splat<V>(now) * a[1];
                const float after = k == 0 ? across : 2.0f * across * now - before;
                before = now;
                now = after;
            }
        }
        squares = squares + point_weight<V>(table, i) * (u[0] * u[0] + u[1] * u[1]);
        store(at.data() + 2 * i * lanes, u[0]);
        store(at.data() + (2 * i + 1) * lanes, u[1]);
    }
    store(square, squares);
    store(out, load<V>(out) + squares);
}

// Add to out[lane] the products of the disk's field and that of strips (`strips_at`, of cut_pixel()); store the mean intensity of
// the disk, over the points, in light[lane]. kept: RimScratch::kept.
template <std::size_t Rims, class I>
LOMMEL_INLINE void cut_products(I, const RimTable& table, const float* kept, const RimCut& cut, const Floats& strips_at,
                                Floats& local, float* out, float* light) {
    using V = typename I::floats;
    constexpr std::size_t lanes = sizeof(V) / sizeof(float);
    const RimPixels& pixels = cut.image.pixels;
    const std::size_t g = table.point_places.size(), radii = table.radii(), block = radii * Rims * 4 * lanes;
    const std::ptrdiff_t next = static_cast<std::ptrdiff_t>(block) * (cut.image.turned ? -1 : 1);
    // X and Y near the pixel: local[angle][place][rim][re X, im X, re Y, im Y][lane]; first those of rings, at one polar angle.
    constexpr std::size_t each = Rims * 4;
    const std::size_t near = pixels.places * each * lanes;
    local.resize(pixels.turns * near + block);
    float* const rings = local.data() + pixels.turns * near;
    for (std::size_t a = 0; a < pixels.turns; ++a) {
        const float *const share = table.shares.data() + (pixels.turn + a) * table.field_taps,
                           *const from =
                               kept + cut.at * block + static_cast<std::ptrdiff_t>(table.starts[pixels.turn + a]) * next;
        for (std::size_t r = 0; r < radii; ++r) {
            V sum[each];
            std::fill_n(sum, each, splat<V>(0.0f));
            for (std::size_t t = 0; t < table.field_taps; ++t) {
                const V by = splat<V>(share[t]);
                const float* const own = from + static_cast<std::ptrdiff_t>(t) * next + r * each * lanes;
                for (std::size_t c = 0; c < each; ++c) {
                    sum[c] = sum[c] + by * load<V>(own + c * lanes);
                }
            }
            for (std::size_t c = 0; c < each; ++c) {
                store(rings + (r * each + c) * lanes, sum[c]);
            }
        }
        for (std::size_t l = 0; l < pixels.places; ++l) {
            V sum[each];
            std::fill_n(sum, each, splat<V>(0.0f));
            for (std::size_t r = 0; r < radii; ++r) {
                const V by = splat<V>(table.local[pixels.place + l * radii + r]);
                for (std::size_t c = 0; c < each; ++c) {
                    sum[c] = sum[c] + by * load<V>(rings + (r * each + c) * lanes);
                }
            }
            for (std::size_t c = 0; c < each; ++c) {
                store(local.data() + a * near + (l * each + c) * lanes, sum[c]);
            }
        }
    }
    V products = splat<V>(0.0f), lights = splat<V>(0.0f);
    const std::size_t parts = pixels.turns * pixels.places * Rims * 2;
    for_fixed_tiles<rim_points_tile>(g * g, [&](std::size_t from, auto size) LOMMEL_INLINE_LAMBDA {
        constexpr std::size_t R = decltype(size)::value;
        V disk[R][2] = {};
        multiply<R, 2>(table.parts.data() + pixels.part + from * parts, local.data(), parts, disk);
        for (std::size_t r = 0; r < R; ++r) {
            const float* const u = strips_at.data() + 2 * (from + r) * lanes;
            const V weight = point_weight<V>(table, from + r);
            products = products + weight * (disk[r][0] * load<V>(u) + disk[r][1] * load<V>(u + lanes));
            lights = lights + weight * (disk[r][0] * disk[r][0] + disk[r][1] * disk[r][1]);
        }
    });
    store(light, lights);
    store(out, load<V>(out) - splat<V>(2.0f) * products);
}

// Bound on the field of the strips at the points of a pixel: moduli: of strip_light().
template <class I>
LOMMEL_INLINE void strip_bound(I, const RimStripTable& strips, const Floats& moduli, std::int64_t y, std::int64_t x,
                               float* largest) {
    using V = typename I::floats;
    constexpr std::size_t lanes = sizeof(V) / sizeof(float);
    const std::size_t each = strips.lines.room(lanes) / 2;
    V all = splat<V>(0.0f);
    for (std::size_t d = 0; d < strips.lines.directions.size(); ++d) {
        const float* const of = moduli.data() + d * each + strips.first(d, y, x) * lanes;
        V most = splat<V>(0.0f);
        for (std::size_t n = 0; n < strips.span; ++n) {
            most = larger(most, load<V>(of + n * lanes));
        }
        all = all + splat<V>(static_cast<float>(strips.gain)) * most;
    }
    store(largest, all);
}

// Intensity of the field of a direction between the places i and i + 1 of its table, weighted by the moduli of the weights of taps,
// from above: to moduli[direction][i][lane].
template <class I>
LOMMEL_INLINE void strip_light(I, const RimStripTable& strips, const float* fields, Floats& moduli, Floats& light) {
    using V = typename I::floats;
    constexpr std::size_t lanes = sizeof(V) / sizeof(float);
    const StripTable<float>& lines = strips.lines;
    const std::size_t room = lines.room(lanes), each = room / 2, taps = lines.count.taps;
    moduli.assign(lines.directions.size() * each, 0.0f);
    light.assign(moduli.size(), 0.0f);
    for (const StripLine& line : lines.points.lines) {
        const std::size_t places = 2 * lines.directions[line.direction].places - 1;
        float* to = moduli.data() + line.direction * each;
        for (std::size_t i = 0; i < places; ++i, to += lanes) {
            V sum = splat<V>(0.0f);
            for (std::size_t part = 0; part < 2 * line.sums; ++part) {
                const V value = load<V>(fields + part / 2 * room + (2 * i + part % 2) * lanes);
                sum = sum + value * value;
            }
            alignas(64) float squares[lanes];
            store(squares, sum);
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                to[lane] += std::sqrt(squares[lane]);
            }
        }
        fields += line.sums * room;
    }
    for (std::size_t d = 0; d < lines.directions.size(); ++d) {
        const std::size_t places = 2 * lines.directions[d].places - 1;
        for (std::size_t i = taps / 2 - 1; i + taps / 2 < places; ++i) {
            V sum = splat<V>(0.0f);
            for (std::size_t k = 0; k < taps; ++k) {
                const V modulus = load<V>(moduli.data() + d * each + (i + k - (taps / 2 - 1)) * lanes);
                sum = sum + splat<V>(static_cast<float>(strips.taps[k])) * modulus * modulus;
            }
            store(light.data() + d * each + i * lanes, sum);
        }
    }
}

// Bound on the root mean square of the computed field of strips in a pixel: the sum over directions of the root of the mean of
// `light`, over the coordinate along the direction.
template <class I>
LOMMEL_INLINE void root_light(I, const RimStripTable& strips, const Floats& light, std::int64_t y, std::int64_t x,
                              float* roots) {
    using V = typename I::floats;
    constexpr std::size_t lanes = sizeof(V) / sizeof(float);
    const StripTable<float>& lines = strips.lines;
    const std::size_t each = lines.room(lanes) / 2;
    std::fill_n(roots, lanes, 0.0f);
    for (std::size_t d = 0; d < lines.directions.size(); ++d) {
        const double by = strips.step / lines.count.spacing, wide = by * std::abs(lines.points.cosines[d]),
                     tall = by * std::abs(lines.points.sines[d]);
        const double zero = static_cast<double>(lines.directions[d].places) - 1.0;
        const double middle =
            zero + by * (lines.points.cosines[d] * static_cast<double>(x) + lines.points.sines[d] * static_cast<double>(y));
        // Density of the coordinate: a trapezoid.
        const double half = 0.5 * (wide + tall), top = 1.0 / std::max(wide, tall),
                     slope = std::min(wide, tall) > 1e-9 ? 1.0 / (wide * tall) : 1e300;
        V sum = splat<V>(0.0f);
        for (double cell = std::floor(middle - half - 0.01); cell < middle + half + 0.01; cell += 1.0) {
            const double near = std::max({0.0, cell - middle, middle - cell - 1.0});
            const float density = static_cast<float>(std::min(top, slope * std::max(0.0, half + 0.01 - near)) * strips.gain);
            sum = sum + splat<V>(density) * load<V>(light.data() + d * each + static_cast<std::size_t>(cell) * lanes);
        }
        alignas(64) float sums[lanes];
        store(sums, sum);
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            roots[lane] += std::sqrt(sums[lane]);
        }
    }
}

// Strips of the apertures of a stack, subtracted from what RimKernels::light() computed for a batch of its pupils.
class RimStrips {
   public:
    // Pupils from `first` on, one in each lane, as many as `errors`. Averages out[lane] of pixels are in rows of `width`, from the
    // pixel (top, left).
    struct Batch {
        Level level;
        std::size_t first;
        const std::vector<RimJob>& jobs;
        const std::vector<RimErrors>& errors;
        const double* allowed;  // RimAnswer::allowed
        std::int64_t top, left;
        std::size_t width;
    };

    RimStrips(const DiskStack& stack, const RimTable& table) : stack_(stack), table_(table) {
        for (const Strip& strip : stack.strips) {
            cut_ += strip.area();
        }
        const double nearest = table.window.nearest(), far = RimStripTable::farthest(table);
        std::vector<std::size_t> all(stack.count);
        std::iota(all.begin(), all.end(), std::size_t{0});
        // Share of the error of averages for that of strips, which counts twice the largest field, about.
        constexpr double share = 0.3;
        const double allowed = share * table.window.error / (2.0 * (std::sqrt(1.7 / (nearest * nearest * nearest)) + cut_));
        choice_ = StripChoice(stack, all, 0, {-far, far, -far, far},
                              0.2 * static_cast<double>(table.pixels.size()) * 8.0 *
                                  static_cast<double>(table.point_places.size() * table.point_places.size()),
                              allowed);
        double size = 0.0;  // largest phase of a line, from the middle of a pixel
        for (const Strip& strip : stack.strips) {
            size = std::max(size, strip.farthest() * table.window.step * std::sqrt(0.5));
        }
        std::size_t waves = 1;
        while (RimStripTable::rest_of(size, waves) * cut_ > 1.5 * allowed && waves < RimStripTable::most_waves) {
            ++waves;
        }
        strips_ = cache<RimStripTable>.get(stack.strips, choice_.count, stack.amplitude, waves, table);
        terms_ = cache<StripTerms>.get(stack.strips, choice_.count, stack.terms);
    }

    static constexpr double aimed = 0.95;  // part of the allowed error that may come from strips that are left out

    // Subtract the strips from the averages in scratch.out; return bounds on the errors of these.
    std::vector<double> subtract(const Batch& batch, RimScratch& scratch) const {
        const std::size_t lanes = RimKernels::lanes(batch.level), here = batch.errors.size();
        thread_local ChordalScratch<float> chordal;
        thread_local Floats moduli, lights, local, series, at;
        const float* const fields = fields_of(batch, chordal);
        dispatch_widest(batch.level,
                        [&](auto isa) LOMMEL_INLINE_LAMBDA { strip_light(isa, *strips_, fields, moduli, lights); });
        // Per lane, those beyond the last pupil as of it: numbers of RimErrors, error of the strips' field, allowed error.
        struct alignas(64) Lanes {
            float rms[most_pupils], wide[most_pupils], narrow[most_pupils], rounding[most_pupils], largest[most_pupils],
                field[most_pupils], off[most_pupils], allowed[most_pupils], own[most_pupils], disk[most_pupils],
                of_field[most_pupils], left[most_pupils], most[most_pupils], square[most_pupils], light[most_pupils],
                fields[most_pupils], sup[most_pupils], turned[rim_most_turns][most_pupils], size[3][most_pupils];
        } of;
        constexpr float above = 1.00001f;  // covers roundings of bounds
        std::vector<double> bounds(here, 0.0);
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const std::size_t p = std::min(lane, here - 1);
            const RimErrors& errors = batch.errors[p];
            const auto put = [&](float* to, double value) { to[lane] = above * static_cast<float>(value); };
            put(of.rms, errors.rms);
            put(of.wide, errors.squares[0]);
            put(of.narrow, errors.squares[1]);
            put(of.rounding, errors.rounding);
            put(of.largest, errors.largest);
            put(of.field, errors.field);
            put(of.off, error_of(batch.first + p));
            put(of.fields, errors.fields);
            for (std::size_t n = 0; n < rim_most_turns; ++n) {
                put(of.turned[n], errors.turned[n]);
            }
            for (std::size_t e = 0; e < 2; ++e) {
                put(of.size[e], std::sqrt(errors.squares[e]));
            }
            put(of.size[2], std::sqrt(2.0 * static_cast<double>(table_.rims.size()) * errors.largest));
            of.allowed[lane] =
                static_cast<float>(aimed * (batch.allowed != nullptr ? batch.allowed[batch.first + p] : table_.window.error));
        }
        const float pixels = above * static_cast<float>(batch.errors[0].pixels),
                    rest = above * static_cast<float>(strips_->rest),
                    quadrature = above * static_cast<float>(table_.off_strips),
                    units = 0x1p-24f * static_cast<float>(strips_->points * strips_->points + 32);
        for (const RimJob& job : batch.jobs) {
            for (std::size_t i = 0; i < job.count; ++i) {
                const std::size_t pixel = job.to[i] / lanes;
                const std::int64_t y = batch.top + static_cast<std::int64_t>(pixel / batch.width),
                                   x = batch.left + static_cast<std::int64_t>(pixel % batch.width);
                const double nearer = table_.window.nearest() /
                                      (table_.window.step * std::hypot(std::max(0.0, std::abs(static_cast<double>(y)) - 0.5),
                                                                       std::max(0.0, std::abs(static_cast<double>(x)) - 0.5)));
                float* const out = scratch.out.data() + job.to[i];
                // Errors without strips; roots of the mean intensity of the disk and its error; errors if strips are left out.
                const RimPixels& here_off = *job.pixels;
                const float angles = static_cast<float>(here_off.off_angles), wide = static_cast<float>(here_off.off_radii[0]),
                            narrow = static_cast<float>(here_off.off_radii[1]), gain = static_cast<float>(here_off.gain),
                            dropped = static_cast<float>(here_off.dropped), falls = static_cast<float>(std::min(1.0, nearer));
                // Whether strips of these root mean squares are too bright to be left out.
                const auto too_bright = [&](const float* roots) {
                    bool any = false;
                    for (std::size_t lane = 0; lane < lanes; ++lane) {
                        const float interpolated = angles * of.rms[lane] +
                                                   std::min(wide * of.wide[lane], narrow * of.narrow[lane]) +
                                                   gain * of.rounding[lane] + dropped * of.largest[lane] + pixels;
                        const float of_field = falls * of.field[lane],
                                    root = std::sqrt(std::max(0.0f, out[lane]) + interpolated),
                                    strips = above * roots[lane] + of.off[lane];
                        of.of_field[lane] = of_field;
                        of.own[lane] = interpolated + 2.0f * of_field * root + of_field * of_field;
                        of.disk[lane] = root + of_field;
                        of.left[lane] = strips * (2.0f * of.disk[lane] + strips);
                        any |= !(of.own[lane] + of.left[lane] <= of.allowed[lane]);  // also if it is not a number
                    }
                    return any;
                };
                dispatch_widest(batch.level,
                                [&](auto isa) LOMMEL_INLINE_LAMBDA { strip_bound(isa, *strips_, moduli, y, x, of.sup); });
                bool bright = too_bright(of.sup);
                if (bright) {
                    dispatch_widest(batch.level,
                                    [&](auto isa) LOMMEL_INLINE_LAMBDA { root_light(isa, *strips_, lights, y, x, of.most); });
                    bright = too_bright(of.most);
                }
                if (bright) {
                    // Error of what strips add, from root mean squares of fields at the points; products: whether they have the
                    // disk's field there.
                    const float* const turned = of.turned[here_off.turns - 1];
                    const float off_turns = above * static_cast<float>(here_off.off_turns),
                                off_places[3] = {above * static_cast<float>(here_off.off_places[0]),
                                                 above * static_cast<float>(here_off.off_places[1]),
                                                 above * static_cast<float>(here_off.off_places[2])};
                    const auto off = [&](std::size_t lane, float strips, float disk, bool products) {
                        // Products are left out of the average over the pixel, not over its points.
                        const float field = of.off[lane] + rest * of.sup[lane],
                                    of_disk = of.of_field[lane] + of.fields[lane] + off_turns * turned[lane] +
                                              std::min({off_places[0] * of.size[0][lane], off_places[1] * of.size[1][lane],
                                                        off_places[2] * of.size[2][lane]}),
                                    product =
                                        products
                                            ? of_disk * (strips + field) + disk * field
                                            : disk * (std::min(of.most[lane], std::sqrt(strips * strips + quadrature)) + field);
                        return quadrature + 2.0f * product + field * (2.0f * strips + field) +
                               units * strips * (strips + 2.0f * disk);
                    };
                    const RimCut cut{{*job.pixels, y, x, job.turned, job.quarters[i]}, job.at[i]};
                    dispatch_widest(batch.level, [&](auto isa) LOMMEL_INLINE_LAMBDA {
                        for_taps(choice_.count.taps, [&](auto taps) LOMMEL_INLINE_LAMBDA {
                            cut_pixel<decltype(taps)::value>(isa, table_, *strips_, fields, cut, series, at, out, of.square);
                        });
                    });
                    // The products are left out where, for all pupils, what they add is within what is allowed.
                    bool products = false;
                    for (std::size_t lane = 0; lane < lanes; ++lane) {
                        of.left[lane] = off(lane, std::sqrt(of.square[lane]), of.disk[lane], false);
                        products |= !(of.own[lane] + of.left[lane] <= of.allowed[lane]);
                    }
                    if (products) {
                        dispatch_widest(batch.level, [&](auto isa) LOMMEL_INLINE_LAMBDA {
                            const auto add = [&](auto rims) LOMMEL_INLINE_LAMBDA {
                                cut_products<decltype(rims)::value>(isa, table_, scratch.kept.data(), cut, at, local, out,
                                                                    of.light);
                            };
                            table_.rims.size() == 1 ? add(Size<1>{}) : add(Size<2>{});
                        });
                        for (std::size_t lane = 0; lane < here; ++lane) {
                            of.left[lane] = off(lane, std::sqrt(of.square[lane]), std::sqrt(of.light[lane]), true);
                        }
                    }
                }
                for (std::size_t lane = 0; lane < here; ++lane) {
                    const double bound = static_cast<double>(above * (of.own[lane] + of.left[lane]));
                    bounds[lane] = bound < 1e30 ? std::max(bounds[lane], bound) : std::numeric_limits<double>::infinity();
                }
            }
        }
        return bounds;
    }

   private:
    // Fields of all lines of a batch, at the places of their tables.
    const float* fields_of(const Batch& batch, ChordalScratch<float>& scratch) const {
        using Kernels = ChordKernels<float>;
        const std::size_t lanes = Kernels::lanes(batch.level), terms = stack_.terms.size(), here = batch.errors.size();
        const TermClasses classes(stack_.terms);
        const ChordLanes order{lanes, true};
        scratch.strip_coefficients.resize(terms * lanes);
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const double* const own = stack_.outer.data() + (batch.first + lane % here) * terms;
            for (std::size_t j = 0; j < terms; ++j) {
                scratch.strip_coefficients[j * lanes + order.place(lane)] = Kernels::unit * own[classes.order[j]];
            }
        }
        const std::array<ChordalTables<float>, 2> none;
        const StripTables<float> tables{std::shared_ptr<const StripTable<float>>(strips_, &strips_->lines), nullptr, terms_,
                                        nullptr};
        const ChordalBatch<float> of{batch.level, stack_, nullptr, here, 0.0, none, scratch, tables};
        of.strip_fields([&](std::size_t i, float* sums) {
            const StripLine& line = terms_->points.lines[i];
            Kernels::strip_nodes(batch.level, line, *terms_, strips_->lines.weights.data() + line.first_node,
                                 scratch.strip_coefficients.data(), nullptr, sums);
        });
        return scratch.strip_fields.data();
    }
    // Bound on the error of the strips' field, which changes by at most `cut_` over a unit of v.
    double error_of(std::size_t pupil) const {
        double sum = 0.0, degree = 0.0;
        for (std::size_t j = 0; j < stack_.terms.size(); ++j) {
            sum += std::abs(stack_.outer[pupil * stack_.terms.size() + j]);
            degree = std::max(degree, static_cast<double>(stack_.terms[j].n));
        }
        const double phases = unit_roundoff * (static_cast<double>(stack_.terms.size()) + degree + 7.0) * sum;
        return choice_.error + choice_.misfits * strips_->misfit +
               cut_ * (choice_.count.spacing * 0.5001 / static_cast<double>(RimStripTable::fractions) +
                       2.0 * (phases + choice_.rounding(stack_.terms.size(), true) +
                              single_roundoff * static_cast<double>(4 * strips_->waves + 8)));
    }

    const DiskStack& stack_;
    const RimTable& table_;
    double cut_ = 0.0;  // area of the strips / pi
    StripChoice choice_;
    std::shared_ptr<const RimStripTable> strips_;
    std::shared_ptr<const StripTerms> terms_;
};

}  // namespace lommel
