// Depth from camera frames without Python, using the table files that LiveDepth.save() writes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

#include "lommel/focal/stream.hpp"

namespace lommel {

// Table file, little-endian: 32-bit integers, then floats, in the order of the fields below.
struct FocalFile {
    static constexpr std::int32_t magic = 0x464d4c4c, version = 3;  // the letters "LLMF"
    static constexpr std::int32_t block = 4;  // side of the blocks of the depth map, in pixels
    enum Whole {
        Magic,
        Version,
        Binning,
        Side,
        Blur,
        Frames,
        Degree,
        Reach,
        Residuals,
        Candidates,
        Weights,
        ImageDegree,
        ImageReach,
        Images,
        wholes
    };
    enum Number {
        White = 6,
        Offset,
        Full,
        ReadVariance,
        Pixels,
        First,
        Step,
        Low,
        High,
        Largest,
        numbers
    };  // number[0] to number[5] are two sets of three filter taps

    std::array<std::int32_t, wholes> whole;
    std::array<float, numbers> number;
    std::vector<float> residuals, weights, forms, statistics, images, mixes;

    // Read a table file. Throws std::invalid_argument if the data are not valid.
    FocalFile(const void* data, std::size_t bytes) {
        const std::uint16_t one = 1;
        unsigned char low;
        std::memcpy(&low, &one, 1);
        require(low == 1, "tables are read on little-endian processors alone");
        const auto* from = static_cast<const unsigned char*>(data);
        const unsigned char* const end = from + bytes;
        const auto take = [&](void* to, std::size_t size) {
            require(static_cast<std::size_t>(end - from) >= size, "the tables end too early");
            std::copy_n(from, size, static_cast<unsigned char*>(to));  // no copy if size is 0, for an empty vector
            from += size;
        };
        take(whole.data(), sizeof whole);
        require(whole[Magic] == magic, "these are no tables of live depth");
        require(whole[Version] == version, "these tables are of another version of lommel: save them again");
        const auto sound = [](bool holds) { require(holds, "the tables are damaged"); };
        const auto within = [&](Whole which, std::int32_t least, std::int32_t most) {
            sound(whole[which] >= least && whole[which] <= most);
            return static_cast<std::size_t>(whole[which]);
        };
        within(Binning, 1, 4), within(Side, 1, 4), within(Blur, 0, 4096), within(Reach, 1, 2), within(ImageReach, 1, 2);
        sound(whole[Binning] * whole[Side] == block);
        const std::size_t frames = within(Frames, 2, 16), terms = within(Degree, 1, 32) + 1, count = within(Residuals, 1, 48);
        const std::size_t candidates = within(Candidates, 9, 1001), around = within(Weights, 1, 16);
        const std::size_t image_terms = within(ImageDegree, 1, 32) + 1, kept = within(Images, 0, 60);
        sound(candidates % 4 == 1);
        const auto finite = [](float x) { return std::isfinite(x); };
        take(number.data(), sizeof number);
        sound(std::all_of(number.begin(), number.end(), finite));
        sound(number[White] > 0.0f && number[ReadVariance] >= 0.0f && number[Pixels] > 0.0f && number[Step] > 0.0f);
        const auto fill = [&](std::vector<float>& to, std::size_t size) {
            require(static_cast<std::size_t>(end - from) / sizeof(float) >= size, "the tables end too early");
            to.resize(size);
            take(to.data(), size * sizeof(float));
            sound(std::all_of(to.begin(), to.end(), finite));
        };
        fill(residuals, count * frames * terms);
        fill(weights, around);
        fill(forms, candidates * (count * (count + 1) / 2));
        fill(statistics, FocalCandidates::rows * candidates);
        fill(images, kept * frames * image_terms);
        fill(mixes, kept * candidates);
        require(from == end, "the tables go on after their end");
    }

