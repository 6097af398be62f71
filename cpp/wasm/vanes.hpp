// Images of a pupil with straight vanes, or with very large aberrations, by quadrature along its rows, for the live page.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <memory>
#include <numeric>
#include <vector>

#include "lommel/base/pi.hpp"
#include "overlap.hpp"
#include "lommel/pixels/filter.hpp"
#include "lommel/pixels/taps.hpp"

#include "light.hpp"
#include "lommel/special/wave_sums.hpp"

namespace live {

using lommel::pi;

// The aperture is divided into panels of rows between the heights where edges meet. Within a panel each row has the same number
// of intervals, whose ends are analytic functions of y but for square roots at the first and last row, which y = middle + half
// sin(t) removes. So Gauss-Legendre rules in t and in x converge faster than any power, and sums over rows and columns are
// matrix products.
class CutPupil {
   public:
    // Rotated so that the x axis has the direction `facing`. `aberrated`: with the wavefront.
    CutPupil(const Light& light, double stretch, double facing, bool aberrated)
        : eps_(light.obscuration), half_width_(0.5 * light.vane_width), lines_(static_cast<double>(light.lines.size())),
          overlap_(light.terms, light.stretched(aberrated ? stretch : 0.0).data(), eps_) {
        overlap_.face(facing);
        for (const double angle : light.vanes) {
            vanes_.push_back({std::cos(angle - facing), std::sin(angle - facing)});
        }
        for (const Row& row : rows(0.0, 4.0, 10.0, dense)) {
            for (const Interval& part : row.parts) {
                area_ += row.weight * (part.high - part.low) / pi;
            }
        }
    }

    double area() const { return area_; }  // relative to that of the whole disk

    // Return the estimated time of field() for all lines, in WebAssembly on a laptop.
    double seconds(std::size_t side, double step) const {
        const double far = static_cast<double>(side / 2) * step;
        const auto price = [&](double length) { return 10.0 + dense * length * (overlap_.slope() + far); };
        const std::array<double, 2> found = counts(0.0, turns_to(far), 10.0, dense, price);
        return lines_ * (80e-9 * found[1] + 30e-9 * found[0] * static_cast<double>(side));
    }

