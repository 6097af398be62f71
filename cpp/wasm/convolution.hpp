// Convolution of an image with one PSF, with reflecting edges.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <vector>

#include "lommel/base/simd.hpp"
#include "lommel/special/fft.hpp"

namespace lommel {

// FFT convolution of the planes (colours) of an image with real PSFs. The upper and lower half of a plane, each with its
// margins, are the real and imaginary part of one complex plane; convolution with a real PSF does not mix these parts. Rows are
// transformed eight at a time, then columns. Layout of a spectrum: [group of eight columns][frequency][re or im][column].
// Single precision: error of about 1e-6 of the brightest pixel, bounded by RowFft::rounding() units of roundoff per transform.
class Convolution {
   public:
    // For images of height x width pixels and PSFs of at most 2 `reach` + 1 pixels a side.
    Convolution(std::size_t height, std::size_t width, std::size_t reach)
        : height_(height), width_(width), reach_(reach), half_((height + 1) / 2),
          across_(RowFft<float>::length(width + 2 * reach)), down_(RowFft<float>::length(half_ + 2 * reach)), wide_(across_.n),
          tall_(down_.n) {}

    bool is(std::size_t height, std::size_t width, std::size_t reach) const {
        return height_ == height && width_ == width && reach_ == reach;
    }

    // Set the PSF to `scale` times values[side][side], centred on the middle pixel; `side` is odd and at most 2 reach + 1.
    void set_spread(const float* values, std::size_t side, float scale) {
        const std::size_t middle = side / 2;
        rows_.assign(wide_ * tall_ * 2, 0.0F);
        // PSF rows -middle .. middle, stored cyclically. A group of eight rows that are all zero needs no transform.
        for (std::size_t group = 0; group < tall_ / 8; ++group) {
            bool any = false;
            start();
            for (std::size_t r = 0; r < 8; ++r) {
                const std::size_t row = 8 * group + r;
                const bool before = row >= down_.n - middle && row < down_.n;
                if (row > middle && !before) {
                    continue;
                }
                any = true;
                const float* from = values + (before ? row + middle - down_.n : row + middle) * side;
                for (std::size_t x = 0; x < side; ++x) {
                    line_[(x >= middle ? x - middle : wide_ + x - middle) * fft_element + r] = scale * from[x];
                }
            }
            if (any) {
                store_rows(group);
            }
        }
        spectrum_of(spread_);
    }

    // Set plane `which` of the image; its transform is reused if the values have not changed.
    void set_plane(std::size_t which, const float* plane) {
        planes_.resize(std::max(planes_.size(), which + 1));
        Plane& here = planes_[which];
        const std::size_t bytes = height_ * width_ * sizeof(float);
        if (!here.values.empty() && std::memcmp(here.values.data(), plane, bytes) == 0) {
            return;
        }
        here.values.assign(plane, plane + height_ * width_);
        rows_.assign(wide_ * tall_ * 2, 0.0F);
        const auto mirrored = [](std::ptrdiff_t at, std::size_t size) {
            const std::ptrdiff_t n = static_cast<std::ptrdiff_t>(size);
            at = ((at % (2 * n)) + 2 * n) % (2 * n);
            return static_cast<std::size_t>(at < n ? at : 2 * n - 1 - at);
        };
        const std::ptrdiff_t margin = static_cast<std::ptrdiff_t>(reach_);
        std::vector<std::size_t> columns(width_ + 2 * reach_);
        for (std::size_t x = 0; x < columns.size(); ++x) {
            columns[x] = mirrored(static_cast<std::ptrdiff_t>(x) - margin, width_);
        }
        for (std::size_t group = 0; group < tall_ / 8; ++group) {
            start();
            for (std::size_t r = 0; r < 8; ++r) {
                const std::size_t row = 8 * group + r;
                if (row >= half_ + 2 * reach_) {
                    continue;
                }
                const std::ptrdiff_t y = static_cast<std::ptrdiff_t>(row) - margin;
                const float* upper = plane + mirrored(y, height_) * width_;
                const float* lower = plane + mirrored(y + static_cast<std::ptrdiff_t>(half_), height_) * width_;
                for (std::size_t x = 0; x < columns.size(); ++x) {
                    line_[x * fft_element + r] = upper[columns[x]];
                    line_[x * fft_element + fft_rows + r] = lower[columns[x]];
                }
            }
            store_rows(group);
        }
        spectrum_of(here.spectrum);
    }

