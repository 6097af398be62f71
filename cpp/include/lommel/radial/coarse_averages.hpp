// Averages of a radially symmetric PSF over pixels wider than its interference rings, by the divergence theorem from the flux
// through pixel edges: the intensity is the divergence of the radial vector field of modulus E(r) / r, where E(r) is the
// encircled energy / (2 pi) (docs/certificate.md, section 9, "Coarse pixels").
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "lommel/base/cache.hpp"
#include "lommel/bounds/pixels.hpp"
#include "lommel/bounds/refine.hpp"
#include "lommel/pixels/weights.hpp"
#include "lommel/pixels/window.hpp"
#include "lommel/radial/energy_tail.hpp"
#include "lommel/radial/intensity.hpp"
#include "lommel/special/chebyshev.hpp"
#include "lommel/special/legendre.hpp"

namespace lommel {

// Tables of a window: its distinct pixels, and the average of r^-3 over each, r the distance from the axis.
struct CoarseWindow {
    PixelWindow window;
    PixelGroups groups;
    std::vector<double> edges;  // distances of pixel edges from the axis, in pixels, ascending; negative across the axis
    std::vector<std::int32_t> left, right, top, bottom;  // for each column or row: index into `edges` of its two edges
    Doubles means;  // for each group of pixels: average of distance^-3 over a pixel, in pixels^-3

    explicit CoarseWindow(const PixelWindow& w) : window(w), groups(w) {
        const std::vector<double>&down = groups.rows.distances, &across = groups.columns.distances;
        for (const auto* along : {&down, &across}) {
            for (const double middle : *along) {
                edges.push_back(middle - 0.5);
                edges.push_back(middle + 0.5);
            }
        }
        std::sort(edges.begin(), edges.end());
        edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
        const auto find = [&](const std::vector<double>& along, double away, std::vector<std::int32_t>& found) {
            for (const double middle : along) {
                found.push_back(
                    static_cast<std::int32_t>(std::lower_bound(edges.begin(), edges.end(), middle + away) - edges.begin()));
            }
        };
        find(across, -0.5, left);
        find(across, 0.5, right);
        find(down, -0.5, top);
        find(down, 0.5, bottom);
        groups.cosine = {};
        means.resize(groups.v.size() + widest_step, 0.0);
        each(std::numeric_limits<double>::infinity(), [&](std::size_t group, std::size_t k, std::size_t i) {
            const double x0 = edges[left[k]], x1 = edges[right[k]], y0 = edges[top[i]], y1 = edges[bottom[i]];
            means[group] = crossing(x0, y0) - crossing(x1, y0) + crossing(y0, x0) - crossing(y1, x0);
        });
    }

    std::size_t bytes() const { return sizeof(double) * means.size() + sizeof(std::int32_t) * groups.index.size(); }
    bool is(const PixelWindow& w) const { return window == w; }
    static constexpr std::size_t most_bytes = std::size_t{48} << 20;
    static std::shared_ptr<const CoarseWindow> get(const PixelWindow& w) { return cache<CoarseWindow>.get(w); }

    // Call f(group, column, row) once for each distinct pixel whose nearer edges are less than `limit` pixels from the axis.
    template <class F>
    void each(double limit, const F& f) const {
        const std::size_t columns = left.size(), rows = top.size();
        for (std::size_t i = 0; i < rows && edges[top[i]] < limit; ++i) {
            for (std::size_t k = 0; k < columns && edges[left[k]] < limit; ++k) {
                const std::int32_t group = groups.index[i * columns + k];
                // Skip a pixel (i, k) whose mirror image (k, i) in the window has been visited.
                if (!(k < i && i < columns && k < rows && group == groups.index[k * columns + i])) {
                    f(static_cast<std::size_t>(group), k, i);
                }
            }
        }
    }
    bool holds_axis(std::size_t column, std::size_t row) const { return edges[left[column]] < 0.0 && edges[top[row]] < 0.0; }
    // Squared distances from the axis, in pixels^2, of the nearest and the farthest point of a pixel's edges.
    double nearest(std::size_t column, std::size_t row) const {
        const double x0 = edges[left[column]], x1 = edges[right[column]], y0 = edges[top[row]], y1 = edges[bottom[row]];
        if (holds_axis(column, row)) {
            const double nearer = std::min(std::min(-x0, x1), std::min(-y0, y1));
            return nearer * nearer;
        }
        const double x = std::max(0.0, x0), y = std::max(0.0, y0);
        return x * x + y * y;
    }
    double farthest(std::size_t column, std::size_t row) const {
        const double x1 = edges[right[column]], y1 = edges[bottom[row]];
        return x1 * x1 + y1 * y1;
    }