    // Field at the columns and rows of a square window about the axis, real and imaginary parts alternating; with `kernel`, the
    // samples from which it interpolates the field.
    std::vector<float> field(std::size_t side, double step, const lommel::GriddingKernel* kernel = nullptr) const {
        const double far = static_cast<double>(side / 2) * step, slope = overlap_.slope() + far;
        const std::vector<Row> all = rows(0.0, turns_to(far), 10.0, dense);
        const std::size_t count = all.size(), blocks = (side + wide - 1) / wide;
        const lommel::WaveKernel kernel_of(side);
        lommel::WaveSums waves(kernel_of);
        // Sums of each row along the columns: [eight columns][row][real parts, imaginary parts].
        std::vector<float> sums(2 * wide * count * blocks), out(2 * side * side);
        const Taper taper(kernel, step);
        lommel::dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            for (std::size_t first = 0; first < count; first += wide) {
                const std::size_t here = std::min(wide, count - first);
                waves.start();
                for (std::size_t r = 0; r < here; ++r) {
                    add_row(isa, all[first + r], taper, slope, step, r, waves);
                }
                waves.finish(isa, [&](std::size_t k, const double* sum, double gain) LOMMEL_INLINE_LAMBDA {
                    float* const to = &sums[2 * wide * (k / wide * count + first) + k % wide];
                    for (std::size_t r = 0; r < here; ++r) {
                        to[2 * wide * r] = static_cast<float>(gain * sum[r]);
                        to[2 * wide * r + wide] = static_cast<float>(gain * sum[wide + r]);
                    }
                });
            }
            for (std::size_t b = 0; b < blocks; ++b) {
                waves.start();
                for (std::size_t r = 0; r < count; ++r) {
                    waves.add(isa, &sums[2 * wide * (b * count + r)], step * all[r].y);
                }
                waves.finish(isa, [&](std::size_t k, const double* sum, double gain) LOMMEL_INLINE_LAMBDA {
                    float* const to = &out[2 * (k * side + b * wide)];
                    for (std::size_t i = 0; i < std::min(wide, side - b * wide); ++i) {
                        to[2 * i] = static_cast<float>(gain * sum[i]);
                        to[2 * i + 1] = static_cast<float>(gain * sum[wide + i]);
                    }
                });
            }
        });
        return out;
    }

    // int P(u - f, y) conj P(u + f, y) over the area: the OTF at f over the cutoff along x; nodes as in Overlap::at().
    std::complex<double> contrast(double f, std::size_t more) {
        std::complex<double> sum = 0.0;
        overlap_.set_shift(f, more);
        for (const Row& row : rows(f, overlap_.run(), 8.0, 0.25)) {
            for (const Interval& part : row.parts) {
                sum += row.weight * overlap_.along(row.y, part.low, part.high);
            }
        }
        return sum / (pi * area_);
    }

    // Return the approximate number of nodes of contrast(); a row costs as much as a hundred nodes.
    double contrast_price(double f) {
        overlap_.set_shift(f, 0);
        const auto price = [&](double length) { return 20.0 + 0.2 * overlap_.run() * length; };
        const std::array<double, 2> found = counts(f, overlap_.run(), 8.0, 0.25, price);
        return 100.0 * found[0] + found[1];
    }

   private:
    static constexpr double dense = 0.28;  // nodes per radian
    static constexpr std::size_t wide = lommel::fft_rows;
    struct Point {
        double x, y;
    };
    struct Vane {
        double c, s;
    };
    struct Interval {
        double low, high;
    };
    // At most ten intervals in a row: nine gaps with eight vanes and a hole; twice as many for two rows.
    class Intervals {
       public:
        void push_back(Interval interval) { at_[count_++] = interval; }
        const Interval* begin() const { return at_.data(); }
        const Interval* end() const { return at_.data() + count_; }
        std::size_t size() const { return count_; }
        const Interval& operator[](std::size_t i) const { return at_[i]; }

       private:
        std::array<Interval, 24> at_;
        std::size_t count_ = 0;
    };
    struct Row {
        double y, weight;
        Intervals parts;
    };
    using Line = lommel::Overlap::Line;

    double turns_to(double far) const { return overlap_.slope() + 1.42 * far; }

    // Gauss-Legendre rule on pieces of equal length, for an integrand whose phase changes by `turns` radians in total.
    struct Pieces {
        Pieces(double least, double turns, double density)
            : count(1 + static_cast<std::size_t>(turns / 800.0)),
              nodes(rounded(least + density * turns / static_cast<double>(count))) {}

        const lommel::Overlap::Rule& rule() const { return lommel::Overlap::rule(nodes); }
        const std::size_t count, nodes;

       private:
        static std::size_t rounded(double nodes) {
            const std::size_t n = static_cast<std::size_t>(nodes), step = n < 64 ? 4 : 16;  // few different sizes
            return (n / step + 1) * step;
        }
    };

    // Coefficients of the phase along a row.
    void along(double y, Line& c) const {
        for (std::size_t p = 0; p < c.size(); ++p) {
            c[p] = 0.0;
            for (std::size_t j = c.size() - p; j-- > 0;) {
                c[p] = c[p] * y + overlap_.powers()[p][j];
            }
        }
    }

    // Reciprocal transform of a kernel at samples this step apart, as a polynomial of x^2; 1 without a kernel.
    struct Taper {
        static constexpr std::size_t terms = 12;
        std::array<double, terms> at{};

        Taper(const lommel::GriddingKernel* kernel, double step) {
            at[0] = 1.0;
            if (kernel != nullptr) {
                double values[terms];
                for (std::size_t j = 0; j < terms; ++j) {
                    const double square = 0.5 + 0.5 * lommel::chebyshev_point(j, terms);
                    values[j] = 1.0 / kernel->transform(step * std::sqrt(square));
                }
                lommel::ChebyshevToMonomials<terms>()(values, 1, at.data(), terms);
            }
        }
        template <class V>
        LOMMEL_INLINE V operator()(V x) const {
            const V z = x * x + x * x - (x - x + 1.0);
            V sum = z - z + at[terms - 1];
            for (std::size_t p = terms - 1; p-- > 0;) {
                sum = sum * z + at[p];
            }
            return sum;
        }
    };

    // Add the waves of a row at its nodes to sum `r`. A separate function: a browser that recompiles frequently called
    // functions then uses the faster code from the next call on.
    template <class I>
    [[gnu::noinline]] void add_row(I isa, const Row& row, const Taper& taper, double slope, double step, std::size_t r,
                                   lommel::WaveSums& waves) const {
        using namespace lommel;
        using V = typename I::pack;
        Line c;
        along(row.y, c);
        for (const Interval& part : row.parts) {
            const Pieces pieces(10.0, (part.high - part.low) * slope, dense);
            const lommel::Overlap::Rule& rule = pieces.rule();
            const double length = (part.high - part.low) / static_cast<double>(pieces.count),
                         weight = row.weight * taper(row.y) * length / pi;
            for (std::size_t piece = 0; piece < pieces.count; ++piece) {
                const double low = part.low + length * static_cast<double>(piece);
                for (std::size_t k = 0; k < rule.nodes; k += I::lanes) {
                    const V x = splat<V>(low) + splat<V>(length) * load<V>(&rule.x[k]);
                    V phase = splat<V>(c[overlap_.degree()]), sine, cosine;
                    for (std::size_t p = overlap_.degree(); p-- > 0;) {
                        phase = phase * x + splat<V>(c[p]);
                    }
                    sincos(isa, phase, sine, cosine);
                    const V w = splat<V>(weight) * load<V>(&rule.w[k]) * taper(x), s = splat<V>(step) * x;
                    const V re = w * cosine, im = w * sine;
                    for (std::size_t lane = 0; lane < std::min(I::lanes, rule.nodes - k); ++lane) {
                        waves.add(isa, r, re[lane], im[lane], s[lane]);
                    }
                }
            }
        }
    }

    // Clear intervals of a row at this height, shifted by `by`.
    Intervals row(double y, double by) const {
        const double rim = std::sqrt(std::max(0.0, (1.0 - y) * (1.0 + y)));
        Intervals clear;
        clear.push_back({-rim + by, rim + by});
        const auto block = [&](double low, double high) {
            Intervals left;
            for (const Interval& part : clear) {
                if (low + by > part.low) {
                    left.push_back({part.low, std::min(part.high, low + by)});
                }
                if (high + by < part.high) {
                    left.push_back({std::max(part.low, high + by), part.high});
                }
            }
            clear = left;
        };
        if (std::abs(y) < eps_) {
            const double hole = std::sqrt((eps_ - y) * (eps_ + y));
            block(-hole, hole);
        }
        for (const Vane& vane : vanes_) {
            double low = -2.0, high = 2.0;
            const double cuts[3][2] = {
                {vane.c, -vane.s * y}, {-vane.s, -half_width_ - vane.c * y}, {vane.s, -half_width_ + vane.c * y}};
            for (const auto& [factor, least] : cuts) {  // factor x > least
                if (factor > 1e-14) {
                    low = std::max(low, least / factor);
                } else if (factor < -1e-14) {
                    high = std::min(high, least / factor);
                } else if (least >= 0.0) {
                    high = low;
                }
            }
            if (high > low) {
                block(low, high);
            }
        }
        return clear;
    }
    Intervals shared(double y, double f) const {
        Intervals both, left = row(y, -f);
        if (f == 0.0) {
            return left;
        }
        for (const Interval& a : row(y, f)) {
            for (const Interval& b : left) {
                if (std::min(a.high, b.high) > std::max(a.low, b.low)) {
                    both.push_back({std::max(a.low, b.low), std::min(a.high, b.high)});
                }
            }
        }
        return both;
    }

    // Call use(middle, half the height, pieces) for each panel of the area that is clear in both apertures, shifted by f and by
    // -f.
    template <class Use>
    void panels(double f, double turns, double least, double density, Use use) const {
        const std::vector<double> edges = meetings(f);
        for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
            const double middle = 0.5 * (edges[k] + edges[k + 1]), half = 0.5 * (edges[k + 1] - edges[k]);
            // Displacement of the ends of intervals.
            const Intervals first = shared(middle - 0.999999 * half, f), last = shared(middle + 0.999999 * half, f);
            double move = first.size() == last.size() ? 0.0 : 2.0;
            for (std::size_t i = 0; i < std::min(first.size(), last.size()); ++i) {
                move = std::max({move, std::abs(first[i].low - last[i].low), std::abs(first[i].high - last[i].high)});
            }
            use(middle, half, Pieces(least + 2.0, 0.5 * pi * turns * (move + 2.0 * half), density));
        }
    }
    std::vector<Row> rows(double f, double turns, double least, double density) const {
        std::vector<Row> found;
        panels(f, turns, least, density, [&](double middle, double half, const Pieces& pieces) {
            const double each = pi / static_cast<double>(pieces.count);
            const lommel::Overlap::Rule& rule = pieces.rule();
            for (std::size_t piece = 0; piece < pieces.count; ++piece) {
                for (std::size_t i = 0; i < rule.nodes; ++i) {
                    const double t = each * (static_cast<double>(piece) + rule.x[i]) - 0.5 * pi;
                    const double y = middle + half * std::sin(t);
                    found.push_back({y, each * rule.w[i] * half * std::cos(t), shared(y, f)});
                }
            }
        });
        return found;
    }
    // Approximate number of these rows, and the sum over their intervals of price(length).
    template <class Price>
    std::array<double, 2> counts(double f, double turns, double least, double density, Price price) const {
        std::array<double, 2> found{};
        panels(f, turns, least, density, [&](double middle, double half, const Pieces& pieces) {
            const double count = static_cast<double>(pieces.count * pieces.nodes);
            found[0] += count;
            for (const double t : {-0.92, -0.38, 0.38, 0.92}) {
                for (const Interval& part : shared(middle + half * t, f)) {
                    found[1] += 0.25 * count * price(part.high - part.low);
                }
            }
        });
        return found;
    }

    // Ascending heights at which edges of the apertures shifted by f and by -f meet, begin or end without being covered.
    std::vector<double> meetings(double f) const {
        std::vector<std::array<double, 2>> circles;  // centre and radius
        std::vector<std::array<Point, 2>> lines;
        for (const double by : {f, -f}) {
            circles.push_back({by, 1.0});
            if (eps_ > 0.0) {
                circles.push_back({by, eps_});
            }
            for (const Vane& v : vanes_) {
                const Point a{by - v.s * half_width_, v.c * half_width_}, b{by + v.s * half_width_, -v.c * half_width_};
                lines.push_back({a, b});
                lines.push_back({a, {a.x + 2.0 * v.c, a.y + 2.0 * v.s}});
                lines.push_back({b, {b.x + 2.0 * v.c, b.y + 2.0 * v.s}});
            }
            if (f == 0.0) {
                break;
            }
        }
        std::vector<double> heights;
        const auto add = [&](double x, double y) {
            if (clear(x - f, y) && clear(x + f, y)) {
                heights.push_back(y);
            }
        };
        for (std::size_t i = 0; i < circles.size(); ++i) {
            const double middle = circles[i][0], radius = circles[i][1];
            add(middle, radius);
            add(middle, -radius);
            for (std::size_t j = i + 1; j < circles.size(); ++j) {
                const double distance = circles[j][0] - middle;
                if (distance != 0.0) {
                    const double x = 0.5 * (distance + (radius - circles[j][1]) * (radius + circles[j][1]) / distance);
                    const double square = (radius - x) * (radius + x);
                    if (square >= 0.0) {
                        add(middle + x, std::sqrt(square));
                        add(middle + x, -std::sqrt(square));
                    }
                }
            }
            for (const auto& [p, q] : lines) {
                const double dx = q.x - p.x, dy = q.y - p.y, x = p.x - middle, size = dx * dx + dy * dy;
                const double at = -(x * dx + p.y * dy) / size;
                const double square = at * at - (x * x + p.y * p.y - radius * radius) / size;
                for (const double side : {-1.0, 1.0}) {
                    const double t = square >= 0.0 ? at + side * std::sqrt(square) : -1.0;
                    if (t >= 0.0 && t <= 1.0) {
                        add(p.x + t * dx, p.y + t * dy);
                    }
                }
            }
        }
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const auto& [p, q] = lines[i];
            add(p.x, p.y);
            const double dx = q.x - p.x, dy = q.y - p.y;
            for (std::size_t j = i + 1; j < lines.size(); ++j) {
                const auto& [a, b] = lines[j];
                const double ex = b.x - a.x, ey = b.y - a.y, cross = dx * ey - dy * ex;
                if (std::abs(cross) > 1e-12) {
                    const double t = ((a.x - p.x) * ey - (a.y - p.y) * ex) / cross;
                    const double u = ((a.x - p.x) * dy - (a.y - p.y) * dx) / cross;
                    if (t >= 0.0 && t <= 1.0 && u >= 0.0 && u <= 1.0) {
                        add(p.x + t * dx, p.y + t * dy);
                    }
                }
            }
        }
        std::sort(heights.begin(), heights.end());
        const auto same = [](double a, double b) { return b - a < 1e-10; };
        heights.erase(std::unique(heights.begin(), heights.end(), same), heights.end());
        return heights;
    }

    // Return whether a point is clear; points on an edge are.
    bool clear(double x, double y) const {
        constexpr double little = 1e-9;
        const double rho = std::hypot(x, y);
        return rho <= 1.0 + little && rho >= eps_ - little && std::none_of(vanes_.begin(), vanes_.end(), [&](const Vane& v) {
                   return v.c * x + v.s * y > little && std::abs(v.c * y - v.s * x) < half_width_ - little;
               });
    }

    double eps_, half_width_, lines_, area_ = 0.0;
    std::vector<Vane> vanes_;
    lommel::Overlap overlap_;
};

