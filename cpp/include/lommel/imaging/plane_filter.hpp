// Axial convolution of an image stack, separately at each lateral spatial frequency.
#pragma once

#include <algorithm>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "lommel/base/parallel.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/special/fft.hpp"

namespace lommel {

// Planes of an image stack. specimen, recording: numbers of planes; first: specimen plane at which the recording starts;
// before, after: numbers of copies of the first and of the last plane that extend the specimen and contribute to the recording.
struct StackPlanes {
    std::size_t specimen, recording, first, before, after;
};

// Axial Fourier transform of a kernel, divided by the FFT length: [row][group of eight columns][frequency][re or im][column],
// columns in the order 0 4 1 5 2 6 3 7. If only half of the rows and one more are stored, rows k and -k are equal; if only half
// of the frequencies and one more, frequencies k and -k are complex conjugates.
struct PlaneTransfer {
    const float* values;
    std::size_t rows, frequencies;
};

// Axial convolution (*) of a specimen s: recording = sum over kernels h_k of h_k * (w_k s), where w_k s is the specimen with each
// plane multiplied by its weight; or the transposed operator. Works in place on [plane][row][column], on eight columns at a time.
// Each row is first copied from all planes, because each plane is on a memory page of its own.
class PlaneFilter {
   public:
    // `length`: FFT length supported by RowFft, at least the number of planes of the specimen and of all copies (StackPlanes);
    // weights[kernel][plane of the specimen].
    PlaneFilter(StackPlanes planes, std::size_t length, std::size_t rows, std::size_t columns,
                std::vector<PlaneTransfer> kernels, const float* weights)
        : planes_(planes), fft_(length), rows_(rows), columns_(columns), groups_((columns + 7) / 8),
          kernels_(std::move(kernels)), weights_(weights) {}

    // Replace the specimen (first planes of `room`) by its recording; if `transposed`, apply the transposed operator.
    void run(std::complex<float>* room, bool transposed, int threads) const {
        constexpr std::size_t together = 4;
        std::vector<Scratch> scratch(static_cast<std::size_t>(processors()) + 1);
        parallel_for((rows_ + together - 1) / together, threads, [&](std::size_t worker, std::size_t task) {
            Scratch& own = scratch[worker];
            if (own.held.empty()) {
                own.held.resize(groups_ * planes_.specimen * fft_element);
                for (Floats* each : {&own.a, &own.b, &own.c, &own.d}) {
                    each->resize(fft_.n * fft_element);
                }
            }
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                for (std::size_t row = task * together; row < std::min(rows_, (task + 1) * together); ++row) {
                    take(room, row, transposed ? planes_.recording : planes_.specimen, own.held.data());
                    for (std::size_t group = 0; group < groups_; ++group) {
                        float* const held = &own.held[group * planes_.specimen * fft_element];
                        if (transposed) {
                            returned(isa, row, group, held, own);
                        } else {
                            seen(isa, row, group, held, own);
                        }
                    }
                    put(room, row, transposed ? planes_.specimen : planes_.recording, own.held.data());
                }
            });
        });
    }

   private:
    struct Scratch {
        Floats held, a, b, c, d;
    };

    // Pairs of floats as 64-bit integers: re and im are separated by masks and shifts alone.
#if defined(LOMMEL_VECTORS)
    typedef std::uint64_t Pairs __attribute__((vector_size(32)));
#else
    using Pairs = std::uint64_t;
#endif
    static constexpr std::uint64_t low = 0xffffffffU;
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    static LOMMEL_INLINE Pairs firsts(Pairs a, Pairs b) { return (a & ~low) | (b >> 32U); }
    static LOMMEL_INLINE Pairs seconds(Pairs a, Pairs b) { return (a << 32U) | (b & low); }
#else
    static LOMMEL_INLINE Pairs firsts(Pairs a, Pairs b) { return (a & low) | (b << 32U); }
    static LOMMEL_INLINE Pairs seconds(Pairs a, Pairs b) { return (a >> 32U) | (b & ~low); }
