// Polar non-uniform FFT, image: interpolation between circles, tile by tile, with an error bound for each tile.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <type_traits>
#include <vector>

#include "lommel/base/parallel.hpp"
#include "lommel/base/reference.hpp"
#include "lommel/pixels/tiles.hpp"
#include "lommel/zernike/error_check.hpp"
#include "lommel/zernike/polar_zones.hpp"

namespace lommel {

class PolarImage : public PaintedParts<PaintedPart> {  // each part: one tile in one zone
   public:
    // Estimated work, in units of one azimuthal order at one pixel: a fixed time per pixel and an FFT per circle.
    static double work(const ZernikeField& field, const Tiles& tiles) {
        return 28.0 * static_cast<double>(tiles.height * tiles.width) +
               6.0 * static_cast<double>(field.outer().orders) * field.reach();
    }

    // Begin an image of these pixels at a pitch of `step` in v. Memory is reused by the next image.
    void begin(const Tiles& tiles, double step, int threads) {
        tiles_ = &tiles;
        list_ = tiles.all();
        step_ = step;
        threads_ = threads;
    }

    // Compute the circles for an error of I of at most `tol` times its maximum, in this window or `outside` of it. Returns false if
    // they are unlikely to meet it.
    bool prepare(const PolarPupil& pupil, double tol, double outside = 0.0) {
        const bool likely = zones_.plan(pupil, step_, tiles_->nearest(), tiles_->farthest(), tol, outside, threads_);
        zones_.fill(pupil, threads_);
        return likely;
    }

    // Compute I times `scale` at all pixels of the image.
    template <class T>
    void paint(double scale, T* image);

   private:
    // Callback that takes the intensities of the pixels of a line, values[pixel][direction].
    template <class Real>
    using Made = Reference<void(const Tiles::Line& line, const Real (*values)[Tiles::directions])>;

