// From pupils that are not radially symmetric to finished images, each with its proven error.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lommel/images.hpp"
#include "lommel/octants.hpp"
#include "lommel/parallel.hpp"
#include "lommel/zernike_field.hpp"

namespace lommel {

// Pupils of the same terms (n, m). `inner` are the coefficients within the obscuration, over its radius; not read without.
struct ZernikeStack {
    const std::int32_t *n, *m;
    const double *outer, *inner;  // [pupil][term]
    std::size_t count, terms;
    double obscuration, gaussian;

    ZernikePhase phase(std::size_t i) const { return {n, m, outer + i * terms, terms, gaussian}; }
    ZernikePhase inner_phase(std::size_t i) const {
        return {n, m, inner + i * terms, terms, gaussian * obscuration * obscuration};
    }
};

template <class T>
class ZernikeRenderer {
   public:
    // The axis of pupil i is in the middle of pixel (rows[i], columns[i]), which may be outside of the image.
    ZernikeRenderer(const ZernikeStack& stack, std::size_t height, std::size_t width, const std::int64_t* rows,
                    const std::int64_t* columns, double step, double tol, int threads, T* images, double* scales, double* bounds)
        : stack_(stack), height_(height), width_(width), rows_(rows), columns_(columns), step_(step), tol_(tol),
          threads_(threads), images_(images), scales_(scales), bounds_(bounds) {}

    void run() {
        if (stack_.count > 1) {
            parallel_for(stack_.count, threads_, [&](std::size_t, std::size_t pupil) { render(pupil, 1); });
        } else {
            render(0, threads_);
        }
    }

   private:
    void render(std::size_t pupil, int threads) {
        thread_local ZernikeField field;
        const ZernikePhase phase = stack_.phase(pupil), inner = stack_.inner_phase(pupil);
        const auto octants = Octants::get(static_cast<std::int64_t>(height_), static_cast<std::int64_t>(width_), rows_[pupil],
                                          columns_[pupil]);
        const double reach = step_ * std::sqrt(static_cast<double>(octants->groups.back().square()));
        const bool normalize = scales_[pupil] == 0.0;
        T* image = images_ + pupil * height_ * width_;
        const double area = 1.0 - stack_.obscuration * stack_.obscuration, g = stack_.gaussian;
        const double bright = g > 1e-6 ? std::exp(-g * (1.0 - area)) * -std::expm1(-g * area) / g : area;
        for (double error = 0.4 * tol_ * bright / (2.0 * phase.size() + 1.0);; error *= 0.1) {
            const double bound = field.prepare(phase, inner, stack_.obscuration, reach, error);
            const double top = paint(field, *octants, step_, normalize ? 1.0 : scales_[pupil], threads, image);
            double relative = relative_error(top, bound);
            if (normalize) {
                relative = normalized_error(relative);
            } else if (relative > tol_) {
                relative = relative_error(std::max(top, scanned_peak(phase, inner, error)), bound);
            }
            if (relative <= tol_) {
                bounds_[pupil] = relative;
                if (normalize) {
                    scales_[pupil] = 1.0 / top;
                    for (std::size_t i = 0; i < height_ * width_; ++i) {
                        image[i] = static_cast<T>(static_cast<double>(image[i]) / top);
                    }
                }
                return;
            }
            if (error < 8.0 * unit_roundoff) {
                throw ToleranceNotMet(relative);
            }
        }
    }

