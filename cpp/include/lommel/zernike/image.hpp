// Image of a pupil without radial symmetry; the accuracy of each radial piece depends on its brightness (docs/certificate.md,
// section 7).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "lommel/base/parallel.hpp"
#include "lommel/base/reference.hpp"
#include "lommel/pixels/mirrored.hpp"
#include "lommel/zernike/field.hpp"
#include "lommel/zernike/error_check.hpp"

namespace lommel {

// Bound on the rounding error of the field U in single precision: of coefficients, of the position x on a ring (powers of x have
// slopes up to 7), of Horner's rule, of cos(m psi) and sin(m psi) (m times that of psi), and of the sum over azimuthal orders m.
inline double single_rounding(const PiecePlan& plan, const Doubles& coefficients) {
    double sum = 0.0;
    for (const double c : coefficients) {
        sum += std::abs(c);
    }
    const double steps =
        4.0 * ring_degree + 4.0 * static_cast<double>(plan.orders.highest()) + static_cast<double>(plan.rows.size()) + 32.0;
    return 5.97e-8 * steps * sum;
}

// Pixels within one radial piece, and the accuracy of their values.
struct ZernikePart : PaintedPart {
    std::size_t piece, first, last;  // index of the piece; range of its groups of mirrored pixels
    double allowed = 0.0;            // allowed error of U
    bool done = false;
    ZernikePart(std::size_t s, std::size_t from, std::size_t to) : piece(s), first(from), last(to) {}
};

// Image in progress: its pixels by radial pieces, each with its own accuracy. An error e of the field U matters less where the PSF
// is dark: |I - I_exact| <= e (2 |U| + e). A preview of I at some radii decides the allowed error of a piece; the computed values
// give its error bound.
class ZernikeImage : public PaintedParts<ZernikePart> {
   public:
    // Begin an image of these pixels at a pitch of `step` in v. Memory is reused by the next image.
    void begin(std::shared_ptr<const MirroredPixels> pixels, double step, int threads) {
        pixels_ = std::move(pixels);
        step_ = step;
        threads_ = threads;
    }

    ZernikeField& field() { return field_; }

    // Preview the intensity I at some radii, and derive the allowed error of U on each piece; tol: (tolerance of I) / (its peak).
    void prepare(double tol) {
        const double reach = step_ * std::sqrt(static_cast<double>(pixels_->groups.back().square()));
        const double near = step_ * std::sqrt(static_cast<double>(pixels_->groups.front().square()));
        Looks seen{std::vector<double>(looks), std::vector<double>(looks)};
        parallel_for(looks, threads_, [&](std::size_t, std::size_t i) {
            // Samples are denser near the axis, where the image is brightest.
            const double x = (static_cast<double>(i) + 0.5) / looks;
            seen.v[i] = near + (reach - near) * x * std::sqrt(x);
            seen.bright[i] = field_.look(seen.v[i]);
        });
        const double all = ZernikeBudget::image * tol * seen.brightest(near, reach);
        const auto allowed = [&](double intensity) { return allowed_error(all, intensity, 2.0); };
        field_.prepare(allowed(2.0 * all / tol), threads_, [&](std::size_t pieces) {
            std::vector<std::size_t> in_use;
            parts_.clear();
            for (std::size_t s = 0, first = 0, last = 0; s < pieces; ++s, first = last) {
                last = s + 1 == pieces ? pixels_->groups.size() : boundary(s, 1, 1, first, pixels_->groups.size());
                if (first < last) {
                    in_use.push_back(s);
                    parts_.emplace_back(s, first, last);
                }
            }
            return in_use;
        });
        for (ZernikePart& part : parts_) {
            const double low = field_.width() * static_cast<double>(part.piece);
            part.allowed = allowed(seen.brightest(low, low + field_.width()));
        }
    }

