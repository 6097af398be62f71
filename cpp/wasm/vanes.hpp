// Images of a pupil with straight vanes, by quadrature along its rows, for the live page.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "lommel/measures/overlap.hpp"
#include "lommel/pixels/filter.hpp"
#include "lommel/pixels/taps.hpp"

#include "light.hpp"

namespace live {

// The aperture is cut into panels of rows between the places where edges meet; within a panel each row is the same number of
// intervals, whose ends are analytic but for square roots at its first and last row, which y = middle + half sin(t) removes. So
// Gauss-Legendre rules in t and in x converge faster than any power, and sums over rows and columns are products of matrices.
class CutPupil {
   public:
    // Turned so that the x axis lies at the angle `facing`. `lit`: with the wavefront.
    CutPupil(const Light& light, double stretch, double facing, bool lit)
        : eps_(light.obscuration), half_width_(0.5 * light.vane_width),
          overlap_(light.terms, light.stretched(lit ? stretch : 0.0).data(), eps_) {
        overlap_.face(facing);
        for (const double angle : light.vanes) {
            vanes_.push_back({std::cos(angle - facing), std::sin(angle - facing)});
        }
        for (const Row& row : rows(0.0, 4.0, 10.0)) {
            for (const Interval& part : row.parts) {
                area_ += row.weight * (part.high - part.low) / pi;
            }
        }
    }

    double area() const { return area_; }  // over that of the whole disk

    // The field at columns and rows of a square window about the axis: real and imaginary parts in turn.
    std::vector<double> field(std::size_t side, double step) const {
        const double middle = static_cast<double>(side / 2), far = middle * step, slope = overlap_.slope() + far;
        const std::vector<Row> all = rows(0.0, slope + 0.42 * far, 10.0);
        const std::size_t count = all.size(), blocks = (side + wide - 1) / wide, most = side / 2;
        // Of each row along the columns, `wide` of them at a time: first all rows of the first columns.
        std::vector<double> sums(2 * wide * count * blocks), re(wide * blocks), im(wide * blocks),
            turns(2 * count * (most + 1));
        for (std::size_t r = 0; r < count; ++r) {
            std::fill(re.begin(), re.end(), 0.0);
            std::fill(im.begin(), im.end(), 0.0);
            Line c;
            along(all[r].y, c);
            for (const Interval& part : all[r].parts) {
                const double length = part.high - part.low;
                const Rule& rule = rule_of(10.0, length * slope);
                for (std::size_t k = 0; k < rule.nodes; ++k) {
                    const double x = part.low + length * rule.x[k], a = all[r].weight * length * rule.w[k] / pi;
                    add_waves(a, phase(c, x) + middle * step * x, step * x, blocks, re.data(), im.data());
                }
            }
            for (std::size_t b = 0; b < blocks; ++b) {
                double* const to = &sums[2 * wide * (b * count + r)];
                std::copy_n(&re[wide * b], wide, to);
                std::copy_n(&im[wide * b], wide, to + wide);
            }
            const double c1 = std::cos(step * all[r].y), s1 = std::sin(step * all[r].y);
            double c0 = 1.0, s0 = 0.0;
            for (std::size_t k = 0; k <= most; ++k) {
                turns[2 * (k * count + r)] = c0;
                turns[2 * (k * count + r) + 1] = s0;
                const double next = c0 * c1 - s0 * s1;
                s0 = s0 * c1 + c0 * s1;
                c0 = next;
            }
        }
        // Rows k above and k below the axis share their cosines and sines.
        std::vector<double> out(2 * side * side);
        for (std::size_t b = 0; b < blocks; ++b) {
            for (std::size_t k = 0; k <= most; ++k) {
                double c[2 * wide] = {}, s[2 * wide] = {};
                const double *turn = &turns[2 * k * count], *sum = &sums[2 * wide * b * count];
                for (std::size_t r = 0; r < count; ++r, turn += 2, sum += 2 * wide) {
                    for (std::size_t i = 0; i < 2 * wide; ++i) {
                        c[i] += turn[0] * sum[i];
                        s[i] += turn[1] * sum[i];
                    }
                }
                for (std::size_t i = 0; i < std::min(wide, side - b * wide); ++i) {
                    double* const above = &out[2 * ((most - k) * side + b * wide + i)];
                    above[0] = c[i] - s[wide + i];
                    above[1] = c[wide + i] + s[i];
                    if (most + k < side) {
                        double* const below = &out[2 * ((most + k) * side + b * wide + i)];
                        below[0] = c[i] + s[wide + i];
                        below[1] = c[wide + i] - s[i];
                    }
                }
            }
        }
        return out;
    }