   private:
    // Integral over y, from `start` to start + 1, of x / r^3 along a pixel edge at distance x; r^2 = x^2 + y^2, all in pixels.
    static double crossing(double x, double start) {
        const double end = start + 1.0, before = std::sqrt(x * x + start * start), after = std::sqrt(x * x + end * end);
        if (start < 0.0) {
            return (end / after - start / before) / x;
        }
        return x == 0.0 ? 0.0 : x * (1.0 / (before * (before + start)) - 1.0 / (after * (after + end)));
    }
};

// Encircled energy / (2 pi), E(r) = int_0^r I(s) s ds: a polynomial on each interval (panel) of r, with an error bound.
class EnergyWithin {
   public:
    static constexpr double width = 2.0;  // width of a panel in optical units
    double rounding = 0.0;                // bound on the rounding error of computed encircled energies

    // Bound on |n-th derivative of the intensity| / 2^n, n >= 1, along any line: by Bernstein's inequality half of the largest
    // possible intensity, `swing`, or from the pupil, whose points far from the line's axis are few (docs/certificate.md, section 9).
    static double slope(std::size_t n, double swing) {
        const double order = static_cast<double>(n);
        return std::min(swing, 20.371832715762604 / ((order + 2.0) * (order + 2.0) * (order + 1.25)));
    }
    // Error of the encircled energy / (2 pi), due to interpolation of the intensity at `points` >= 4 Chebyshev points of a panel,
    // divided by half the panel's width and by the distance of its end from the axis: over a part of the panel, and over all of it.
    struct Between {
        double part = 0.0, whole = 0.0;

        Between(std::size_t points, double swing) {
            double power = 1.0;
            const auto add = [&](std::size_t k, double size) {
                const double order = static_cast<double>(k);
                part += size * (k < 3 ? 2.0 : 1.0 / (order - 2.0));
                whole += size * (k < 3 ? 2.0 : 2.0 / (order * (order - 2.0)));
            };
            for (std::size_t k = 1; k <= 3 * points; ++k) {
                power *= 0.5 * width / static_cast<double>(k);
                const double size = 2.0 * slope(k, swing) * power;  // bound on the Chebyshev coefficient of order k
                if (k == 3 * points) {
                    part += 5.0 * size;  // all further orders
                    whole += 5.0 * size;
                } else if (k >= points) {
                    add(k, size);
                    if (k > points) {
                        add(k > 2 * points ? k - 2 * points : 2 * points - k,
                            size);  // the order with the same values at the points
                    }
                }
            }
        }
    };

