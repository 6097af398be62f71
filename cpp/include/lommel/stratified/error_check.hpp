// Intensity of one plane of a stack: its error bounds (docs/certificate.md, section 15), and its sum over azimuthal orders.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "lommel/pixels/layout.hpp"
#include "lommel/stratified/bessel.hpp"
#include "lommel/stratified/profiles.hpp"

namespace lommel {

// Error bounds of the intensity I of one plane of a stack.
struct Judged {
    double given;  // error of I at the radii where it is computed
    double most;   // bound on |I| at any radius
    double swing;  // bound on |I - c| at any radius, for some constant c

    Judged(const Planes& planes, std::size_t plane, const PartSizes& sizes)
        : Judged(planes, plane, sizes, 0, planes.harmonics.size()) {}

    // Error bounds of that part of I which consists of the azimuthal orders planes.harmonics[first .. last - 1].
    Judged(const Planes& planes, std::size_t plane, const PartSizes& sizes, std::size_t first, std::size_t last) {
        const Parts F(planes, planes.angles.error, sizes);
        // `rounding` covers the rounding of products and Hermitian forms, and the relative error of the collected power, by which
        // I is divided: 1e-13.
        given =
            planes.bilinear(
                plane, [&](std::size_t j, std::size_t l) { return F.off * (F.found[j] + F.found[l] + F.off); }, first, last) +
            rounding *
                planes.bilinear(plane, [&](std::size_t j, std::size_t l) { return F.found[j] * F.found[l]; }, first, last);
        const auto anywhere = [&](std::size_t j, std::size_t l) { return F.most[j] * F.most[l]; };
        const std::size_t turning = std::max<std::size_t>(first, 1);
        const double steady = first == 0 ? planes.bilinear(plane, anywhere, 0, 1) : 0.0;
        most = swing = planes.bilinear(plane, anywhere, turning, last);
        // Order 0 of I, its mean over the azimuth, is not negative: it differs from half of its maximum by at most that half.
        most += steady;
        swing += 0.5 * steady;
    }

    // Error bounds of a derivative of the intensity, 2 Re sum over j, l of form[j][l] G_j conj(F_l). `of`: sizes (PartSizes) of the
    // parts F_l of the field; `sizes`, `error`: sizes and error bound of the derivatives G_j of these parts.
    Judged(const Planes& planes, std::size_t plane, const PartSizes& of, const PartSizes& sizes, double error,
           std::size_t first, std::size_t last) {
        const Parts F(planes, planes.angles.error, of), G(planes, error, sizes);
        given = 2.0 * planes.bilinear(
                          plane,
                          [&](std::size_t j, std::size_t l) {
                              return G.off * (F.found[l] + F.off) + (F.off + rounding * F.found[l]) * G.found[j];
                          },
                          first, last);
        most = swing =
            2.0 * planes.bilinear(plane, [&](std::size_t j, std::size_t l) { return G.most[j] * F.most[l]; }, first, last);
    }

    // Bounds for factor * A + share * B, if *this bounds A and `other` bounds B.
    Judged sum(double factor, const Judged& other, double share) const {
        Judged made = *this;
        made.given = std::abs(factor) * given + std::abs(share) * other.given;
        made.most = std::abs(factor) * most + std::abs(share) * other.most;
        made.swing = std::abs(factor) * swing + std::abs(share) * other.swing;
        return made;
    }

   private:
    static constexpr double rounding = 4e-13;

    // Parts F_m of a field. found: largest |F_m| at the radii; most: bound on |F_m| at any radius; off: error of F_m.
    struct Parts {
        double off;
        std::array<double, most_parts> found{}, most{};

        Parts(const Planes& planes, double error, const PartSizes& sizes)
            : off(error +
                  planes.angles.rounding(BesselPieces::error) * *std::max_element(sizes.most, sizes.most + most_parts)) {
            for (std::size_t m = 0; m < most_parts; ++m) {
                found[m] = std::sqrt(sizes.found[m]);
                most[m] = sizes.most[m] + off;
            }
        }
    };
};

// Intensity at the pixels of a centred window, as a sum over its azimuthal orders with stored cosines and sines of the azimuth.
class Turned {
   public:
    Turned(const Planes& planes, const Layout& layout) : orders_(planes.harmonics.size()) {
        const std::size_t pixels = planes.radial() ? 0 : layout.height() * layout.width();
        around_.resize((orders_ - 1) * pixels);
        for (std::size_t i = 0; i < pixels; ++i) {
            const double y = static_cast<double>(i / layout.width()) - static_cast<double>(layout.rows.low);
            const double x = static_cast<double>(i % layout.width()) - static_cast<double>(layout.columns.low);
            const double r = std::max(std::hypot(x, y), 1e-300), c = x / r, s = y / r;
            for (std::size_t k = 1; k < orders_; ++k) {
                const Harmonic& h = planes.harmonics[k];
                around_[(k - 1) * pixels + i] =
                    h.order == 1 ? h.cosine * c + h.sine * s : h.cosine * (c * c - s * s) + h.sine * 2.0 * c * s;
            }
        }
    }

    void sum(const Layout& layout, const double* values, std::size_t stride, double* out) const {
        const std::size_t pixels = layout.height() * layout.width(), cy = layout.rows.low, cx = layout.columns.low;
        for (std::size_t y = 0, i = 0; y < layout.height(); ++y) {
            const std::size_t dy = y < cy ? cy - y : y - cy;
            for (std::size_t x = 0; x < layout.width(); ++x, ++i) {
                const std::size_t rank = layout.rank(dy, x < cx ? cx - x : x - cx);
                double total = values[rank];
                for (std::size_t k = 1; k < orders_; ++k) {
                    total += around_[(k - 1) * pixels + i] * values[k * stride + rank];
                }
                out[i] = total;
            }
        }
    }

   private:
    std::size_t orders_;
    Doubles around_;
};

}  // namespace lommel
