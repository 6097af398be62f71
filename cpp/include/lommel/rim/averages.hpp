// Averages over pixels far from the axis, computed from the pupil function on the rims of the aperture and its obscuration, for
// any Zernike terms (certificate, section 10, "From the rim").
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

#include "lommel/base/simd.hpp"
#include "lommel/base/tasks.hpp"
#include "lommel/base/watch.hpp"
#include "lommel/chordal/kernels.hpp"
#include "lommel/rim/light.hpp"
#include "lommel/rim/strips.hpp"
#include "lommel/rim/table.hpp"
#include "lommel/zernike/disk_stack.hpp"

namespace lommel {

// Stack of pupils whose image axes DiskStack::move_axes() has moved to pixel centres; remaining shifts are less than a pixel.
class RimStack {
   public:
    explicit RimStack(const DiskStack& stack) : stack_(stack), degree_(RimSlopes::degree_of(stack.terms, stack.amplitude)) {}

    static bool serves(const DiskStack& stack) { return RimSlopes::degree_of(stack.terms, stack.amplitude) <= rim_most_degree; }
    // out[pupil]: upper bound on the root mean square over the pupil of dbar^K P / P, with pupil function P, dbar = d/dx + i d/dy,
    // K = rim_orders; infinity on overflow.
    void remainders(int threads, double* out) const {
        const Batches batches(stack_.count);
        const auto disk = cache<RimDisk>.get(stack_.terms, stack_.amplitude);
        parallel_for(batches.together + batches.alone, worthwhile_threads(threads, 3.0 * static_cast<double>(stack_.count)),
                     [&](std::size_t, std::size_t b) {
                         thread_local RimScratch scratch;
                         const Batch batch = batches[b];
                         gather(batch, false, nullptr, scratch);
                         scratch.e.resize(2 * disk->slopes.orders.size() * batch.lanes());
                         scratch.mean.resize(batch.lanes());
                         scratch.largest.resize(batch.lanes());
                         RimKernels::mean(batch.level, batch.lone, *disk, scratch);
                         for (std::size_t lane = 0; lane < batch.here; ++lane) {
                             const double mean = std::sqrt(static_cast<double>(scratch.mean[lane])),
                                          rounding = 0x1p-24 * disk->slopes.units() * rim_orders *
                                                     std::sqrt(static_cast<double>(scratch.largest[lane]));
                             // Overflow gives inf or NaN, both of which become infinite.
                             const double all = rim_scale(rim_orders) * (1.0001 * mean + rounding);
                             out[batch.first + lane] = all < 1e300 ? all : std::numeric_limits<double>::infinity();
                         }
                     });
    }

   protected:
    // Pupils first .. first + here - 1, one per vector lane; or, if `lone`, one pupil, with angles or radii in the lanes.
    struct Batch {
        Level level;
        std::size_t first, here;
        bool lone;
        std::size_t lanes() const { return RimKernels::lanes(level); }
    };
    // Division of pupils into batches that fill vectors; if the last pupils would fill less than a third of a vector, they are
    // computed one by one.
    struct Batches {
        std::size_t count, together, alone;
        explicit Batches(std::size_t pupils, bool any_alone = true) : count(pupils) {
            const std::size_t most = RimKernels::lanes(processor_level()), few = pupils % most;
            alone = any_alone && 3 * few < most ? few : 0;
            together = (pupils - alone + most - 1) / most;
        }
        Batch operator[](std::size_t b) const {
            const Level widest = processor_level();
            const std::size_t most = RimKernels::lanes(widest);
            return b < together ? Batch{widest, b * most, std::min(most, count - b * most), false}
                                : Batch{RimKernels::narrow(widest), count - alone + b - together, 1, true};
        }
    };
    // Copy the Zernike coefficients of a batch (those of the obscuration if `inner`) to scratch.coefficients[term][lane]. With
    // `line`, also write their sum over the terms of each azimuthal order, times ChordKernels::unit, to scratch.phases.
    void gather(const Batch& batch, bool inner, const RimLine* line, RimScratch& scratch) const {
        const std::size_t lanes = batch.lanes(), first = batch.first, here = batch.here, terms = stack_.terms.size();
        const std::vector<double>& all = inner ? stack_.inner : stack_.outer;
        scratch.coefficients.resize(terms * lanes);
        if (line != nullptr) {
            scratch.phases.assign(line->orders.size() * lanes, 0.0);
        }
        const ChordLanes order{lanes, true};
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const double* const own = all.data() + (first + lane % here) * terms;
            for (std::size_t t = 0; t < terms; ++t) {
                scratch.coefficients[t * lanes + lane] = static_cast<float>(own[t]);
                if (line != nullptr) {
                    scratch.phases[line->columns[t] * lanes + order.place(lane)] += ChordKernels<float>::unit * own[t];
                }
            }
        }
    }