// Window of samples for an image; for pixel averages a larger one, of finer samples.
struct CutSamples {
    CutSamples(const View& view, double stretch)
        : taps(view.step * stretch, 1e-7, 1.05), filter{taps.weights.data(), taps.weights.size(), taps.stride},
          wide(filter.samples(view.side)), middle(taps.stride * (view.side / 2) + taps.margin()),
          side(view.integrate ? 2 * std::max(middle, wide - 1 - middle) + 1 : view.side),
          step(view.step * stretch / (view.integrate ? static_cast<double>(taps.stride) : 1.0)) {}

    const lommel::PixelTaps taps;
    const lommel::PixelFilter filter;
    const std::size_t wide, middle, side;
    const double step;
};

// Return the estimated time of cut_image_of(), from the slowest line.
inline double cut_seconds(const Light& light, const View& view) {
    double widest = 0.0;
    for (const Line& line : light.lines) {
        widest = std::max(widest, line.stretch);
    }
    const CutSamples samples(view, widest);
    return CutPupil(light, widest, 0.0, true).seconds(samples.side, samples.step);
}

// Add the fractions of all light per pixel of a pupil with vanes in one line to `total`, and with weights to three planes.
// Returns the clear area over that of the disk.
inline double add_cut_image(const Light& light, const Line& line, const View& view, std::vector<double>& total,
                            const double* weights, float* planes) {
    const CutPupil pupil(light, line.stretch, 0.0, true);
    const double step = view.step * line.stretch;
    const double scale = line.share * step * step / (12.566370614359172 * pupil.area());
    const std::size_t pixels = view.side * view.side;
    const CutSamples samples(view, line.stretch);
    const std::size_t side = samples.side, wide = samples.wide;
    const std::vector<float> field = pupil.field(side, samples.step);
    std::vector<double> image(side * side);
    for (std::size_t i = 0; i < side * side; ++i) {
        const double re = static_cast<double>(field[2 * i]), im = static_cast<double>(field[2 * i + 1]);
        image[i] = re * re + im * im;
    }
    if (view.integrate) {
        const std::size_t skip = side / 2 - samples.middle;
        for (std::size_t row = 0; row < wide; ++row) {
            std::copy_n(&image[(row + skip) * side + skip], wide, &image[row * wide]);
        }
        std::vector<double> averages(pixels);
        samples.filter.average(image.data(), 1, view.side, view.side, averages.data(), pixels, 1);
        image.swap(averages);
    }
    for (std::size_t i = 0; i < pixels; ++i) {
        total[i] += scale * image[i];
        for (std::size_t c = 0; planes != nullptr && c < 3; ++c) {
            planes[c * pixels + i] += static_cast<float>(weights[c] * scale * image[i]);
        }
    }
    return pupil.area();
}

