// Fields of strips cut out of a disk, as by vanes: quadrature on a few lines along each strip, whose fields in the direction of
// the strip are tabulated and interpolated (docs/certificate-chords.md, section 8, "Strips"). Vector lanes are pupils.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/base/pi.hpp"
#include "lommel/base/product.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/bounds/strips.hpp"
#include "lommel/chordal/tables.hpp"
#include "lommel/chordal/transform.hpp"
#include "lommel/special/least_squares.hpp"
#include "lommel/special/legendre.hpp"
#include "lommel/special/radial_polynomials.hpp"

namespace lommel {

// Interpolation of waves exp(-i spacing (place) t), |t| <= 1, between places -(taps/2 - 1) .. taps/2, by the real weights with the
// least mean square error over t. Weights are real, so that t > 0 is enough; Gauss's rule is exact there to 1e-30.
class Interpolation {
   public:
    Interpolation(std::size_t taps, double spacing) : taps_(taps), t_(nodes), root_(nodes), waves_(2 * nodes * taps) {
        gauss_legendre(nodes, t_.data(), root_.data());
        for (std::size_t g = 0; g < nodes; ++g) {
            t_[g] = 0.5 * spacing * (1.0 + t_[g]);
            root_[g] = std::sqrt(0.5 * root_[g]);
            for (std::size_t k = 0; k < taps; ++k) {
                put(waves_.data() + 2 * g * taps + k, taps, g, static_cast<double>(k) - static_cast<double>(taps / 2 - 1));
            }
        }
    }
    // Find the weights of `count` places from 0 to 1: to weights[place][tap]. Return the largest root mean square error over t of a
    // wave, for weights that are rounded to double.
    double find(const std::vector<double>& places, double* weights) const {
        const std::size_t count = places.size();
        std::vector<double> wanted(2 * nodes * count), found(taps_ * count), made(2 * nodes * count), squares(count, 0.0);
        for (std::size_t g = 0; g < nodes; ++g) {
            for (std::size_t i = 0; i < count; ++i) {
                put(wanted.data() + 2 * g * count + i, count, g, places[i]);
            }
        }
        least_squares(2 * nodes, taps_, count, waves_.data(), wanted.data(), found.data());
        product(waves_.data(), 2 * nodes, taps_, found.data(), count, 1, made.data());
        for (std::size_t j = 0; j < made.size(); ++j) {
            squares[j % count] += (made[j] - wanted[j]) * (made[j] - wanted[j]);
        }
        double most = 0.0;
        for (std::size_t i = 0; i < count; ++i) {
            double size = 1.0;
            for (std::size_t k = 0; k < taps_; ++k) {
                weights[i * taps_ + k] = found[k * count + i];
                size += std::abs(weights[i * taps_ + k]);
            }
            most = std::max(most, std::sqrt(squares[i]) + unit_roundoff * static_cast<double>(taps_ + 8) * size);
        }
        return most;
    }

   private:
    static constexpr std::size_t nodes = 32;

    // Write real and imaginary part of the wave of a place at a node, times the root of the node's weight.
    void put(double* to, std::size_t stride, std::size_t g, double place) const {
        to[0] = root_[g] * std::cos(place * t_[g]);
        to[stride] = root_[g] * std::sin(place * t_[g]);
    }

    std::size_t taps_;
    std::vector<double> t_, root_, waves_;  // waves_: [node][re, im][tap]
};

// Interpolations to choose from: the error of each, half way between two places, with which it hardly changes from place to place.
struct Interpolations {
    struct Choice {
        std::size_t taps;
        double spacing, misfit;
    };
    std::vector<Choice> choices;

    Interpolations() {
        for (std::size_t taps = 4; taps <= most_taps; taps += 2) {
            for (double spacing = 0.55 * pi; spacing > 0.1 * pi; spacing *= 0.92) {
                double weights[most_taps];
                choices.push_back({taps, spacing, 1.02 * Interpolation(taps, spacing).find({0.5}, weights)});
            }
        }
    }
    bool is() const { return true; }
    std::size_t bytes() const { return choices.size() * sizeof(Choice); }
    static constexpr std::size_t most_bytes = 1 << 16;
};

// Line along a strip, with the line at -s if the strip is symmetric. The nodes at +-t and +-s are summed first, with parities in s
// as two sums, `sums` = 2, or one if s = 0.
struct StripLine {
    std::size_t direction;  // index of its direction
    std::size_t nodes, points;  // number of nodes t >= 0, and of points +-t, +-s at each
    std::size_t first, first_node;  // places of its points, of its nodes, among those of all lines
    bool mirrored, turned, both;  // turned: the points at -s are at -t
    std::size_t sums;
    wide s;
};

// Points of the lines of all strips. weights: of nodes; x, y: of points, [line][node][point: +s +t, +s -t, -s +t, -s -t].
struct StripPoints {
    std::vector<StripLine> lines;
    std::vector<double> cosines, sines;  // of the directions
    std::vector<wide> t, weights, x, y;