    const DiskStack& stack_;
    std::size_t degree_;
};

// Results of RimAverages. The averages `near`, in a box around each axis, are computed beforehand. Boxes may exceed the window.
struct RimAnswer {
    const double *remainders, *near;  // RimStack::remainders(), [pupil]; near: averages in boxes, [pupil][row][column]
    const std::int64_t* places;  // [pupil]: index of its image in `images`
    double *images, *numbers;  // [image][row][column]; numbers: [pupil][error bound, maximum] of averages outside boxes
    const double* allowed = nullptr;  // error that is allowed, [pupil]; null: that which is requested
};

class RimAverages : RimStack {
   public:
    RimAverages(const DiskStack& stack, const DiskWindow& window, std::size_t box, double error, const RimAnswer& answer)
        : RimStack(stack), height_(static_cast<std::int64_t>(window.height)), width_(static_cast<std::int64_t>(window.width)),
          box_(static_cast<std::int64_t>(box)), answer_(answer),
          within_(stack.amplitude.scaled(stack.obscuration * stack.obscuration)) {
        std::int64_t reach = box_ / 2 + 1;
        for (std::size_t p = 0; p < stack.count; ++p) {
            const std::int64_t row = stack.rows[p], column = stack.columns[p];
            reach =
                std::max({reach, std::abs(row), std::abs(height_ - 1 - row), std::abs(column), std::abs(width_ - 1 - column)});
        }
        const std::size_t degree = std::max<std::size_t>(8, degree_);
        table_ = cache<RimTable>.get(RimWindow{window.step, box, static_cast<std::size_t>(reach), stack.obscuration, degree,
                                               error, stack.strips, stack.strips.empty() ? 0.0 : slope()});
        for (const RimWaves& rim : table_->rims) {
            lines_.push_back(cache<RimLine>.get(stack.terms, rim.radius == 1.0 ? stack.amplitude : within_, rim.angles));
        }
        if (!stack.strips.empty()) {
            strips_ = std::make_unique<const RimStrips>(stack, *table_);
        }
    }
    void run(int threads) const {
        const Batches batches(stack_.count, strips_ == nullptr);
        const auto lone =
            batches.alone > 0 ? cache<RimLone>.get(*table_, RimKernels::lanes(RimKernels::narrow(processor_level()))) : nullptr;
        const double work = 9.0 * static_cast<double>(stack_.count) + 20.0 * static_cast<double>(batches.alone);
        parallel_for(batches.together + batches.alone, worthwhile_threads(threads, work),
                     [&](std::size_t, std::size_t b) { render(batches[b], lone.get()); });
    }

   private:
    // Smallest rectangle of pixels that holds the windows of all pupils of a batch, in rows and columns from the axis.
    struct Around {
        std::int64_t top, bottom, left, right;
        std::size_t width() const { return static_cast<std::size_t>(right - left + 1); }
        std::size_t size() const { return static_cast<std::size_t>(bottom - top + 1) * width(); }
        bool holds(std::int64_t y, std::int64_t x) const { return y >= top && y <= bottom && x >= left && x <= right; }
        std::size_t at(std::int64_t y, std::int64_t x) const {
            return static_cast<std::size_t>(y - top) * width() + static_cast<std::size_t>(x - left);
        }
    };