    // |int P(u - f, y) conj P(u + f, y)| over the area: the contrast at f over the cutoff along x.
    std::array<double, 2> contrast(double f) const {
        double re = 0.0, im = 0.0;
        const double turns = 2.0 * overlap_.slope() * std::min(1.0, 2.0 * f);
        for (const Row& row : rows(f, turns, 6.0)) {
            Line c;
            along(row.y, c);
            for (const Interval& part : row.parts) {
                const double length = part.high - part.low;
                const Rule& rule = rule_of(6.0, length * turns);
                for (std::size_t k = 0; k < rule.nodes; ++k) {
                    const double u = part.low + length * rule.x[k], d = phase(c, u - f) - phase(c, u + f);
                    re += row.weight * length * rule.w[k] * std::cos(d);
                    im += row.weight * length * rule.w[k] * std::sin(d);
                }
            }
        }
        return {re / (pi * area_), im / (pi * area_)};
    }

   private:
    static constexpr double pi = 3.14159265358979323846;
    static constexpr std::size_t wide = 8;
    struct Point {
        double x, y;
    };
    struct Vane {
        double c, s;
    };
    struct Interval {
        double low, high;
    };
    struct Row {
        double y, weight;
        std::vector<Interval> parts;
    };
    using Line = lommel::Overlap::Line;
    using Rule = lommel::Overlap::Rule;

    // For an integrand that turns through so many radians.
    static const Rule& rule_of(double least, double turns) {
        const double nodes = least + 0.28 * turns;
        if (nodes > 4000.0) {
            throw std::domain_error("these aberrations are too large for an aperture with vanes on the live page");
        }
        return lommel::Overlap::rule((static_cast<std::size_t>(nodes) + 3) / 4 * 4);
    }

    // Coefficients of the phase along a row.
    void along(double y, Line& c) const {
        for (std::size_t p = 0; p < c.size(); ++p) {
            c[p] = 0.0;
            for (std::size_t j = c.size() - p; j-- > 0;) {
                c[p] = c[p] * y + overlap_.powers()[p][j];
            }
        }
    }
    static double phase(const Line& c, double x) {
        double sum = 0.0;
        for (std::size_t p = c.size(); p-- > 0;) {
            sum = sum * x + c[p];
        }
        return sum;
    }

    // Adds a exp(i (first - k step)) to the sums k.
    static void add_waves(double a, double first, double step, std::size_t blocks, double* re, double* im) {
        double c[wide], s[wide];
        for (std::size_t k = 0; k < wide; ++k) {
            c[k] = std::cos(static_cast<double>(k) * step);
            s[k] = -std::sin(static_cast<double>(k) * step);
        }
        const double c1 = std::cos(static_cast<double>(wide) * step), s1 = -std::sin(static_cast<double>(wide) * step);
        double x = a * std::cos(first), y = a * std::sin(first);
        for (std::size_t b = 0; b < blocks; ++b, re += wide, im += wide) {
            for (std::size_t k = 0; k < wide; ++k) {
                re[k] += x * c[k] - y * s[k];
                im[k] += x * s[k] + y * c[k];
            }
            const double next = x * c1 - y * s1;
            y = y * c1 + x * s1;
            x = next;
        }
    }