    void tile(std::size_t i, double scale, const Made<float>& singles, const Made<double>& doubles) {
        thread_local std::vector<Tiles::Line> lines;
        for (std::size_t z = 0; z < zones_.size(); ++z) {
            const PolarZone& zone = zones_[z];
            lines.clear();
            tiles_->lines(list_[i], zone.low, zone.high, [&](const Tiles::Line& line) { lines.push_back(line); });
            if (!lines.empty()) {
                dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                    PaintedPart& part = parts_[i * zones_.size() + z];
                    const Tiles::Tile& at = list_[i];
                    if (zone.style->around == 14) {
                        pixels<14, 14, double>(isa, zone, at, lines, scale, doubles, part);
                    } else if (zone.style->around == 12) {
                        pixels<12, 12, double>(isa, zone, at, lines, scale, doubles, part);
                    } else if (zone.style->doubles && zone.style->around == 10) {
                        pixels<10, 10, double>(isa, zone, at, lines, scale, doubles, part);
                    } else if (zone.style->doubles) {
                        pixels<10, 8, double>(isa, zone, at, lines, scale, doubles, part);
                    } else if (zone.style->around == 8) {
                        pixels<8, 8, float>(isa, zone, at, lines, scale, singles, part);
                    } else if (zone.style->around == 6) {
                        pixels<8, 6, float>(isa, zone, at, lines, scale, singles, part);
                    } else if (zone.style->between == 8) {
                        pixels<8, 4, float>(isa, zone, at, lines, scale, singles, part);
                    } else if (!zone.style->rough) {
                        pixels<6, 4, float>(isa, zone, at, lines, scale, singles, part);
                    } else if (zone.style->between == 6) {
                        pixels<6, 4, float, true>(isa, zone, at, lines, scale, singles, part);
                    } else if (zone.style->around == 3) {
                        pixels<4, 3, float, true>(isa, zone, at, lines, scale, singles, part);
                    } else {
                        pixels<4, 2, float, true>(isa, zone, at, lines, scale, singles, part);
                    }
                });
            }
        }
    }

    // Weights of a kernel's taps, polynomials of the position x, for one vector of taps at a time.
    template <class V, class Real>
    static LOMMEL_INLINE void taps(const Taps<Real>& polynomials, Real x, Real* out, std::size_t count = Taps<Real>::taps) {
        constexpr std::size_t lanes = sizeof(V) / sizeof(Real);
        const V at = splat<V>(x);
        for (std::size_t part = 0; part < count; part += lanes) {
            store(out + part,
                  horner(Taps<Real>::terms, at, [&](std::size_t k) LOMMEL_INLINE_LAMBDA { return polynomials.at[k] + part; }));
        }
    }

    // Weights of two kernels of four taps each: of the first at the position `first`, of the second at `second`.
    template <class V>
    static LOMMEL_INLINE void taps(const PairedTaps& polynomials, float first, float second, float* out) {
        constexpr std::size_t lanes = sizeof(V) / sizeof(float);
        for (std::size_t part = 0; part < PairedTaps::taps; part += lanes) {
            V at = splat<V>(part < PairedTaps::taps / 2 ? first : second);
            if constexpr (lanes == PairedTaps::taps) {
                using Bits = typename Vector<lanes / 2>::turns;
                at = choose_lanes(load<Bits>(PairedTaps::halves), splat<V>(second), at);
            }
            store(out + part,
                  horner(PairedTaps::terms, at, [&](std::size_t k) LOMMEL_INLINE_LAMBDA { return polynomials.at[k] + part; }));
        }
    }

    // Number of circles summed at a time: the largest divisor of `of` that is at most `most`, so that the sums fit in registers.
    static constexpr std::size_t largest_divisor(std::size_t of, std::size_t most) {
        while (of % most != 0) {
            --most;
        }
        return most;
    }

    // Compute the pixels of a tile in one zone, on the given lines, by Between taps between circles and Around taps around them.
    template <std::size_t Between, std::size_t Around, class Real, bool Rough = false, class I>
    LOMMEL_INLINE void pixels(I, const PolarZone& zone, const Tiles::Tile& tile, const std::vector<Tiles::Line>& lines,
                              double scale, const Made<Real>& made, PaintedPart& part) const {
        using V = std::conditional_t<sizeof(Real) == 8, typename I::pack, typename I::floats>;
        using Narrow = typename RowPack<I, Real>::type;
        using D = typename I::pack;
        constexpr std::size_t at_once = Tiles::side, numbers = PolarRows<Real>::directions, lanes = sizeof(V) / sizeof(Real),
                              packs = numbers / lanes;
        const PolarRows<Real>& rows = zone.rows(Real());
        // Where: type of positions, in single precision if Rough.
        using Where = std::conditional_t<Rough, float, double>;
        using W = std::conditional_t<Rough, Narrow, D>;
        const Where per_row = static_cast<Where>(step_ / zone.style->step()),
                    per_angle = static_cast<Where>(static_cast<double>(zone.circle->points()) / 6.283185307179586477);
        // The first tap of a pixel has the index (position + shift), rounded up, counted in circles and in angles of a circle.
        const Where row_shift = static_cast<Where>(static_cast<double>(PolarTable::before) -
                                                   static_cast<double>(zone.first * PolarTable::block) - 0.5 * Between),
                    angle_shift = static_cast<Where>(static_cast<double>(rows.margin()) - 0.5 * Around);
        const std::size_t stride = rows.stride();
        const V scales = splat<V>(static_cast<Real>(scale));
        alignas(64) Real tops[Tiles::directions] = {};
        const bool whole = tiles_->whole(tile);
        std::int64_t nearest = 1 << 30, farthest = 0;
        for (const Tiles::Line& line : lines) {
            look();
            const std::size_t here = static_cast<std::size_t>(line.count);
            alignas(64) Where x[2][at_once];
            alignas(64) std::conditional_t<Rough, std::int32_t, std::int64_t> place[2][at_once];
            // weights[pixel]: the taps between circles, then the taps around circles.
            constexpr bool paired = Between == 4;
            constexpr std::size_t most = paired ? PairedTaps::taps / 2 : Taps<Real>::taps;
            alignas(64) Real weights[at_once][2 * most], values[at_once][Tiles::directions];
            constexpr std::size_t wide = sizeof(W) / sizeof(Where);
            for (std::size_t i = 0; i < here; i += wide) {
                // Positions beyond the end of the line only fill up the vector.
                const W across = splat<W>(static_cast<Where>(line.a)),
                        along = splat<W>(static_cast<Where>(line.b + static_cast<std::int64_t>(i))) + load<W>(counting<Where>),
                        square = across * across + along * along;
                alignas(64) Where root[wide];
                store(root, square);
                for (Where& r : root) {
                    r = std::sqrt(r);
                }
                split(load<W>(root) * splat<W>(per_row) + splat<W>(row_shift), x[0] + i, place[0] + i);
                split(angle<Where>(across, along) * splat<W>(per_angle) + splat<W>(angle_shift), x[1] + i, place[1] + i);
            }
            nearest = std::min<std::int64_t>(nearest, place[0][0]);
            farthest = std::max<std::int64_t>(farthest, place[0][here - 1]);
            for (std::size_t i = 0; i < here; ++i) {
                if constexpr (paired) {
                    taps<Narrow>(zone.both, x[0][i], x[1][i], weights[i]);
                } else if (!Rough && std::is_same_v<Real, float> && zone.style->exact) {
                    // Weights in double precision, rounded once to single precision.
                    alignas(64) double exact[2][DoubleTaps::taps];
                    taps<D>(zone.kernels->outer().doubles, static_cast<double>(x[0][i]), exact[0], most);
                    taps<D>(zone.circle->doubles, static_cast<double>(x[1][i]), exact[1], most);
                    for (std::size_t k = 0; k < most; ++k) {
                        weights[i][k] = static_cast<Real>(exact[0][k]);
                        weights[i][most + k] = static_cast<Real>(exact[1][k]);
                    }
                } else {
                    taps<Narrow>(zone.kernels->outer().taps(Real()), static_cast<Real>(x[0][i]), weights[i]);
                    taps<Narrow>(zone.circle->taps(Real()), static_cast<Real>(x[1][i]), weights[i] + most);
                }
            }
            for (std::size_t i = 0; i < here; ++i) {
                const Real* start =
                    rows.row(static_cast<std::size_t>(place[0][i])) + static_cast<std::size_t>(place[1][i]) * numbers;
                constexpr std::size_t together = largest_divisor(Between, packs == 1 ? 8 : packs == 2 ? 5 : 2);
                V total[packs] = {};
                for (std::size_t j = 0; j < Between; j += together) {
                    V sum[together][packs] = {};
                    for (std::size_t l = 0; l < Around; ++l) {
                        const V weight = splat<V>(weights[i][most + l]);
                        for (std::size_t k = 0; k < together; ++k) {
                            const Real* at = start + (j + k) * stride + l * numbers;
                            for (std::size_t p = 0; p < packs; ++p) {
                                sum[k][p] = sum[k][p] + weight * load<V>(at + p * lanes);
                            }
                        }
                    }
                    for (std::size_t k = 0; k < together; ++k) {
                        const V weight = splat<V>(weights[i][j + k]);
                        for (std::size_t p = 0; p < packs; ++p) {
                            total[p] = total[p] + weight * sum[k][p];
                        }
                    }
                }
                if constexpr (packs > 1) {
                    for (std::size_t p = 0; p < packs / 2; ++p) {
                        const V re = total[p], im = total[packs / 2 + p];
                        store(&values[i][p * lanes], scales * (re * re + im * im));
                    }
                } else {
                    static_assert(lanes == numbers && sizeof(V) == 2 * sizeof(Narrow));
                    alignas(64) Real squares[numbers];
                    store(squares, scales * (total[0] * total[0]));
                    store(values[i], load<Narrow>(squares) + load<Narrow>(squares + numbers / 2));
                }
            }
            if (whole) {
                constexpr std::size_t narrow_lanes = sizeof(Narrow) / sizeof(Real);
                for (std::size_t p = 0; p < Tiles::directions; p += narrow_lanes) {
                    Narrow top = load<Narrow>(tops + p);
                    for (std::size_t i = 0; i < here; ++i) {
                        top = larger(load<Narrow>(values[i] + p), top);
                    }
                    store(tops + p, top);
                }
            } else {
                for (std::size_t i = 0; i < here; ++i) {
                    for (std::size_t k = 0; k < Tiles::directions; ++k) {
                        const bool seen = tiles_->visible(line.a, line.b + static_cast<std::int64_t>(i), k);
                        tops[k] = values[i][k] > tops[k] && seen ? values[i][k] : tops[k];
                    }
                }
            }
            made(line, values);
        }
        for (const Real top : tops) {
            part.top = std::max(part.top, static_cast<double>(top) / scale);
        }
        for (std::size_t row = static_cast<std::size_t>(nearest); row < static_cast<std::size_t>(farthest) + Between; ++row) {
            part.error = std::max(part.error, zone.errors[row]);
        }
    }

    template <class Real>
    static constexpr Real counting[] = {0, 1, 2, 3, 4, 5, 6, 7};

    // Split each x into the next larger integer (place) and 2 t - 1 (rest), with t in [0, 1] the distance from the integer below.
    template <class V, class Real, class Place>
    static LOMMEL_INLINE void split(V x, Real* rest, Place* place) {
        static_assert(sizeof(Place) == sizeof(Real));
        // Adding `number`, 1.5 times 2^52 or 2^23, puts the nearest integer into the lowest bits, as in sincos().
        constexpr Real number = sizeof(Real) == 8 ? Real(6755399441055744.0) : Real(12582912.0);
        constexpr Place bits = sizeof(Real) == 8 ? static_cast<Place>(0x4338000000000000) : static_cast<Place>(0x4B400000);
        const V magic = splat<V>(number), shifted = (x + splat<V>(Real(0.5))) + magic, next = shifted - magic;
        store(rest, (x - next) * splat<V>(Real(2)) + splat<V>(Real(1)));
        std::memcpy(place, &shifted, sizeof shifted);
        for (std::size_t i = 0; i < sizeof(V) / sizeof(Real); ++i) {
            place[i] -= bits;
        }
    }

    // Moduli of the coefficients of the power series of atan(x), highest power first; single precision starts at 1/17.
    template <class Real>
    static constexpr Real odd_shares[] = {Real(1.0 / 37.0), Real(1.0 / 35.0), Real(1.0 / 33.0), Real(1.0 / 31.0),
                                          Real(1.0 / 29.0), Real(1.0 / 27.0), Real(1.0 / 25.0), Real(1.0 / 23.0),
                                          Real(1.0 / 21.0), Real(1.0 / 19.0), Real(1.0 / 17.0), Real(1.0 / 15.0),
                                          Real(1.0 / 13.0), Real(1.0 / 11.0), Real(1.0 / 9.0),  Real(1.0 / 7.0),
                                          Real(1.0 / 5.0),  Real(1.0 / 3.0),  Real(1.0)};

    // atan(b/a) for 0 <= b <= a, as pi/8 + atan(x) with x = (b - t_0 a) / (a + t_0 b), |x| <= t_0 = tan(pi/8).
    template <class Real, class V>
    static LOMMEL_INLINE V angle(V a, V b) {
        constexpr Real middle = Real(0.41421356237309504880), eighth = Real(0.39269908169872415481);
        const V x = (b - splat<V>(middle) * a) / (a + splat<V>(middle) * b + splat<V>(Real(1e-30))), z = x * x;
        constexpr std::size_t first = sizeof(Real) == 8 ? 0 : 10;
        V sum = splat<V>(odd_shares<Real>[first]);
        for (std::size_t k = first + 1; k < std::size(odd_shares<Real>); ++k) {
            sum = splat<V>(odd_shares<Real>[k]) - sum * z;
        }
        return splat<V>(eighth) + x * sum;
    }

    const Tiles* tiles_ = nullptr;
    std::vector<Tiles::Tile> list_;
    double step_ = 1.0;
    int threads_ = 1;
    PolarZones zones_;
};

template <class T>
void PolarImage::paint(double scale, T* image) {
    parts_.assign(list_.size() * zones_.size(), PaintedPart());
    parallel_for(list_.size(), threads_, [&](std::size_t, std::size_t i) {
        thread_local Tiles::Buffer<T> buffer;
        tiles_->prefetch(list_[i], image);
        const auto put = [&](const Tiles::Line& line, const auto* values) { buffer.put(list_[i], line, values); };
        tile(i, scale, put, put);
        tiles_->copy(list_[i], buffer, image);
    });
}
#if defined(LOMMEL_COMPILED)
extern template void PolarImage::paint<float>(double, float*);
extern template void PolarImage::paint<double>(double, double*);
#endif

}  // namespace lommel
