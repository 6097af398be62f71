// Depth map and sharp images from a focal stack; rows are filtered while they are read, and no memory is allocated per frame.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <vector>

#include "lommel/base/aligned.hpp"
#include "lommel/base/parallel.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/focal/depth.hpp"
#include "lommel/focal/energies.hpp"
#include "lommel/focal/frames.hpp"
#include "lommel/focal/polynomials.hpp"

namespace lommel {

// Plan of a FocalStream: size of the frames, filters, and outputs. Heights and widths count pixels after binning by `binning`.
struct FocalPlan {
    std::size_t height, width, binning;
    std::size_t channels, frames;  // order of frames: all of the first channel, then of the second, ...
    FocalTaps taps;
    const float* residuals;  // FocalMixture factors of residual images: [channels][count][frames][degree + 1]
    std::size_t residual_count;
    const float* images;  // FocalMixture factors of the images kept for mix(), first channel only: [count][frames][degree + 1]
    std::size_t image_count;
    FocalWindow window;
    std::size_t fine;  // number of depths per block along either axis; block sums are interpolated for them
    std::size_t blur;  // blur radius in binned pixels; pixels this close to the border or to an unknown pixel are not trusted
    std::size_t strips;

    std::size_t planes() const { return channels * frames; }
    // Number of rows that must be read beyond a row before its results can be computed.
    std::size_t ahead() const { return std::max(taps.degree * taps.reach, blur); }
};

// Processing of a focal stack: take() filters frames and estimates depths; search() corrects depths; mix() computes sharp images.
class FocalStream {
   public:
    FocalStream(const FocalPlan& plan, const FocalCandidates* candidates)
        : plan_(plan), reader_(plan.height, plan.width, plan.binning),
          summing_(plan.height * plan.binning, plan.width * plan.binning), down_(plan.height / plan.window.side),
          across_(plan.width / plan.window.side), pitch_((across_ + 31) / 32 * 32 + 2 * FocalRows::margin) {
        if (plan.residual_count > 0) {
            each_ = plan.residual_count * (plan.residual_count + 1) / 2;
            products_ = plan.channels * each_;
            search_ = std::make_unique<FocalSearch>(*candidates, plan.channels, plan.residual_count);
            rows_ = products_ + plan.channels + 1;
            kept_ = 2 * neighbours() + 2;
            places_.resize(down() * across());
            filled_.resize(down() * across());
            columns_.resize(across());
            margin_ = 2 * plan.fine * plan.window.weights.size();
            map_pitch_ = across() + 2 * margin_ + widest_step;
            maps_.resize(4 * (down() + 2 * margin_) * map_pitch_);
            std::fill(maps_.begin(), maps_.end(), std::numeric_limits<float>::quiet_NaN());
            for (std::size_t x = 0; x < across(); ++x) {
                wider_.push_back(wider(x, across_));
            }
            for (std::size_t h = down(), w = across(); h * w > 1; h = (h + 1) / 2, w = (w + 1) / 2) {
                levels_.push_back({h, w, std::vector<float>(h * w), std::vector<float>(h * w)});
            }
            levels_.push_back({1, 1, std::vector<float>(1), std::vector<float>(1)});
        }
        row_ = (plan.width + 31) / 32 * 32;
        images_.resize(plan.image_count * plan.height * row_ + 64);
        const std::size_t strips = std::max<std::size_t>(1, std::min(plan.strips, down_ > 0 ? down_ : 1));
        for (std::size_t s = 0; s < strips; ++s) {
            strips_.push_back(std::make_unique<Strip>(plan, *this));
        }
    }

    // down(), across(): number of rows and columns of the depth map.
    std::size_t down() const { return down_ * plan_.fine; }
    std::size_t across() const { return across_ * plan_.fine; }
    const FocalPlan& plan() const { return plan_; }
    const FocalPlace* places() const { return places_.data(); }
    const float* filled() const { return filled_.data(); }

    // Write the results of FocalSums: sums of raw values over the pixels known in all frames, and the number of these pixels.
    void sum(const FocalFrame* frames, double* out) {
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA { summing_(isa, frames, plan_.planes(), out); });
    }