    StripPoints(const std::vector<Strip>& strips, const StripCount& count) {
        const wide pi = std::acos(wide(-1));
        std::vector<wide> at(count.lines), of(count.lines), eta(count.nodes), gauss(count.nodes);
        gauss_legendre(count.lines, at.data(), of.data());
        gauss_legendre(count.nodes, eta.data(), gauss.data());
        for (const Strip& strip : strips) {
            std::size_t direction = 0;
            while (direction < cosines.size() && (cosines[direction] != strip.cosine || sines[direction] != strip.sine)) {
                ++direction;
            }
            if (direction == cosines.size()) {
                cosines.push_back(strip.cosine);
                sines.push_back(strip.sine);
            }
            const wide half = (static_cast<wide>(strip.high) - strip.low) / 2,
                       middle = (static_cast<wide>(strip.high) + strip.low) / 2;
            for (std::size_t j = 0; j < count.lines; ++j) {
                const bool central = !strip.mirrored && strip.symmetric() && 2 * j + 1 == count.lines;
                const wide s = central ? wide(0) : middle + half * at[j];
                if (!strip.mirrored && strip.symmetric() && 2 * j + 1 < count.lines) {
                    continue;  // the line at -s stands for it
                }
                const wide end = std::sqrt((1 - s) * (1 + s)), from = strip.beginning(s);
                const bool folds = strip.symmetric() && s != 0, both = strip.both() || strip.whole();
                StripLine line{direction,
                               0,
                               std::size_t{folds ? 2u : 1u} * (both ? 2 : 1),
                               x.size(),
                               t.size(),
                               folds,
                               strip.turned,
                               both,
                               std::size_t{s == 0 ? 1u : 2u},
                               s};
                for (std::size_t k = strip.whole() ? count.nodes / 2 : 0; k < count.nodes; ++k, ++line.nodes) {
                    const wide along = (end + from) / 2 + (end - from) / 2 * eta[k];
                    t.push_back(strip.behind && !strip.ahead ? -along : along);
                    weights.push_back(half * of[j] * (end - from) / 2 * gauss[k] / pi);
                    for (std::size_t point = 0; point < line.points; ++point) {
                        const bool other = point >= (both ? 2u : 1u);
                        const wide u = (both && point % 2 == 1) != (strip.turned && other) ? -t.back() : t.back();
                        const wide v = other ? -s : s;
                        x.push_back(static_cast<wide>(strip.cosine) * u - static_cast<wide>(strip.sine) * v);
                        y.push_back(static_cast<wide>(strip.sine) * u + static_cast<wide>(strip.cosine) * v);
                    }
                }
                lines.push_back(line);
            }
        }
    }
};

// Quadrature weights times pupil amplitude at the nodes, [line][node].
inline std::vector<double> strip_weights(const StripPoints& points, const Amplitude& light) {
    std::vector<double> weights;
    for (const StripLine& line : points.lines) {
        for (std::size_t k = line.first_node; k < line.first_node + line.nodes; ++k) {
            weights.push_back(static_cast<double>(points.weights[k] * light.at(line.s * line.s + points.t[k] * points.t[k])));
        }
    }
    return weights;
}

// Zernike terms at the points of strips, [line][node][index in classes.order][point].
struct StripTerms {
    std::vector<Strip> strips;
    StripCount count;
    std::vector<ZernikeTerm> terms;
    StripPoints points;
    Doubles values;

    StripTerms(const std::vector<Strip>& of, const StripCount& n, const std::vector<ZernikeTerm>& list)
        : strips(of), count(n), terms(list), points(of, n), values(points.x.size() * list.size()) {
        const ZernikeValues polynomials(list, TermClasses(list).order);
        for (const StripLine& line : points.lines) {
            look();
            for (std::size_t i = 0; i < line.nodes * line.points; ++i) {
                const std::size_t point = line.first + i, node = point - i % line.points;
                polynomials.at(points.x[point], points.y[point], [&](std::size_t j, wide value) {
                    values[node * list.size() + j * line.points + i % line.points] = static_cast<double>(value);
                });
            }
        }
    }
    // Call put(point, value) for a term at all points; term: index in classes.order.
    template <class Put>
    void column(std::size_t term, const Put& put) const {
        for (const StripLine& line : points.lines) {
            for (std::size_t i = 0; i < line.nodes * line.points; ++i) {
                const std::size_t point = line.first + i, node = point - i % line.points;
                put(point, values[node * terms.size() + term * line.points + i % line.points]);
            }
        }
    }
    bool is(const std::vector<Strip>& of, const StripCount& n, const std::vector<ZernikeTerm>& list) const {
        return count.lines == n.lines && count.nodes == n.nodes && strips == of && terms == list;
    }
    std::size_t bytes() const { return values.size() * sizeof(double) + 4 * points.x.size() * sizeof(wide); }
    static constexpr std::size_t most_bytes = std::size_t{32} << 20;
};

// Tables of the strips of an aperture for a window: waves of the nodes at the places of the table, and the interpolation.
template <class Real>
struct StripTable {
    using Values = Aligned<Real>;
    struct Direction {
        std::size_t places;  // the table has the places 1 - places .. places - 1
        Values weights;  // [row][column][tap]
        std::vector<std::int32_t> first;  // [row][column]: index in the table of the first tap
    };
    struct Line {
        Values cosines, sines;  // of the phases t v: [place >= 0][node]
        Values turns;  // cosine and sine of the phase s v of the pixel: [row][column][2]; empty if s = 0
    };

