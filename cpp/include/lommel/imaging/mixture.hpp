// Windows of a bank, and the mixtures of four of them that points between them spread.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "lommel/base/simd.hpp"

namespace lommel {

// Windows of 2 widest + 1 pixels a side, equally spaced in defocus, alike in their four quadrants: zeros but for the
// halves[i] pixels on either side of the middle of window i, which sums to energies[i]. Mixtures are divided by what theirs
// would sum to.
template <class T>
struct WindowBank {
    const T* windows;  // [window and one more][row from the middle one down][column from the middle one on, zeros last]
    const std::int64_t* halves;  // [window]
    const double* energies;  // [window]
    std::size_t count, widest, stride;

    std::size_t room() const { return (widest + 1) * stride; }
};

// The four windows of a pixel, from `first`, and their weights: cubic Lagrange in the middle interval. None reaches more
// than `half` pixels from the middle.
template <class T>
struct Mixture {
    std::uint32_t first, half;
    T layer;
    T weights[6];  // between zeros: those of the windows before and after
    bool any;     // else nothing is spread
    bool hidden;  // in part
};

// Makes mixtures of a bank, or their derivatives by the position in it.
template <class T>
class Mixer {
   public:
    explicit Mixer(const WindowBank<T>& bank, bool slopes = false)
        : slopes_(slopes), last_(static_cast<std::ptrdiff_t>(bank.count) - 1), halves_(bank.count - 3),
          energies_(bank.energies, bank.energies + bank.count) {
        for (std::size_t i = 0; i < halves_.size(); ++i) {
            halves_[i] = static_cast<std::uint32_t>(*std::max_element(bank.halves + i, bank.halves + i + 4));
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
        m.first = static_cast<std::uint32_t>(first), m.half = halves_[static_cast<std::size_t>(first)];
        const V t = splat<V>(static_cast<T>(inside - static_cast<double>(first)));
        const V a = load<V>(powers[0]), b = load<V>(powers[1]), c = load<V>(powers[2]), d = load<V>(powers[3]);
        const V energies = load<V>(energies_.data() + first), weights = a + t * (b + t * (c + t * d));
        const T held = total(weights * energies);
        if (!slopes_) {
            store(m.weights + 1, weights * splat<V>(value / held));
            return;
        }
        const V changes = b + t * (splat<V>(T(2)) * c + t * (splat<V>(T(3)) * d));
        store(m.weights + 1, (changes - weights * splat<V>(total(changes * energies) / held)) * splat<V>(value / held));
    }

   private:
    using V = std::conditional_t<sizeof(T) == 4, typename Vector<2>::floats, typename Vector<4>::pack>;
    static constexpr T powers[4][4] = {{T(1), T(0), T(0), T(0)},
                                       {T(-11.0 / 6.0), T(3), T(-1.5), T(1.0 / 3.0)},
                                       {T(1), T(-2.5), T(2), T(-0.5)},
                                       {T(-1.0 / 6.0), T(0.5), T(-0.5), T(1.0 / 6.0)}};
    LOMMEL_INLINE static T total(V of_four) { return (of_four[0] + of_four[1]) + (of_four[2] + of_four[3]); }

    bool slopes_;
    std::ptrdiff_t last_;
    std::vector<std::uint32_t> halves_;  // of the widest of four windows
    std::vector<T, AlignedAllocator<T>> energies_;
};

}  // namespace lommel
