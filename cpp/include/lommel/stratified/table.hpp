// Table of Bessel functions J_m(v rho), rho being the pupil radius and v the image radius; independent of depth and focus.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/pixels/layout.hpp"
#include "lommel/stratified/bessel.hpp"

namespace lommel {

struct AngleTable {
    static constexpr std::size_t tile = 16;  // radii per tile

    std::shared_ptr<const Radii> radii;  // kept alive, as the cache compares its address
    double step;
    std::vector<double> rho;
    std::size_t parts;
    bool slopes;
    std::size_t kinds, tiles;
    Doubles rows;  // [tile][J_m of each part m, then dJ_m/dv][angle][radius in the tile]

    AngleTable(const std::shared_ptr<const Radii>& at, double pitch, const std::vector<double>& angles, std::size_t orders,
               bool derivatives)
        : radii(at), step(pitch), rho(angles), parts(orders), slopes(derivatives), kinds(slopes ? 2 * parts : parts),
          tiles((at->count + tile - 1) / tile), rows(tiles * kinds * rho.size() * tile) {
        const auto bessel = BesselPieces::get(radii->reach() * step);
        dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            for (std::size_t t = 0; t < tiles; ++t) {
                look();
                for (std::size_t q = 0; q < rho.size(); ++q) {
                    double* const row = rows.data() + (t * kinds * rho.size() + q) * tile;
                    for (std::size_t i = 0; i < tile; ++i) {
                        fill(isa, *bessel, row + i, rho[q], std::min(t * tile + i, radii->count - 1));
                    }
                }
            }
        });
    }

    std::size_t stride() const { return tiles * tile; }
    const double* of(std::size_t t, std::size_t kind) const { return rows.data() + (t * kinds + kind) * rho.size() * tile; }

    bool is(const std::shared_ptr<const Radii>& at, double pitch, const std::vector<double>& angles, std::size_t orders,
            bool derivatives) const {
        return radii == at && step == pitch && parts == orders && slopes >= derivatives && rho == angles;
    }
    std::size_t bytes() const { return sizeof(double) * rows.size(); }
    static constexpr std::size_t most_bytes = std::size_t{96} << 20;
    static std::shared_ptr<const AngleTable> get(const std::shared_ptr<const Radii>& at, double pitch,
                                                 const std::vector<double>& angles, std::size_t orders, bool derivatives) {
        return cache<AngleTable>.get(at, pitch, angles, orders, derivatives);
    }

   private:
    template <class I>
    LOMMEL_INLINE void fill(I isa, const BesselPieces& bessel, double* to, double angle, std::size_t place) const {
        const std::size_t part_stride = rho.size() * tile;
        double J[BesselPieces::orders];
        bessel(isa, angle * (step * radii->radii[place]), J);
        for (std::size_t m = 0; m < parts; ++m) {
            to[m * part_stride] = J[m];
            if (slopes) {
                to[(parts + m) * part_stride] = angle * (m == 0 ? -J[1] : 0.5 * (J[m - 1] - J[m + 1]));
            }
        }
    }
};

}  // namespace lommel
