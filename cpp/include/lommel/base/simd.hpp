// Vectors of doubles and floats, compiled for several instruction sets, one of which is chosen at run time.
#pragma once

#if defined(__FAST_MATH__)
#error "the error bounds assume IEEE arithmetic: leave -ffast-math out"
#endif

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <type_traits>
#include <utility>

#include "lommel/base/aligned.hpp"

#if defined(__GNUC__) || defined(__clang__)
#define LOMMEL_INLINE inline __attribute__((always_inline))
#define LOMMEL_INLINE_LAMBDA __attribute__((always_inline))
#define LOMMEL_NOINLINE __attribute__((noinline))
#else
#define LOMMEL_INLINE inline
#define LOMMEL_INLINE_LAMBDA
#define LOMMEL_NOINLINE
#endif

namespace lommel {

// LOMMEL_VECTORS: the compiler has vector types. Without them, or with LOMMEL_WITHOUT_VECTORS, loops over lanes are compiled.
#if (defined(__GNUC__) || defined(__clang__)) && !defined(LOMMEL_WITHOUT_VECTORS)
#define LOMMEL_VECTORS 1
#if defined(__x86_64__)
#define LOMMEL_X86 1
#endif
#endif

// Table rows are padded to a multiple of this number of doubles: the lanes of the widest vector, whichever is used.
constexpr std::size_t row_lanes = 8;

#ifdef LOMMEL_VECTORS

template <std::size_t Lanes>
struct Vector {
    typedef double pack __attribute__((vector_size(8 * Lanes)));
    typedef std::int64_t bits __attribute__((vector_size(8 * Lanes)));
    typedef float floats __attribute__((vector_size(8 * Lanes)));  // twice as many lanes as pack
    typedef float narrow __attribute__((vector_size(4 * Lanes)));  // as many lanes as pack
    typedef std::uint32_t turns __attribute__((vector_size(8 * Lanes)));  // angles in units of 2^-32 turns
};
template <class V, class Narrow>
LOMMEL_INLINE V converted(Narrow p) {
#if defined(LOMMEL_X86) && !defined(__clang__)
    if constexpr (sizeof(V) > 16 && sizeof(V) == 2 * sizeof(Narrow)) {  // converted by one instruction, where GCC uses two
        V wide;
        asm("vcvtps2pd %1, %0" : "=v"(wide) : "vm"(p));
        return wide;
    }
#endif
    return __builtin_convertvector(p, V);
}

// Vector with all lanes equal to x, computed as x - 0: compilers reduce this to a broadcast instruction, but fill an
// initializer list lane by lane.
template <class V, class Real>
LOMMEL_INLINE V splat(Real x) {
#if defined(LOMMEL_X86) && !defined(__clang__)
    // In assembly: this function is written for baseline registers of 16 bytes, so GCC splits wider vectors in it, even where
    // it is inlined into a kernel for wider registers, and reassembles broadcasts (unlike sums and products) in many steps.
    if constexpr (sizeof(V) > 16) {
        V v;
        if constexpr (sizeof(Real) == 4) {
            asm("vbroadcastss %1, %0" : "=v"(v) : "vm"(x));
        } else {
            asm("vbroadcastsd %1, %0" : "=v"(v) : "vm"(x));
        }
        return v;
    }
#endif
    return x - V{};
}
// Return v, kept in a register by an empty assembly statement: GCC would load v from memory for each use.
template <class V>
LOMMEL_INLINE V loaded(V v) {
#if defined(LOMMEL_X86) && !defined(__clang__)
    asm("" : "+v"(v));
#endif
    return v;
}
template <class V>
LOMMEL_INLINE V larger(V a, V b) {
#if defined(LOMMEL_X86) && !defined(__clang__)
    // In assembly, as a single instruction: for floats, GCC compiles a > b ? a : b to two, a comparison and a mask.
    if constexpr (sizeof(V) > 16 && sizeof(a[0]) == sizeof(float)) {
        V v;
        asm("vmaxps %2, %1, %0" : "=v"(v) : "v"(a), "v"(b));
        return v;
    }
#endif
    return a > b ? a : b;
}
template <class V>
LOMMEL_INLINE V smaller(V a, V b) {
    return a < b ? a : b;
}
template <class V>
LOMMEL_INLINE V below(V x, V limit, V a, V b) {
    return x < limit ? a : b;
}
// 2^k in each lane, given shifted = 1.5 * 2^52 + k with an integer k, which the low bits of `shifted` hold.
template <class B, class V>
LOMMEL_INLINE V power_of_two(V shifted) {
    B bits;
    std::memcpy(&bits, &shifted, sizeof bits);
    bits = (bits << 52) + (std::int64_t{1023} << 52);
    std::memcpy(&shifted, &bits, sizeof shifted);
    return shifted;
}
template <class B, class V>
LOMMEL_INLINE V choose(B at, std::int64_t bit, V a, V b) {
    return (at & bit) != 0 ? a : b;
}
// Low 32 bits of the 64-bit lanes of a and b, interleaved: a[0], b[0], a[1], b[1], ...
template <class W, class V>
LOMMEL_INLINE W low_halves(V a, V b) {
    typedef std::uint64_t Bits __attribute__((vector_size(sizeof(V))));
    Bits low, high;
    std::memcpy(&low, &a, sizeof low);
    std::memcpy(&high, &b, sizeof high);
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    std::swap(low, high);
#endif
    const Bits both = (low & 0xffffffffu) | (high << 32);
    W w;
    std::memcpy(&w, &both, sizeof w);
    return w;
}
// Convert 32-bit integers, read as signed, to floats.
template <class V, class W>
LOMMEL_INLINE V signed_floats(W w) {
    typedef std::int32_t Whole __attribute__((vector_size(sizeof(W))));
    Whole whole;
    std::memcpy(&whole, &w, sizeof whole);
    return __builtin_convertvector(whole, V);
}
template <class W, class V>
LOMMEL_INLINE V choose_lanes(W at, V a, V b) {
    return at != 0 ? a : b;
}
template <class V, class W>
LOMMEL_INLINE V flipped(V v, W bits) {
    W w;
    std::memcpy(&w, &v, sizeof w);
    w = w ^ bits;
    std::memcpy(&v, &w, sizeof v);
    return v;
}
// Truncate the lanes of x to integers, and read the bits of these integers as floats.
template <class V>
LOMMEL_INLINE V from_bits(V x) {
    typedef std::int32_t Whole __attribute__((vector_size(sizeof(V))));
    const Whole whole = __builtin_convertvector(x, Whole);
    std::memcpy(&x, &whole, sizeof x);
    return x;
}
#if !defined(__clang__)
LOMMEL_INLINE std::size_t low_place(std::uint64_t places) {
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    return places >> 32;
#else
    return static_cast<std::uint32_t>(places);
#endif
}
LOMMEL_INLINE std::size_t high_place(std::uint64_t places) {
#if __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    return static_cast<std::uint32_t>(places);
#else
    return places >> 32;
#endif
}
// Load two floats from c + at[0] and two from c + at[1]; for eight lanes also two from c + at[4] and two from c + at[5].
template <class V>
LOMMEL_INLINE V pairs(const float* c, const std::int32_t* at) {
    typedef double Two __attribute__((vector_size(16)));
    const auto two = [&](std::size_t i) LOMMEL_INLINE_LAMBDA {  // loads at[i] and at[i + 1], both >= 0, at once
        std::uint64_t places;
        std::memcpy(&places, at + i, sizeof places);
        typedef double Second __attribute__((aligned(4), may_alias));
        double first;
        std::memcpy(&first, c + low_place(places), sizeof first);
        const Second& second = *reinterpret_cast<const Second*>(c + high_place(places));
        Two both = {first, 0.0};
#ifdef LOMMEL_X86
        if constexpr (sizeof(V) > 16) {
            asm("vmovhps %1, %0, %0" : "+x"(both) : "m"(second));
            return both;
        }
#endif
        both[1] = second;
        return both;
    };
    V v;
    const Two low = two(0);
    if constexpr (sizeof(V) == 16) {
        std::memcpy(&v, &low, sizeof v);
    }
#ifdef LOMMEL_X86
    if constexpr (sizeof(V) == 32) {
        const Two high = two(4);
        asm("vinsertf128 $1, %2, %t1, %0" : "=x"(v) : "x"(low), "xm"(high));
    }
#endif
    return v;
}
// Separate pairs: in each group of four lanes, `first` has the first elements of the pairs of a and b, `second` the second ones.
template <class V>
LOMMEL_INLINE void turned_pairs(V a, V b, V& first, V& second) {
    if constexpr (sizeof(V) == 16) {
        typedef std::int32_t Order __attribute__((vector_size(16)));
        first = __builtin_shuffle(a, b, Order{0, 2, 4, 6});
        second = __builtin_shuffle(a, b, Order{1, 3, 5, 7});
    }
#ifdef LOMMEL_X86
    if constexpr (sizeof(V) > 16) {
        asm("vshufps $0x88, %2, %1, %0" : "=v"(first) : "v"(a), "v"(b));
        asm("vshufps $0xdd, %2, %1, %0" : "=v"(second) : "v"(a), "v"(b));
    }
#endif
}
// Load four floats from c + at[0]; a vector of eight lanes has four more from c + at[4].
template <class V>
LOMMEL_INLINE V fours(const float* c, const std::int32_t* at) {
    V v;
    if constexpr (sizeof(V) == 16) {
        std::memcpy(&v, c + at[0], sizeof v);
    }
#ifdef LOMMEL_X86
    if constexpr (sizeof(V) == 32) {
        typedef float Quad __attribute__((vector_size(16)));
        Quad low, high;
        std::memcpy(&low, c + at[0], sizeof low);
        std::memcpy(&high, c + at[4], sizeof high);
        asm("vinsertf128 $1, %2, %t1, %0" : "=x"(v) : "x"(low), "xm"(high));
    }
#endif
    return v;
}
// Transpose 4 x 4 blocks: in each group of four lanes, out[k] holds lane k of a, b, c and d.
template <class V>
LOMMEL_INLINE void turned_fours(V a, V b, V c, V d, V (&out)[4]) {
    if constexpr (sizeof(V) == 16) {
        typedef std::int32_t Order __attribute__((vector_size(16)));
        const Order low = {0, 4, 1, 5}, high = {2, 6, 3, 7}, first_half = {0, 1, 4, 5}, second_half = {2, 3, 6, 7};
        const V ab = __builtin_shuffle(a, b, low), cd = __builtin_shuffle(c, d, low), ab2 = __builtin_shuffle(a, b, high),
                cd2 = __builtin_shuffle(c, d, high);
        out[0] = __builtin_shuffle(ab, cd, first_half);
        out[1] = __builtin_shuffle(ab, cd, second_half);
        out[2] = __builtin_shuffle(ab2, cd2, first_half);
        out[3] = __builtin_shuffle(ab2, cd2, second_half);
    }
#ifdef LOMMEL_X86
    if constexpr (sizeof(V) > 16) {
        V ab, cd, ab2, cd2;
        asm("vunpcklps %2, %1, %0" : "=v"(ab) : "v"(a), "v"(b));
        asm("vunpcklps %2, %1, %0" : "=v"(cd) : "v"(c), "v"(d));
        asm("vunpckhps %2, %1, %0" : "=v"(ab2) : "v"(a), "v"(b));
        asm("vunpckhps %2, %1, %0" : "=v"(cd2) : "v"(c), "v"(d));
        asm("vunpcklpd %2, %1, %0" : "=v"(out[0]) : "v"(ab), "v"(cd));
        asm("vunpckhpd %2, %1, %0" : "=v"(out[1]) : "v"(ab), "v"(cd));
        asm("vunpcklpd %2, %1, %0" : "=v"(out[2]) : "v"(ab2), "v"(cd2));
        asm("vunpckhpd %2, %1, %0" : "=v"(out[3]) : "v"(ab2), "v"(cd2));
    }
#endif
}
#endif
template <class Order, class Real, class V, std::size_t... I>
LOMMEL_INLINE V permuted(V v, std::index_sequence<I...>) {
#ifdef __clang__
    return __builtin_shufflevector(v, v, Order::at(I, sizeof...(I))...);
#else
    using Lane = std::conditional_t<sizeof(Real) == 4, std::int32_t, std::int64_t>;
    typedef Lane Sequence __attribute__((vector_size(sizeof(V))));
    constexpr Lane from[] = {static_cast<Lane>(Order::at(I, sizeof...(I)))...};
#ifdef LOMMEL_X86
    // Doubles are permuted as pairs of floats: AVX2 has no instruction that permutes four doubles by indices in a register.
    if constexpr (sizeof(V) > 16) {
        constexpr std::int64_t pair = std::int64_t{1} << 32;
        alignas(64) static constexpr Lane sequence[] = {
            static_cast<Lane>(sizeof(Real) == 4 ? from[I] : 2 * from[I] + pair * (2 * from[I] + 1))...};
        V in, out;
        std::memcpy(&in, sequence, sizeof in);
        asm("vpermps %1, %2, %0" : "=v"(out) : "v"(v), "v"(in));
        return out;
    } else
#endif
        return __builtin_shuffle(v, Sequence{from[I]...});
#endif
}

#else

template <class Real, std::size_t Lanes>
struct Pack {
    Real v[Lanes];
    friend Pack operator+(Pack a, Pack b) {
        return each(a, b, [](Real x, Real y) { return x + y; });
    }
    friend Pack operator-(Pack a, Pack b) {
        return each(a, b, [](Real x, Real y) { return x - y; });
    }
    friend Pack operator*(Pack a, Pack b) {
        return each(a, b, [](Real x, Real y) { return x * y; });
    }
    friend Pack operator/(Pack a, Pack b) {
        return each(a, b, [](Real x, Real y) { return x / y; });
    }
    friend Pack operator+(Pack a, Real b) {
        return each(a, a, [b](Real x, Real) { return x + b; });
    }
    friend Pack operator&(Pack a, Real b) {
        return each(a, a, [b](Real x, Real) { return x & b; });
    }
    Real operator[](std::size_t i) const { return v[i]; }
    template <class F>
    static Pack each(Pack a, Pack b, F f) {
        for (std::size_t i = 0; i < Lanes; ++i) {
            a.v[i] = f(a.v[i], b.v[i]);
        }
        return a;
    }
};

template <std::size_t Lanes>
struct Vector {
    using pack = Pack<double, Lanes>;
    using floats = Pack<float, 2 * Lanes>;
    using narrow = Pack<float, Lanes>;
    using turns = Pack<std::uint32_t, 2 * Lanes>;
    struct bits {
        std::int64_t v[Lanes];
        friend bits operator+(bits a, std::int64_t b) {
            for (std::int64_t& lane : a.v) {
                lane += b;
            }
            return a;
        }
    };
};

template <class V, class Real>
LOMMEL_INLINE V splat(Real x) {
    V p;
    for (auto& lane : p.v) {
        lane = x;
    }
    return p;
}
template <class V>
LOMMEL_INLINE V loaded(V v) {
    return v;
}
template <class V>
LOMMEL_INLINE V larger(V a, V b) {
    return V::each(a, b, [](auto x, auto y) { return x > y ? x : y; });
}
template <class W, class V>
LOMMEL_INLINE W low_halves(V a, V b) {
    W w;
    for (std::size_t i = 0; i < sizeof(V) / sizeof(double); ++i) {
        std::uint64_t bits[2];
        std::memcpy(&bits[0], &a.v[i], sizeof(double));
        std::memcpy(&bits[1], &b.v[i], sizeof(double));
        w.v[2 * i] = static_cast<std::uint32_t>(bits[0]);
        w.v[2 * i + 1] = static_cast<std::uint32_t>(bits[1]);
    }
    return w;
}
template <class V, class W>
LOMMEL_INLINE V signed_floats(W w) {
    V v;
    for (std::size_t i = 0; i < sizeof(W) / sizeof(float); ++i) {
        v.v[i] = static_cast<float>(static_cast<std::int32_t>(w.v[i]));
    }
    return v;
}
template <class W, class V>
LOMMEL_INLINE V choose_lanes(W at, V a, V b) {
    for (std::size_t i = 0; i < sizeof(V) / sizeof(float); ++i) {
        a.v[i] = at.v[i] != 0 ? a.v[i] : b.v[i];
    }
    return a;
}
template <class V, class W>
LOMMEL_INLINE V flipped(V v, W bits) {
    for (std::size_t i = 0; i < sizeof(V) / sizeof(float); ++i) {
        std::uint32_t lane;
        std::memcpy(&lane, &v.v[i], sizeof lane);
        lane ^= bits.v[i];
        std::memcpy(&v.v[i], &lane, sizeof lane);
    }
    return v;
}
template <class V>
LOMMEL_INLINE V from_bits(V x) {
    for (float& lane : x.v) {
        const std::int32_t whole = static_cast<std::int32_t>(lane);
        std::memcpy(&lane, &whole, sizeof lane);
    }
    return x;
}
template <class V>
LOMMEL_INLINE V smaller(V a, V b) {
    return V::each(a, b, [](double x, double y) { return x < y ? x : y; });
}
template <class V>
LOMMEL_INLINE V below(V x, V limit, V a, V b) {
    for (std::size_t i = 0; i < sizeof(V) / sizeof(x[0]); ++i) {
        a.v[i] = x.v[i] < limit.v[i] ? a.v[i] : b.v[i];
    }
    return a;
}
template <class B, class V>
LOMMEL_INLINE V power_of_two(V shifted) {
    return V::each(shifted, shifted,
                   [](double x, double) { return std::ldexp(1.0, static_cast<int>(x - 6755399441055744.0)); });
}
template <class V, class Narrow>
LOMMEL_INLINE V converted(Narrow p) {
    V wide;
    std::copy(std::begin(p.v), std::end(p.v), wide.v);
    return wide;
}
template <class B, class V>
LOMMEL_INLINE V choose(B at, std::int64_t bit, V a, V b) {
    for (std::size_t i = 0; i < sizeof(V) / sizeof(double); ++i) {
        a.v[i] = (at.v[i] & bit) != 0 ? a.v[i] : b.v[i];
    }
    return a;
}
template <class Order, class Real, class V, std::size_t... I>
LOMMEL_INLINE V permuted(V v, std::index_sequence<I...>) {
    return V{{v[Order::at(I, sizeof...(I))]...}};
}

#endif

// Permute lanes: lane i of the result is lane Order::at(i, lanes) of v.
template <class Order, class Real, class V>
LOMMEL_INLINE V permuted(V v) {
    return permuted<Order, Real>(v, std::make_index_sequence<sizeof(V) / sizeof(Real)>());
}

template <class V, class Real>
LOMMEL_INLINE V load(const Real* from) {
    V p;
    std::memcpy(&p, from, sizeof p);
    return p;
}
template <class V, class Real>
LOMMEL_INLINE void store(Real* to, V p) {
    std::memcpy(to, &p, sizeof p);
}
LOMMEL_INLINE void prefetch(const void* at) {
#if defined(__GNUC__) || defined(__clang__)
    __builtin_prefetch(at);
#else
    static_cast<void>(at);
#endif
}
// Load one value for each lane of a vector of doubles; floats are converted to double.
template <class I>
LOMMEL_INLINE typename I::pack widened(const float* from) {
    return converted<typename I::pack>(load<typename Vector<I::lanes>::narrow>(from));
}
template <class I>
LOMMEL_INLINE typename I::pack widened(const double* from) {
    return load<typename I::pack>(from);
}
template <class V>
LOMMEL_INLINE double lane_sum(V v) {
    double sum = 0.0;
    for (std::size_t i = 0; i < sizeof(V) / sizeof(double); ++i) {
        sum += v[i];
    }
    return sum;
}

// Instruction set of a kernel: vector types, and `unroll`, the number of vectors that fit in registers for each of three arrays.
template <std::size_t Lanes, std::size_t Unroll>
struct Isa {
    using pack = typename Vector<Lanes>::pack;
    using bits = typename Vector<Lanes>::bits;
    using floats = typename Vector<Lanes>::floats;
    using turns = typename Vector<Lanes>::turns;
    static constexpr std::size_t lanes = Lanes, unroll = Unroll;
};
using Avx512 = Isa<8, 4>;
using Avx2 = Isa<4, 4>;
using Portable = Isa<2, 4>;
constexpr std::size_t widest_step = 32;  // most values that a kernel handles at once or accesses past an array's end

// Whether only processors without AVX2, which are rare, take the instruction set I.
#ifdef LOMMEL_X86
template <class I>
constexpr bool is_fallback = std::is_same_v<I, Portable>;
#else
template <class I>
constexpr bool is_fallback = false;
#endif

enum class Level { portable, avx2, avx512 };

// Highest instruction level that processor_level() returns; tests lower it to compare the levels.
inline std::atomic<Level>& level_limit() {
    static std::atomic<Level> limit{Level::avx512};
    return limit;
}

inline Level processor_level() {
#ifdef LOMMEL_X86
    static const Level found = [] {
        __builtin_cpu_init();
        if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
            __builtin_cpu_supports("avx512bw")) {
            return Level::avx512;
        }
        return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") ? Level::avx2 : Level::portable;
    }();
    return std::min(found, level_limit().load(std::memory_order_relaxed));
#else
    return Level::portable;
#endif
}