    void render(const Batch& batch, const RimLone* lone) const {
        thread_local RimScratch scratch;
        const std::size_t lanes = batch.lanes();
        for (std::size_t d = 0; d < table_->rims.size(); ++d) {
            gather(batch, d == 1, lines_[d].get(), scratch);
            const double edge = (d == 0 ? stack_.amplitude : within_).at(1.0);
            RimKernels::coefficients(batch.level, batch.lone, table_->rims[d], *lines_[d], edge, d, scratch);
        }
        look();
        const Around pixels = around(batch);
        scratch.out.assign(pixels.size() * lanes, 0.0f);
        const std::vector<RimJob> list = jobs(pixels, lanes);
        RimKernels::light(batch.level, *table_, batch.lone ? lone : nullptr, list, scratch);
        if (batch.lone) {  // lanes are radii of one pupil: sums of averages, and maxima of the other numbers, over the lanes
            for (std::size_t i = 0; i < scratch.out.size(); i += lanes) {
                scratch.out[i] = std::accumulate(&scratch.out[i], &scratch.out[i] + lanes, 0.0f);
            }
            for (Floats* all : {&scratch.squares, &scratch.largest}) {
                (*all)[0] = *std::max_element(all->begin(), all->end());
            }
        }
        std::vector<RimErrors> errors;
        for (std::size_t lane = 0; lane < batch.here; ++lane) {
            errors.push_back(errors_of(batch.first + lane, scratch, lane, lanes));
        }
        std::vector<double> cut(batch.here, 0.0);
        if (strips_ != nullptr) {
            cut = strips_->subtract(
                {batch.level, batch.first, list, errors, answer_.allowed, pixels.top, pixels.left, pixels.width()}, scratch);
        }
        for (std::size_t lane = 0; lane < batch.here; ++lane) {
            const std::size_t pupil = batch.first + lane;
            const double top = write(pupil, pixels, scratch.out.data() + lane, lanes);
            answer_.numbers[2 * pupil] = strips_ != nullptr ? cut[lane] : errors[lane].of_averages(top);
            answer_.numbers[2 * pupil + 1] = top;
        }
    }
    // Slope of the phases of most pupils around the rim, rounded up.
    double slope() const {
        double most = 0.0;
        for (std::size_t p = 0; p < stack_.count; ++p) {
            double square = 0.0;
            for (std::size_t j = 0; j < stack_.terms.size(); ++j) {
                const double of = static_cast<double>(stack_.terms[j].m) * stack_.outer[p * stack_.terms.size() + j];
                square += of * of;
            }
            most = std::max(most, square);
        }
        return std::exp2(std::ceil(2.0 * std::log2(3.0 + std::sqrt(most))) / 2.0);
    }
    Around around(const Batch& batch) const {
        Around all{height_, -height_, width_, -width_};
        for (std::size_t p = batch.first; p < batch.first + batch.here; ++p) {
            const std::int64_t row = stack_.rows[p], column = stack_.columns[p];
            all = {std::min(all.top, -row), std::max(all.bottom, height_ - 1 - row), std::min(all.left, -column),
                   std::max(all.right, width_ - 1 - column)};
        }
        return all;
    }
    std::vector<RimJob> jobs(const Around& pixels, std::size_t lanes) const {
        std::vector<RimJob> list;
        const std::int64_t around = static_cast<std::int64_t>(table_->around);
        for (const RimPixels& of : table_->pixels) {
            const std::int64_t begin = of.begin;
            for (std::size_t turned = 0; turned < of.mirrors(); ++turned) {
                RimJob job{&of, {}, {}, {}, 0, turned == 1};
                for (std::size_t i = 0; i < 4; ++i) {
                    const auto [y, x] = of.image(turned == 1, i);
                    if (pixels.holds(y, x)) {
                        // The images of the pixel (p, q), at the polar angle psi, are at psi + i pi / 2 or, if mirrored (`turned`), at
                        // i pi / 2 - psi.
                        const std::int64_t quarters = static_cast<std::int64_t>(i) * around / 4;
                        const std::int64_t place = turned == 0 ? begin + quarters : quarters - 1 - begin;
                        const std::int64_t within = place < 0 ? place + around : place < around ? place : place - around;
                        job.at[job.count] = table_->margin + static_cast<std::size_t>(within);
                        job.quarters[job.count] = static_cast<std::uint8_t>(i);
                        job.to[job.count++] = pixels.at(y, x) * lanes;
                    }
                }
                if (job.count > 0) {
                    list.push_back(job);
                }
            }
        }
        return list;
    }
    // Write the image of a pupil, in its box from answer_.near, outside from `averages`; return the largest average outside.
    double write(std::size_t pupil, const Around& pixels, const float* averages, std::size_t lanes) const {
        const std::int64_t row = stack_.rows[pupil], column = stack_.columns[pupil], half = box_ / 2;
        double top = 0.0;
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
            double* to = answer_.images + answer_.places[pupil] * height_ * width_;
            for (std::int64_t y = -row; y < height_ - row; ++y, to += width_) {
                const float* from = averages + pixels.at(y, -column) * lanes;
                for (std::int64_t x = 0; x < width_; ++x, from += lanes) {
                    to[x] = std::max(0.0, static_cast<double>(*from));
                    top = std::max(top, to[x]);
                }
                if (std::abs(y) <= half) {
                    const std::int64_t left = std::max<std::int64_t>(0, column - half),
                                       right = std::min(width_, column + half + 1);
                    const double* const near =
                        answer_.near + (static_cast<std::int64_t>(pupil) * box_ + y + half) * box_ + half - column;
                    std::copy(near + left, near + std::max(left, right), to + left);
                }
            }
        });
        return top;
    }
    RimErrors errors_of(std::size_t pupil, const RimScratch& scratch, std::size_t lane, std::size_t lanes) const {
        const RimTable& table = *table_;
        const double nearest = table.window.nearest();
        // Root mean square error of the field U over a pixel, of which all parts fall with the distance at least.
        double off = stack_.lost[pupil] + answer_.remainders[pupil] * std::pow(nearest, -static_cast<double>(rim_orders)) *
                                              std::sqrt(table.off_field);
        double size[2] = {0.0, 0.0};
        for (std::size_t d = 0; d < table.rims.size(); ++d) {
            const RimWaves& rim = table.rims[d];
            const RimSums& of = scratch.of[d];
            std::array<double, rim_orders> each, rounded;
            const std::vector<double>& all = d == 0 ? stack_.outer : stack_.inner;
            strangers(rim, *lines_[d], all.data() + pupil * stack_.terms.size(), each, rounded);
            const double v = rim.radius * nearest, orders = static_cast<double>(2 * rim.orders + 1);
            const double sums =
                1.5 * std::sqrt(static_cast<double>(rim.angles)) * (0.25 * static_cast<double>(rim.angles) + 8.0);
            for (std::size_t k = 0; k < rim_orders; ++k) {
                const double energy = static_cast<double>(of.energy[k * lanes + lane]);
                const double left = 1.0001 * static_cast<double>(of.left[k * lanes + lane]) +
                                    2.0 * each[k] * std::sqrt(orders * energy) + orders * each[k] * each[k];
                // units: rounding error of the sums over angles, the phases, the derivatives of ln P and k steps of rim_powers(), in
                // units of 2^-24 times the bound rounded[k] from strangers().
                const double units = sums + 16.0 + lines_[d]->slopes.units() * static_cast<double>(k);
                off += rim.radius * rim.radius * rim_scale(k) * 2.0 / std::pow(v, static_cast<double>(k + 1)) *
                       (std::sqrt(left) + orders * each[k] + 0x1p-24 * units * rounded[k]);
            }
            size[0] += 1.001 * static_cast<double>(of.size[0][lane]);
            size[1] += 1.001 * static_cast<double>(of.size[1][lane]);
        }
        const double rms = std::sqrt(1.001 * static_cast<double>(scratch.squares[lane]) / static_cast<double>(table.around)),
                     largest = static_cast<double>(scratch.largest[lane]);
        // Rounding in single precision. units: relative error of sums over radii, angles and channels. The field consists of `many`
        // waves: for each rim, of radius R, one proportional to exp(i R v) and one to exp(-i R v). waves: error bound of any of these.
        // By Schwarz, the moduli of all waves sum to at most sqrt(many * (sum of squared moduli)).
        const double units = 0x1p-24 * static_cast<double>(table.radii() * table.margin * table.channels() + 64),
                     waves = 2.83 * 0x1p-24 * static_cast<double>(table.rims[0].orders / 2 + 2 * rim_orders + 8) * size[1],
                     many = 2.0 * static_cast<double>(table.rims.size());
        RimErrors made{
            table.off_pixels,
            rms,
            {size[0] * size[0], size[1] * size[1]},
            units * largest + waves * (2.0 * std::sqrt(many * largest) + waves) / static_cast<double>(table.channels()),
            largest,
            0.0,
            off,
            0.0,
            {}};
        made.averages = made.of(table.off_angles, table.off_radii, table.gain, table.dropped);
        for (std::size_t n = 0; table.window.fields() && n < rim_most_turns; ++n) {
            for (std::size_t d = 0; d < table.rims.size(); ++d) {
                made.turned[n] += 1.001 * static_cast<double>(scratch.of[d].turned[n][lane]);
            }
        }
        const double summed = 0x1p-24 * static_cast<double>(table.field_taps + table.radii() + table.most_parts + 32);
        made.fields = table.field_angles * std::sqrt(many * rms) +
                      std::min(table.field_radii[0] * size[0], table.field_radii[1] * size[1]) +
                      table.field_gain * (many * waves + summed * std::sqrt(many * largest));
        return made;
    }
    // Bounds for the derivatives dbar^k P / rim_scale(k), dbar = d/dx + i d/dy, of the pupil function P with Zernike coefficients
    // `own`. each[k]: bound on the aliasing error of any Fourier coefficient (certificate, section 10, "Orders"); rounded[k]: bound
    // on the sum of the moduli of the terms of the derivative.
    void strangers(const RimWaves& rim, const RimLine& line, const double* own, std::array<double, rim_orders>& each,
                   std::array<double, rim_orders>& rounded) const {
        const RimSlopes& slopes = line.slopes;
        // e: Fourier coefficients of the derivatives of log P (RimSlopes): contributions of the amplitude and of each Zernike term,
        // summed; apart: sums of the moduli of these contributions, for rounding errors.
        std::vector<double> e(2 * slopes.orders.size()), apart(e.size());
        for (std::size_t i = 0; i < e.size(); ++i) {
            e[i] = static_cast<double>(slopes.fixed[i]);
            apart[i] = std::abs(e[i]);
        }
        for (std::size_t i = 0; i < slopes.parts.size(); ++i) {
            const double part = static_cast<double>(slopes.weights[i]) * own[slopes.parts[i].term];
            e[slopes.parts[i].at] += part;
            apart[slopes.parts[i].at] += std::abs(part);
        }
        std::vector<double> moduli(slopes.orders.size()), summed(moduli.size());
        for (std::size_t i = 0; i < moduli.size(); ++i) {
            moduli[i] = std::sqrt(e[2 * i] * e[2 * i] + e[2 * i + 1] * e[2 * i + 1]);
            summed[i] = apart[2 * i] + apart[2 * i + 1];
        }
        // phase[m]: amplitude of the term of azimuthal order m in the phase of the pupil function P. At complex angles theta +- i t,
        // |exp(i m theta)| is at most exp(|m| t), and |P| is at most exp(sum over m of phase[m] sinh(m t)).
        std::vector<double> phase(slopes.degree + 1, 0.0);
        for (std::size_t c = 0; c < line.orders.size(); ++c) {
            double sum = 0.0;
            for (std::size_t t = 0; t < line.columns.size(); ++t) {
                sum += line.columns[t] == c ? own[t] : 0.0;
            }
            double& to = phase[static_cast<std::size_t>(std::abs(line.orders[c]))];
            to = std::hypot(to, sum);
        }
        each.fill(std::numeric_limits<double>::infinity());
        for (const double t : {0.0, 0.3, 0.7}) {
            std::array<double, rim_most_degree + 1> grown;
            for (std::size_t m = 0; m <= slopes.degree; ++m) {
                grown[m] = std::exp(static_cast<double>(m) * t);
            }
            std::array<double, rim_most_degree> size{};
            for (std::size_t j = 0, i = 0; j < slopes.degree; ++j) {
                for (; i < slopes.ends[j]; ++i) {
                    size[j] += (t > 0.0 ? moduli : summed)[i] * grown[static_cast<std::size_t>(std::abs(slopes.orders[i]))];
                }
            }
            double exponent = -t * static_cast<double>(rim.angles - rim.orders);
            for (std::size_t m = 0; m < phase.size(); ++m) {
                exponent += 0.5 * phase[m] * (grown[m] - 1.0 / grown[m]);
            }
            const double first =
                t > 0.0 ? 2.0 * std::exp(std::min(exponent, 600.0)) / (1.0 - std::exp(-t * static_cast<double>(rim.angles)))
                        : 1.0;
            std::array<double, rim_orders> power{first};
            for (std::size_t k = 0; k + 1 < rim_orders; ++k) {
                for (std::size_t j = 0; j < std::min(k + 1, slopes.degree); ++j) {
                    power[k + 1] += size[j] * power[k - j] / static_cast<double>(k + 1);
                }
            }
            for (std::size_t k = 0; k < rim_orders; ++k) {
                (t > 0.0 ? each : rounded)[k] = t > 0.0 ? std::min(each[k], power[k]) : power[k];
            }
        }
    }

    std::int64_t height_, width_, box_;
    RimAnswer answer_;
    Amplitude within_;
    std::shared_ptr<const RimTable> table_;
    std::vector<std::shared_ptr<const RimLine>> lines_;
    std::unique_ptr<const RimStrips> strips_;
};

}  // namespace lommel
