// From a radial profile to a pixel grid.
#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lommel {

// The centred grid has few distinct radii: all pixels (dy, dx) with the same dy^2 + dx^2 share one value.
// `index` (quadrant, (rows+1) x (cols+1)) receives the rank of each squared radius; returns the squared
// radii in rising order. Marks and ranks instead of sorting: linear in the largest squared radius.
inline std::vector<std::int64_t> distinct_radii(std::size_t rows, std::size_t cols, std::int32_t* index) {
    const std::size_t largest = rows * rows + cols * cols;
    std::vector<std::int32_t> rank(largest + 1, 0);
    for (std::size_t y = 0; y <= rows; ++y) {
        for (std::size_t x = 0; x <= cols; ++x) {
            rank[y * y + x * x] = 1;
        }
    }
    std::vector<std::int64_t> squares;
    for (std::size_t s = 0; s <= largest; ++s) {
        if (rank[s] != 0) {
            rank[s] = static_cast<std::int32_t>(squares.size());
            squares.push_back(static_cast<std::int64_t>(s));
        }
    }
    for (std::size_t y = 0; y <= rows; ++y) {
        for (std::size_t x = 0; x <= cols; ++x) {
            index[y * (cols + 1) + x] = rank[y * y + x * x];
        }
    }
    return squares;
}

// One image of height x width from the values at the distinct radii. The centre is the middle of pixel
// (height / 2, width / 2). Each row is gathered once and its mirror image copied: bound by memory writes.
template <class T>
void scatter(const double* profile, double scale, const std::int32_t* index, std::size_t height, std::size_t width,
             T* out) {
    const std::size_t cy = height / 2, cx = width / 2, cols = cx + 1;
    for (std::size_t dy = 0; dy <= cy; ++dy) {
        const std::int32_t* from = index + dy * cols;
        T* row = out + (cy - dy) * width;
        for (std::size_t dx = 0; dx <= cx; ++dx) {
            const T value = static_cast<T>(scale * profile[from[dx]]);
            row[cx - dx] = value;
            if (cx + dx < width) {
                row[cx + dx] = value;
            }
        }
        if (dy > 0 && cy + dy < height) {
            T* mirrored = out + (cy + dy) * width;
            for (std::size_t x = 0; x < width; ++x) {
                mirrored[x] = row[x];
            }
        }
    }
}

// |U|^2 at rising v, where piece s of U covers [s, s + 1] * piece_width and is given by `terms` Chebyshev
// coefficients. Clenshaw's recurrence: two real fused chains per value, no loss of digits at any degree.
inline void intensity_of_pieces(const std::complex<double>* pieces, std::size_t piece_count, std::size_t terms,
                                double piece_width, const double* v, std::size_t count, double* out) {
    for (std::size_t i = 0; i < count; ++i) {
        std::size_t s = static_cast<std::size_t>(v[i] / piece_width);
        s = s < piece_count ? s : piece_count - 1;
        const double x = 2.0 * (v[i] / piece_width - static_cast<double>(s)) - 1.0;
        const std::complex<double>* c = pieces + s * terms;
        double re1 = 0.0, re2 = 0.0, im1 = 0.0, im2 = 0.0;
        for (std::size_t k = terms; k-- > 1;) {
            const double re = c[k].real() + 2.0 * x * re1 - re2;
            const double im = c[k].imag() + 2.0 * x * im1 - im2;
            re2 = re1;
            re1 = re;
            im2 = im1;
            im1 = im;
        }
        const double re = c[0].real() + x * re1 - re2;
        const double im = c[0].imag() + x * im1 - im2;
        out[i] = re * re + im * im;
    }
}

}  // namespace lommel