    // Compute the encircled energy up to the distance `reach`, from the intensity at `points` Chebyshev points per panel.
    // request: requested error of the field U; swing: half of the largest possible intensity.
    void make(Field& field, const Phase& phase, double obscuration, double reach, double request, std::size_t points,
              double swing, int threads) {
        panels_ = static_cast<std::size_t>(std::ceil(reach / width)) + 1;
        count_ = points + 2;
        const std::size_t all = panels_ * points;
        radii_.resize(all + widest_step);
        values_.resize(all + widest_step);
        places_.resize(points);
        for (std::size_t j = 0; j < points; ++j) {
            places_[j] = chebyshev_point(points - 1 - j, points);
        }
        for (std::size_t s = 0; s < panels_; ++s) {
            for (std::size_t j = 0; j < points; ++j) {
                radii_[s * points + j] = 0.5 * width * (static_cast<double>(2 * s + 1) + places_[j]);
            }
        }
        std::fill(radii_.begin() + all, radii_.end(), radii_[all - 1]);
        const Places at(radii_.data(), all, 1.0);
        const double bound = field.prepare(phase, 0, obscuration, at, request);
        intensities(field, at, threads, [&](std::size_t first, std::size_t count, const double* found) {
            std::copy_n(found, count, values_.data() + first);
        });

        transforms_.resize(std::max(transforms_.size(), points + 1));
        Doubles& transform = transforms_[points];
        if (transform.size() == 0) {
            const Doubles by_coefficient = cosine_transform(points);  // matrix for values at descending points
            transform.resize(points * points);
            for (std::size_t k = 0; k < points; ++k) {
                for (std::size_t j = 0; j < points; ++j) {
                    transform[(points - 1 - j) * points + k] = by_coefficient[k * points + j];
                }
            }
        }
        const double n = static_cast<double>(points), spread = lebesgue(points),
                     between = swing * interpolation_error(0.5 * width, points);
        energies_.assign(panels_ * count_, 0.0);
        offs_.assign(2 * panels_ + 2, 0.0);
        rounding = 0.0;
        const Between missed(points, swing);
        part_ = 0.5 * width * missed.part;
        double inside = 0.0;
        mean_.resize(points);
        moment_.resize(points + 3);
        series_.resize(count_);
        monomials_.assign(count_ * count_, 0.0);  // [k][power]: monomial coefficients of the Chebyshev polynomial T_k
        sizes_.assign(count_, 0.0);  // [k]: rounding error of the Chebyshev polynomial T_k, evaluated by powers, in roundoffs
        for (std::size_t k = 0; k < count_; ++k) {
            for (std::size_t power = k % 2; power <= k; power += 2) {
                const double risen = k > 1 && power > 0 ? 2.0 * monomials_[(k - 1) * count_ + power - 1] : 0.0;
                monomials_[k * count_ + power] = k < 2 ? 1.0 : risen - monomials_[(k - 2) * count_ + power];
                sizes_[k] += std::abs(monomials_[k * count_ + power]) *
                             (2.0 * static_cast<double>(power) + static_cast<double>(points) + 8.0);
            }
        }
        for (std::size_t s = 0; s < panels_; ++s) {
            const double* const values = values_.data() + s * points;
            const double middle = 0.5 * width * static_cast<double>(2 * s + 1), end = middle + 0.5 * width;
            rows_summed(transform.data(), values, points, points, mean_.data());
            double* const energy = &energies_[s * count_];
            const double before = inside;
            inside = integrate_moment(0.5 * width, middle, mean_.data(), points, before, moment_.data(), series_.data());
            // evaluating: rounding error of the energy, in roundoffs, due to positions and coefficients; tall: bound on the intensity
            // on the panel.
            const double top = *std::max_element(values, values + points), tall = spread * top + between;
            double evaluating = 4.0 * end * end * tall;
            rows_summed(monomials_.data(), series_.data(), count_, count_, energy);
            for (std::size_t k = 0; k < count_; ++k) {
                evaluating += sizes_[k] * std::abs(series_[k]);
            }
            rounding = std::max(rounding, unit_roundoff * evaluating);
            const double given = spread * intensity_error(std::sqrt(top), bound),
                         area = 0.5 * (end * end - (end - width) * (end - width));
            offs_[2 * s + 1] = given + unit_roundoff * 2.0 * n * (n + 8.0) * top;
            offs_[2 * s + 2] = offs_[2 * s] + offs_[2 * s + 1] * area + 0.5 * width * end * missed.whole +
                               unit_roundoff * (n + 8.0) * (before + inside);
        }
    }