    // What is clear of a row at this height, moved by `by`.
    std::vector<Interval> row(double y, double by) const {
        const double rim = std::sqrt(std::max(0.0, (1.0 - y) * (1.0 + y)));
        std::vector<Interval> clear{{-rim + by, rim + by}};
        const auto block = [&](double low, double high) {
            std::vector<Interval> left;
            for (const Interval& part : clear) {
                if (low + by > part.low) {
                    left.push_back({part.low, std::min(part.high, low + by)});
                }
                if (high + by < part.high) {
                    left.push_back({std::max(part.low, high + by), part.high});
                }
            }
            clear.swap(left);
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
    std::vector<Interval> shared(double y, double f) const {
        std::vector<Interval> both, left = row(y, -f);
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

    // The rows, with weights and intervals, of the aperture moved by f and by -f where both are clear.
    std::vector<Row> rows(double f, double turns, double least) const {
        std::vector<Row> found;
        const std::vector<double> edges = meetings(f);
        for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
            const double middle = 0.5 * (edges[k] + edges[k + 1]), half = 0.5 * (edges[k + 1] - edges[k]);
            // How far the ends of intervals move.
            const std::vector<Interval> first = shared(middle - 0.999999 * half, f), last = shared(middle + 0.999999 * half, f);
            double move = first.size() == last.size() ? 0.0 : 2.0;
            for (std::size_t i = 0; i < std::min(first.size(), last.size()); ++i) {
                move = std::max({move, std::abs(first[i].low - last[i].low), std::abs(first[i].high - last[i].high)});
            }
            const Rule& rule = rule_of(least + 2.0, 0.5 * pi * turns * (move + 2.0 * half));
            for (std::size_t i = 0; i < rule.nodes; ++i) {
                const double t = pi * (rule.x[i] - 0.5), y = middle + half * std::sin(t);
                found.push_back({y, pi * rule.w[i] * half * std::cos(t), shared(y, f)});
            }
        }
        return found;
    }

    // Heights, rising, at which edges of the aperture moved by f and by -f meet, begin or end, where no other part hides that.
    std::vector<double> meetings(double f) const {
        std::vector<std::array<double, 2>> circles;  // middle and radius
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
                const double apart = circles[j][0] - middle;
                if (apart != 0.0) {
                    const double x = 0.5 * (apart + (radius - circles[j][1]) * (radius + circles[j][1]) / apart);
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

    // On an edge, too.
    bool clear(double x, double y) const {
        constexpr double little = 1e-9;
        const double rho = std::hypot(x, y);
        return rho <= 1.0 + little && rho >= eps_ - little && std::none_of(vanes_.begin(), vanes_.end(), [&](const Vane& v) {
                   return v.c * x + v.s * y > little && std::abs(v.c * y - v.s * x) < half_width_ - little;
               });
    }

    double eps_, half_width_, area_ = 0.0;
    std::vector<Vane> vanes_;
    lommel::Overlap overlap_;
};

// Fractions of all light per pixel of a pupil with vanes in one line, added to `total`, and by their weights to three planes.
// Returns the clear area over that of the disk.
inline double add_cut_image(const Light& light, const Line& line, const View& view, std::vector<double>& total,
                            const double* weights, float* planes) {
    const CutPupil pupil(light, line.stretch, 0.0, true);
    const double step = view.step * line.stretch;
    const double scale = line.share * step * step / (12.566370614359172 * pupil.area());
    const std::size_t pixels = view.side * view.side;
    // Averages are made of a larger window of finer samples.
    const lommel::PixelTaps taps(step, 1e-7, 1.05);
    const lommel::PixelFilter filter{taps.weights.data(), taps.weights.size(), taps.stride};
    const std::size_t wide = filter.samples(view.side), middle = taps.stride * (view.side / 2) + taps.margin();
    const std::size_t side = view.integrate ? 2 * std::max(middle, wide - 1 - middle) + 1 : view.side;
    std::vector<double> image = pupil.field(side, view.integrate ? step / static_cast<double>(taps.stride) : step);
    for (std::size_t i = 0; i < side * side; ++i) {
        image[i] = image[2 * i] * image[2 * i] + image[2 * i + 1] * image[2 * i + 1];
    }
    if (view.integrate) {
        const std::size_t skip = side / 2 - middle;
        for (std::size_t row = 0; row < wide; ++row) {
            std::copy_n(&image[(row + skip) * side + skip], wide, &image[row * wide]);
        }
        std::vector<double> averages(pixels);
        filter.average(image.data(), 1, view.side, view.side, averages.data(), pixels, 1);
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

// As image_of(); no bound is proven.
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

// Factors of 8 values at 0, 1 ... 7 for the one between them at x.
inline void lagrange(double x, double* out) {
    constexpr double below[8] = {-5040.0, 720.0, -240.0, 144.0, -144.0, 240.0, -720.0, 5040.0};
    for (int a = 0; a < 8; ++a) {
        out[a] = 1.0 / below[a];
        for (int b = 0; b < 8; ++b) {
            out[a] *= a == b ? 1.0 : x - b;
        }
    }
}

// Means on circles about the axis at radii in v of the reference, over the peak without aberration: by interpolation in samples of
// the field at 8 points each way. Returns the clear area over that of the disk.
inline double cut_circles(const Light& light, bool lit, const double* v, std::size_t count, double* out) {
    std::fill_n(out, count, 0.0);
    double brightest = 0.0, area = 1.0;
    for (const Line& line : light.lines) {
        const CutPupil pupil(light, line.stretch, 0.0, lit);
        area = pupil.area();
        brightest += line.weight() * area * area;
        const double reach = v[count - 1] * line.stretch, step = std::max(0.5, reach / 500.0);
        const std::size_t half = static_cast<std::size_t>(reach / step) + 5, side = 2 * half + 1;
        const std::vector<double> field = pupil.field(side, step);
        for (std::size_t k = 0; k < count; ++k) {
            const double radius = v[k] * line.stretch;
            const std::size_t places = 4 * static_cast<std::size_t>(0.6 * radius + 6.0);
            double sum = 0.0;
            for (std::size_t j = 0; j < places; ++j) {
                const double theta = 6.283185307179586 * (static_cast<double>(j) + 0.25) / static_cast<double>(places);
                const double x = radius * std::cos(theta) / step + static_cast<double>(half);
                const double y = radius * std::sin(theta) / step + static_cast<double>(half);
                const std::size_t column = static_cast<std::size_t>(x) - 3, row = static_cast<std::size_t>(y) - 3;
                double across[8], down[8], re = 0.0, im = 0.0;
                lagrange(x - static_cast<double>(column), across);
                lagrange(y - static_cast<double>(row), down);
                for (std::size_t a = 0; a < 8; ++a) {
                    const double* const from = &field[2 * ((row + a) * side + column)];
                    for (std::size_t b = 0; b < 8; ++b) {
                        re += down[a] * across[b] * from[2 * b];
                        im += down[a] * across[b] * from[2 * b + 1];
                    }
                }
                sum += re * re + im * im;
            }
            out[k] += line.weight() * sum / static_cast<double>(places);
        }
    }
    std::for_each(out, out + count, [&](double& value) { value /= brightest; });
    return area;
}

// Contrast along x and y at frequencies over the cutoff of the reference, and without aberration.
inline void cut_contrast(const Light& light, const double* f, std::size_t count, double* x, double* y, double* limit) {
    double* const curves[3] = {x, y, limit};
    for (std::size_t curve = 0; curve < 3; ++curve) {
        std::vector<std::array<double, 2>> sums(count, {0.0, 0.0});
        for (const Line& line : light.lines) {
            const CutPupil pupil(light, line.stretch, curve == 1 ? 1.5707963267948966 : 0.0, curve < 2);
            for (std::size_t i = 0; i < count && f[i] < line.stretch; ++i) {
                const std::array<double, 2> part = pupil.contrast(f[i] / line.stretch);
                sums[i][0] += line.share * part[0];
                sums[i][1] += line.share * part[1];
            }
        }
        std::transform(sums.begin(), sums.end(), curves[curve], [](const auto& sum) { return std::hypot(sum[0], sum[1]); });
    }
}

}  // namespace live