    // Reduce the allowed error of all pieces whose error of I exceeds `most`; return false if the expansion, too, must become more
    // accurate.
    bool tighten(double most) {
        bool any = false;
        for (ZernikePart& part : parts_) {
            if (part.error_bound() > most) {
                if (part.error < ZernikeBudget::blame * field_.base()) {
                    return false;
                }
                part.allowed = ZernikeBudget::piece_retry * std::min(part.allowed, part.error);
                part.done = false;
                any = true;
            }
        }
        return any;
    }

    // Compute the pieces that are not done, and write I times `scale` to their pixels.
    template <class T>
    void paint(double scale, T* image);

   private:
    // Callback that takes I of the groups first .. first + here - 1; the values of the eight pixels of a group are `stride` apart.
    template <class Real>
    using Put = Reference<void(std::size_t first, std::size_t here, std::size_t stride, const Real* values)>;

    static constexpr std::size_t looks = 32;

    // First group of pixels beyond ring r - 1 of the `rings` rings of piece s, limited to the range least .. most.
    std::size_t boundary(std::size_t s, std::size_t r, std::size_t rings, std::size_t least, std::size_t most) const {
        const double v = field_.width() * (static_cast<double>(s) + static_cast<double>(r) / static_cast<double>(rings));
        return std::clamp(pixels_->first_at(v / step_), least, most);
    }