   private:
    static void require(bool holds, const char* otherwise) {
        if (!holds) {
            throw std::invalid_argument(otherwise);
        }
    }
};

// Camera whose frames all have one size: computes depth maps and sharp images from its focal stacks.
class FocalCamera {
   public:
    FocalCamera(const FocalFile& file, std::size_t height, std::size_t width, std::size_t threads) : file_(file) {
        const auto whole = [&](FocalFile::Whole which) { return static_cast<std::size_t>(file.whole[which]); };
        const std::size_t binning = whole(FocalFile::Binning), frames = whole(FocalFile::Frames);
        const auto reach = [&](FocalFile::Whole degree, FocalFile::Whole taps) { return whole(degree) * whole(taps); };
        const std::size_t least = std::min(height, width);
        // Frames smaller than the blur or the filters have no reliable depth. The check also limits buffers sized by the file.
        if (2 * whole(FocalFile::Blur) >= least / binning || reach(FocalFile::Degree, FocalFile::Reach) >= least / binning ||
            reach(FocalFile::ImageDegree, FocalFile::ImageReach) >= least) {
            throw std::invalid_argument("frames are smaller than the blur and the filters that the tables are for");
        }
        const float* const n = file_.number.data();
        FocalPlan plan{height / binning,
                       width / binning,
                       binning,
                       1,
                       frames,
                       {whole(FocalFile::Degree), whole(FocalFile::Reach), {n[0], n[1], n[2]}},
                       file_.residuals.data(),
                       whole(FocalFile::Residuals),
                       nullptr,
                       0,
                       {whole(FocalFile::Side), file_.weights},
                       1,
                       whole(FocalFile::Blur),
                       threads};
        const std::size_t count = whole(FocalFile::Candidates);
        const FocalCandidates candidates{count,
                                         file_.forms.data(),
                                         file_.statistics.data(),
                                         n[FocalFile::ReadVariance],
                                         n[FocalFile::Pixels],
                                         n[FocalFile::First],
                                         n[FocalFile::Step],
                                         n[FocalFile::Low],
                                         n[FocalFile::High],
                                         n[FocalFile::Largest]};
        stream_ = std::make_unique<FocalStream>(plan, &candidates);
        if (!file_.mixes.empty()) {
            plan.height = height, plan.width = width, plan.binning = 1;
            plan.taps = {whole(FocalFile::ImageDegree), whole(FocalFile::ImageReach), {n[3], n[4], n[5]}};
            plan.residuals = nullptr, plan.residual_count = 0;
            plan.images = file_.images.data(), plan.image_count = whole(FocalFile::Images);
            plan.window.side = FocalFile::block, plan.blur = 0;
            pictures_ = std::make_unique<FocalStream>(plan, nullptr);
        }
        frames_.resize(frames);
        sums_.resize((frames + 1) * FocalSums::cells * FocalSums::cells);
    }

    std::size_t frames() const { return frames_.size(); }
    std::size_t down() const { return stream_->down(); }
    std::size_t across() const { return stream_->across(); }

    // Compute the depth of each block and its standard error in metres, and its misfit (FocalPlace), from frames of 8 bits a pixel
    // or, if `words`, 16 bits, with rows `stride` pixels apart. Throws std::invalid_argument if frames are dark or differ too much
    // in exposure.
    void take(const void* const* frames, bool words, std::size_t stride, float* depth, float* errors, float* misfit) {
        taken_ = false;
        const float full = std::min(file_.number[FocalFile::Full], words ? 65535.0f : 255.0f);
        for (std::size_t i = 0; i < frames_.size(); ++i) {
            frames_[i] = {frames[i],
                          words ? FocalFrame::Kind::words : FocalFrame::Kind::bytes,
                          stride,
                          full,
                          file_.number[FocalFile::Offset],
                          {},
                          nullptr,
                          0};
        }
        stream_->sum(frames_.data(), sums_.data());
        constexpr std::size_t cells = FocalSums::cells * FocalSums::cells;
        const auto total = [&](std::size_t i) {
            double sum = 0.0;
            for (std::size_t c = 0; c < cells; ++c) {
                sum += sums_[i * cells + c];
            }
            return sum;
        };
        const double count = std::max(total(frames_.size()), 1.0), white = static_cast<double>(file_.number[FocalFile::White]);
        const auto mean = [&](std::size_t i) {
            return (total(i) / count - static_cast<double>(file_.number[FocalFile::Offset])) * white;
        };
        const double first = mean(0);
        for (std::size_t i = 0; i < frames_.size(); ++i) {
            const double exposure = mean(i) / first;
            if (!(first > 0.0) || !(exposure >= 0.5 && exposure <= 2.0)) {
                throw std::invalid_argument(
                    "frames must hold light, of exposures that differ by less than a factor of 2, and not be full everywhere");
            }
            frames_[i].gain[0] = static_cast<float>(white / exposure);
        }
        stream_->take(frames_.data());
        stream_->search();
        stream_->depths(depth, errors, misfit);
        taken_ = true;
    }

    // Compute the sharp image of the frames of the last take(), which must still be in memory. Throws std::invalid_argument if
    // take() has not yet succeeded, or if the file has no tables for sharp images.
    void sharpen(float* image) {
        if (!pictures_ || !taken_) {
            throw std::invalid_argument(pictures_ ? "there are no frames yet" : "the tables have no sharp images: sharp=True");
        }
        pictures_->take(frames_.data());
        pictures_->mix(stream_->filled(), down(), across(), FocalFile::block, file_.mixes.data(),
                       static_cast<std::size_t>(file_.whole[FocalFile::Candidates]), image);
    }

   private:
    FocalFile file_;
    std::unique_ptr<FocalStream> stream_, pictures_;
    std::vector<FocalFrame> frames_;
    std::vector<double> sums_;
    bool taken_ = false;
};

}  // namespace lommel
