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
#include "lommel/zernike/disk_stack.hpp"

namespace lommel {

// Errors of averages of a pupil without strips: of Gauss quadrature over pixels; what errors of interpolation and rounding are
// relative to; these of all pixels, `averages`; `field`: of the field, its root mean square over the Gauss points of a pixel;
// fields: of interpolation and rounding of fields.
struct RimErrors {
    double pixels, rms, squares[2], rounding, largest, averages, field, fields;

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

// Tables of strips for the Gauss points of pixels within `reach` of the axis, of which each has `gauss` along an axis.
struct RimStripTable {
    static constexpr std::size_t fractions = 2048;  // number of fractions of a spacing, at which fields are interpolated

    StripTable<float> lines;
    std::size_t reach, gauss;
    // Coordinates of Gauss points, along either axis; the same in fractions of the spacing.
    std::vector<double> places, scaled;
    std::vector<double> taps;  // [tap]: mean modulus of its weight
    Floats weights;  // [fraction][tap]
    std::vector<Floats>
        turns;  // [line], of the phases s v along y, along x: [place][cosine, sine along y, cosine, sine along x]
    double step, misfit, gain = 0.0;  // gain: largest sum of the moduli of weights

    RimStripTable(const std::vector<Strip>& strips, const StripCount& count, const Amplitude& light, const RimTable& table)
        : lines(strips, count, light, corners(table), corners(table), 1.0), reach(table.window.reach),
          gauss(table.gauss_places.size()), weights((fractions + 1) * count.taps), step(table.window.step) {
        for (std::size_t i = 0; i < (2 * reach + 1) * gauss; ++i) {
            const double pixel = static_cast<double>(i / gauss) - static_cast<double>(reach);
            places.push_back(step * (pixel + 0.5 * table.gauss_places[i % gauss]));
            scaled.push_back(places[i] / count.spacing * static_cast<double>(fractions));
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
        for (const StripLine& line : lines.points.lines) {
            const double c = static_cast<double>(line.s) * lines.points.cosines[line.direction],
                         s = -static_cast<double>(line.s) * lines.points.sines[line.direction];
            Floats made;
            for (const double place : places) {
                for (const double angle : {c * place, s * place}) {
                    made.push_back(static_cast<float>(std::cos(angle)));
                    made.push_back(static_cast<float>(std::sin(angle)));
                }
            }
            turns.push_back(std::move(made));
        }
    }
    bool is(const std::vector<Strip>& strips, const StripCount& count, const Amplitude& light, const RimTable& table) const {
        return lines.count == count && lines.strips == strips && lines.amplitude == light && step == table.window.step &&
               reach == table.window.reach && gauss == table.gauss_places.size();
    }
    std::size_t bytes() const {
        return lines.bytes() + (weights.size() + turns.size() * 4 * places.size()) * sizeof(float) +
               places.size() * sizeof(double);
    }
    static constexpr std::size_t most_bytes = std::size_t{32} << 20;
    // Largest distance of a point along an axis.
    static double farthest(const RimTable& table) {
        return table.window.step * (static_cast<double>(table.window.reach) + 0.5);
    }

   private:
    static WindowAxis corners(const RimTable& table) {
        return WindowAxis(std::vector<double>{-farthest(table), farthest(table)});
    }
};

// One pixel: index of its first angle in the ring; distances from the axis in pixels.
struct RimCut {
    const RimPixels& pixels;
    std::size_t at;
    std::int64_t y, x;
    bool turned;
    std::uint8_t quarter;
};

// Add to out[lane] what strips add to the average over a pixel, and store the averages of their intensity in square[lane],
// of that of the disk in light[lane]. fields:
// of lines, at the places of their tables; kept: RimScratch::kept.
template <std::size_t Rims, std::size_t T, class I>
LOMMEL_INLINE void cut_pixel(I, const RimTable& table, const RimStripTable& strips, const float* fields, const float* kept,
                             const RimCut& cut, Floats& local, float* out, float* square, float* light) {
    using V = typename I::floats;
    constexpr std::size_t lanes = sizeof(V) / sizeof(float), most_directions = 16;
    const StripTable<float>& lines = strips.lines;
    const RimPixels& pixels = cut.pixels;
    const std::size_t g = strips.gauss, radii = table.radii(), block = radii * Rims * 4 * lanes, room = lines.room(lanes);
    const std::size_t directions = lines.directions.size();
    const std::ptrdiff_t next = static_cast<std::ptrdiff_t>(block) * (cut.turned ? -1 : 1);
    const bool across = cut.quarter % 2 == 1;
    // Signs of the coordinates of the point (y, x) of a RimTable in the pixel, where they are exchanged if `across`.
    const bool down = cut.turned ? cut.quarter == 0 || cut.quarter == 3 : cut.quarter > 1,
               left = cut.turned ? cut.quarter > 1 : cut.quarter == 1 || cut.quarter == 2;
    const std::size_t first_row = static_cast<std::size_t>(cut.y + static_cast<std::int64_t>(strips.reach)) * g,
                      first_column = static_cast<std::size_t>(cut.x + static_cast<std::int64_t>(strips.reach)) * g;
    // X and Y at places near the pixel: local[angle][place][rim][re X, im X, re Y, im Y][lane].
    constexpr std::size_t each = Rims * 4;
    const std::size_t here = pixels.places * each * lanes;
    local.resize(pixels.count * here);
    const float* ring = kept + cut.at * block;
    for (std::size_t t = 0; t < pixels.count; ++t, ring += next) {
        for (std::size_t l = 0; l < pixels.places; ++l) {
            const float* const share = table.local.data() + pixels.place + l * radii;
            V sum[each];
            std::fill_n(sum, each, splat<V>(0.0f));
            for (std::size_t r = 0; r < radii; ++r) {
                const V by = splat<V>(share[r]);
                for (std::size_t c = 0; c < each; ++c) {
                    sum[c] = sum[c] + by * load<V>(ring + (r * each + c) * lanes);
                }
            }
            for (std::size_t c = 0; c < each; ++c) {
                store(local.data() + t * here + (l * each + c) * lanes, sum[c]);
            }
        }
    }
    const double *const at_x = strips.scaled.data(), *const at_y = at_x;
    double middle[most_directions];
    for (std::size_t d = 0; d < directions; ++d) {
        middle[d] = static_cast<double>((lines.directions[d].places - 1) * strips.fractions) + 0.5;
    }
    V squares = splat<V>(0.0f), products = splat<V>(0.0f), lights = splat<V>(0.0f);
    for (std::size_t i = 0; i < g * g; ++i) {
        const std::size_t p = across ? i % g : i / g, q = across ? i / g : i % g;
        const std::size_t row = first_row + (down ? g - 1 - p : p), column = first_column + (left ? g - 1 - q : q);
        const float* weights[most_directions];
        std::size_t first[most_directions];
        for (std::size_t d = 0; d < directions; ++d) {
            const std::size_t place = static_cast<std::size_t>(lines.points.cosines[d] * at_x[column] +
                                                               lines.points.sines[d] * at_y[row] + middle[d]);
            first[d] = place / strips.fractions - (T / 2 - 1);
            weights[d] = strips.weights.data() + place % strips.fractions * T;
        }
        V u[2] = {splat<V>(0.0f), splat<V>(0.0f)};
        const float* field = fields;
        for (std::size_t l = 0; l < lines.points.lines.size(); ++l) {
            const StripLine& line = lines.points.lines[l];
            const float* const w = weights[line.direction];
            const float* from = field + first[line.direction] * 2 * lanes;
            V a[2] = {splat<V>(0.0f), splat<V>(0.0f)}, b[2] = {splat<V>(0.0f), splat<V>(0.0f)};
            for (std::size_t k = 0; k < T; ++k, from += 2 * lanes) {
                const V weight = splat<V>(w[k]);
                a[0] = a[0] + weight * load<V>(from);
                a[1] = a[1] + weight * load<V>(from + lanes);
                if (line.sums == 2) {
                    b[0] = b[0] + weight * load<V>(from + room);
                    b[1] = b[1] + weight * load<V>(from + room + lanes);
                }
            }
            if (line.sums == 2) {
                const float *const y = strips.turns[l].data() + 4 * row, *const x = strips.turns[l].data() + 4 * column + 2;
                const V c = splat<V>(y[0] * x[0] - y[1] * x[1]), s = splat<V>(y[1] * x[0] + y[0] * x[1]);
                a[0] = c * a[0] + s * b[0];
                a[1] = c * a[1] + s * b[1];
            }
            u[0] = u[0] + a[0];
            u[1] = u[1] + a[1];
            field += line.sums * room;
        }
        const float *const shares = table.shares.data() + (pixels.point + i) * table.field_taps, *const parts =
                                                                                                     table.parts.data() +
                                                                                                     pixels.part +
                                                                                                     i * pixels.places * Rims *
                                                                                                         2;
        const float* angle = local.data() + table.starts[pixels.point + i] * here;
        V re = splat<V>(0.0f), im = splat<V>(0.0f);
        for (std::size_t t = 0; t < table.field_taps; t += 2, angle += 2 * here) {
            V sum[2][4];  // two taps at a time: more independent sums
            std::fill_n(sum[0], 8, splat<V>(0.0f));
            for (std::size_t j = 0; j < pixels.places * Rims; ++j) {
                const V x = splat<V>(parts[2 * j]), y = splat<V>(parts[2 * j + 1]);
                for (std::size_t tap = 0; tap < 2; ++tap) {
                    const float* const from = angle + tap * here + j * 4 * lanes;
                    sum[tap][0] = sum[tap][0] + x * load<V>(from);
                    sum[tap][1] = sum[tap][1] + x * load<V>(from + lanes);
                    sum[tap][2] = sum[tap][2] + y * load<V>(from + 2 * lanes);
                    sum[tap][3] = sum[tap][3] + y * load<V>(from + 3 * lanes);
                }
            }
            for (std::size_t tap = 0; tap < 2; ++tap) {
                const V share = splat<V>(shares[t + tap]);
                re = re + share * (sum[tap][0] + sum[tap][2]);
                im = im + share * (sum[tap][1] + sum[tap][3]);
            }
        }
        const V weight = splat<V>(static_cast<float>(0.25 * table.gauss_weights[i / g] * table.gauss_weights[i % g]));
        squares = squares + weight * (u[0] * u[0] + u[1] * u[1]);
        products = products + weight * (re * u[0] + im * u[1]);
        lights = lights + weight * (re * re + im * im);
    }
    store(square, squares);
    store(light, lights);
    store(out, load<V>(out) + (squares - splat<V>(2.0f) * products));
}

// Intensity of the field of a direction between the places i and i + 1 of its table, weighted by the moduli of the weights of taps,
// from above: to moduli[direction][i][lane].
template <class I>
LOMMEL_INLINE void strip_light(I, const RimStripTable& strips, const float* fields, Floats& squares, Floats& light) {
    using V = typename I::floats;
    constexpr std::size_t lanes = sizeof(V) / sizeof(float);
    const StripTable<float>& lines = strips.lines;
    const std::size_t room = lines.room(lanes), each = room / 2, taps = lines.count.taps;
    squares.assign(lines.directions.size() * each, 0.0f);
    light.assign(squares.size(), 0.0f);
    for (const StripLine& line : lines.points.lines) {
        const std::size_t places = 2 * lines.directions[line.direction].places - 1;
        float* const to = squares.data() + line.direction * each;
        for (std::size_t i = 0; i < places * lanes; ++i) {
            float sum = 0.0f;
            for (std::size_t part = 0; part < 2 * line.sums; ++part) {
                const float value = fields[part / 2 * room + i / lanes * 2 * lanes + part % 2 * lanes + i % lanes];
                sum += value * value;
            }
            to[i] += std::sqrt(sum);
        }
        fields += line.sums * room;
    }
    for (std::size_t d = 0; d < lines.directions.size(); ++d) {
        const std::size_t places = 2 * lines.directions[d].places - 1;
        for (std::size_t i = taps / 2 - 1; i + taps / 2 < places; ++i) {
            V sum = splat<V>(0.0f);
            for (std::size_t k = 0; k < taps; ++k) {
                const V modulus = load<V>(squares.data() + d * each + (i + k - (taps / 2 - 1)) * lanes);
                sum = sum + splat<V>(static_cast<float>(strips.taps[k])) * modulus * modulus;
            }
            store(light.data() + d * each + i * lanes, sum);
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
        quadrature_ = RimTable::mean_pixel_error(table.window.step, table.gauss_places.size());
        const double nearest = table.window.nearest(), far = RimStripTable::farthest(table);
        std::vector<std::size_t> all(stack.count);
        std::iota(all.begin(), all.end(), std::size_t{0});
        // Share of the error of averages for that of strips, which counts twice the largest field, about.
        constexpr double share = 0.3;
        const double allowed = share * table.window.error / (2.0 * (std::sqrt(1.7 / (nearest * nearest * nearest)) + cut_));
        choice_ = StripChoice(stack, all, 0, {-far, far, -far, far},
                              0.2 * static_cast<double>(table.pixels.size()) * 8.0 *
                                  static_cast<double>(table.gauss_places.size() * table.gauss_places.size()),
                              allowed);
        strips_ = cache<RimStripTable>.get(stack.strips, choice_.count, stack.amplitude, table);
        terms_ = cache<StripTerms>.get(stack.strips, choice_.count, stack.terms);
    }

    static constexpr double aimed = 0.95;  // part of the allowed error that may come from strips that are left out

    // Subtract the strips from the averages in scratch.out; return bounds on the errors of these.
    std::vector<double> subtract(const Batch& batch, RimScratch& scratch) const {
        const std::size_t lanes = RimKernels::lanes(batch.level), here = batch.errors.size();
        thread_local ChordalScratch<float> chordal;
        thread_local Floats moduli, bright, local;
        const float* const fields = fields_of(batch, chordal);
        dispatch_widest(batch.level,
                        [&](auto isa) LOMMEL_INLINE_LAMBDA { strip_light(isa, *strips_, fields, moduli, bright); });
        // Per lane, those beyond the last pupil as of it: numbers of RimErrors, error of the strips' field, allowed error.
        struct alignas(64) Lanes {
            float rms[most_pupils], wide[most_pupils], narrow[most_pupils], rounding[most_pupils], largest[most_pupils],
                field[most_pupils], off[most_pupils], allowed[most_pupils], own[most_pupils], disk[most_pupils],
                of_field[most_pupils], left[most_pupils], most[most_pupils], square[most_pupils], light[most_pupils];
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
            of.allowed[lane] =
                static_cast<float>(aimed * (batch.allowed != nullptr ? batch.allowed[batch.first + p] : table_.window.error));
        }
        const double units = 0x1p-24 * static_cast<double>(strips_->gauss * strips_->gauss + 32);
        const float pixels = static_cast<float>(batch.errors[0].pixels);
        for (const RimJob& job : batch.jobs) {
            for (std::size_t i = 0; i < job.count; ++i) {
                const std::size_t pixel = job.to[i] / lanes;
                const std::int64_t y = batch.top + static_cast<std::int64_t>(pixel / batch.width),
                                   x = batch.left + static_cast<std::int64_t>(pixel % batch.width);
                const double nearer = table_.window.nearest() /
                                      (table_.window.step * std::hypot(std::max(0.0, std::abs(static_cast<double>(y)) - 0.5),
                                                                       std::max(0.0, std::abs(static_cast<double>(x)) - 0.5)));
                float* const out = scratch.out.data() + job.to[i];
                root_light(bright, lanes, y, x, of.most);
                // Errors without strips; roots of the mean intensity of the disk and its error; errors if strips are left out.
                const RimPixels& here_off = *job.pixels;
                const float angles = static_cast<float>(here_off.off_angles), wide = static_cast<float>(here_off.off_radii[0]),
                            narrow = static_cast<float>(here_off.off_radii[1]), gain = static_cast<float>(here_off.gain),
                            dropped = static_cast<float>(here_off.dropped), falls = static_cast<float>(std::min(1.0, nearer));
                bool bright_pixel = false;
                for (std::size_t lane = 0; lane < lanes; ++lane) {
                    const float interpolated = angles * of.rms[lane] +
                                               std::min(wide * of.wide[lane], narrow * of.narrow[lane]) +
                                               gain * of.rounding[lane] + dropped * of.largest[lane] + pixels;
                    const float of_field = falls * of.field[lane], root = std::sqrt(std::max(0.0f, out[lane]) + interpolated),
                                strips = above * of.most[lane] + of.off[lane];
                    of.of_field[lane] = of_field;
                    of.own[lane] = interpolated + 2.0f * of_field * root + of_field * of_field;
                    of.disk[lane] = root + of_field;
                    of.left[lane] = strips * (2.0f * of.disk[lane] + strips);
                    bright_pixel |= !(of.own[lane] + of.left[lane] <= of.allowed[lane]);  // also if it is not a number
                }
                if (bright_pixel) {
                    const RimCut cut{*job.pixels, job.at[i], y, x, job.turned, job.quarters[i]};
                    dispatch_widest(batch.level, [&](auto isa) LOMMEL_INLINE_LAMBDA {
                        for_taps(choice_.count.taps, [&](auto taps) LOMMEL_INLINE_LAMBDA {
                            constexpr std::size_t T = decltype(taps)::value;
                            table_.rims.size() == 1 ? cut_pixel<1, T>(isa, table_, *strips_, fields, scratch.kept.data(), cut,
                                                                      local, out, of.square, of.light)
                                                    : cut_pixel<2, T>(isa, table_, *strips_, fields, scratch.kept.data(), cut,
                                                                      local, out, of.square, of.light);
                        });
                    });
                    for (std::size_t lane = 0; lane < here; ++lane) {
                        const double of_disk = static_cast<double>(of.of_field[lane]) + batch.errors[lane].fields,
                                     off = static_cast<double>(of.off[lane]),
                                     strips = std::sqrt(static_cast<double>(of.square[lane])),
                                     disk = std::sqrt(static_cast<double>(of.light[lane]));
                        of.left[lane] = static_cast<float>(quadrature_ + 2.0 * (of_disk * (strips + off) + disk * off) +
                                                           off * (2.0 * strips + off) + units * strips * (strips + 2.0 * disk));
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
                       2.0 * (phases + choice_.rounding(stack_.terms.size(), true)));
    }
    // Bound on the root mean square of the computed field of strips in a pixel: the sum over directions of the root of the mean of
    // `light`, over the coordinate along the direction.
    void root_light(const Floats& light, std::size_t lanes, std::int64_t y, std::int64_t x, float* roots) const {
        const StripTable<float>& lines = strips_->lines;
        const std::size_t each = lines.room(lanes) / 2;
        std::fill_n(roots, lanes, 0.0f);
        for (std::size_t d = 0; d < lines.directions.size(); ++d) {
            const double by = strips_->step / lines.count.spacing, wide = by * std::abs(lines.points.cosines[d]),
                         tall = by * std::abs(lines.points.sines[d]);
            const double zero = static_cast<double>(lines.directions[d].places) - 1.0;
            const double middle =
                zero + by * (lines.points.cosines[d] * static_cast<double>(x) + lines.points.sines[d] * static_cast<double>(y));
            // Density of the coordinate: a trapezoid.
            const double half = 0.5 * (wide + tall), top = 1.0 / std::max(wide, tall),
                         slope = std::min(wide, tall) > 1e-9 ? 1.0 / (wide * tall) : 1e300;
            float sums[most_pupils] = {};
            for (double cell = std::floor(middle - half - 0.01); cell < middle + half + 0.01; cell += 1.0) {
                const double near = std::max({0.0, cell - middle, middle - cell - 1.0});
                const float density =
                    static_cast<float>(std::min(top, slope * std::max(0.0, half + 0.01 - near)) * strips_->gain);
                const float* const from = light.data() + d * each + static_cast<std::size_t>(cell) * lanes;
                for (std::size_t lane = 0; lane < lanes; ++lane) {
                    sums[lane] += density * from[lane];
                }
            }
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                roots[lane] += std::sqrt(sums[lane]);
            }
        }
    }

    const DiskStack& stack_;
    const RimTable& table_;
    double cut_ = 0.0, quadrature_ = 0.0;  // area of the strips / pi; error of what they add by Gauss quadrature over a pixel
    StripChoice choice_;
    std::shared_ptr<const RimStripTable> strips_;
    std::shared_ptr<const StripTerms> terms_;
};

}  // namespace lommel