    struct Crossed {
        double light = 0.0, turn = 0.0, off = 0.0;
    };
    // crossing(): Gauss quadrature along a pixel edge at distance x from the axis, from `start` to start + 1, all in units of the
    // pixel pitch `step`. light: integral of E x / r^2, E the encircled energy / (2 pi); turn: integral of x / r^2, about the angle
    // that the edge subtends; off: error of `light` due to errors of E. The number of nodes is a multiple of `together`.
    static constexpr std::size_t together = 8;
    Crossed crossing(double x, double start, double step, const std::vector<double>& nodes,
                     const std::vector<double>& weights) const {
        Crossed sum;
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
            const double places = step * (1.0 / width), farthest = static_cast<double>(panels_ - 1);
            for (std::size_t first = 0; first < nodes.size(); first += together) {
                double at[together], share[together], made[together];
                std::int32_t panel[together];
                for (std::size_t i = 0; i < together; ++i) {
                    const double t = start + nodes[first + i], square = std::max(1e-300, x * x + t * t),
                                 r = std::sqrt(square) * places;
                    panel[i] = static_cast<std::int32_t>(std::min(farthest, r));
                    at[i] = 2.0 * (r - static_cast<double>(panel[i])) - 1.0;
                    share[i] = weights[first + i] * x / square;
                }
                const double* from[together];
                for (std::size_t i = 0; i < together; ++i) {
                    from[i] = energies_.data() + static_cast<std::size_t>(panel[i]) * count_;
                    made[i] = from[i][count_ - 1];
                }
                for (std::size_t k = count_ - 1; k-- > 0;) {
                    for (std::size_t i = 0; i < together; ++i) {
                        made[i] = made[i] * at[i] + from[i][k];
                    }
                }
                for (std::size_t i = 0; i < together; ++i) {
                    sum.light += share[i] * made[i];
                    sum.turn += share[i];
                }
            }
        });
        const double end = start + 1.0, y = std::max(start * start, end * end);
        const double r = step * std::sqrt(x * x + y);
        sum.off = std::abs(sum.turn) * (off(r) + part(r));
        return sum;
    }

    // The error of E(r), the encircled energy / (2 pi), is at most off(r) + part(r); between two radii r <= R it changes by at most
    // off(R) - off(r) + 2 part(R).
    double part(double r) const { return part_ * (r + width); }
    double off(double r) const {
        const std::size_t s = panel(r);
        const double inside = width * static_cast<double>(s);
        return offs_[2 * s] + 0.5 * offs_[2 * s + 1] * (r * r - inside * inside);
    }

   private:
    // Compute sums[column], the sum over rows of factors[row] * matrix[row][column].
    static void rows_summed(const double* matrix, const double* factors, std::size_t rows, std::size_t columns, double* sums) {
        dispatch([&](auto) LOMMEL_INLINE_LAMBDA {
            std::fill_n(sums, columns, 0.0);
            for (std::size_t i = 0; i < rows; ++i) {
                const double *const row = matrix + i * columns, factor = factors[i];
                for (std::size_t k = 0; k < columns; ++k) {
                    sums[k] += factor * row[k];
                }
            }
        });
    }
    std::size_t panel(double r) const { return std::min(panels_ - 1, static_cast<std::size_t>(r / width)); }

    std::size_t panels_ = 1, count_ = 1;
    double part_ = 0.0;
    Doubles radii_, values_;
    std::vector<Doubles> transforms_;  // [points]: matrix [point][coefficient] from values to Chebyshev coefficients
    std::vector<double> places_, mean_, moment_, series_, monomials_, sizes_;  // buffers of make()
    // energies_[panel][power]: coefficients of the encircled energy in the position on a panel, -1 to 1. offs_[panel][0]: error
    // bound of the energy at the panel's start; offs_[panel][1]: error bound of the intensity on the panel.
    std::vector<double> energies_, offs_;
};

// Averages of one pupil's intensity over the pixels of a window: near the axis from the flux through each pixel's four edges,
// by Gauss quadrature; farther out from the smooth part of the intensity, with a bound on the omitted interference rings.
class CoarseAverages {
   public:
    // by_rings: error bound of far averages, which omit interference rings; error: error bound of near averages, which are
    // computed from the flux through pixel edges; top: largest average.
    double by_rings = 0.0, error = 0.0, top = 0.0;
    Doubles values;
    double off() const { return std::max(by_rings, error); }

