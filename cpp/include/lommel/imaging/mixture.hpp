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
    explicit Mixer(const WindowBank<T>& bank)
        : halves_(bank.halves), last_(static_cast<std::ptrdiff_t>(bank.count) - 1), energies_((bank.widest + 2) * bank.count) {
        for (std::size_t half = 0; half <= bank.widest; ++half) {
            for (std::size_t i = 0; i < bank.count; ++i) {
                energies_[(half + 1) * bank.count + i] = static_cast<T>(bank.energies[i * (bank.widest + 1) + half]);
            }
        }
    }

    LOMMEL_INLINE void operator()(double position, T value, Mixture<T>& m) const {
        m.any = !(position < 0.0) && value != T(0);
        if (!m.any) {
            return;
        }
        // Of whole numbers with a sign, which processors make of others faster.
        const double inside = std::min(position, static_cast<double>(last_));
        const std::ptrdiff_t interval = std::min(static_cast<std::ptrdiff_t>(inside), last_ - 1);
        const std::ptrdiff_t first = std::min(std::max<std::ptrdiff_t>(interval - 1, 0), last_ - 3);
        const double part = inside - static_cast<double>(interval);
        const double wide = (1.0 - part) * halves_[interval] + part * halves_[interval + 1];
        const std::ptrdiff_t half = static_cast<std::ptrdiff_t>(std::ceil(wide));
        m.first = static_cast<std::uint32_t>(first), m.half = static_cast<std::uint32_t>(half);
        m.rim = static_cast<T>(wide + 1.0 - static_cast<double>(half));
        const V t = splat<V>(static_cast<T>(inside - static_cast<double>(first)));
        const V weights = load<V>(powers[0]) + t * (load<V>(powers[1]) + t * (load<V>(powers[2]) + t * load<V>(powers[3])));
        const T* energy = energies_.data() + half * (last_ + 1) + first;
        const V held = weights * (splat<V>(m.rim) * load<V>(energy + last_ + 1) + splat<V>(T(1) - m.rim) * load<V>(energy));
        store(m.weights + 1, weights * splat<V>(value / ((held[0] + held[1]) + (held[2] + held[3]))));
    }

   private:
    using V = std::conditional_t<sizeof(T) == 4, typename Vector<2>::floats, typename Vector<4>::pack>;
    static constexpr T powers[4][4] = {{T(1), T(0), T(0), T(0)},
                                       {T(-11.0 / 6.0), T(3), T(-1.5), T(1.0 / 3.0)},
                                       {T(1), T(-2.5), T(2), T(-0.5)},
                                       {T(-1.0 / 6.0), T(0.5), T(-0.5), T(1.0 / 6.0)}};
    const double* halves_;
    std::ptrdiff_t last_;
    std::vector<T, AlignedAllocator<T>> energies_;  // [half width, before the first one zeros][window]
};

}  // namespace lommel