// Like image_of(), without an error bound.
inline Proof cut_image_of(const Light& light, const View& view, float* out, const double* weights, float* planes,
                          double* area) {
    const std::size_t pixels = view.side * view.side;
    std::vector<double> total(pixels, 0.0);
    if (planes != nullptr) {
        std::fill_n(planes, 3 * pixels, 0.0F);
    }
    for (std::size_t k = 0; k < light.lines.size(); ++k) {
        *area = add_cut_image(light, light.lines[k], view, total, weights + 3 * k, planes);
    }
    std::transform(total.begin(), total.end(), out, [](double x) { return static_cast<float>(x); });
    return {std::nan(""), *std::max_element(total.begin(), total.end())};
}

// Intensity near the axis, interpolated by a kernel from samples of the field divided by its transform.
class CutField {
   public:
    // At radii up to `reach` in v. `even`: the intensity is the same after half a turn.
    CutField(const CutPupil& pupil, double reach, bool even)
        : turn_(even ? pi : 2.0 * pi), kernel_(lommel::GriddingKernel::of(taps, pi / step)), polynomials_(kernel_),
          half_(side(reach) / 2), samples_(pupil.field(2 * half_ + 1, step, &kernel_)) {}

    static constexpr double step = 1.5;
    static std::size_t side(double reach) { return 2 * (static_cast<std::size_t>(reach / step) + taps / 2 + 1) + 1; }