    static constexpr double least_exact = 2.0;  // minimum pixel pitch, in optical units, if tables are not accurate enough
    static constexpr std::size_t few = 8;  // largest number of pupils for which filters may be faster
#if defined(__wasm__)
    // The live web page renders one image per window: weights (AverageRings), computed for it alone, would not save time.
    static constexpr double least = 3.0, least_alone = least, of_weights = 1e9;
#else
    static constexpr double least = 7.4;         // minimum pixel pitch, in optical units
    static constexpr double least_alone = 4.0;   // minimum pixel pitch, in optical units, for few pupils
    static constexpr double of_weights = 0.125;  // used if a stack takes at most this share of the time to compute weights
#endif

    struct Attempt {
        double rings, field, sums;  // requested errors: of averages by omitted rings; field U; of averages by quadrature
    };

    // Error bound of averages without interference rings, over pixels of width `step` with edges at distances >= r from the axis.
    // The flux through an edge is E (top of the file) times the angle that the edge subtends at the axis. An error rings(r) of E
    // therefore gives an error of rings(r) * (sum of the four angles) / step^2. This sum is at most 2 sqrt(2) step / r or, if the
    // axis is in the pixel, 2 pi <= pi step / r, as then r <= step / 2. Of the smooth intensity, only the term in r^-3 is averaged;
    // the average of the rest is at most curved(r) or, if the axis is in the pixel, pi / 2 times curved(r).
    static double left_out(const EnergyTail& tail, double step, double r) {
        return 3.1416 * tail.rings(r) / (r * step) + 1.6 * tail.curved(r);
    }
    // Distance from the axis, found by bisection, beyond which averages without interference rings have an error of <= `request`.
    static double without_rings(const EnergyTail& tail, double step, double request) {
        double low = 1.0, high = 1e8;
        while (high > 1.01 * low) {
            const double middle = std::sqrt(low * high);
            (left_out(tail, step, middle) <= request ? high : low) = middle;
        }
        return high;
    }