    std::vector<Strip> strips;
    StripCount count;
    Amplitude amplitude;
    WindowAxis rows, columns;
    double step;
    StripPoints points;
    std::vector<double> weights;  // quadrature weight times pupil amplitude, [line][node]
    std::vector<Direction> directions;
    std::vector<Line> lines;
    double misfit = 0.0;  // largest error of the interpolation
    std::size_t sums = 0, most_places = 0;  // number of sums over lines, largest number of places of a direction

    StripTable(const std::vector<Strip>& of, const StripCount& n, const Amplitude& light, const WindowAxis& down,
               const WindowAxis& across, double pixel_step)
        : strips(of), count(n), amplitude(light), rows(down), columns(across), step(pixel_step), points(of, n),
          weights(strip_weights(points, light)) {
        const std::vector<double> y = rows.places(step), x = columns.places(step);
        const std::size_t pixels = y.size() * x.size();
        const Interpolation interpolation(count.taps, count.spacing);
        for (std::size_t d = 0; d < points.cosines.size(); ++d) {
            look();
            Direction made{0, Values(pixels * count.taps), std::vector<std::int32_t>(pixels)};
            double farthest = 0.0;
            std::vector<double> fractions(x.size()), found(x.size() * count.taps);
            for (std::size_t i = 0; i < pixels; i += x.size()) {
                for (std::size_t j = 0; j < x.size(); ++j) {
                    const double at = along(d, x[j], y[i / x.size()]) / count.spacing;
                    fractions[j] = at - std::floor(at);
                    farthest = std::max(farthest, std::abs(at));
                    made.first[i + j] =
                        static_cast<std::int32_t>(std::floor(at)) - static_cast<std::int32_t>(count.taps / 2 - 1);
                }
                misfit = std::max(misfit, interpolation.find(fractions, found.data()));
                for (std::size_t j = 0; j < x.size(); ++j) {
                    const double* const own = found.data() + j * count.taps;
                    std::transform(own, own + count.taps, made.weights.data() + (i + j) * count.taps,
                                   [](double weight) { return static_cast<Real>(weight); });
                }
            }
            made.places = static_cast<std::size_t>(std::ceil(farthest)) + count.taps / 2 + 1;
            for (std::int32_t& first : made.first) {
                first += static_cast<std::int32_t>(made.places) - 1;
            }
            most_places = std::max(most_places, made.places);
            directions.push_back(std::move(made));
        }
        for (const StripLine& line : points.lines) {
            look();
            const std::size_t size = directions[line.direction].places * line.nodes;
            Line made{Values(size), Values(size), Values(line.sums == 2 ? 2 * pixels : 0)};
            for (std::size_t i = 0; i < size; ++i) {
                const wide angle = static_cast<wide>(count.spacing) * static_cast<wide>(i / line.nodes) *
                                   points.t[line.first_node + i % line.nodes];
                made.cosines[i] = static_cast<Real>(std::cos(angle));
                made.sines[i] = static_cast<Real>(std::sin(angle));
            }
            for (std::size_t i = 0; i < made.turns.size() / 2; ++i) {
                const wide c = points.cosines[line.direction], s = points.sines[line.direction];
                const wide angle = line.s * (c * y[i / x.size()] - s * x[i % x.size()]);
                made.turns[2 * i] = static_cast<Real>(std::cos(angle));
                made.turns[2 * i + 1] = static_cast<Real>(std::sin(angle));
            }
            lines.push_back(std::move(made));
            sums += line.sums;
        }
    }
    bool is(const std::vector<Strip>& of, const StripCount& n, const Amplitude& light, const WindowAxis& down,
            const WindowAxis& across, double pixel_step) const {
        return count == n && step == pixel_step && strips == of && amplitude == light && rows == down && columns == across;
    }
    std::size_t bytes() const {
        std::size_t values = 0;
        for (const Direction& direction : directions) {
            values += 2 * direction.weights.size();
        }
        for (const Line& line : lines) {
            values += 2 * line.cosines.size() + line.turns.size();
        }
        return values * sizeof(Real);
    }
    static constexpr std::size_t most_bytes = std::size_t{64} << 20;
    // Number of reals in the table of one sum over a line.
    std::size_t room(std::size_t lanes) const { return 2 * (2 * most_places - 1) * lanes; }