    void paint(ZernikePart& part, const Put<float>& floats, const Put<double>& doubles) {
        const std::size_t s = part.piece;
        part.done = true;
        part.top = 0.0;
        thread_local Doubles coefficients;
        thread_local Floats singles;
        const PiecePlan plan = field_.plan(s, part.allowed, part.last - part.first);
        part.error = plan.error;
        const double per_pixel = step_ / field_.width();
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            using I = decltype(isa);
            constexpr std::size_t unroll = I::lanes == 8 ? 2 : 1;
            if (plan.rings == 0) {
                field_.whole(plan, s, coefficients);
                pixels<degree_count, unroll, typename I::pack>(plan, part.first, part.last, 2.0 * per_pixel,
                                                               -(2.0 * static_cast<double>(s) + 1.0), coefficients.data(),
                                                               doubles);
                return;
            }
            std::size_t from = part.first;
            for (std::size_t r = 0; r < plan.rings; ++r) {
                const std::size_t to = r + 1 == plan.rings ? part.last : boundary(s, r + 1, plan.rings, from, part.last);
                if (from == to) {
                    continue;
                }
                field_.ring(isa, plan, s, r, coefficients);
                const double slope = 2.0 * static_cast<double>(plan.rings) * per_pixel;
                const double offset = -(2.0 * static_cast<double>(s * plan.rings + r) + 1.0);
                const double rounding = single_rounding(plan, coefficients);
                if (plan.error + rounding <= part.allowed) {
                    part.error = std::max(part.error, plan.error + rounding);
                    singles.assign(coefficients.begin(), coefficients.end());
                    pixels<ring_degree, unroll, typename I::floats>(plan, from, to, slope, offset, singles.data(), floats);
                } else {
                    pixels<ring_degree, unroll, typename I::pack>(plan, from, to, slope, offset, coefficients.data(), doubles);
                }
                from = to;
            }
        });
    }

    template <std::size_t Degree, std::size_t Unroll, class V, class Real>
    static LOMMEL_INLINE void sum(const ActiveOrders& orders, const Real* coefficients, const V* x, const V* c, const V* s,
                                  V (*out)[Unroll]) {
        if (orders.sines) {
            sum_orders<Degree, true, Unroll>(orders, coefficients, x, c, s, out);
        } else {
            sum_orders<Degree, false, Unroll>(orders, coefficients, x, c, s, out);
        }
    }

    // Compute the pixels of groups [first, last) in one ring, at positions slope * r + offset in it (-1 to 1), r: radius in pixels.
    template <std::size_t Degree, std::size_t Unroll, class V, class Real>
    LOMMEL_INLINE void pixels(const PiecePlan& plan, std::size_t first, std::size_t last, double slope, double offset,
                              const Real* coefficients, const Put<Real>& put) const {
        constexpr std::size_t lanes = sizeof(V) / sizeof(Real), at_once = Unroll * lanes;
        Glance glance;
        for (std::size_t g = first; g < last; g += at_once) {
            glance(at_once * (1 + 4 * plan.rows.size()));
            alignas(64) Real x[at_once], c[at_once], s[at_once], values[at_once * 8];
            const std::size_t here = std::min(at_once, last - g);
            alignas(64) double a[at_once], b[at_once];
            for (std::size_t i = 0; i < at_once; ++i) {
                const MirroredPixels::Group group = pixels_->groups[g + std::min(i, here - 1)];
                // At the axis any direction is valid; a > 0 avoids 0 / 0.
                a[i] = group.a == 0 ? 1e-150 : group.a;
                b[i] = group.b;
            }
            for (std::size_t i = 0; i < at_once; ++i) {
                const double r = std::sqrt(a[i] * a[i] + b[i] * b[i]), over = 1.0 / r;
                x[i] = static_cast<Real>(r * slope + offset);
                c[i] = static_cast<Real>(a[i] * over);
                s[i] = static_cast<Real>(b[i] * over);
            }
            V vx[Unroll], vc[Unroll], vs[Unroll], out[8][Unroll];
            for (std::size_t u = 0; u < Unroll; ++u) {
                vx[u] = load<V>(x + u * lanes);
                vc[u] = load<V>(c + u * lanes);
                vs[u] = load<V>(s + u * lanes);
            }
            sum<Degree, Unroll>(plan.orders, coefficients, vx, vc, vs, out);
            for (std::size_t j = 0; j < 8; ++j) {
                for (std::size_t u = 0; u < Unroll; ++u) {
                    store(values + j * at_once + u * lanes, out[j][u]);
                }
            }
            put(g, here, at_once, values);
        }
    }

    // Write scale * values[stride * j + i] to pixel j of the eight of group first + i, i < count; raise `top` to the largest value.
    template <class Real, class T>
    void place(std::size_t first, std::size_t count, std::size_t stride, const Real* values, double scale, T* image,
               double& top) const {
        const std::int64_t width = pixels_->width, center = pixels_->row * width + pixels_->column;
        const std::int64_t inner = std::min(std::min(pixels_->row, pixels_->height - 1 - pixels_->row),
                                            std::min(pixels_->column, width - 1 - pixels_->column));
        Real peak = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const MirroredPixels::Group group = pixels_->groups[first + i];
            const std::int64_t a = group.a, b = group.b;
            const std::int64_t right[8] = {a, a, -a, -a, b, b, -b, -b}, down[8] = {b, -b, b, -b, a, -a, a, -a};
            for (std::size_t j = 0; j < 8; ++j) {
                if (a > inner) {
                    const std::int64_t px = pixels_->column + right[j], py = pixels_->row + down[j];
                    if (px < 0 || px >= width || py < 0 || py >= pixels_->height) {
                        continue;
                    }
                }
                const Real value = values[j * stride + i];
                image[center + down[j] * width + right[j]] = static_cast<T>(scale * static_cast<double>(value));
                peak = value > peak ? value : peak;
            }
        }
        top = std::max(top, static_cast<double>(peak));
    }

    std::shared_ptr<const MirroredPixels> pixels_;
    double step_ = 1.0;
    int threads_ = 1;
    ZernikeField field_;
};

template <class T>
void ZernikeImage::paint(double scale, T* image) {
    parallel_for(parts_.size(), threads_, [&](std::size_t, std::size_t i) {
        ZernikePart& part = parts_[i];
        if (!part.done) {
            const auto put = [&](std::size_t first, std::size_t here, std::size_t stride, const auto* values) {
                place(first, here, stride, values, scale, image, part.top);
            };
            paint(part, Put<float>(put), Put<double>(put));
        }
    });
}
#if defined(LOMMEL_COMPILED)
extern template void ZernikeImage::paint<float>(double, float*);
extern template void ZernikeImage::paint<double>(double, double*);
#endif

}  // namespace lommel