    // Sums of the intensity along columns and along rows at samples of pitch `step`, fine enough for the band of the transfer
    // function, which is their transform.
    std::array<std::vector<double>, 2> sums() const {
        const int far = static_cast<int>(half_) - static_cast<int>(taps / 2) - 1;
        std::array<std::vector<double>, 2> found;
        found.fill(std::vector<double>(static_cast<std::size_t>(2 * far + 1), 0.0));
        lommel::dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            for (int y = -far; y <= far; ++y) {
                for (int x = -far; x <= far; ++x) {
                    const double value = intensity(isa, step * x, step * y);
                    found[0][static_cast<std::size_t>(x + far)] += value;
                    found[1][static_cast<std::size_t>(y + far)] += value;
                }
            }
        });
        return found;
    }

    // Mean on a circle, around which the highest frequency of the intensity is 2 v.
    double mean(double v) const {
        const std::size_t places = 6 + static_cast<std::size_t>(turn_ * (0.38 * v + 3.0));
        double sum = 0.0;
        lommel::dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
            for (std::size_t j = 0; j < places; ++j) {
                const double theta = turn_ * (static_cast<double>(j) + 0.25) / static_cast<double>(places);
                sum += intensity(isa, v * std::cos(theta), v * std::sin(theta));
            }
        });
        return sum / static_cast<double>(places);
    }

   private:
    static constexpr std::size_t taps = lommel::SingleTaps::taps;

    template <class I>
    LOMMEL_INLINE double intensity(I, double x, double y) const {
        using namespace lommel;
        using V = typename RowPack<I, float>::type;
        constexpr std::size_t lanes = sizeof(V) / sizeof(float), parts = 2 * taps / lanes;
        const double at[2] = {x / step + static_cast<double>(half_), y / step + static_cast<double>(half_)};
        float weights[2][taps], across[2 * taps];
        std::size_t first[2];
        for (std::size_t axis = 0; axis < 2; ++axis) {
            const double whole = std::floor(at[axis]);
            const V t = splat<V>(static_cast<float>(2.0 * (at[axis] - whole) - 1.0));
            for (std::size_t i = 0; i < taps; i += lanes) {
                V sum = load<V>(polynomials_.at[0] + i);
                for (std::size_t p = 1; p < SingleTaps::terms; ++p) {
                    sum = sum * t + load<V>(polynomials_.at[p] + i);
                }
                store(weights[axis] + i, sum);
            }
            first[axis] = static_cast<std::size_t>(whole) - taps / 2 + 1;
        }
        for (std::size_t i = 0; i < taps; ++i) {
            across[2 * i] = across[2 * i + 1] = weights[0][i];
        }
        V sums[parts];
        const float* from = &samples_[2 * (first[1] * (2 * half_ + 1) + first[0])];
        for (std::size_t row = 0; row < taps; ++row, from += 2 * (2 * half_ + 1)) {
            const V w = splat<V>(weights[1][row]);
            for (std::size_t p = 0; p < parts; ++p) {
                const V here = w * load<V>(from + p * lanes);
                sums[p] = row == 0 ? here : sums[p] + here;
            }
        }
        V both = sums[0] * load<V>(across);
        for (std::size_t p = 1; p < parts; ++p) {
            both = both + sums[p] * load<V>(across + p * lanes);
        }
        float re = 0.0F, im = 0.0F;
        for (std::size_t i = 0; i < lanes; i += 2) {
            re += both[i];
            im += both[i + 1];
        }
        return static_cast<double>(re) * re + static_cast<double>(im) * im;
    }

    double turn_;
    lommel::GriddingKernel kernel_;
    lommel::SingleTaps polynomials_;
    std::size_t half_;
    std::vector<float> samples_;
};

