// Distinct distances of pixels from an axis at a pixel centre or midway between pixels, and the index of each pixel's distance.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/pixels/render.hpp"

namespace lommel {

// Ascending radii, padded for vector loads past the last one. Each derived class states their unit.
struct Radii {
    Doubles radii;
    std::size_t count = 0;  // number of radii without the padding
    double reach() const { return radii.back(); }
};

struct Layout : Radii {  // the radii are in units of the pixel pitch
    FoldedSide rows, columns;

    Layout(const FoldedSide& down, const FoldedSide& across) : rows(down), columns(across) {
        const SquaredRadii squares(rows, columns);
        count = squares.count();
        const std::size_t pixels = rows.distances() * columns.distances();
        if (count <= few) {
            of_few_.resize(pixels);
            squares.ranks(of_few_.data());
        } else {
            of_many_.resize(pixels);
            squares.ranks(of_many_.data());
        }
        radii.resize(count + padding);
        squares.each([&](std::size_t rank, std::size_t s) { radii[rank] = squares.square(s); });
        std::transform(radii.begin(), radii.begin() + count, radii.begin(), [](double s) { return std::sqrt(s); });
        std::fill(radii.begin() + count, radii.end(), radii[count - 1]);
    }

    static constexpr std::size_t padding = widest_step, few = std::size_t{1} << 16;
    std::size_t height() const { return rows.count; }
    std::size_t width() const { return columns.count; }
    std::size_t bytes() const { return sizeof(double) * radii.size() + 2 * of_few_.size() + 4 * of_many_.size(); }

    // Index in `radii` of a pixel's distance from the axis; dy, dx: indices of its row and column distances.
    std::size_t rank(std::size_t dy, std::size_t dx) const {
        const std::size_t at = dy * columns.distances() + dx;
        return of_many_.empty() ? of_few_[at] : of_many_[at];
    }
    // Write the image rows whose distances from the axis have indices [first, last); profile: one value for each radius.
    template <class T>
    void scatter(const T* profile, std::size_t first, std::size_t last, T* image) const;

    bool is(const FoldedSide& down, const FoldedSide& across) const { return rows == down && columns == across; }

    static constexpr std::size_t most_bytes = std::size_t{96} << 20;
    static std::shared_ptr<const Layout> get(const FoldedSide& down, const FoldedSide& across) {
        return cache<Layout>.get(down, across);
    }
    // Layout around the centre of pixel (height / 2, width / 2).
    static std::shared_ptr<const Layout> get(std::size_t height, std::size_t width) {
        return get(FoldedSide(height), FoldedSide(width));
    }

   private:
    // [row distance][column distance]: index of a pixel's radius in `radii`; in of_few_, faster to read, if 16 bits suffice.
    std::vector<std::uint16_t> of_few_;
    std::vector<std::uint32_t> of_many_;
};

template <class T>
void Layout::scatter(const T* profile, std::size_t first, std::size_t last, T* image) const {
    if (of_many_.empty()) {
        scatter_rows(profile, of_few_.data(), rows, columns, first, last, image);
    } else {
        scatter_rows(profile, of_many_.data(), rows, columns, first, last, image);
    }
}
#if defined(LOMMEL_COMPILED)
extern template void Layout::scatter<float>(const float*, std::size_t, std::size_t, float*) const;
extern template void Layout::scatter<double>(const double*, std::size_t, std::size_t, double*) const;
#endif

}  // namespace lommel