#endif

    // Copy one row of all planes, with re and im exchanged: the FFT of exchanged numbers is the inverse FFT. Re and im remain
    // exchanged up to the products in multiply(). Columns are in the order 0 4 1 5 2 6 3 7.
    LOMMEL_INLINE void take(const std::complex<float>* room, std::size_t row, std::size_t count, float* held) const {
        for (std::size_t plane = 0; plane < count; ++plane) {
            const float* from = reinterpret_cast<const float*>(room + (plane * rows_ + row) * columns_);
            float* to = held + plane * fft_element;
            float last[fft_element] = {};
            for (std::size_t group = 0; group < groups_; ++group, from += fft_element, to += planes_.specimen * fft_element) {
                if (8 * group + 8 > columns_) {
                    std::memcpy(last, from, (columns_ - 8 * group) * 2 * sizeof(float));
                    from = last;
                }
                for (std::size_t k = 0; k < 8; k += sizeof(Pairs) / sizeof(float)) {
                    const Pairs a = load<Pairs>(from + k), b = load<Pairs>(from + k + 8);
                    store(to + k, seconds(a, b));
                    store(to + k + 8, firsts(a, b));
                }
            }
        }
    }

    LOMMEL_INLINE void put(std::complex<float>* room, std::size_t row, std::size_t count, const float* held) const {
        for (std::size_t plane = 0; plane < count; ++plane) {
            float* to = reinterpret_cast<float*>(room + (plane * rows_ + row) * columns_);
            const float* from = held + plane * fft_element;
            float last[fft_element];
            for (std::size_t group = 0; group < groups_; ++group, to += fft_element, from += planes_.specimen * fft_element) {
                const bool part = 8 * group + 8 > columns_;
                float* const here = part ? last : to;
                for (std::size_t k = 0; k < 8; k += sizeof(Pairs) / sizeof(float)) {
                    const Pairs re = load<Pairs>(from + k), im = load<Pairs>(from + k + 8);
                    store(here + k, firsts(re, im));
                    store(here + k + 8, seconds(re, im));
                }
                if (part) {
                    std::memcpy(to, last, (columns_ - 8 * group) * 2 * sizeof(float));
                }
            }
        }
    }

    // Forward operator, from specimen to recording, for one row and eight columns: multiply by the weights, pad with copies of
    // the outermost planes, convolve, crop.
    template <class I>
    LOMMEL_INLINE void seen(I isa, std::size_t row, std::size_t group, float* held, Scratch& own) const {
        const std::size_t last = (planes_.specimen - 1) * fft_element, n = fft_.n;
        for (std::size_t kernel = 0; kernel < kernels_.size(); ++kernel) {
            float* const line = own.a.data();
            scaled<false>(isa, held, planes_.specimen, weights_ + kernel * planes_.specimen, line);
            std::memset(line + last + fft_element, 0, (n - planes_.specimen) * fft_element * sizeof(float));
            for (std::size_t k = 1; k <= planes_.after; ++k) {
                std::memcpy(line + last + k * fft_element, line + last, fft_element * sizeof(float));
            }
            for (std::size_t k = 1; k <= planes_.before; ++k) {
                std::memcpy(line + (n - k) * fft_element, line, fft_element * sizeof(float));
            }
            const float* const made = fft_.whole(isa, line, own.b.data());
            if (kernel == 0) {
                multiply<false, false>(isa, made, row, group, kernels_[kernel], own.c.data());
            } else {
                multiply<false, true>(isa, made, row, group, kernels_[kernel], own.c.data());
            }
        }
        const float* const back = fft_.whole(isa, own.c.data(), own.a.data());
        std::memcpy(held, back + planes_.first * fft_element, planes_.recording * fft_element * sizeof(float));
    }

    // Transpose of seen(), from recording to specimen, for one row and eight columns.
    template <class I>
    LOMMEL_INLINE void returned(I isa, std::size_t row, std::size_t group, float* held, Scratch& own) const {
        const std::size_t last = (planes_.specimen - 1) * fft_element, n = fft_.n, from = planes_.first * fft_element;
        float* const line = own.a.data();
        std::memset(line, 0, from * sizeof(float));
        std::memcpy(line + from, held, planes_.recording * fft_element * sizeof(float));
        const std::size_t to = from + planes_.recording * fft_element;
        std::memset(line + to, 0, (n * fft_element - to) * sizeof(float));
        const float* const made = fft_.whole(isa, line, own.b.data());
        for (std::size_t kernel = 0; kernel < kernels_.size(); ++kernel) {
            multiply<true, false>(isa, made, row, group, kernels_[kernel], own.c.data());
            float* const back = fft_.whole(isa, own.c.data(), own.d.data());
            for (std::size_t k = 1; k <= planes_.after; ++k) {
                add(back + last + k * fft_element, back + last);
            }
            for (std::size_t k = 1; k <= planes_.before; ++k) {
                add(back + (n - k) * fft_element, back);
            }
            if (kernel == 0) {
                scaled<false>(isa, back, planes_.specimen, weights_, held);
            } else {
                scaled<true>(isa, back, planes_.specimen, weights_ + kernel * planes_.specimen, held);
            }
        }
    }

    static LOMMEL_INLINE void add(const float* from, float* to) {
        for (std::size_t k = 0; k < fft_element; ++k) {
            to[k] += from[k];
        }
    }

    template <bool Added, class I>
    static LOMMEL_INLINE void scaled(I, const float* from, std::size_t count, const float* weights, float* to) {
        using V = typename RowPack<I, float>::type;
        for (std::size_t plane = 0; plane < count; ++plane) {
            const V weight = splat<V>(weights[plane]);
            for (std::size_t k = 0; k < fft_element; k += sizeof(V) / sizeof(float), from += sizeof(V) / sizeof(float)) {
                float* const here = to + plane * fft_element + k;
                const V value = weight * load<V>(from);
                store(here, Added ? load<V>(here) + value : value);
            }
        }
    }

    // Multiply the spectrum x by the kernel's transfer function (its conjugate if `Transposed`). Write the product to y or, if
    // `Added`, add it to y. In x, re and im are stored in exchanged places; in y they are not.
    template <bool Transposed, bool Added, class I>
    LOMMEL_INLINE void multiply(I, const float* x, std::size_t row, std::size_t group, const PlaneTransfer& kernel,
                                float* y) const {
        using V = typename RowPack<I, float>::type;
        const std::size_t its = kernel.rows < rows_ ? std::min(row, rows_ - row) : row, n = fft_.n;
        const float* const transfer = kernel.values + (its * groups_ + group) * kernel.frequencies * fft_element;
        for (std::size_t f = 0; f < n; ++f) {
            const bool opposite = f >= kernel.frequencies;
            const float* const t = transfer + (opposite ? n - f : f) * fft_element;
            const float turn = opposite != Transposed ? -1.0F : 1.0F;
            for (std::size_t k = 0; k < fft_rows; k += sizeof(V) / sizeof(float)) {
                const V im = load<V>(x + f * fft_element + k), re = load<V>(x + f * fft_element + fft_rows + k);
                const V c = load<V>(t + k), s = splat<V>(turn) * load<V>(t + fft_rows + k);
                float* const here = y + f * fft_element + k;
                const V real = re * c - im * s, imaginary = im * c + re * s;
                store(here, Added ? load<V>(here) + real : real);
                store(here + fft_rows, Added ? load<V>(here + fft_rows) + imaginary : imaginary);
            }
        }
    }

    StackPlanes planes_;
    RowFft<float> fft_;
    std::size_t rows_, columns_, groups_;
    std::vector<PlaneTransfer> kernels_;
    const float* weights_;
};

}  // namespace lommel