    // Scaled intensities of one image; returns the largest unscaled one.
    template <class Value>
    static double paint(const ZernikeField& field, const Octants& octants, double step, double scale, int threads, Value* image) {
        std::vector<double> peaks(field.pieces(), 0.0);
        parallel_for(field.pieces(), threads, [&](std::size_t, std::size_t s) {
            thread_local Doubles piece, ring;
            const double per_pixel = step / field.width();
            const std::size_t first = octants.first_at(static_cast<double>(s) / per_pixel);
            const std::size_t last = s + 1 == field.pieces() ? octants.groups.size()
                                                             : octants.first_at(static_cast<double>(s + 1) / per_pixel);
            if (first == last) {
                return;
            }
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                field.combine_piece(isa, s, piece);
                // Rings are worth while where they hold vectors full of pixels.
                const std::size_t rings = field.rings();
                if (field.obscured() || last - first > 20 * rings) {
                    std::size_t from = first;
                    for (std::size_t r = 0; r < rings; ++r) {
                        const double outer = static_cast<double>(s) + static_cast<double>(r + 1) / static_cast<double>(rings);
                        const std::size_t to = r + 1 == rings ? last : std::clamp(octants.first_at(outer / per_pixel), from, last);
                        if (from == to) {
                            continue;
                        }
                        field.template ring<ring_degree>(isa, piece, s, r, rings, ring);
                        const double slope = 2.0 * static_cast<double>(rings) * per_pixel;
                        const double offset = -(2.0 * (static_cast<double>(s * rings + r)) + 1.0);
                        peaks[s] = std::max(peaks[s], pixels<ring_degree>(isa, field, octants, from, to, slope, offset,
                                                                          ring.data(), scale, image));
                        from = to;
                    }
                } else {
                    field.template ring<degree_count>(isa, piece, s, 0, 1, ring);
                    peaks[s] = pixels<degree_count>(isa, field, octants, first, last, 2.0 * per_pixel,
                                                    -(2.0 * static_cast<double>(s) + 1.0), ring.data(), scale, image);
                }
            });
        });
        return *std::max_element(peaks.begin(), peaks.end());
    }

    template <std::size_t Degree, class I, class Value>
    static LOMMEL_INLINE double pixels(I isa, const ZernikeField& field, const Octants& octants, std::size_t first, std::size_t last,
                                       double slope, double offset, const double* ring, double scale, Value* image) {
        using V = typename I::pack;
        constexpr std::size_t unroll = I::lanes == 8 ? 2 : 1, at_once = unroll * I::lanes;
        double peak = 0.0;
        for (std::size_t g = first; g < last; g += at_once) {
            alignas(64) double x[at_once], c[at_once], s[at_once], values[8][at_once];
            for (std::size_t i = 0; i < at_once; ++i) {
                const Octants::Group group = octants.groups[std::min(g + i, last - 1)];
                const double a = group.a, b = group.b, r = std::sqrt(a * a + b * b);
                x[i] = r * slope + offset;
                c[i] = r > 0.0 ? a / r : 1.0;
                s[i] = r > 0.0 ? b / r : 0.0;
            }
            V vx[unroll], vc[unroll], vs[unroll], out[8][unroll];
            for (std::size_t u = 0; u < unroll; ++u) {
                vx[u] = load<V>(x + u * I::lanes);
                vc[u] = load<V>(c + u * I::lanes);
                vs[u] = load<V>(s + u * I::lanes);
            }
            if (field.orders().sines) {
                sum_orders<Degree, true, unroll>(isa, field.orders(), ring, vx, vc, vs, out);
            } else {
                sum_orders<Degree, false, unroll>(isa, field.orders(), ring, vx, vc, vs, out);
            }
            for (std::size_t j = 0; j < 8; ++j) {
                for (std::size_t u = 0; u < unroll; ++u) {
                    store(values[j] + u * I::lanes, out[j][u]);
                }
            }
            for (std::size_t i = 0; i < std::min(at_once, last - g); ++i) {
                const Octants::Group group = octants.groups[g + i];
                for (std::size_t j = 0; j < 8; ++j) {
                    const std::int64_t along = j < 4 ? group.a : group.b, across = j < 4 ? group.b : group.a;
                    const std::int64_t px = octants.column + (j % 4 < 2 ? along : -along);
                    const std::int64_t py = octants.row + (j % 2 == 0 ? across : -across);
                    if (px >= 0 && px < octants.width && py >= 0 && py < octants.height) {
                        image[py * octants.width + px] = static_cast<Value>(scale * values[j][i]);
                        peak = std::max(peak, values[j][i]);
                    }
                }
            }
        }
        return peak;
    }

    // The largest I on a coarse grid that rays reach: a window may miss the peak.
    double scanned_peak(const ZernikePhase& phase, const ZernikePhase& inner, double error) const {
        double blur = 4.0;
        phase.amplitudes([&](double amplitude, std::size_t n) { blur += amplitude * static_cast<double>(n * n); });
        const std::int64_t side = 65;
        const double step = std::min(blur, 400.0) / 32.0;
        const Octants octants(side, side, side / 2, side / 2);
        std::vector<double> image(static_cast<std::size_t>(side * side));
        ZernikeField field;
        field.prepare(phase, inner, stack_.obscuration, step * std::sqrt(static_cast<double>(octants.groups.back().square())), error);
        return paint(field, octants, step, 1.0, 1, image.data());
    }

    ZernikeStack stack_;
    std::size_t height_, width_;
    const std::int64_t *rows_, *columns_;
    double step_, tol_;
    int threads_;
    T* images_;
    double *scales_, *bounds_;
};

}  // namespace lommel