   private:
    double along(std::size_t d, double x, double y) const { return points.cosines[d] * x + points.sines[d] * y; }
};

// Tables of the strips for a single image. The spacing of places is such that pixels of a row (of a column, for steep directions,
// |sine| > |cosine|: its `axis`) are a whole number of places apart, `per`: vector lanes are pixels, which share the weights.
template <class Real>
struct LoneStripTable {
    using Values = Aligned<Real>;
    struct Direction {
        bool steep;
        double spacing;  // negative if places run against the axis
        std::size_t places, padded, per,
            length;  // places p >= 0, rounded up to vectors; fields are [p % per][p / per], of `length`
        Values weights;  // [line across the axis][tap]
        std::vector<std::int32_t> taps;  // [line across the axis][tap]: index of the first pixel's place in a field
        std::vector<std::int32_t> slots;  // [place 1 - places .. places - 1]: index in a field

        std::size_t room() const { return per * length; }
    };
    struct Line {
        Values cosines, sines;  // of the phases t v: [node][place >= 0]
        Values along[2], across;  // cosines and sines of the phases s v: along the axis; [line across it][2]
    };

    std::vector<Strip> strips;
    StripCount count;
    Amplitude amplitude;
    WindowAxis rows, columns;
    double step;
    std::size_t lanes;
    StripPoints points;
    std::vector<double> weights;  // as of StripTable
    std::vector<Direction> directions;
    std::vector<Line> lines;
    double misfit = 0.0;
    std::size_t sums = 0, room = 0;  // number of sums over lines, largest number of reals of a field
    bool steep = false;  // whether any direction is

