// Intensities, on circles around the axis, of a microscope with aberrations, for eight planes at once: sums over pupil angles,
// then Fourier transforms over azimuthal orders (docs/certificate.md, section 16).
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstring>

#include "lommel/base/product.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/special/fft.hpp"

namespace lommel {

constexpr std::size_t ring_planes = fft_rows;

// Fields in several planes on circles around the axis: azimuthal order m of field f is the sum over nodes q in the pupil of
// parts[m][f][q] * waves[q] * J_|m|(v rho_q) / sqrt(power), with v the radius of the circle and rho_q that of the node; `parts`,
// `waves` and `power` are those of the plane.
struct RingLight {
    const double* bessel;  // Bessel functions J_|m|(v rho): [|m|][circle][node]
    std::size_t orders, circles, nodes;  // azimuthal orders m = 1 - orders .. orders - 1
    const std::complex<double>* parts;   // [plane, or one for all][azimuthal order m][field][node]
    std::size_t wavefronts, fields;
    const std::complex<double>* waves;  // [plane][node in the pupil]
    const double* power;                // [plane]: collected power
    std::size_t planes;
};

// Interpolation weights of `count` taps as polynomials of 2 t - 1, with t = 0 .. 1 between the two middle taps:
// polynomials[power, highest first][tap].
struct RingTaps {
    static constexpr std::size_t most = 16;
    const double* polynomials;
    std::size_t terms, count;
};

// Interpolation from `angles` equidistant angles on each circle to any position: each circle is replaced by a weighted sum of
// itself and its neighbours (filter), azimuthal orders m are multiplied by gains[m], then taps interpolate along the radius (along)
// and along the circles (around). The interpolation error of order m is at most aliases[m] times its modulus.
struct RingSteps {
    std::size_t angles;
    const double* filter;  // weights of the circle itself, of its neighbours on either side, ...
    std::size_t filters;
    RingTaps along, around;
    const double *gains, *aliases;
    std::size_t orders;

    std::size_t finer() const { return 2 * angles; }
    std::size_t row() const { return finer() + around.count + 1; }  // angles per circle, repeated ones included
    std::size_t before() const { return along.count / 2; }          // number of circles of negative radius
};

// Maxima over all circles of a plane, for the error bound of its image.
struct RingSizes {
    explicit RingSizes(std::size_t fields) : squares(fields * ring_planes) {}
    Doubles squares;                    // largest squared modulus of a field: [field][plane]
    double top[ring_planes] = {};       // largest intensity
    double aliases[ring_planes] = {};   // largest sum of the aliasing errors of a circle's azimuthal orders
    double numbers[ring_planes] = {};   // largest sum of the moduli of a circle's azimuthal orders
};

// Intensities of eight planes on circles, filtered and interpolated to twice as many angles.
class Rings {
   public:
    Rings(const RingLight& light, const RingSteps& steps)
        : light_(light), steps_(steps), fft_(steps.angles), finer_(steps.finer()), circles_(light.circles - steps.filters + 1),
          rows_((steps.before() + circles_) * steps.row() * ring_planes) {}