// Kernels of the compiled library are optimized in full although what surrounds them is not (cmake/python.cmake): their loops
// over arrays of vectors must be unrolled for these to stay in registers. So are plain loops over the pixels of a photograph.
#if defined(LOMMEL_COMPILED) && defined(__GNUC__) && !defined(__clang__)
#define LOMMEL_KERNEL LOMMEL_NOINLINE __attribute__((optimize("O3", "no-math-errno")))
#else
#define LOMMEL_KERNEL LOMMEL_NOINLINE
#endif
#ifdef LOMMEL_X86
template <class Kernel>
LOMMEL_KERNEL __attribute__((target("avx512f,avx512dq,avx512vl,avx512bw,avx2,fma"))) void run_avx512(const Kernel& kernel) {
    kernel(Avx512{});
}
template <class Kernel>
LOMMEL_KERNEL __attribute__((target("avx2,fma"))) void run_avx2(const Kernel& kernel) {
    kernel(Avx2{});
}
template <class Kernel>
LOMMEL_KERNEL void run_portable(const Kernel& kernel) {
    kernel(Portable{});
}
#endif

// Run a kernel with AVX2 instructions if `level`, which the processor must have, is avx2 or avx512; otherwise with baseline ones.
// The kernel and all that it calls must be inlined, or they use baseline instructions. Each call of dispatch() compiles its kernel
// twice, for AVX2 and for the baseline; a kernel takes its caller's functions as a Reference, so that it is not compiled again for
// each caller.
template <class Kernel>
LOMMEL_INLINE void dispatch([[maybe_unused]] Level level, const Kernel& kernel) {
#ifdef LOMMEL_X86
    level >= Level::avx2 ? run_avx2(kernel) : run_portable(kernel);
#else
    kernel(Portable{});
#endif
}
template <class Kernel>
LOMMEL_INLINE void dispatch(const Kernel& kernel) {
    dispatch(processor_level(), kernel);
}

// Like dispatch(), but compiled for AVX-512 as well, for kernels that this accelerates by much more than the usual 5 %.
template <class Kernel>
LOMMEL_INLINE void dispatch_widest([[maybe_unused]] Level level, const Kernel& kernel) {
#ifdef LOMMEL_X86
    if (level == Level::avx512) {
        return run_avx512(kernel);
    }
#endif
    dispatch(level, kernel);
}
template <class Kernel>
LOMMEL_INLINE void dispatch_widest(const Kernel& kernel) {
    dispatch_widest(processor_level(), kernel);
}

// Number of doubles in a vector of a kernel run by dispatch_widest().
constexpr std::size_t widest_lanes(Level level) {
    return level == Level::avx512 ? Avx512::lanes : level == Level::avx2 ? Avx2::lanes : Portable::lanes;
}

}  // namespace lommel
