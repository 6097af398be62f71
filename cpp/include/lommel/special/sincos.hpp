// Sine and cosine of vectors of doubles (radians), and of angles in units of 2^-32 turns as floats.
#pragma once

#include "lommel/base/simd.hpp"

namespace lommel {

// Sine and cosine with an absolute error below 2e-16, plus 1e-16 from the reduction of the argument, for |x| < 1e6: Cody and
// Waite's reduction by pi/2 in three parts, then the minimax polynomials of fdlibm on [-pi/4, pi/4].
template <class I>
LOMMEL_INLINE void sincos(I, typename I::pack x, typename I::pack& sine, typename I::pack& cosine) {
    using V = typename I::pack;
    // Adding 1.5 * 2^52 rounds to the nearest integer, which is then in the lowest bits.
    const V magic = splat<V>(6755399441055744.0);
    const V shifted = x * splat<V>(0.63661977236758134308) + magic;
    const V k = shifted - magic;
    V r = x - k * splat<V>(1.57079632673412561417e+00);
    r = r - k * splat<V>(6.07710050630396597660e-11);
    r = r - k * splat<V>(2.02226624879595063154e-21);
    const V z = r * r;
    V s = splat<V>(1.58969099521155010221e-10);
    s = s * z + splat<V>(-2.50507602534068634195e-08);
    s = s * z + splat<V>(2.75573137070700676789e-06);
    s = s * z + splat<V>(-1.98412698298579493134e-04);
    s = s * z + splat<V>(8.33333333332248946124e-03);
    s = s * z + splat<V>(-1.66666666666666324348e-01);
    s = r + r * z * s;
    V c = splat<V>(-1.13596475577881948265e-11);
    c = c * z + splat<V>(2.08757232129817482790e-09);
    c = c * z + splat<V>(-2.75573143513906633035e-07);
    c = c * z + splat<V>(2.48015872894767294178e-05);
    c = c * z + splat<V>(-1.38888888888741095749e-03);
    c = c * z + splat<V>(4.16666666666666019037e-02);
    c = splat<V>(1.0) - splat<V>(0.5) * z + z * z * c;
    typename I::bits quadrant;
    std::memcpy(&quadrant, &shifted, sizeof quadrant);
    const V a = choose(quadrant, 1, c, s), b = choose(quadrant, 1, s, c);
    sine = choose(quadrant, 2, splat<V>(0.0) - a, a);
    cosine = choose(quadrant + 1, 2, splat<V>(0.0) - b, b);
}

// Sine and cosine, as floats, of multiples x of 2^-32 turns: the vector (cos, sin) has an error below 5 roundings to float. The
// two highest bits of `shifted` are the nearest quarter turn; the remaining angle is at most pi/4, where polynomials of degree
// 7 and 8 have an error below 2e-9.
template <class W, class V>
LOMMEL_INLINE void sincos_turns(W x, V& sine, V& cosine) {
    const W shifted = x + 0x20000000u, half = shifted & 0x80000000u, other = (shifted + 0x40000000u) & 0x80000000u;
    const V r = signed_floats<V>(x - (shifted & 0xc0000000u)) * splat<V>(1.4629180792671596e-09f);  // 2 pi / 2^32
    const V z = r * r;
    V s = splat<V>(-1.9496e-04f);
    s = s * z + splat<V>(8.33198e-03f);
    s = s * z + splat<V>(-1.6666651e-01f);
    s = r + r * (z * s);
    V c = splat<V>(2.43904508e-05f);
    c = c * z + splat<V>(-1.38867638e-03f);
    c = c * z + splat<V>(4.16666233e-02f);
    c = c * z + splat<V>(-4.99999997e-01f);
    c = splat<V>(1.0f) + z * c;
    const W quarter = shifted & 0x40000000u;
    sine = flipped(choose_lanes(quarter, c, s), half);
    cosine = flipped(choose_lanes(quarter, s, c), other);
}

}  // namespace lommel