    // Compute eight planes from `first` on. row(i): intensities [angle][plane] on circle i - steps.before(), negative numbers for
    // negative radii. The first angle is angle -(steps.around.count / 2), as angles are repeated at both ends of a turn.
    void fill(std::size_t first, RingSizes& sizes) {
        sum(first);
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            squares(isa, std::min(ring_planes, light_.planes - first), sizes);
            look();
            filter(isa);
            for (std::size_t j = 0; j < circles_; j += 2) {
                look();
                spread(isa, j, sizes);
            }
        });
        turn();
    }

    std::size_t rows() const { return steps_.before() + circles_; }
    const double* row(std::size_t i) const { return rows_.data() + i * steps_.row() * ring_planes; }

   private:
    // Azimuthal orders m of the fields on all circles: found_[|m|][circle][sign of m][field][re, im][plane].
    void sum(std::size_t first) {
        const std::size_t here = std::min(ring_planes, light_.planes - first), nodes = light_.nodes;
        const std::size_t each = 2 * light_.fields * fft_element;
        found_.resize(light_.orders * light_.circles * each);
        Doubles waves(nodes * fft_element), sources(nodes * each);
        for (std::size_t q = 0; q < nodes; ++q) {
            for (std::size_t p = 0; p < here; ++p) {
                const std::complex<double> wave = light_.waves[(first + p) * nodes + q] / std::sqrt(light_.power[first + p]);
                waves[q * fft_element + p] = wave.real();
                waves[q * fft_element + ring_planes + p] = wave.imag();
            }
        }
        const std::size_t all = 2 * light_.orders - 1, one = light_.fields * nodes;
        // `parts` has one wavefront for each plane, or one for all planes.
        const bool many = light_.wavefronts > 1;
        const std::size_t from = many ? first : 0, last = many ? here - 1 : 0, wavefront_stride = many ? all * one : 0;
        for (std::size_t m = 0; m < light_.orders; ++m) {
            for (std::size_t s = 0; s < 2; ++s) {
                const std::size_t order = s == 0 ? light_.orders - 1 + m : light_.orders - 1 - m;
                for (std::size_t f = 0; f < light_.fields; ++f) {
                    double* to = sources.data() + (s * light_.fields + f) * fft_element;
                    const double* wave = waves.data();
                    const std::complex<double>* part = light_.parts + (from * all + order) * one + f * nodes;
                    for (std::size_t q = 0; q < nodes; ++q, ++part, to += each, wave += fft_element) {
                        for (std::size_t p = 0; p < ring_planes; ++p) {
                            const std::complex<double> here = part[std::min(p, last) * wavefront_stride];
                            const double x = wave[p], y = wave[ring_planes + p];
                            to[p] = here.real() * x - here.imag() * y;
                            to[ring_planes + p] = here.real() * y + here.imag() * x;
                        }
                    }
                }
            }
            look();
            product(light_.bessel + m * light_.circles * nodes, light_.circles, nodes, sources.data(), each, 1,
                    found_.data() + m * light_.circles * each);
        }
    }

    // Number of doubles per circle in memory: for one angle more than needed, so that circles use different cache sets.
    std::size_t stride() const { return (fft_.n + 1) * ring_planes; }

    // Intensities at the angles of all circles: intensities_[circle][angle][plane].
    template <class I>
    LOMMEL_INLINE void squares(I isa, std::size_t here, RingSizes& sizes) {
        using V = typename I::pack;
        const std::size_t n = fft_.n, fields = light_.fields, each = 2 * fields * fft_element;
        constexpr std::size_t packs = ring_planes / I::lanes;
        intensities_.assign(light_.circles * stride(), 0.0);
        a_.assign(finer_.n * fft_element, 0.0);
        b_.resize(finer_.n * fft_element);
        V top[packs] = {};
        for (std::size_t c = 0; c < light_.circles; ++c) {
            double* const out = intensities_.data() + c * stride();
            for (std::size_t f = 0; f < fields; ++f) {
                // Restore the zero padding, which the previous transform has overwritten.
                std::fill_n(a_.data() + light_.orders * fft_element, (n - 2 * light_.orders + 1) * fft_element, 0.0);
                for (std::size_t m = 0; m < light_.orders; ++m) {
                    const double* from = found_.data() + (m * light_.circles + c) * each + f * fft_element;
                    std::memcpy(a_.data() + m * fft_element, from, sizeof(double) * fft_element);
                    if (m > 0) {
                        std::memcpy(a_.data() + (n - m) * fft_element, from + fields * fft_element,
                                    sizeof(double) * fft_element);
                    }
                }
                const double* before = fft_.run(isa, a_.data(), b_.data());
                double* const size = sizes.squares.data() + f * ring_planes;
                V largest[packs];
                for (std::size_t p = 0; p < packs; ++p) {
                    largest[p] = load<V>(size + p * I::lanes);
                }
                for (std::size_t q = 0; q < n / 4; ++q) {
                    for (std::size_t p = 0; p < packs; ++p) {
                        ComplexPack<V> x[4];
                        fft_.last(before + q * fft_element + p * I::lanes, x);
                        for (std::size_t k = 0; k < 4; ++k) {
                            double* const to = out + (q + k * n / 4) * ring_planes + p * I::lanes;
                            const V square = x[k].re * x[k].re + x[k].im * x[k].im, total = load<V>(to) + square;
                            largest[p] = larger(largest[p], square);
                            top[p] = larger(top[p], total);
                            store(to, total);
                        }
                    }
                }
                for (std::size_t p = 0; p < packs; ++p) {
                    store(size + p * I::lanes, largest[p]);
                }
            }
        }
        for (std::size_t p = 0; p < here; ++p) {
            sizes.top[p] = top[p / I::lanes][p % I::lanes];
        }
    }

    // Filter each circle by its neighbours, angle by angle. The circle of radius -r is that of radius r rotated by half a turn.
    template <class I>
    LOMMEL_INLINE void filter(I) {
        using V = typename I::pack;
        const std::size_t n = fft_.n, margin = steps_.filters - 1;
        filtered_.resize(circles_ * stride());
        line_.resize((margin + light_.circles) * ring_planes);
        double* const line = line_.data() + margin * ring_planes;
        for (std::size_t q = 0; q < n; ++q) {
            for (std::size_t c = 0; c < light_.circles; ++c) {
                std::memcpy(line + c * ring_planes, intensities_.data() + c * stride() + q * ring_planes,
                            sizeof(double) * ring_planes);
            }
            for (std::size_t c = 1; c <= margin; ++c) {
                std::memcpy(line - c * ring_planes, intensities_.data() + c * stride() + (q + n / 2) % n * ring_planes,
                            sizeof(double) * ring_planes);
            }
            for (std::size_t j = 0; j < circles_; ++j) {
                for (std::size_t p = 0; p < ring_planes; p += I::lanes) {
                    const double* at = line + j * ring_planes + p;
                    V sum = splat<V>(steps_.filter[0]) * load<V>(at);
                    for (std::size_t k = 1; k < steps_.filters; ++k) {
                        sum =
                            sum + splat<V>(steps_.filter[k]) * (load<V>(at + k * ring_planes) + load<V>(at - k * ring_planes));
                    }
                    store(filtered_.data() + j * stride() + q * ring_planes + p, sum);
                }
            }
        }
    }

    // Interpolate the filtered circles j and j + 1 to twice as many angles, in one complex transform: one circle is the real part,
    // the other the imaginary part. The circles stay separate, as the gains are real and equal for orders m and -m.
    template <class I>
    LOMMEL_INLINE void spread(I isa, std::size_t j, RingSizes& sizes) {
        using V = typename I::pack;
        constexpr std::size_t packs = ring_planes / I::lanes;
        const std::size_t n = fft_.n;
        for (std::size_t i = 0; i < 2; ++i) {
            const double* from = filtered_.data() + std::min(j + i, circles_ - 1) * stride();
            for (std::size_t q = 0; q < n; ++q) {
                std::memcpy(a_.data() + q * fft_element + i * ring_planes, from + q * ring_planes,
                            sizeof(double) * ring_planes);
            }
        }
        const double* orders = fft_.whole(isa, a_.data(), b_.data());
        double* const to = orders == a_.data() ? b_.data() : a_.data();
        // Zero the first and the last n / 2 elements, the only ones that the transform reads; then write the orders into them.
        std::fill_n(to, n / 2 * fft_element, 0.0);
        std::fill_n(to + (finer_.n - n / 2) * fft_element, n / 2 * fft_element, 0.0);
        V off[packs] = {}, size[packs] = {};
        for (std::size_t m = 0; m < steps_.orders; ++m) {
            const V gain = splat<V>(steps_.gains[m] / static_cast<double>(n));
            const V alias = splat<V>(steps_.aliases[m] / static_cast<double>(n));
            // The second transform is a forward one, like the first, so the angle is reversed: order m goes to index -m.
            const auto put = [&](std::size_t from, std::size_t at) LOMMEL_INLINE_LAMBDA {
                for (std::size_t p = 0; p < packs; ++p) {
                    const V re = load<V>(orders + from * fft_element + p * I::lanes);
                    const V im = load<V>(orders + from * fft_element + ring_planes + p * I::lanes);
                    const V sum = larger(re, splat<V>(0.0) - re) + larger(im, splat<V>(0.0) - im);
                    off[p] = off[p] + alias * sum;
                    size[p] = size[p] + gain * sum;
                    store(to + at * fft_element + p * I::lanes, gain * re);
                    store(to + at * fft_element + ring_planes + p * I::lanes, gain * im);
                }
            };
            put(m, m == 0 ? 0 : finer_.n - m);
            if (m > 0) {
                put(n - m, m);
            }
        }
        for (std::size_t p = 0; p < ring_planes; ++p) {
            sizes.aliases[p] = std::max(sizes.aliases[p], double(off[p / I::lanes][p % I::lanes]));
            sizes.numbers[p] = std::max(sizes.numbers[p], double(size[p / I::lanes][p % I::lanes]));
        }
        const double* before = finer_.run(isa, to, to == a_.data() ? b_.data() : a_.data());
        const std::size_t circle_stride = steps_.row() * ring_planes;
        double* const row = rows_.data() + (steps_.before() + j) * circle_stride + steps_.around.count / 2 * ring_planes;
        const bool both = j + 1 < circles_;
        for (std::size_t q = 0; q < finer_.n / 4; ++q) {
            for (std::size_t p = 0; p < packs; ++p) {
                ComplexPack<V> x[4];
                finer_.last(before + q * fft_element + p * I::lanes, x);
                for (std::size_t k = 0; k < 4; ++k) {
                    double* const at = row + (q + k * finer_.n / 4) * ring_planes + p * I::lanes;
                    store(at, x[k].re);
                    if (both) {
                        store(at + circle_stride, x[k].im);
                    }
                }
            }
        }
    }

    // Fill the circles of negative radius, and repeat angles at both ends of a turn.
    void turn() {
        const std::size_t before = steps_.before(), circle_stride = steps_.row() * ring_planes, turn = finer_.n * ring_planes;
        const std::size_t margin = steps_.around.count / 2 * ring_planes;
        for (std::size_t i = 1; i <= before; ++i) {
            const double* from = rows_.data() + (before + i) * circle_stride + margin;
            double* to = rows_.data() + (before - i) * circle_stride + margin;
            std::copy_n(from, turn / 2, to + turn / 2);
            std::copy_n(from + turn / 2, turn / 2, to);
        }
        for (std::size_t i = 0; i < rows(); ++i) {
            double* const row = rows_.data() + i * circle_stride;
            std::copy_n(row + turn, margin, row);
            std::copy_n(row + margin, circle_stride - margin - turn, row + margin + turn);
        }
    }

    RingLight light_;
    RingSteps steps_;
    RowFft<double> fft_, finer_;
    std::size_t circles_;
    Doubles rows_, found_, intensities_, filtered_, line_, a_, b_;
};

}  // namespace lommel