// Return the largest radius, at most `reach` in v of the reference, up to which there is time to compute the circles of a pupil
// with vanes.
inline double cut_reach(const Light& light, double reach) {
    double widest = 0.0;
    for (const Line& line : light.lines) {
        widest = std::max(widest, line.stretch);
    }
    const CutPupil aberrated(light, widest, 0.0, true), plain(light, widest, 0.0, false);
    const double lines = static_cast<double>(light.lines.size());
    for (reach = std::min(reach, 2000.0 / widest);; reach *= 0.85) {
        const double far = reach * widest;
        const std::size_t side = CutField::side(far);
        const double rings = 2.0 * lines * 100e-9 * far * far;
        if (aberrated.seconds(side, CutField::step) + plain.seconds(side, CutField::step) / lines + rings < 0.9 || far < 50.0) {
            return reach;
        }
    }
}

// Sums of the intensity of each line along columns and along rows.
using CutSums = std::vector<std::array<std::vector<double>, 2>>;

// On circles about the axis with ascending radii from 0, in v of the reference: the mean intensity relative to the peak without
// aberration, and the encircled energy as a fraction of all light. Returns the clear area over that of the disk.
inline double cut_circles(const Light& light, bool aberrated, const double* v, std::size_t count, double* means, double* shares,
                          CutSums* sums) {
    std::fill_n(means, count, 0.0);
    std::fill_n(shares, count, 0.0);
    double brightest = 0.0, area = 1.0;
    std::unique_ptr<CutField> field;
    for (const Line& line : light.lines) {
        // Without aberration all lines have the same pupil.
        if (aberrated || !field) {
            const CutPupil pupil(light, line.stretch, 0.0, aberrated);
            double widest = line.stretch;
            for (const Line& other : light.lines) {
                widest = aberrated ? widest : std::max(widest, other.stretch);
            }
            area = pupil.area();
            field.reset();
            field = std::make_unique<CutField>(pupil, v[count - 1] * widest, !aberrated);
        }
        if (sums != nullptr) {
            sums->push_back(field->sums());
            for (std::vector<double>& axis : sums->back()) {
                for (double& value : axis) {
                    value *= CutField::step * CutField::step / (12.566370614359172 * area);
                }
            }
        }
        brightest += line.weight() * area * area;
        double energy = 0.0;
        for (std::size_t k = 0; k < count; ++k) {
            const double radius = v[k] * line.stretch;
            means[k] += line.weight() * field->mean(radius);
            if (k > 0) {
                const double before = v[k - 1] * line.stretch, wide = radius - before;
                const lommel::Overlap::Rule& rule = lommel::Overlap::rule(5 + static_cast<std::size_t>(0.7 * wide));
                for (std::size_t i = 0; i < rule.nodes; ++i) {
                    const double at = before + wide * rule.x[i];
                    energy += 0.5 * wide * rule.w[i] * at * field->mean(at);
                }
            }
            shares[k] += line.share * energy / area;
        }
    }
    std::for_each(means, means + count, [&](double& value) { value /= brightest; });
    return area;
}