    LoneStripTable(const std::vector<Strip>& of, const StripCount& n, const Amplitude& light, const WindowAxis& down,
                   const WindowAxis& across, double pixel_step, std::size_t in)
        : strips(of), count(n), amplitude(light), rows(down), columns(across), step(pixel_step), lanes(in), points(of, n),
          weights(strip_weights(points, light)) {
        const std::vector<double> places[2] = {rows.places(step), columns.places(step)};
        for (std::size_t d = 0; d < points.cosines.size(); ++d) {
            look();
            const double c = points.cosines[d], s = points.sines[d], along = std::abs(s) > std::abs(c) ? s : c;
            const std::size_t per = static_cast<std::size_t>(std::ceil(std::abs(along) * step / count.spacing));
            Direction made{std::abs(s) > std::abs(c), along * step / static_cast<double>(per), 0, 0, per, 0, {}, {}, {}};
            const std::vector<double>&axis = places[made.steep ? 0 : 1], &others = places[made.steep ? 1 : 0];
            std::vector<double> fractions, found(others.size() * count.taps);
            std::vector<std::int64_t> low;
            for (const double other : others) {
                const double at = (along * axis[0] + (made.steep ? c : s) * other) / made.spacing;
                low.push_back(static_cast<std::int64_t>(std::floor(at)));
                fractions.push_back(at - std::floor(at));
            }
            misfit = std::max(misfit, Interpolation(count.taps, std::abs(made.spacing)).find(fractions, found.data()));
            made.weights = Values(found.size());
            std::transform(found.begin(), found.end(), made.weights.begin(), [](double w) { return static_cast<Real>(w); });
            const auto [least, most] = std::minmax_element(low.begin(), low.end());
            const std::int64_t before = static_cast<std::int64_t>(count.taps / 2 - 1),
                               end = *most + static_cast<std::int64_t>(per * (axis.size() - 1) + count.taps / 2);
            made.places = static_cast<std::size_t>(std::max(std::abs(*least - before), std::abs(end))) + 1;
            made.padded = (made.places + lanes - 1) / lanes * lanes;
            made.length = (2 * made.places - 2) / per + 1 + lanes;
            const auto slot = [&](std::size_t place) {
                return static_cast<std::int32_t>(place % per * made.length + place / per);
            };
            for (const std::int64_t first : low) {
                for (std::size_t k = 0; k < count.taps; ++k) {
                    const std::int64_t place = first - before + static_cast<std::int64_t>(k + made.places) - 1;
                    made.taps.push_back(slot(static_cast<std::size_t>(place)));
                }
            }
            for (std::size_t place = 0; place < 2 * made.places - 1; ++place) {
                made.slots.push_back(slot(place));
            }
            steep = steep || made.steep;
            room = std::max(room, 2 * made.room());
            directions.push_back(std::move(made));
        }
        for (const StripLine& line : points.lines) {
            look();
            const Direction& of_line = directions[line.direction];
            Line made{Values(line.nodes * of_line.padded), Values(line.nodes * of_line.padded), {}, {}};
            for (std::size_t i = 0; i < made.cosines.size(); ++i) {
                const wide angle = static_cast<wide>(of_line.spacing) * static_cast<wide>(i % of_line.padded) *
                                   points.t[line.first_node + i / of_line.padded];
                made.cosines[i] = static_cast<Real>(std::cos(angle));
                made.sines[i] = static_cast<Real>(std::sin(angle));
            }
            if (line.sums == 2) {
                const wide by[2] = {line.s * points.cosines[line.direction], -line.s * points.sines[line.direction]};
                const std::size_t axis = of_line.steep ? 0 : 1;
                for (Values& values : made.along) {
                    values.assign((places[axis].size() + lanes - 1) / lanes * lanes, Real(0));
                }
                for (std::size_t i = 0; i < places[axis].size(); ++i) {
                    made.along[0][i] = static_cast<Real>(std::cos(by[axis] * places[axis][i]));
                    made.along[1][i] = static_cast<Real>(std::sin(by[axis] * places[axis][i]));
                }
                for (const double other : places[1 - axis]) {
                    made.across.push_back(static_cast<Real>(std::cos(by[1 - axis] * other)));
                    made.across.push_back(static_cast<Real>(std::sin(by[1 - axis] * other)));
                }
            }
            lines.push_back(std::move(made));
            sums += line.sums;
        }
    }
    bool is(const std::vector<Strip>& of, const StripCount& n, const Amplitude& light, const WindowAxis& down,
            const WindowAxis& across, double pixel_step, std::size_t in) const {
        return count == n && step == pixel_step && lanes == in && strips == of && amplitude == light && rows == down &&
               columns == across;
    }
    std::size_t bytes() const {
        std::size_t values = 0;
        for (const Direction& direction : directions) {
            values += 2 * direction.weights.size() + direction.slots.size();
        }
        for (const Line& line : lines) {
            values += 2 * (line.cosines.size() + line.along[0].size()) + line.across.size();
        }
        return values * sizeof(Real);
    }
    static constexpr std::size_t most_bytes = std::size_t{96} << 20;
};

// Sum the values g at the points of a node: to sums[sum over +-s][p re, im, m re, im], where p and m are even and odd in t. With
// A = F(s) + F(-s), and B = -i (F(s) - F(-s)), the field of both lines is cos(s v) A + sin(s v) B.
template <class V, class Real>
LOMMEL_INLINE void fold_points(const StripLine& line, const V (&re)[4], const V (&im)[4], std::size_t stride, Real* sums) {
    constexpr std::size_t lanes = sizeof(V) / sizeof(Real);
    V p[2][4] = {};
    const std::size_t sides = line.mirrored ? 2 : 1;
    for (std::size_t side = 0; side < sides; ++side) {
        const std::size_t a = side * (line.both ? 2 : 1);
        const bool both = line.both;
        p[side][0] = both ? re[a] + re[a + 1] : re[a];
        p[side][1] = both ? im[a] + im[a + 1] : im[a];
        p[side][2] = both ? re[a] - re[a + 1] : re[a];
        p[side][3] = both ? im[a] - im[a + 1] : im[a];
    }
    if (line.turned) {
        p[1][2] = V{} - p[1][2];
        p[1][3] = V{} - p[1][3];
    }
    for (std::size_t part = 0; part < 4; ++part) {
        store(sums + part * lanes, p[0][part] + p[1][part]);
    }
    if (line.sums == 2) {
        Real* const other = sums + stride;
        for (std::size_t part = 0; part < 4; part += 2) {
            store(other + part * lanes, p[0][part + 1] - p[1][part + 1]);
            store(other + (part + 1) * lanes, p[1][part] - p[0][part]);
        }
    }
}

// Pupil function, times weights, at the nodes of a line, folded: to sums[sum][node][4][lane]. kept: if not null, receives the
// values at the points, [node][point][re, im][lane].
template <std::size_t R, class I, class Real>
LOMMEL_INLINE void strip_nodes(I, const StripLine& line, const StripTerms& terms, const double* weights,
                               const double* coefficients, Real* kept, Real* sums) {
    using Wave = Waves<I, Real>;
    using V = typename Wave::V;
    constexpr std::size_t lanes = Wave::lanes, C = Wave::vectors;
    const std::size_t count = terms.terms.size();
    for (std::size_t k = 0; k < line.nodes; ++k) {
        typename I::pack phases[R][C];
        for (std::size_t r = 0; r < R; ++r) {
            for (std::size_t c = 0; c < C; ++c) {
                phases[r][c] = Wave::zero();
            }
        }
        multiply<R, C>(terms.values.data() + (line.first + k * R) * count, coefficients, count, phases);
        const V w = splat<V>(static_cast<Real>(weights[k]));
        V re[4] = {}, im[4] = {};
        for (std::size_t r = 0; r < R; ++r) {
            Wave::wave(Wave::phase(phases[r]), im[r], re[r]);
            re[r] = re[r] * w;
            im[r] = im[r] * w;
            if (kept != nullptr) {
                store(kept + (2 * (k * R + r)) * lanes, re[r]);
                store(kept + (2 * (k * R + r) + 1) * lanes, im[r]);
            }
        }
        fold_points(line, re, im, 4 * line.nodes * lanes, sums + 4 * k * lanes);
    }
}

// As strip_nodes(), for `kept` values times a Zernike term of each lane: factors[point][lane].
template <class I, class Real>
LOMMEL_INLINE void strip_products(I, const StripLine& line, const Real* kept, const Real* factors, Real* sums) {
    using V = typename Waves<I, Real>::V;
    constexpr std::size_t lanes = Waves<I, Real>::lanes;
    for (std::size_t k = 0; k < line.nodes; ++k) {
        V re[4] = {}, im[4] = {};
        for (std::size_t r = 0; r < line.points; ++r) {
            const std::size_t point = k * line.points + r;
            const V z = load<V>(factors + point * lanes);
            re[r] = load<V>(kept + 2 * point * lanes) * z;
            im[r] = load<V>(kept + (2 * point + 1) * lanes) * z;
        }
        fold_points(line, re, im, 4 * line.nodes * lanes, sums + 4 * k * lanes);
    }
}

// Field of a line at the places of its table, from the folded nodes: table[place][re, im][lane].
template <std::size_t R, class I, class Real>
LOMMEL_INLINE void strip_places(I, const Real* nodes, std::size_t count, const Real* cosines, const Real* sines,
                                std::size_t place, std::size_t places, Real* table) {
    using V = typename Waves<I, Real>::V;
    constexpr std::size_t lanes = Waves<I, Real>::lanes;
    V even[R][2] = {}, odd[R][2] = {};
    for (std::size_t k = 0; k < count; ++k, nodes += 4 * lanes) {
        const V p = load<V>(nodes), q = load<V>(nodes + lanes), m = load<V>(nodes + 2 * lanes), n = load<V>(nodes + 3 * lanes);
        for (std::size_t r = 0; r < R; ++r) {
            const V c = splat<V>(cosines[(place + r) * count + k]), s = splat<V>(sines[(place + r) * count + k]);
            even[r][0] = even[r][0] + c * p;
            even[r][1] = even[r][1] + c * q;
            odd[r][0] = odd[r][0] + s * m;
            odd[r][1] = odd[r][1] + s * n;
        }
    }
    for (std::size_t r = 0; r < R; ++r) {
        Real *const up = table + 2 * (places - 1 + place + r) * lanes, *const down =
                                                                           table + 2 * (places - 1 - place - r) * lanes;
        store(up, even[r][0] + odd[r][1]);
        store(up + lanes, even[r][1] - odd[r][0]);
        store(down, even[r][0] - odd[r][1]);
        store(down + lanes, even[r][1] + odd[r][0]);
    }
}

template <class I, class Real>
LOMMEL_INLINE void strip_line(I isa, const StripTable<Real>& table, std::size_t line, const Real* nodes, Real* to) {
    constexpr std::size_t block = Waves<I, Real>::lanes * sizeof(Real) > 32 ? 4 : 2;
    const StripLine& of = table.points.lines[line];
    const std::size_t places = table.directions[of.direction].places;
    const Real *const cosines = table.lines[line].cosines.data(), *const sines = table.lines[line].sines.data();
    std::size_t place = 0;
    for (; place + block <= places; place += block) {
        strip_places<block>(isa, nodes, of.nodes, cosines, sines, place, places, to);
    }
    for (; place < places; ++place) {
        strip_places<1>(isa, nodes, of.nodes, cosines, sines, place, places, to);
    }
}

// Call of(Size<T>()) for the number of taps T of an interpolation.
template <class F>
LOMMEL_INLINE void for_taps(std::size_t taps, const F& of) {
    switch (taps) {
        case 4:
            return of(Size<4>{});
        case 6:
            return of(Size<6>{});
        case 8:
            return of(Size<8>{});
        case 10:
            return of(Size<10>{});
        default:
            return of(Size<most_taps>{});
    }
}

// Subtract the field of one line from a row of pixels: u[column][re, im][lane].
template <std::size_t T, bool Two, class I, class Real>
LOMMEL_INLINE void subtract_line(I, const StripTable<Real>& table, std::size_t line, const Real* fields, std::size_t other,
                                 std::size_t row, Real* u) {
    using V = typename Waves<I, Real>::V;
    constexpr std::size_t lanes = Waves<I, Real>::lanes;
    const typename StripTable<Real>::Direction& of = table.directions[table.points.lines[line].direction];
    const std::size_t width = table.columns.count;
    const Real *w = of.weights.data() + row * width * T, *turn = table.lines[line].turns.data() + (Two ? 2 * row * width : 0);
    const std::int32_t* const first = of.first.data() + row * width;
    for (std::size_t x = 0; x < width; ++x, w += T, u += 2 * lanes) {
        const Real* from = fields + static_cast<std::size_t>(first[x]) * 2 * lanes;
        V a[2] = {}, b[2] = {};
        for (std::size_t k = 0; k < T; ++k, from += 2 * lanes) {
            const V weight = splat<V>(w[k]);
            a[0] = a[0] + weight * load<V>(from);
            a[1] = a[1] + weight * load<V>(from + lanes);
            if constexpr (Two) {
                b[0] = b[0] + weight * load<V>(from + other);
                b[1] = b[1] + weight * load<V>(from + other + lanes);
            }
        }
        if constexpr (Two) {
            const V c = splat<V>(turn[2 * x]), s = splat<V>(turn[2 * x + 1]);
            a[0] = c * a[0] + s * b[0];
            a[1] = c * a[1] + s * b[1];
        }
        store(u, load<V>(u) - a[0]);
        store(u + lanes, load<V>(u + lanes) - a[1]);
    }
}

template <class I, class Real>
LOMMEL_INLINE void subtract_strips(I isa, const StripTable<Real>& table, const Real* fields, std::size_t row, Real* u) {
    const std::size_t room = table.room(Waves<I, Real>::lanes);
    for (std::size_t line = 0; line < table.lines.size(); ++line) {
        const bool two = table.points.lines[line].sums == 2;
        for_taps(table.count.taps, [&](auto taps) LOMMEL_INLINE_LAMBDA {
            constexpr std::size_t T = decltype(taps)::value;
            two ? subtract_line<T, true>(isa, table, line, fields, room, row, u)
                : subtract_line<T, false>(isa, table, line, fields, room, row, u);
        });
        fields += (two ? 2 : 1) * room;
    }
}

// As strip_line() for a single image, whose nodes have the same values in all lanes: to[re, im][slot].
template <class I, class Real>
LOMMEL_INLINE void lone_strip_line(I, const LoneStripTable<Real>& table, std::size_t line, const Real* nodes, Real* to) {
    using V = typename Waves<I, Real>::V;
    constexpr std::size_t lanes = Waves<I, Real>::lanes;
    const typename LoneStripTable<Real>::Direction& of = table.directions[table.points.lines[line].direction];
    const std::size_t count = table.points.lines[line].nodes;
    const Real *const cosines = table.lines[line].cosines.data(), *const sines = table.lines[line].sines.data();
    const std::int32_t* const middle = of.slots.data() + of.places - 1;
    const auto block = [&](std::size_t place, auto vectors) LOMMEL_INLINE_LAMBDA {
        constexpr std::size_t R = decltype(vectors)::value;
        V even[R][2] = {}, odd[R][2] = {};
        for (std::size_t k = 0; k < count; ++k) {
            const Real* const node = nodes + 4 * k * lanes;
            const V p = splat<V>(node[0]), q = splat<V>(node[lanes]), m = splat<V>(node[2 * lanes]),
                    n = splat<V>(node[3 * lanes]);
            for (std::size_t r = 0; r < R; ++r) {
                const std::size_t at = k * of.padded + place + r * lanes;
                const V c = load<V>(cosines + at), s = load<V>(sines + at);
                even[r][0] = even[r][0] + c * p;
                even[r][1] = even[r][1] + c * q;
                odd[r][0] = odd[r][0] + s * m;
                odd[r][1] = odd[r][1] + s * n;
            }
        }
        for (std::size_t r = 0; r < R; ++r) {
            Real up[2][lanes], down[2][lanes];
            store(up[0], even[r][0] + odd[r][1]);
            store(up[1], even[r][1] - odd[r][0]);
            store(down[0], even[r][0] - odd[r][1]);
            store(down[1], even[r][1] + odd[r][0]);
            const std::size_t from = place + r * lanes;
            for (std::size_t lane = 0; lane < lanes && from + lane < of.places; ++lane) {
                const std::ptrdiff_t at = static_cast<std::ptrdiff_t>(from + lane);
                for (std::size_t part = 0; part < 2; ++part) {
                    to[part * of.room() + static_cast<std::size_t>(middle[at])] = up[part][lane];
                    to[part * of.room() + static_cast<std::size_t>(middle[-at])] = down[part][lane];
                }
            }
        }
    };
    std::size_t place = 0;
    for (; place + 2 * lanes <= of.padded; place += 2 * lanes) {
        block(place, Size<2>{});
    }
    if (place < of.padded) {
        block(place, Size<1>{});
    }
}

// Subtract the field of one line from `count` vectors of pixels along the axis of its direction, the first at the pixel `first`:
// u[vector][re, im]. across: index of the row or column.
template <std::size_t T, bool Two, class I, class Real>
LOMMEL_INLINE void lone_subtract_line(I, const LoneStripTable<Real>& table, std::size_t line, const Real* fields,
                                      std::size_t across, std::size_t first, std::size_t count, Real* u) {
    using V = typename Waves<I, Real>::V;
    constexpr std::size_t lanes = Waves<I, Real>::lanes;
    const typename LoneStripTable<Real>::Direction& of = table.directions[table.points.lines[line].direction];
    const typename LoneStripTable<Real>::Line& own = table.lines[line];
    const std::size_t im = of.room(), other = table.room;
    V w[T];
    const Real* from[T];
    for (std::size_t k = 0; k < T; ++k) {
        w[k] = splat<V>(of.weights[across * T + k]);
        from[k] = fields + of.taps[across * T + k] + first;
    }
    V cb = {}, sb = {};
    if constexpr (Two) {
        cb = splat<V>(own.across[2 * across]);
        sb = splat<V>(own.across[2 * across + 1]);
    }
    for (std::size_t i = 0; i < count * lanes; i += lanes, u += 2 * lanes) {
        V a[2] = {}, b[2] = {};
        for (std::size_t k = 0; k < T; ++k) {
            const Real* const at = from[k] + i;
            a[0] = a[0] + w[k] * load<V>(at);
            a[1] = a[1] + w[k] * load<V>(at + im);
            if constexpr (Two) {
                b[0] = b[0] + w[k] * load<V>(at + other);
                b[1] = b[1] + w[k] * load<V>(at + other + im);
            }
        }
        if constexpr (Two) {
            const V ca = load<V>(own.along[0].data() + first + i), sa = load<V>(own.along[1].data() + first + i);
            const V c = ca * cb - sa * sb, s = sa * cb + ca * sb;
            a[0] = c * a[0] + s * b[0];
            a[1] = c * a[1] + s * b[1];
        }
        store(u, load<V>(u) - a[0]);
        store(u + lanes, load<V>(u + lanes) - a[1]);
    }
}

// Subtract the strips from a row of a single image: u[vector of columns][re, im]. Those of steep directions are subtracted from as
// many rows as a vector has lanes when the first of them is asked for, in the order of rows: band[column][re, im][row of the band].
template <class I, class Real>
LOMMEL_INLINE void lone_subtract_strips(I isa, const LoneStripTable<Real>& table, const Real* fields, std::size_t row,
                                        Real* band, Real* u) {
    using V = typename Waves<I, Real>::V;
    constexpr std::size_t lanes = Waves<I, Real>::lanes;
    const std::size_t width = table.columns.count, vectors = (width + lanes - 1) / lanes, in = row % lanes;
    const auto lines = [&](bool steep, const auto& visit) LOMMEL_INLINE_LAMBDA {
        const Real* field = fields;
        for (std::size_t line = 0; line < table.lines.size(); ++line) {
            const StripLine& of = table.points.lines[line];
            if (table.directions[of.direction].steep == steep) {
                for_taps(table.count.taps, [&](auto taps) LOMMEL_INLINE_LAMBDA {
                    of.sums == 2 ? visit(taps, Size<2>{}, line, field) : visit(taps, Size<1>{}, line, field);
                });
            }
            field += of.sums * table.room;
        }
    };
    if (table.steep && in == 0) {
        std::fill_n(band, 2 * lanes * vectors * lanes, Real(0));
        lines(true, [&](auto taps, auto sums, std::size_t line, const Real* field) LOMMEL_INLINE_LAMBDA {
            for (std::size_t x = 0; x < width; ++x) {
                lone_subtract_line<decltype(taps)::value, decltype(sums)::value == 2>(isa, table, line, field, x, row, 1,
                                                                                      band + 2 * x * lanes);
            }
        });
    }
    lines(false, [&](auto taps, auto sums, std::size_t line, const Real* field) LOMMEL_INLINE_LAMBDA {
        lone_subtract_line<decltype(taps)::value, decltype(sums)::value == 2>(isa, table, line, field, row, 0, vectors, u);
    });
    if (table.steep) {
        for (std::size_t i = 0; i < vectors; ++i) {
            Real here[2][lanes];
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                const Real* const at = band + 2 * (i * lanes + lane) * lanes + in;
                here[0][lane] = at[0];
                here[1][lane] = at[lanes];
            }
            Real* const to = u + 2 * i * lanes;
            store(to, load<V>(to) + load<V>(here[0]));
            store(to + lanes, load<V>(to + lanes) + load<V>(here[1]));
        }
    }
    for (std::size_t x = width; x < vectors * lanes; ++x) {
        u[2 * (vectors - 1) * lanes + x % lanes] = u[(2 * vectors - 1) * lanes + x % lanes] = Real(0);
    }
}

}  // namespace lommel
