// Banks of PSF windows sampled over defocus, and cubic interpolation between four neighbouring windows.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "lommel/base/simd.hpp"

namespace lommel {

// Bank of PSF windows at equal steps of defocus, 2 widest + 1 pixels a side. Windows are symmetric about both axes, so only one
// quadrant is stored. Window i is zero beyond halves[i] pixels from its middle pixel and sums to energies[i]. The interpolated
// window of an object point is scaled so that its sum is the point's value (brightness).
template <class T>
struct WindowBank {
    const T* windows;  // [window, one spare][row from the middle down][column from the middle right, zero padded]
    const std::int64_t* halves;  // [window]: half width in pixels
    const double* energies;  // [window]: sum of its values
    std::size_t count, widest, stride;

    std::size_t room() const { return (widest + 1) * stride; }
};

// Position of a point in a window bank: index of the first of its four windows (negative: the point spreads no light), and the
// distance from that window in steps of the bank.
template <class T>
struct BankPlace {
    std::int32_t first;
    T within;
};

// Interpolated window of one point: index of the first window, cubic Lagrange weights of the four, half width in pixels, and
// occlusion layer. `any`: the point spreads light. `hidden`: some pixels that its window reaches see the point only in part.
template <class T>
struct Mixture {
    T weights[4];
    std::uint32_t first, half;
    T layer;
    bool any, hidden;
};

// Weights of the four windows summed for a point.
template <class T>
class Mixer {
   public:
    explicit Mixer(const WindowBank<T>& bank)
        : last_(static_cast<std::int32_t>(bank.count) - 1), halves_(bank.count - 3),
          energies_(bank.energies, bank.energies + bank.count) {
        for (std::size_t i = 0; i < halves_.size(); ++i) {
            halves_[i] = static_cast<std::uint32_t>(*std::max_element(bank.halves + i, bank.halves + i + 4));
        }
    }

    std::size_t half(std::int32_t first) const { return halves_[static_cast<std::size_t>(first)]; }

    LOMMEL_INLINE BankPlace<T> place(double position, T value) const {
        const double inside = std::min(std::max(position, 0.0), static_cast<double>(last_));
        const std::int32_t first = std::min(std::max(static_cast<std::int32_t>(inside) - 1, 0), last_ - 3);
        return {position < 0.0 || value == T(0) ? -1 : first, static_cast<T>(inside - static_cast<double>(first))};
    }

    LOMMEL_INLINE void operator()(const BankPlace<T>& place, T value, Mixture<T>& m) const {
        m.any = place.first >= 0;
        if (!m.any) {
            m.first = m.half = 0;
            std::fill_n(m.weights, 4, T(0));
            return;
        }
        const std::size_t first = static_cast<std::size_t>(place.first);
        m.first = static_cast<std::uint32_t>(first), m.half = halves_[first];
        // Copy the number place.within to all lanes by adding it to 0: splat() needs vectors of the processor's own width.
        const V t = V{} + place.within;
        const V a = load<V>(powers[0]), b = load<V>(powers[1]), c = load<V>(powers[2]), d = load<V>(powers[3]);
        const V energies = load<V>(energies_.data() + first), weights = a + t * (b + t * (c + t * d));
        store(m.weights, weights * (V{} + value / total(weights * energies)));
    }

   private:
    using V = std::conditional_t<sizeof(T) == 4, typename Vector<2>::floats, typename Vector<4>::pack>;
    // Cubic Lagrange polynomials with the nodes 0, 1, 2, 3: [power][node].
    static constexpr T powers[4][4] = {{T(1), T(0), T(0), T(0)},
                                       {T(-11.0 / 6.0), T(3), T(-1.5), T(1.0 / 3.0)},
                                       {T(1), T(-2.5), T(2), T(-0.5)},
                                       {T(-1.0 / 6.0), T(0.5), T(-0.5), T(1.0 / 6.0)}};
    LOMMEL_INLINE static T total(V of_four) { return (of_four[0] + of_four[1]) + (of_four[2] + of_four[3]); }

    std::int32_t last_;
    std::vector<std::uint32_t> halves_;  // [first window]: largest half width of the four windows, pixels
    std::vector<T, AlignedAllocator<T>> energies_;
};

}  // namespace lommel