// The OTF along x, along y, and without aberration, at frequencies relative to the cutoff of the reference.
inline void cut_contrast(const Light& light, const double* f, std::size_t count, std::size_t more, std::complex<double>* x,
                         std::complex<double>* y, double* limit) {
    std::vector<std::complex<double>> flat(count);
    std::complex<double>* const curves[3] = {x, y, flat.data()};
    for (std::size_t curve = 0; curve < 3; ++curve) {
        std::fill_n(curves[curve], count, 0.0);
        for (const Line& line : light.lines) {
            CutPupil pupil(light, line.stretch, curve == 1 ? 1.5707963267948966 : 0.0, curve < 2);
            for (std::size_t i = 0; i < count && f[i] < line.stretch; ++i) {
                curves[curve][i] += line.share * pupil.contrast(f[i] / line.stretch, more);
            }
        }
    }
    std::transform(flat.begin(), flat.end(), limit, [](std::complex<double> sum) { return std::abs(sum); });
}

// The OTF from the sums of cut_circles(). Returns the fraction of light outside these circles, a bound on the error of each
// value.
inline double near_contrast(const Light& light, const CutSums& sums, const double* f, std::size_t count,
                            std::complex<double>* x, std::complex<double>* y, double* limit) {
    std::complex<double>* const curves[2] = {x, y};
    std::fill_n(x, count, 0.0);
    std::fill_n(y, count, 0.0);
    std::fill_n(limit, count, 0.0);
    constexpr std::size_t intervals = 512;
    std::array<double, intervals + 1> plain{};
    CutPupil flat(light, 1.0, 0.0, false);
    for (std::size_t i = 0; i < intervals; ++i) {
        plain[i] = flat.contrast(static_cast<double>(i) / intervals, 2).real();
    }
    double found = 0.0;
    for (std::size_t k = 0; k < sums.size(); ++k) {
        const Line& line = light.lines[k];
        found += line.share * std::accumulate(sums[k][0].begin(), sums[k][0].end(), 0.0);
        for (std::size_t i = 0; i < count && f[i] < line.stretch; ++i) {
            const double turn = 2.0 * CutField::step * f[i] / line.stretch;
            const std::complex<double> each = std::polar(1.0, turn);
            for (std::size_t axis = 0; axis < 2; ++axis) {
                const std::vector<double>& light_at = sums[k][axis];
                double re = 0.0, im = 0.0;  // Horner's rule
                for (std::size_t j = light_at.size(); j-- > 0;) {
                    const double before = re;
                    re = re * each.real() - im * each.imag() + light_at[j];
                    im = before * each.imag() + im * each.real();
                }
                const double middle = -turn * static_cast<double>(light_at.size() / 2);
                curves[axis][i] += line.share * std::complex<double>(re, im) * std::polar(1.0, middle);
            }
            // Without aberration all lines have the same pupil; linear interpolation of its values has an error below that of
            // the missing light.
            const double at = f[i] / line.stretch * intervals;
            const auto below = static_cast<std::size_t>(at);
            limit[i] += line.share * (plain[below] + (at - static_cast<double>(below)) * (plain[below + 1] - plain[below]));
        }
    }
    return std::abs(1.0 - found);
}

// Approximate number of nodes of cut_contrast(), from three frequencies in the line with the most nodes.
inline double cut_contrast_price(const Light& light, std::size_t count) {
    double widest = 0.0, nodes = 0.0;
    for (const Line& line : light.lines) {
        widest = std::max(widest, line.stretch);
    }
    CutPupil pupil(light, widest, 0.0, true);
    for (const double f : {0.1, 0.35, 0.7}) {
        nodes += pupil.contrast_price(f) / 3.0;
    }
    return 2.0 * static_cast<double>(light.lines.size() * count) * nodes;
}

}  // namespace live
