// Windows of a bank, and the mixtures of four of them that points between them spread.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "lommel/base/simd.hpp"

namespace lommel {

// Windows of 2 widest + 1 pixels a side, equally spaced in defocus, alike in their four quadrants. Of window i the
// pixels up to halves[i] from the middle are used, and of the ring at k the share halves[i] + 1 - k, from 0 to 1; between two
// windows the half width is interpolated, so that what is used never jumps. energies[i][half] is the sum of window i up to a
// whole half width: the mixture is divided by what is used of it.
template <class T>
struct WindowBank {
    const T* windows;  // [window and one more][row from the middle one down][column from the middle one on, zeros last]
    const double* halves;  // [window]
    const double* energies;  // [window][widest + 1]
    std::size_t count, widest, stride;

    std::size_t room() const { return (widest + 1) * stride; }
};

// The four windows of a pixel, from `first`, and their weights: cubic Lagrange in the middle interval, divided by the sum. Up
// to `half` pixels from the middle are used, of the last ring the share `rim`.
template <class T>
struct Mixture {
    std::uint32_t first, half;
    T rim, layer;
    T weights[6];  // between zeros: those of the windows before and after
    bool any;     // else nothing is spread
    bool hidden;  // in part
};

// Makes mixtures of a bank, whose energies it keeps in such a sequence that those of four windows are a vector.
template <class T>
class Mixer {
   public:
    // Points of a row that are taken together, at most.
    static constexpr std::size_t most = 64;

    explicit Mixer(const WindowBank<T>& bank)
        : count_(static_cast<std::int32_t>(bank.count)), widest_(static_cast<T>(bank.widest)), intervals_(bank.count - 1),
          energies_((bank.widest + 2) * bank.count) {
        for (std::int32_t i = 0; i < count_ - 1; ++i) {
            const std::int32_t first = std::min(std::max(i - 1, 0), count_ - 4);
            const double half = bank.halves[i];
            intervals_[static_cast<std::size_t>(i)] = {static_cast<T>(half), static_cast<T>(bank.halves[i + 1] - half),
                                                       static_cast<T>(i - first), first};
        }
        for (std::size_t half = 0; half <= bank.widest; ++half) {
            for (std::size_t i = 0; i < bank.count; ++i) {
                energies_[(half + 1) * bank.count + i] = static_cast<T>(bank.energies[i * (bank.widest + 1) + half]);
            }
        }
    }

    // Writes the mixtures of points of a row, each `apart` from the next.
    LOMMEL_INLINE void operator()(const double* positions, const T* values, std::size_t count, Mixture<T>* made,
                                  std::size_t apart) const {
        // Of a chain of steps as long as that of a point processors follow few at once: compilers make vectors of its begin.
        std::int32_t interval[most];
        T part[most];
        const std::int32_t last = count_ - 1;
        for (std::size_t j = 0; j < count; ++j) {
            const double inside = std::min(std::max(positions[j], 0.0), static_cast<double>(last));
            interval[j] = std::min(static_cast<std::int32_t>(inside), last - 1);
            part[j] = static_cast<T>(inside - static_cast<double>(interval[j]));
        }
        for (std::size_t j = 0; j < count; ++j) {
            Mixture<T>& m = made[j * apart];
            const Interval& here = intervals_[static_cast<std::size_t>(interval[j])];
            const T wide = std::min(here.half + part[j] * here.more, widest_);
            const std::int32_t half = static_cast<std::int32_t>(std::ceil(wide));
            m.first = static_cast<std::uint32_t>(here.first), m.half = static_cast<std::uint32_t>(half);
            m.rim = wide - static_cast<T>(half - 1);
            const V t = splat<V>(part[j] + here.before);
            const V weights = load<V>(powers[0]) + t * (load<V>(powers[1]) + t * (load<V>(powers[2]) + t * load<V>(powers[3])));
            const T* energy = energies_.data() + static_cast<std::ptrdiff_t>(half) * count_ + here.first;
            const V held = weights * (splat<V>(m.rim) * load<V>(energy + count_) + splat<V>(T(1) - m.rim) * load<V>(energy));
            m.weights[0] = m.weights[5] = T(0);
            store(m.weights + 1, weights * splat<V>(values[j] / ((held[0] + held[1]) + (held[2] + held[3]))));
            m.any = !(positions[j] < 0.0) && values[j] != T(0);
            m.layer = T(0), m.hidden = false;
        }
    }

   private:
    using V = std::conditional_t<sizeof(T) == 4, typename Vector<2>::floats, typename Vector<4>::pack>;
    static constexpr T powers[4][4] = {{T(1), T(0), T(0), T(0)},
                                       {T(-11.0 / 6.0), T(3), T(-1.5), T(1.0 / 3.0)},
                                       {T(1), T(-2.5), T(2), T(-0.5)},
                                       {T(-1.0 / 6.0), T(0.5), T(-0.5), T(1.0 / 6.0)}};
    // Between two windows: the half width at the first and how much more it is at the second, and what mixtures there are of.
    struct Interval {
        T half, more, before;  // windows of the mixture before the first of the two
        std::int32_t first;
    };
    std::int32_t count_;
    T widest_;
    std::vector<Interval> intervals_;
    std::vector<T, AlignedAllocator<T>> energies_;  // [half width, before the first one zeros][window]
};

}  // namespace lommel