    // Compute the averages. light: transmitted light / pi; area: largest possible modulus of the field U.
    void make(const CoarseWindow& coarse, const Phase& phase, double obscuration, double light, double area,
              const Attempt& request, int threads) {
        const double step = coarse.window.step, swing = 0.5 * area * area, square = step * step;
        const EnergyTail tail(phase, obscuration);
        // If the error is larger even at the corner of the window, no pixel does without rings.
        const double corner = 1.5 * step * coarse.edges.back();
        const double high = left_out(tail, step, corner) > request.rings ? corner : without_rings(tail, step, request.rings);
        const double limit = high / step;
        const double factor = tail.mean() / (square * step), whole = 12.566370614359172 * light / square;
        const std::size_t count = coarse.groups.v.size();
        values.resize(count + widest_step);
        near_.clear();
        double reach = 0.0;
        const double within = limit * limit;
        for (std::size_t i = 0; i < count; ++i) {
            values[i] = factor * coarse.means[i];
        }
        std::fill(values.begin() + count, values.end(), 0.0);
        coarse.each(limit, [&](std::size_t group, std::size_t column, std::size_t row) {
            if (coarse.nearest(column, row) < within) {
                near_.push_back({group, column, row});
                reach = std::max(reach, coarse.farthest(column, row));
            } else if (coarse.holds_axis(column, row)) {
                values[group] += whole;
            }
        });
        const bool far = near_.size() < count;
        by_rings =
            far ? left_out(tail, step, high) + 64.0 * unit_roundoff * (factor / std::max(1e-3, std::min(1.0, limit)) + whole)
                : 0.0;
        error = 0.0;
        if (!near_.empty()) {
            reach = step * std::sqrt(reach);
            const double room = 0.25 * request.sums * square;  // allowed error of an integral along an edge of a pixel
            // E / r^2 is the integral over s, from 0 to 1, of s times the intensity at s r. gauss_error() is that of both directions.
            const auto quadrature = [&](std::size_t q) {
                return reach * step * gauss_error(step, q) * EnergyWithin::slope(2 * q, swing) / static_cast<double>(4 * q + 4);
            };
            constexpr std::size_t together = EnergyWithin::together;
            const std::size_t least = fewest(4, [&](std::size_t n) { return quadrature(n) <= room; }),
                              q = (least + together - 1) / together * together;
            const std::size_t points = fewest(4, [&](std::size_t n) {
                const EnergyWithin::Between panel(n, swing);
                return 1.1 * panel.whole + 3.0 / step * panel.part <= request.sums;
            });
            energy_.make(field_, phase, obscuration, reach, request.field, points, swing, threads);
            nodes_.assign(q, 0.0);
            weights_.assign(q, 0.0);
            gauss_legendre<double, double>(q, nodes_.data(), weights_.data());
            for (std::size_t j = 0; j < q; ++j) {
                nodes_[j] = 0.5 * (1.0 + nodes_[j]);
                weights_[j] *= 0.5;
            }
            const std::size_t sides = static_cast<std::size_t>(
                std::lower_bound(coarse.edges.begin(), coarse.edges.end(), reach / step * (1.0 + 1e-12)) -
                coarse.edges.begin());
            crossed_.assign(sides * sides, {0.0, -1e300, 0.0});
            const auto crossing = [&](std::int32_t x, std::int32_t start) -> const EnergyWithin::Crossed& {
                EnergyWithin::Crossed& found = crossed_[static_cast<std::size_t>(x) * sides + static_cast<std::size_t>(start)];
                if (found.turn == -1e300) {
                    look();
                    found = energy_.crossing(coarse.edges[x], coarse.edges[start], step, nodes_, weights_);
                }
                return found;
            };
            const double relative = unit_roundoff * static_cast<double>(q + 24) * 2.0 * light;
            for (const Near& pixel : near_) {
                const std::int32_t x0 = coarse.left[pixel.column], x1 = coarse.right[pixel.column], y0 = coarse.top[pixel.row],
                                   y1 = coarse.bottom[pixel.row];
                const EnergyWithin::Crossed sides_of[4] = {crossing(x1, y0), crossing(x0, y0), crossing(y1, x0),
                                                           crossing(y0, x0)};
                double sum = 0.0, turn = 0.0, turns = 0.0, off = 0.0;
                for (std::size_t i = 0; i < 4; ++i) {
                    const double sign = i % 2 == 0 ? 1.0 : -1.0;
                    sum += sign * sides_of[i].light;
                    turn += sign * sides_of[i].turn;
                    turns += std::abs(sides_of[i].turn);
                    off += sides_of[i].off;
                }
                values[pixel.group] = sum / square;
                // A constant error of the encircled energy is multiplied by the sum of the edges' signed angles, `turn`: nearly 0, or
                // 2 pi if the axis is in the pixel.
                const double end = step * std::sqrt(coarse.farthest(pixel.column, pixel.row)),
                             first = energy_.off(step * std::sqrt(coarse.nearest(pixel.column, pixel.row))),
                             last = energy_.off(end), change = 0.5 * (last - first) + energy_.part(end);
                const double given = std::min(off, change * turns + 0.5 * (last + first) * std::abs(turn));
                error = std::max(error, (given + (energy_.rounding + relative) * turns + 4.0 * quadrature(q)) / square);
            }
        }
        top = 0.0;
        for (std::size_t i = 0; i < count; ++i) {
            top = std::max(top, values[i]);
        }
    }

   private:
    Field field_;
    EnergyWithin energy_;
    std::vector<double> nodes_, weights_;
    std::vector<EnergyWithin::Crossed> crossed_;
    struct Near {
        std::size_t group, column, row;
    };
    std::vector<Near> near_;
};

}  // namespace lommel
