// Positions of a window's pixels relative to an arbitrary axis, and groups of pixels with the same value.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lommel/pixels/render.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/base/watch.hpp"

namespace lommel {

struct PixelWindow {
    std::size_t height, width;
    double center_y, center_x, step;  // axis in pixels from the centre of pixel (0, 0); pixel pitch in optical units
    bool integrate;                   // true: averages over pixels; false: samples at pixel centres

    bool operator==(const PixelWindow& o) const {
        return height == o.height && width == o.width && center_y == o.center_y && center_x == o.center_x && step == o.step &&
               integrate == o.integrate;
    }
    double side() const { return integrate ? step : 0.0; }
    // Compute bounds on the smallest (ends[0]) and the largest (ends[1]) distance of pixel centres from the axis, in pixels.
    void reach(double (&ends)[2]) const {
        const auto near = [](double center, std::size_t side) {
            return std::max(0.0, std::max(-center, center - static_cast<double>(side - 1)));
        };
        const auto far = [](double center, std::size_t side) {
            return std::max(std::abs(center), std::abs(static_cast<double>(side - 1) - center));
        };
        ends[0] = std::hypot(near(center_y, height), near(center_x, width));
        ends[1] = std::hypot(far(center_y, height), far(center_x, width));
    }
    // Upper bound on the number of pixels closer to the axis than `away` pixels.
    double within(double away) const {
        const auto along = [&](double center, std::size_t side) {
            const double last = static_cast<double>(side - 1);
            return std::max(0.0, std::min(last, center + away) - std::max(0.0, center - away) + 1.0);
        };
        return along(center_y, height) * along(center_x, width);
    }
    // Distances of rows and columns from the axis; valid if folds(): the axis is in the window, and along either direction at a
    // pixel centre or midway between two.
    FoldedSide rows() const { return {height, center_y}; }
    FoldedSide columns() const { return {width, center_x}; }
    bool folds() const { return FoldedSide::fits(height, center_y) && FoldedSide::fits(width, center_x); }
    bool centered() const { return center_y == static_cast<double>(height / 2) && center_x == static_cast<double>(width / 2); }

    // Call f(i, dx, dy, dx^2 + dy^2) for each pixel i in row order, at (dx, dy) from the axis, in pixels.
    template <class F>
    LOMMEL_INLINE void each(const F& f) const {
        for (std::size_t row = 0, i = 0; row < height; ++row) {
            const double dy = static_cast<double>(row) - center_y, above = dy * dy;
            for (std::int32_t column = 0; column < static_cast<std::int32_t>(width); ++column, ++i) {
                const double dx = static_cast<double>(column) - center_x;
                f(i, dx, dy, dx * dx + above);
            }
        }
    }
};

// cos(4 theta) for the polar angle theta of (x, y); square = x^2 + y^2.
LOMMEL_INLINE double cosine_of_four(double x, double y, double square) {
    const double product = x * y / std::max(square, 1e-300);
    return 1.0 - 8.0 * product * product;
}

// Windows of a stack of pupils, with a common axis or one axis each.
struct PixelWindows {
    PixelWindow first;
    const double* centers = nullptr;  // axes [pupil][row, column], in pixels; null: all have the axis of `first`
    double farthest = 0.0;            // largest distance of a pixel centre from its axis, rounded up to whole pixels

    PixelWindows(const PixelWindow& shared) : PixelWindows(shared, nullptr, 1) {}
    PixelWindows(const PixelWindow& like, const double* each, std::size_t pupils) : first(like), centers(each), farthest(1.0) {
        for (std::size_t p = 0; p < pupils; ++p) {
            const PixelWindow w = (*this)[p];
            double ends[2];
            w.reach(ends);
            farthest = std::max(farthest, std::ceil(ends[1]));
        }
    }
    PixelWindow operator[](std::size_t pupil) const {
        PixelWindow w = first;
        if (centers != nullptr) {
            w.center_y = centers[2 * pupil];
            w.center_x = centers[2 * pupil + 1];
        }
        return w;
    }
};

// Distinct distances of rows (or of columns) from the axis, ascending, in pixels. rank[row]: index of its distance in `distances`.
struct Fold {
    std::vector<double> distances;
    std::vector<std::int32_t> rank;

    Fold(std::size_t count, double center) : rank(count) {
        const auto away = [&](std::size_t i) { return std::abs(static_cast<double>(i) - center); };
        for (std::size_t i = 0; i < count; ++i) {
            distances.push_back(away(i));
        }
        std::sort(distances.begin(), distances.end());
        distances.erase(std::unique(distances.begin(), distances.end()), distances.end());
        for (std::size_t i = 0; i < count; ++i) {
            rank[i] =
                static_cast<std::int32_t>(std::lower_bound(distances.begin(), distances.end(), away(i)) - distances.begin());
        }
    }
};

// Groups of pixels with the same value by symmetry: at row and column distances (a, b) from the axis and, if these occur, (b, a).
struct PixelGroups {
    Fold rows, columns;
    std::vector<std::int32_t> index;  // group of the pixels at [row distance][column distance] from the axis
    std::vector<double> v, cosine;  // [group]: distance from the axis in optical units; cosine of four times the polar angle
    PixelWindow window;

    explicit PixelGroups(const PixelWindow& w) : rows(w.height, w.center_y), columns(w.width, w.center_x), window(w) {
        const std::vector<double>&down = rows.distances, &across = columns.distances;
        const std::size_t common = std::min(down.size(), across.size());
        const bool alike = std::equal(down.begin(), down.begin() + static_cast<std::ptrdiff_t>(common), across.begin());
        index.reserve(down.size() * across.size());
        for (std::size_t i = 0; i < down.size(); ++i) {
            look();
            for (std::size_t k = 0; k < across.size(); ++k) {
                if (alike && k < i && i < across.size()) {
                    index.push_back(index[k * across.size() + i]);
                    continue;
                }
                index.push_back(static_cast<std::int32_t>(v.size()));
                const double a = down[i], b = across[k], square = a * a + b * b;
                v.push_back(w.step * std::sqrt(square));
                cosine.push_back(cosine_of_four(a, b, square));
            }
        }
    }

    // Replace the number i of each group by place[i].
    void renumber(const std::vector<std::int32_t>& place) {
        Glance glance;
        for (std::int32_t& group : index) {
            glance();
            group = place[static_cast<std::size_t>(group)];
        }
    }

    // Write, from values[group], those rows of the image `out` whose distances from the axis are rows.distances[first .. last - 1].
    template <class T>
    void paint(const T* values, std::size_t first, std::size_t last, T* out) const;
};

template <class T>
void PixelGroups::paint(const T* values, std::size_t first, std::size_t last, T* out) const {
    const std::size_t height = window.height, width = window.width;
    if (window.folds()) {
        return scatter_rows(values, index.data(), window.rows(), window.columns(), first, last, out);
    }
    for (std::size_t y = 0; y < height; ++y) {
        const std::size_t distance = static_cast<std::size_t>(rows.rank[y]);
        if (distance < first || distance >= last) {
            continue;
        }
        const std::int32_t* from = index.data() + distance * columns.distances.size();
        for (std::size_t x = 0; x < width; ++x) {
            out[y * width + x] = values[from[columns.rank[x]]];
        }
    }
}
#if defined(LOMMEL_COMPILED)
extern template void PixelGroups::paint<float>(const float*, std::size_t, std::size_t, float*) const;
extern template void PixelGroups::paint<double>(const double*, std::size_t, std::size_t, double*) const;
#endif

}  // namespace lommel