    // Write the convolution of plane `which` with the PSF, clipped to values >= 0.
    void make(std::size_t which, float* out) {
        const std::vector<float>& picture = planes_[which].spectrum;
        const std::size_t element = fft_element, block = down_.n * element;
        rows_.resize(wide_ * tall_ * 2);
        for (std::size_t c = 0; c < wide_ / 8; ++c) {
            const float *a = &picture[c * block], *b = &spread_[c * block];
            line_.resize(std::max(down_.n, wide_) * element);
            // Inverse FFT by a forward FFT: re and im are exchanged before and after the transform.
            for (std::size_t k = 0; k < down_.n; ++k, a += element, b += element) {
                float* to = &line_[k * element];
                for (std::size_t r = 0; r < fft_rows; ++r) {
                    to[fft_rows + r] = a[r] * b[r] - a[fft_rows + r] * b[fft_rows + r];
                    to[r] = a[r] * b[fft_rows + r] + a[fft_rows + r] * b[r];
                }
            }
            const float* done = transformed(down_);
            for (std::size_t y = 0; y < down_.n; ++y, done += element) {
                put_row(y, c, done);
            }
        }
        const float scale = 1.0F / static_cast<float>(wide_ * down_.n);
        for (std::size_t group = reach_ / 8; group * 8 < reach_ + half_; ++group) {
            std::memcpy(line_.data(), &rows_[group * wide_ * element], wide_ * element * sizeof(float));
            const float* done = transformed(across_);
            for (std::size_t r = 0; r < 8; ++r) {
                const std::size_t row = 8 * group + r;
                if (row < reach_ || row >= reach_ + half_) {
                    continue;
                }
                const std::size_t y = row - reach_;
                for (std::size_t part = 0; part < 2 && y + part * half_ < height_; ++part) {
                    // The result has re and im exchanged: the upper half of the plane (part 0) is in its imaginary part.
                    const float* from = done + reach_ * element + (1 - part) * fft_rows + r;
                    float* to = out + (y + part * half_) * width_;
                    for (std::size_t x = 0; x < width_; ++x) {
                        to[x] = std::max(0.0F, scale * from[x * element]);
                    }
                }
            }
        }
    }

   private:
    struct Plane {
        std::vector<float> values, spectrum;
    };

    void start() { line_.assign(std::max(down_.n, wide_) * fft_element, 0.0F); }

    float* transformed(const RowFft<float>& fft) {
        other_.resize(std::max(down_.n, wide_) * fft_element);
        float* at = nullptr;
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA { at = fft.whole(isa, line_.data(), other_.data()); });
        return at;
    }

    // Transform the eight rows in line_ and store them in the layout [group of eight rows][column][re or im][row].
    void store_rows(std::size_t group) {
        std::memcpy(&rows_[group * wide_ * fft_element], transformed(across_), wide_ * fft_element * sizeof(float));
    }
    // Store the complex values of row y in the eight columns of group c.
    void put_row(std::size_t y, std::size_t c, const float* from) {
        float* to = &rows_[((y / 8) * wide_ + 8 * c) * fft_element + y % 8];
        for (std::size_t k = 0; k < 8; ++k, to += fft_element) {
            to[0] = from[k];
            to[fft_rows] = from[fft_rows + k];
        }
    }
    void take_row(std::size_t y, std::size_t c, float* to) const {
        const float* from = &rows_[((y / 8) * wide_ + 8 * c) * fft_element + y % 8];
        for (std::size_t k = 0; k < 8; ++k, from += fft_element) {
            to[k] = from[0];
            to[fft_rows + k] = from[fft_rows];
        }
    }

    void spectrum_of(std::vector<float>& spectrum) {
        const std::size_t block = down_.n * fft_element;
        spectrum.resize(wide_ / 8 * block);
        line_.resize(std::max(down_.n, wide_) * fft_element);
        for (std::size_t c = 0; c < wide_ / 8; ++c) {
            for (std::size_t y = 0; y < down_.n; ++y) {
                take_row(y, c, &line_[y * fft_element]);
            }
            std::memcpy(&spectrum[c * block], transformed(down_), block * sizeof(float));
        }
    }

    std::size_t height_, width_, reach_, half_;
    RowFft<float> across_, down_;
    std::size_t wide_, tall_;
    std::vector<float> rows_, spread_;
    Floats line_, other_;
    std::vector<Plane> planes_;
};

}  // namespace lommel