    // Filter a stack of frames, estimate the depth of each block, and keep images for mix().
    void take(const FocalFrame* frames) {
        const std::size_t side = plan_.window.side, count = strips_.size();
        parallel_for(count, static_cast<int>(count), [&](std::size_t, std::size_t s) {
            const std::size_t first = down_ * s / count, last = down_ * (s + 1) / count;
            const std::size_t bottom = s + 1 == count ? plan_.height : last * side;
            Strip& strip = *strips_[s];
            strip.held[0] = strip.held[1] = Strip::none;
            strip.next = first * plan_.fine, strip.end = last * plan_.fine;
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA { filter(isa, strip, frames, first * side, bottom); });
        });
    }

    // Correct standard errors in places(), mark uncertain depths as unknown, and write filled(), in which no depth is unknown.
    void search() {
        doubt();
        leave_chosen();
        fill();
    }

    // Write the depth of each block after search(), its standard error in metres, and its misfit.
    void depths(float* depth, float* errors, float* misfit) const {
        const FocalCandidates& given = search_->candidates();
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
            for (std::size_t i = 0; i < places_.size(); ++i) {
                const float vergence = given.first + given.step * places_[i].position;
                depth[i] = 1.0f / vergence;
                errors[i] = vergence > 0.0f ? places_[i].error * given.step / (vergence * vergence)
                                            : std::numeric_limits<float>::infinity();
                misfit[i] = places_[i].misfit;
            }
        });
    }

    // Compute a sharp image, sum over kept images of factor * image. factors[candidate][image] are interpolated linearly at the
    // depth positions[down][across] (in candidates) of blocks of `side` x `side` pixels, and between block centres.
    void mix(const float* positions, std::size_t down, std::size_t across, std::size_t side, const float* factors,
             std::size_t candidates, float* out) {
        const std::size_t count = strips_.size();
        parallel_for(count, static_cast<int>(count), [&](std::size_t, std::size_t s) {
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                blend(isa, *strips_[s], positions, down, across, side, factors, candidates, out, plan_.height * s / count,
                      plan_.height * (s + 1) / count);
            });
        });
    }

   private:
    // Working memory of one strip of rows, which one thread filters.
    struct Strip {
        Strip(const FocalPlan& plan, const FocalStream& of)
            : rows(plan.taps, plan.planes(), plan.height, plan.width, plan.ahead()),
              images(plan.images, plan.image_count, 0, plan.frames, plan.taps.degree + 1),
              lines((plan.residual_count + plan.image_count + 2) * FocalRows::padded(plan.width)),
              kept(plan.ahead() + plan.blur + 2), pitch(FocalRows::padded(plan.width)), unknown(kept * pitch),
              counts(plan.width), smooth{Floats(of.rows_ * of.pitch_), Floats(plan.fine > 1 ? of.rows_ * of.pitch_ : 0)},
              padded(of.pitch_), between(plan.fine > 1 ? of.rows_ * (of.across() + 2 * FocalRows::margin) : 0),
              coefficients(3 * plan.image_count * FocalRows::padded(plan.width)) {
            const std::size_t each = plan.residual_count * plan.frames * (plan.taps.degree + 1);
            for (std::size_t c = 0; c < plan.channels; ++c) {
                residuals.emplace_back(plan.residuals + c * each, plan.residual_count, c * plan.frames, plan.frames,
                                       plan.taps.degree + 1);
                products.emplace_back(plan.residual_count, plan.width, plan.window.side);
            }
            sums.resize(of.kept_ * of.rows_ * of.pitch_);
            if (of.search_) {
                scratch = std::make_unique<FocalSearch::Scratch>(*of.search_);
            }
        }
        float* unknown_row(std::size_t y) { return unknown.data() + y % kept * pitch; }

        FocalRows rows;
        std::vector<FocalMixture> residuals;  // residual images of each channel
        FocalMixture images;
        std::vector<FocalProducts> products;
        Floats lines;
        std::size_t kept, pitch;  // number and pitch of the rows in the ring buffer `unknown`
        Floats unknown;
        std::vector<int> counts;  // number of unknown pixels within `blur` of each pixel of a row
        Floats smooth[2], padded, between, coefficients;
        std::size_t held[2] = {none, none};  // index of the block row whose averages each `smooth` holds
        Floats sums;  // ring buffer with the sums of the most recent block rows
        std::size_t next = 0, end = 0;  // range of rows of the depth map still to estimate
        static constexpr std::size_t none = ~std::size_t{0};
        std::unique_ptr<FocalSearch::Scratch> scratch;
    };
    // Level of the image pyramid in fill(). values: depths as fractional candidate indices; weights: 1 for known depths, else 0.
    struct Level {
        std::size_t height, width;
        std::vector<float> values, weights;
    };

    using Index = std::ptrdiff_t;
    // Row y of a map of the places, with margins of NaN: texture, position, squared error and misfit, before doubt().
    enum Map { Texture, Position, Square, Misfit };
    float* map(Map which, Index y) {
        const auto margin = static_cast<Index>(margin_), pitch = static_cast<Index>(map_pitch_),
                   rows = static_cast<Index>(down()) + 2 * margin;
        return maps_.data() + (which * rows + y + margin) * pitch + margin;
    }

    std::size_t line() const { return FocalRows::padded(plan_.width); }
    // Number of block rows above, and equally below, that contribute to the depth of a block.
    std::size_t neighbours() const { return plan_.window.weights.size() - 1 + (plan_.fine > 1 ? 1 : 0); }
    float* sums_of(Strip& strip, std::size_t block) const {
        return strip.sums.data() + block % kept_ * rows_ * pitch_ + FocalRows::margin;
    }

    // Filter the rows own .. end - 1 of a strip, and the rows around them that their results depend on; compute the results.
    template <class I>
    LOMMEL_INLINE void filter(I isa, Strip& strip, const FocalFrame* frames, std::size_t own, std::size_t end) {
        const std::size_t degree = plan_.taps.degree, reach = plan_.taps.reach, ahead = plan_.ahead();
        // Depths at the edge of a strip depend on blocks of the adjacent strip, up to `beyond` rows of pixels from the edge.
        const std::size_t beyond = plan_.residual_count > 0 ? neighbours() * plan_.window.side : 0, own_top = own,
                          own_bottom = end;
        const std::size_t top = own > beyond ? own - beyond : 0, bottom = std::min(end + beyond, plan_.height);
        const std::size_t first = top > ahead ? top - ahead : 0;
        std::fill(strip.counts.begin(), strip.counts.end(), 0);
        for (std::size_t t = first; t < bottom + ahead; ++t) {
            if (t < plan_.height) {
                read(isa, strip, frames, t);
            }
            for (std::size_t m = 1; m <= degree && t >= m * reach; ++m) {
                const std::size_t y = t - m * reach, margin = (degree - m) * reach;
                if (y < plan_.height && y + margin >= top && y < bottom + margin) {
                    strip.rows.step(isa, m, y);
                }
            }
            // Running count of unknown pixels in the rows within `blur`: add the row that enters, subtract the row that leaves.
            const std::size_t blur = plan_.blur, span = 2 * blur + 1;
            if (t + blur >= first + ahead && t + blur - ahead < plan_.height) {
                count(strip, t + blur - ahead, 1);
            }
            if (t + blur >= first + ahead + span && t + blur - ahead - span < plan_.height) {
                count(strip, t + blur - ahead - span, -1);
            }
            if (t >= top + ahead) {
                emit(isa, strip, t - ahead, t - ahead >= own_top && t - ahead < own_bottom);
            }
        }
    }

    template <class I>
    LOMMEL_INLINE void read(I isa, Strip& strip, const FocalFrame* frames, std::size_t y) {
        float* const unknown = strip.unknown_row(y);
        std::fill_n(unknown, plan_.width, 0.0f);
        bool any = false;
        for (std::size_t i = 0; i < plan_.planes(); ++i) {
            any = reader_(isa, frames[i], y, strip.rows.row(i, 0, y), unknown) || any;
        }
        unknown[plan_.width] = any ? 1.0f : 0.0f;
    }
    LOMMEL_INLINE void count(Strip& strip, std::size_t y, int sign) {
        const std::size_t blur = plan_.blur, width = plan_.width;
        const float* const unknown = strip.unknown_row(y);
        for (std::size_t x = 0; x < width && unknown[width] != 0.0f; ++x) {
            if (unknown[x] != 0.0f) {
                for (std::size_t i = x > blur ? x - blur : 0; i < std::min(width, x + blur + 1); ++i) {
                    strip.counts[i] += sign;
                }
            }
        }
    }

    // Compute row y of all residual images, of kept images if `own`, and the rows of the depth map that can now be estimated.
    template <class I>
    LOMMEL_INLINE void emit(I isa, Strip& strip, std::size_t y, bool own) {
        float* lines[most_images + 2];
        const std::size_t residuals = plan_.residual_count, pitch = line();
        for (std::size_t k = 0; k < residuals + 2; ++k) {
            lines[k] = strip.lines.data() + k * pitch;
        }
        const std::size_t block = y / plan_.window.side, within = y % plan_.window.side;
        const bool last = within + 1 == plan_.window.side, judged = residuals > 0 && block < down_;
        float *const mean = lines[residuals], *const trust = lines[residuals + 1];
        float* const sums = judged ? sums_of(strip, block) : nullptr;
        const std::size_t blur = y < plan_.blur || y + plan_.blur >= plan_.height ? plan_.width : plan_.blur;
        if (judged) {
            std::fill_n(trust, plan_.width, 0.0f);
            for (std::size_t x = blur; x + blur < plan_.width; ++x) {
                trust[x] = strip.counts[x] != 0 ? 0.0f : 1.0f;
            }
        }
        // Residual images of each channel; in the last pass, the kept images of the first channel.
        for (std::size_t c = 0; c <= plan_.channels; ++c) {
            const bool kept = c == plan_.channels;
            if (kept ? !own || plan_.image_count == 0 : !judged) {
                continue;
            }
            for (std::size_t k = 0; kept && k < plan_.image_count; ++k) {
                lines[k] = images_.data() + (k * plan_.height + y) * row_;
            }
            (kept ? strip.images : strip.residuals[c])(isa, strip.rows, y, lines);
            if (!kept) {
                average_frames(strip, c, y, mean);
                strip.products[c].take(isa, within, lines, mean, trust);
                if (last) {
                    strip.products[c].sum(isa, sums + c * each_ * pitch_, pitch_, sums + (products_ + c) * pitch_,
                                          sums + (rows_ - 1) * pitch_);
                }
            }
        }
        for (std::size_t q = 0; judged && last && q < rows_; ++q) {
            smooth(isa, strip, sums + q * pitch_);
        }
        while (judged && last && strip.next < strip.end && needed(strip.next) <= block) {
            decide(isa, strip, strip.next++);
        }
    }

    // Last block row on which row y of the depth map depends.
    std::size_t needed(std::size_t y) const {
        const std::size_t fine = plan_.fine, block = fine == 1 ? y : (2 * y + 1 + fine) / (2 * fine);
        return std::min(std::min(block, down_ - 1) + plan_.window.weights.size() - 1, down_ - 1);
    }

    LOMMEL_INLINE void average_frames(Strip& strip, std::size_t channel, std::size_t y, float* mean) {
        const float share = 1.0f / static_cast<float>(plan_.frames);
        for (std::size_t i = 0; i < plan_.frames; ++i) {
            const float* const row = strip.rows.row(channel * plan_.frames + i, 0, y);
            for (std::size_t x = 0; x < plan_.width; ++x) {
                mean[x] = (i == 0 ? 0.0f : mean[x]) + share * row[x];
            }
        }
    }

    // Average a row of blocks along x with the weights of the window, in place; blocks beyond the ends count as 0.
    template <class I>
    LOMMEL_INLINE void smooth(I, Strip& strip, float* row) {
        using V = typename I::floats;
        const std::vector<float>& weights = plan_.window.weights;
        float* const copy = strip.padded.data() + FocalRows::margin;
        std::copy_n(row, across_, copy);
        const std::size_t reach = std::min(weights.size(), FocalRows::margin - 1);
        for (std::size_t x = 0; x < across_; x += 2 * I::lanes) {
            V sum = splat<V>(weights[0]) * load<V>(copy + x);
            for (std::size_t k = 1; k < reach; ++k) {
                sum = sum + splat<V>(weights[k]) * (load<V>(copy + x - k) + load<V>(copy + x + k));
            }
            store(row + x, sum);
        }
    }

    // Estimate row y of the depth map.
    template <class I>
    LOMMEL_INLINE void decide(I isa, Strip& strip, std::size_t y) {
        constexpr std::size_t lanes = 2 * I::lanes;
        const std::size_t fine = plan_.fine, width = across(), trust = rows_ - 1;
        const float place = (static_cast<float>(y) + 0.5f) / static_cast<float>(fine) - 0.5f;
        const float within = std::min(std::max(place, 0.0f), static_cast<float>(down_ - 1));
        const auto block = static_cast<std::size_t>(within);
        const float* around[2];
        for (std::size_t i = 0; i < (fine == 1 ? 1 : 2); ++i) {
            around[i] = average(isa, strip, std::min(block + i, down_ - 1));
        }
        const float* sums = around[0];
        std::size_t pitch = pitch_;
        if (fine > 1) {
            float* const between = strip.between.data();
            pitch = width + 2 * FocalRows::margin;
            for (std::size_t q = 0; q < rows_; ++q) {
                expand(around[0] + q * pitch_, around[1] + q * pitch_, within - static_cast<float>(block), across_, fine, width,
                       between + q * pitch);
            }
            sums = between;
        }
        for (std::size_t x = 0; x < width; x += lanes) {
            (*search_)(isa, sums + x, pitch, sums + trust * pitch + x, wider_.data() + x, wider(y, down_), width - x,
                       *strip.scratch, places_.data() + y * width + x);
        }
        float *const textures = map(Texture, static_cast<Index>(y)), *const positions = map(Position, static_cast<Index>(y)),
                     *const squares = map(Square, static_cast<Index>(y)), *const misfits = map(Misfit, static_cast<Index>(y));
        for (std::size_t x = 0; x < width; ++x) {
            const FocalPlace& here = places_[y * width + x];
            textures[x] = here.texture, positions[x] = here.position, misfits[x] = here.misfit;
            squares[x] = here.error * here.error;
        }
    }

    // Effective pixels, along one axis of `blocks` blocks, of the window around depth x / of that around a block: depths between
    // blocks are of averages that are interpolated.
    float wider(std::size_t x, std::size_t blocks) const {
        const std::vector<float>& weights = plan_.window.weights;
        const float place = (static_cast<float>(x) + 0.5f) / static_cast<float>(plan_.fine) - 0.5f;
        const float within = std::min(std::max(place, 0.0f), static_cast<float>(blocks - 1)),
                    part = within - std::floor(within);
        float squares = weights[0] * weights[0], products = 0.0f;
        for (std::size_t k = 1; k < weights.size(); ++k) {
            squares += 2.0f * weights[k] * weights[k], products += 2.0f * weights[k] * weights[k - 1];
        }
        return 1.0f / (1.0f - 2.0f * part * (1.0f - part) * (1.0f - products / squares));
    }

    // Averages over the window around each block of row `block`: products of residual images divided by (noise variance * trust),
    // the mean of the frames of each channel, and trust, which is the fraction of trusted pixels.
    template <class I>
    LOMMEL_INLINE const float* average(I, Strip& strip, std::size_t block) {
        const std::size_t slot = plan_.fine > 1 ? block % 2 : 0;
        float* const out = strip.smooth[slot].data();
        if (strip.held[slot] == block) {
            return out + FocalRows::margin;
        }
        strip.held[slot] = block;
        const float read = search_->candidates().read_variance, there = share(block, down_);
        float *const sums = out + FocalRows::margin, *const over = strip.padded.data() + FocalRows::margin;
        const float* const trust = sums + (rows_ - 1) * pitch_;
        column(I{}, strip, block, rows_ - 1, nullptr, sums);
        for (std::size_t c = 0; c < plan_.channels; ++c) {
            const float* const light = sums + (products_ + c) * pitch_;
            for (std::size_t i = 0; i <= each_; ++i) {
                column(I{}, strip, block, i == 0 ? products_ + c : c * each_ + i - 1, i == 0 ? nullptr : over, sums);
                // light / (fraction of the window inside the image) = mean of the frames in that fraction = shot noise variance.
                for (std::size_t x = 0; i == 0 && x < across_; ++x) {
                    const float variance = std::max(0.0f, light[x] / (there * share(x, across_))) + read;
                    over[x] = 1.0f / std::max(trust[x] * variance, 1e-20f);
                }
            }
        }
        return sums;
    }
    // Weighted sum over the window's block rows of quantity q (product of residuals, mean frame, trust), times `factors` if any.
    template <class I>
    LOMMEL_INLINE void column(I isa, Strip& strip, std::size_t block, std::size_t q, const float* factors, float* sums) const {
        const std::vector<float>& weights = plan_.window.weights;
        const float scale = 1.0f / static_cast<float>(plan_.window.side * plan_.window.side);
        const float* rows[2 * FocalRows::margin + 1];
        float shares[2 * FocalRows::margin + 1];
        std::size_t count = 0;
        const std::size_t first = block + 1 >= weights.size() ? block + 1 - weights.size() : 0;
        for (std::size_t b = first; b < std::min(down_, block + weights.size()); ++b, ++count) {
            rows[count] = sums_of(strip, b) + q * pitch_;
            shares[count] = scale * weights[b < block ? block - b : b - block];
        }
        float* const to = sums + q * pitch_;
        std::size_t k = 0;
        for (; k + 5 <= count; k += 5) {  // five rows at a time: the number of rows of the usual window
            add<5>(isa, rows + k, shares + k, k == 0, k + 5 == count ? factors : nullptr, to);
        }
        for (; k < count; ++k) {
            add<1>(isa, rows + k, shares + k, k == 0, k + 1 == count ? factors : nullptr, to);
        }
    }
    template <std::size_t Count, class I>
    LOMMEL_INLINE void add(I, const float* const* rows, const float* shares, bool first, const float* factors,
                           float* to) const {
        using V = typename I::floats;
        V share[Count];
        for (std::size_t k = 0; k < Count; ++k) {
            share[k] = splat<V>(shares[k]);
        }
        for (std::size_t x = 0; x < across_; x += 2 * I::lanes) {
            V sum = first ? V{} : load<V>(to + x);
            for (std::size_t k = 0; k < Count; ++k) {
                sum = sum + share[k] * load<V>(rows[k] + x);
            }
            store(to + x, factors ? sum * load<V>(factors + x) : sum);
        }
    }
    // Sum of the window weights, along one axis, of blocks inside 0 .. side - 1, for the window around block `at`.
    float share(std::size_t at, std::size_t side) const {
        const std::vector<float>& weights = plan_.window.weights;
        if (at + 1 >= weights.size() && at + weights.size() <= side) {
            return 1.0f;
        }
        float sum = weights[0];
        for (std::size_t k = 1; k < weights.size(); ++k) {
            sum += (at >= k ? weights[k] : 0.0f) + (at + k < side ? weights[k] : 0.0f);
        }
        return sum;
    }

    // Radius of a window, in depths.
    std::size_t reach() const { return plan_.fine * (plan_.window.weights.size() - 1); }

    // Increase the standard errors of depths near steps in depth, by the slope of the depth map and its deviation from a plane: a
    // window across a step contains two depths, and its mean squared residual is smallest at a depth between them. Depths out of
    // range or with too large an error become unknown.
    void doubt() {
        const FocalCandidates& given = search_->candidates();
        const std::size_t strips = strips_.size();
        parallel_for(strips, static_cast<int>(strips), [&](std::size_t, std::size_t s) {
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                for (std::size_t y = down() * s / strips; y < down() * (s + 1) / strips; ++y) {
                    doubt(isa, y);
                }
            });
        });
        for (std::size_t i = 0; i < places_.size(); ++i) {
            FocalPlace& here = places_[i];
            here.error = filled_[i];
            if (!(here.error <= given.largest && here.position >= given.low && here.position <= given.high)) {
                here.error = std::numeric_limits<float>::infinity();
                here.position = std::numeric_limits<float>::quiet_NaN();
            }
        }
    }
    // Mark depths with more than `rarely_alone` of the largest error as unknown where less than half of those around are known: noise
    // chose them, and errors follow for none that was chosen.
    void leave_chosen() {
        const std::size_t width = across(), height = down();
        const std::size_t reach = 2 * this->reach();
        // (Known) - (unknown) depths, of those whose windows are trusted, in the rows of a square.
        const auto count = [&](std::size_t i) {
            return std::isnan(places_[i].texture) ? 0.0f : std::isfinite(places_[i].error) ? 1.0f : -1.0f;
        };
        std::fill(columns_.begin(), columns_.end(), 0.0f);
        for (std::size_t y = 0; y < height; ++y) {
            float sum = 0.0f;
            for (std::size_t x = 0; x < width + reach; ++x) {
                sum += x < width ? count(y * width + x) : 0.0f;
                sum -= x > 2 * reach ? count(y * width + x - 2 * reach - 1) : 0.0f;
                if (x >= reach) {
                    filled_[y * width + x - reach] = sum;
                }
            }
        }
        for (std::size_t y = 0; y < height + reach; ++y) {
            for (std::size_t x = 0; x < width; ++x) {
                columns_[x] += y < height ? filled_[y * width + x] : 0.0f;
                columns_[x] -= y > 2 * reach ? filled_[(y - 2 * reach - 1) * width + x] : 0.0f;
                if (y >= reach && columns_[x] < 0.0f) {
                    FocalPlace& here = places_[(y - reach) * width + x];
                    if (here.error > rarely_alone * search_->candidates().largest) {
                        here.error = std::numeric_limits<float>::infinity();
                        here.position = std::numeric_limits<float>::quiet_NaN();
                    }
                }
            }
        }
    }
    // Write standard errors of row y to filled_. The variance to add: from the slope of the depth map, and from its deviation from a
    // plane if the frames do not fit a single depth (misfit) or the texture is on one side, so that the depth may be of what is there.
    template <class I>
    LOMMEL_INLINE void doubt(I, std::size_t y) {
        using V = typename I::floats;
        constexpr std::size_t lanes = 2 * I::lanes;
        const auto fine = static_cast<Index>(plan_.fine), reach = static_cast<Index>(this->reach());
        const V zero{}, one = splat<V>(1.0f), half = splat<V>(0.5f), four = splat<V>(4.0f),
                        none = splat<V>(std::numeric_limits<float>::infinity());
        for (std::size_t x = 0; x < across(); x += lanes) {
            const auto at = [&](Map which, Index dy, Index dx) LOMMEL_INLINE_LAMBDA {
                return load<V>(map(which, static_cast<Index>(y) + dy) + static_cast<Index>(x) + dx);
            };
            const auto part = [&](V v, float least, float most) LOMMEL_INLINE_LAMBDA {
                return smaller(larger((v - splat<V>(least)) / splat<V>(most - least), zero), one);
            };
            // tanh(offset of the texture of a window from its centre / (rms width)^2), in blocks; 0 beside a border.
            V aside{};
            for (std::size_t way = 0; way < 2; ++way) {
                const Index dy = fine * ways[way][0], dx = fine * ways[way][1];
                const V before = larger(zero, at(Texture, -dy, -dx)), after = larger(zero, at(Texture, dy, dx)),
                        sum = after + before, from = larger(after, before) - smaller(after, before);
                aside = larger(below(zero, sum, from / sum, zero), aside);
            }
            // Beside light so strong the energy of a plain area is what the filters and the window spread of it.
            const V strong = splat<V>(spread) * larger(zero, at(Texture, 0, 0));
            V lost{};
            for (const Index away : {-2 * reach, 2 * reach}) {
                lost = below(strong, at(Texture, away, 0), one, lost), lost = below(strong, at(Texture, 0, away), one, lost);
            }
            const V square = at(Square, 0, 0), position = at(Position, 0, 0);
            const V mixed = part(at(Misfit, 0, 0), least_mixed, surely_mixed), beside = part(aside, least_aside, surely_aside);
            const V share = larger(mixed * splat<V>(mixed_share), beside * splat<V>(beside_share));
            V slope{}, bent[2] = {};  // from depths at a distance of `reach`, and of twice this
            const auto compare = [&](std::size_t way, Index times) LOMMEL_INLINE_LAMBDA {
                const Index dy = times * reach * ways[way][0], dx = times * reach * ways[way][1];
                const V a = at(Position, -dy, -dx), b = at(Position, dy, dx), of_a = at(Square, -dy, -dx),
                        of_b = at(Square, dy, dx), theirs = of_a + of_b;
                if (way < 2 && times == 1) {
                    const V change = half * (b - a);
                    slope = slope + larger(loaded(change * change) - half * half * theirs, zero);  // 0 for unknown depths, NaN
                }
                // Squares are rounded before noise is subtracted, as by processors without fused multiply-adds.
                const auto bend = [&](V size, V noise) LOMMEL_INLINE_LAMBDA { return loaded(size * size) - four * noise; };
                V most = bent[times - 1];
                most = larger(bend(a + b - (position + position), theirs + four * square), most);
                most = larger(below(of_b, none, zero, bend(a - position, square + of_a)), most);
                bent[times - 1] = larger(below(of_a, none, zero, bend(b - position, square + of_b)), most);
            };
            float shares[lanes], doubts[lanes], asides[lanes];
            store(shares, share), store(asides, aside);
            compare(0, 1), compare(1, 1);
            if (*std::max_element(shares, shares + lanes) > 0.0f) {
                compare(2, 1), compare(3, 1), compare(0, 2), compare(1, 2), compare(2, 2), compare(3, 2);
                const V both = larger(bent[1], bent[0]);
                bent[0] = below(zero, mixed, both, below(beside, one, bent[0], both));
            }
            const V more = splat<V>(slope_share) * slope + share * bent[0];
            store(doubts, below(square, none, below(zero, lost, none, more), zero));
            const float* const squares = map(Square, static_cast<Index>(y)) + x;
            const std::size_t count = std::min(lanes, across() - x);
            for (std::size_t l = 0; l < count; ++l) {
                if (!(asides[l] < rarely_aside) && std::isfinite(squares[l]) && borrowed(y, x + l)) {
                    doubts[l] = std::numeric_limits<float>::infinity();
                }
            }
            for (std::size_t l = 0; l < count; ++l) {
                filled_[y * across() + x + l] = std::sqrt(squares[l] + doubts[l]);
            }
        }
    }
    // True if the depth at (y, x) is of texture more than two blocks away, and nothing on the other side has a depth by texture of its
    // own.
    LOMMEL_NOINLINE bool borrowed(std::size_t y, std::size_t x) const {
        const auto fine = static_cast<Index>(plan_.fine), reach = static_cast<Index>(this->reach());
        const auto i = static_cast<Index>(y), j = static_cast<Index>(x), rows = static_cast<Index>(down()),
                   columns = static_cast<Index>(across());
        const FocalPlace& here = places_[y * across() + x];
        const auto at = [&](Index dy, Index dx) {
            const bool inside = i + dy >= 0 && j + dx >= 0 && i + dy < rows && j + dx < columns;
            return inside ? &here + dy * columns + dx : nullptr;
        };
        const auto known = [](const FocalPlace* one) { return one && std::isfinite(one->error); };
        // True if the texture of the window around `here` is more than two blocks from its centre, towards a: its energy falls like a
        // Gaussian from a to b, or by more than the window alone makes it fall.
        const auto towards = [](const FocalPlace* a, const FocalPlace* here, const FocalPlace* b) {
            const float near = a && b ? std::max(a->texture, 0.0f) : 0.0f, own = std::max(here->texture, 0.0f);
            if (!(near > own) || near > falling * own) {
                return near > own;
            }
            const float rise = near / own, fall = std::max(b->texture, 0.0f) / own;
            return rise * rise * rise * rise * rise * fall * fall * fall > 1.0f;
        };
        for (const auto& [dy, dx] : {std::pair{fine, Index{0}}, {-fine, Index{0}}, {Index{0}, fine}, {Index{0}, -fine}}) {
            if (!towards(at(dy, dx), &here, at(-dy, -dx))) {
                continue;
            }
            bool flat = true;
            for (Index away = 1; away <= flat_reach && flat; ++away) {
                const Index y0 = -away * reach / fine * dy, x0 = -away * reach / fine * dx;
                const FocalPlace* const beyond = at(y0, x0);
                if (!beyond || std::isnan(beyond->texture)) {
                    flat = 2 * away > flat_reach;
                    break;
                }
                flat = !known(beyond) || towards(at(y0 + dy, x0 + dx), beyond, at(y0 - dy, x0 - dx));
            }
            if (flat) {
                return true;
            }
        }
        return false;
    }
    static constexpr Index ways[4][2] = {{0, 1}, {1, 0}, {1, 1}, {1, -1}};
    static constexpr float slope_share = 0.06f, mixed_share = 0.07f, least_mixed = 2.0f, surely_mixed = 5.0f;
    static constexpr float beside_share = 0.25f, rarely_aside = 0.3f, least_aside = 0.5f, surely_aside = 0.7f, falling = 4.5f;
    static constexpr float rarely_alone = 0.25f;
    static constexpr Index flat_reach = 6;  // number of windows on the other side that must have no depth of their own
    static constexpr float spread =
        200.0f;  // energy of texture / energy that filters and window leave two windows away, at least

    // Fill unknown depths with means of known depths around them, from an image pyramid, coarse to fine.
    void fill() {
        Level& finest = levels_[0];
        for (std::size_t i = 0; i < places_.size(); ++i) {
            const bool known = std::isfinite(places_[i].error);
            finest.values[i] = known ? places_[i].position : 0.0f;
            finest.weights[i] = known ? 1.0f : 0.0f;
        }
        for (std::size_t l = 1; l < levels_.size(); ++l) {
            const Level& from = levels_[l - 1];
            Level& to = levels_[l];
            for (std::size_t y = 0; y < to.height; ++y) {
                for (std::size_t x = 0; x < to.width; ++x) {
                    float sum = 0.0f, weight = 0.0f;
                    for (std::size_t i = 2 * y; i < std::min(2 * y + 2, from.height); ++i) {
                        for (std::size_t j = 2 * x; j < std::min(2 * x + 2, from.width); ++j) {
                            sum += from.weights[i * from.width + j] * from.values[i * from.width + j];
                            weight += from.weights[i * from.width + j];
                        }
                    }
                    to.values[y * to.width + x] = weight > 0.0f ? sum / weight : 0.0f;
                    to.weights[y * to.width + x] = weight > 0.0f ? 1.0f : 0.0f;
                }
            }
        }
        Level& coarsest = levels_.back();
        if (coarsest.weights[0] == 0.0f) {
            coarsest.values[0] = 0.5f * static_cast<float>(search_->candidates().count - 1);
        }
        for (std::size_t l = levels_.size() - 1; l-- > 0;) {
            const Level& from = levels_[l + 1];
            Level& to = levels_[l];
            for (std::size_t i = 0; i < to.values.size(); ++i) {
                if (to.weights[i] == 0.0f) {
                    to.values[i] = from.values[i / to.width / 2 * from.width + i % to.width / 2];
                }
            }
        }
        std::copy(finest.values.begin(), finest.values.end(), filled_.begin());
    }

    template <class I>
    LOMMEL_INLINE void blend(I, Strip& strip, const float* positions, std::size_t down, std::size_t across, std::size_t side,
                             const float* factors, std::size_t candidates, float* out, std::size_t top, std::size_t bottom) {
        const std::size_t count = plan_.image_count, pitch = line();
        // before, after: factors of each image at two rows of blocks; here: factors interpolated to one row of pixels.
        float* const before = strip.coefficients.data();
        float* const after = before + count * pitch;
        float* const here = after + count * pitch;
        const auto factor_row = [&](std::size_t block, float* to) {
            for (std::size_t x = 0; x < across; ++x) {
                const float most = static_cast<float>(candidates - 1);
                const float p = std::min(std::max(positions[block * across + x], 0.0f), most);
                const std::size_t j = std::min(static_cast<std::size_t>(p), candidates - 2);
                const float part = p - static_cast<float>(j);
                const float* const f = factors + j * count;
                for (std::size_t k = 0; k < count; ++k) {
                    to[k * pitch + x] = f[k] + part * (f[count + k] - f[k]);
                }
            }
        };
        const float step = 1.0f / static_cast<float>(side);
        std::size_t held[2] = {down, down};
        for (std::size_t y = top; y < bottom; ++y) {
            const float place =
                std::min(std::max((static_cast<float>(y) + 0.5f) * step - 0.5f, 0.0f), static_cast<float>(down - 1));
            const std::size_t block = static_cast<std::size_t>(place), next = std::min(block + 1, down - 1);
            const float part = place - static_cast<float>(block);
            if (held[0] != block) {
                factor_row(block, before), held[0] = block;
            }
            if (side > 1 && held[1] != next) {
                factor_row(next, after), held[1] = next;
            }
            float* const row = out + y * plan_.width;
            for (std::size_t k = 0; k < count; ++k) {
                const float *const a = before + k * pitch, *const b = after + k * pitch;
                float* const between = here + FocalRows::margin;
                if (side > 1) {
                    expand(a, b, part, across, side, plan_.width, between);
                }
                const float* const to = side > 1 ? between : a;
                const float* const image = images_.data() + (k * plan_.height + y) * row_;
                for (std::size_t x = 0; x < plan_.width; ++x) {
                    row[x] = (k == 0 ? 0.0f : row[x]) + to[x] * image[x];
                }
            }
        }
    }
    // to[x], x < width: linear interpolation of (1 - part) a + part b, given at the centres of `across` blocks, each `side` wide.
    static LOMMEL_INLINE void expand(const float* a, const float* b, float part, std::size_t across, std::size_t side,
                                     std::size_t width, float* to) {
        const auto at = [&](std::size_t x) LOMMEL_INLINE_LAMBDA { return a[x] + part * (b[x] - a[x]); };
        const std::size_t half = side / 2;
        const float step = 1.0f / static_cast<float>(side), begin = side % 2 == 0 ? 0.5f * step : 0.0f;
        float left = at(0);
        for (std::size_t i = 0; i < half; ++i) {
            to[i] = left;
        }
        for (std::size_t x = 0; x + 1 < across; ++x) {
            const float right = at(x + 1), slope = right - left;
            float* const cell = to + x * side + half;
            if (side == 4) {
                for (std::size_t i = 0; i < 4; ++i) {
                    cell[i] = left + slope * (0.125f + 0.25f * static_cast<float>(i));
                }
            } else {
                for (std::size_t i = 0; i < side; ++i) {
                    cell[i] = left + slope * (begin + step * static_cast<float>(i));
                }
            }
            left = right;
        }
        for (std::size_t i = (across - 1) * side + half; i < width; ++i) {
            to[i] = left;
        }
    }

    static constexpr std::size_t most_images = 64;

    FocalPlan plan_;
    FocalReader reader_;
    FocalSums summing_;
    std::size_t down_, across_, pitch_, each_ = 0, products_ = 0, rows_ = 0, row_ = 0, kept_ = 0, margin_ = 0, map_pitch_ = 0;
    std::unique_ptr<FocalSearch> search_;
    Floats images_, maps_;
    std::vector<FocalPlace> places_;
    std::vector<float> filled_, wider_, columns_;
    std::vector<Level> levels_;
    std::vector<std::unique_ptr<Strip>> strips_;
};

}  // namespace lommel
