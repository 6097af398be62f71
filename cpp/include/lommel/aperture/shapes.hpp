// Apertures made of ellipses and convex polygons, and their intersections with lines of constant y.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "lommel/base/pi.hpp"
#include "lommel/limits.hpp"

namespace lommel {

struct Point {
    double x, y;
};

// Side of a convex shape (Part), x as a function of y: p + q (y - origin) for a line, plus k sqrt((y - low) (high - y)) for an
// arc from y = low to y = high.
struct Side {
    double p = 0.0, q = 0.0, origin = 0.0, k = 0.0, low = 0.0, high = 0.0;
    double terms = 0.0;  // for an arc: sum of the moduli of the two terms of q, which may cancel

    double at(double y) const {
        const double line = p + q * (y - origin);
        return k == 0.0 ? line : line + k * std::sqrt(std::max(0.0, (y - low) * (high - y)));
    }
};

// Convex part: an ellipse, or a polygon with its corners in positive orientation (from +x towards +y).
class Part {
   public:
    static Part ellipse(Point centre, double a, double b, double angle) {
        Part part;
        const double c = std::cos(angle), s = std::sin(angle);
        part.centre_ = centre;
        part.ax_ = a * c;
        part.ay_ = a * s;
        part.bx_ = -b * s;
        part.by_ = b * c;
        part.a_ = a;
        part.b_ = b;
        part.cosine_ = c;
        part.sine_ = s;
        const double half = std::hypot(part.ay_, part.by_);
        part.low_ = centre.y - half;
        part.high_ = centre.y + half;
        return part;
    }
    static Part polygon(std::vector<Point> points) {
        Part part;
        double area = 0.0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Point a = points[i], b = points[(i + 1) % points.size()];
            area += a.x * b.y - a.y * b.x;
        }
        if (area < 0.0) {
            std::reverse(points.begin(), points.end());
        }
        part.points_ = std::move(points);
        part.low_ = part.high_ = part.points_[0].y;
        for (const Point& p : part.points_) {
            part.low_ = std::min(part.low_, p.y);
            part.high_ = std::max(part.high_, p.y);
        }
        return part;
    }

    bool round() const { return points_.empty(); }
    double low() const { return low_; }
    double high() const { return high_; }
    const std::vector<Point>& points() const { return points_; }

    // Approximate signed distance to the boundary, negative inside; accurate only near the boundary.
    double outside(Point at) const {
        if (round()) {
            return 0.5 * std::min(a_, b_) * (square(at) - 1.0);
        }
        double most = -1e300;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const Point a = points_[i], b = end(i);
            const double dx = b.x - a.x, dy = b.y - a.y;
            most = std::max(most, (dy * (at.x - a.x) - dx * (at.y - a.y)) / std::hypot(dx, dy));
        }
        return most;
    }
    // Left and right side of the part at the height y, low() <= y <= high().
    std::array<Side, 2> sides(double y) const {
        std::array<Side, 2> both;
        if (round()) {
            // Ellipse: y = centre.y + ay cos t + by sin t; midpoints of horizontal chords lie on the line from lowest to highest point.
            const double square = ay_ * ay_ + by_ * by_, lean = (ax_ * ay_ + bx_ * by_) / square, rise = a_ * b_ / square;
            const double terms = (std::abs(ax_ * ay_) + std::abs(bx_ * by_)) / square;
            for (std::size_t i = 0; i < 2; ++i) {
                both[i] = {centre_.x, lean, centre_.y, i == 0 ? -rise : rise, low_, high_, terms};
            }
            return both;
        }
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const Point a = points_[i], b = end(i);
            if (a.y != b.y && std::min(a.y, b.y) <= y && y <= std::max(a.y, b.y)) {
                both[b.y > a.y ? 1 : 0] = {a.x, (b.x - a.x) / (b.y - a.y), a.y};
            }
        }
        return both;
    }
    // Point of an ellipse's boundary at the parameter t (radians).
    Point on(double t) const {
        const double c = std::cos(t), s = std::sin(t);
        return {centre_.x + ax_ * c + bx_ * s, centre_.y + ay_ * c + by_ * s};
    }
    // Points where the sides change: highest and lowest point of an ellipse, or corners of a polygon.
    std::vector<Point> turning() const {
        if (!round()) {
            return points_;
        }
        const double t = std::atan2(by_, ay_);
        return {{on(t).x, high_}, {on(t + pi).x, low_}};
    }
    // Intersections of the boundaries of two parts.
    static std::vector<Point> crossings(const Part& a, const Part& b) {
        std::vector<Point> found;
        if (a.low_ > b.high_ || b.low_ > a.high_) {
            return found;
        }
        if (a.round() && b.round()) {
            // The smaller ellipse is parametrized: along it, the quadratic form of the larger ellipse is most accurate.
            const bool small = std::max(a.a_, a.b_) <= std::max(b.a_, b.b_);
            cross_round(small ? a : b, small ? b : a, found);
        } else if (a.round() || b.round()) {
            const Part &disc = a.round() ? a : b, &other = a.round() ? b : a;
            for (std::size_t i = 0; i < other.points_.size(); ++i) {
                cross_line(disc, other.points_[i], other.end(i), found);
            }
        } else {
            for (std::size_t i = 0; i < a.points_.size(); ++i) {
                const Point p = a.points_[i], q = a.end(i);
                for (std::size_t j = 0; j < b.points_.size(); ++j) {
                    const Point r = b.points_[j], s = b.end(j);
                    const double dx = q.x - p.x, dy = q.y - p.y, ex = s.x - r.x, ey = s.y - r.y, turn = dx * ey - dy * ex;
                    if (std::abs(turn) > 1e-14 * std::hypot(dx, dy) * std::hypot(ex, ey)) {
                        const double t = ((r.x - p.x) * ey - (r.y - p.y) * ex) / turn;
                        const double u = ((r.x - p.x) * dy - (r.y - p.y) * dx) / turn;
                        if (t >= 0.0 && t <= 1.0 && u >= 0.0 && u <= 1.0) {
                            found.push_back({p.x + t * dx, p.y + t * dy});
                        }
                    }
                }
            }
        }
        return found;
    }

   private:
    // Quadratic form of the ellipse at the vector (x, y) from the centre: 1 on the boundary, smaller inside.
    double square(double x, double y) const {
        const double u = (cosine_ * x + sine_ * y) / a_, v = (cosine_ * y - sine_ * x) / b_;
        return u * u + v * v;
    }
    double square(Point at) const { return square(at.x - centre_.x, at.y - centre_.y); }
    Point end(std::size_t i) const { return points_[(i + 1) % points_.size()]; }
    static void cross_round(const Part& a, const Part& b, std::vector<Point>& found) {
        // On the boundary of a, (quadratic form of b) - 1 is a trigonometric polynomial c0 + 2 Re(c1 e^{it} + c2 e^{2it}).
        using Complex = std::complex<double>;
        Complex c[3] = {};
        for (std::size_t i = 0; i < 8; ++i) {
            const double t = 0.25 * pi * static_cast<double>(i), value = b.square(a.on(t)) - 1.0;
            for (std::size_t k = 0; k < 3; ++k) {
                c[k] += 0.125 * value * std::polar(1.0, -static_cast<double>(k) * t);
            }
        }
        const double size = std::abs(c[0]) + std::abs(c[1]) + std::abs(c[2]) + 1.0;
        std::vector<double> angles;
        if (std::abs(c[2]) < 1e-14 * size) {
            // Zeros of c0 + 2 |c1| cos(t + arg c1). Circles that touch up to rounding count as touching: otherwise heights() would miss
            // the point of contact, and clear_spans() might be called for the height of this point, where the two circles meet.
            if (std::abs(c[1]) > 1e-14 * size && std::abs(c[0].real()) <= 2.0 * std::abs(c[1]) + 1e-14 * size) {
                const double cosine = -0.5 * c[0].real() / std::abs(c[1]), middle = -std::arg(c[1]);
                const double turn = std::acos(std::min(1.0, std::max(-1.0, cosine)));
                angles = {middle + turn, middle - turn};
            }
        } else {
            // z^2 times the trigonometric polynomial, z = e^{it}, has degree 4 in z; the Durand-Kerner iteration finds all its roots.
            const Complex p[5] = {std::conj(c[2]), std::conj(c[1]), c[0], c[1], c[2]};
            Complex z[4] = {{1.0, 0.1}, {-0.3, 1.1}, {-1.0, -0.2}, {0.2, -0.9}};
            for (int step = 0; step < 200; ++step) {
                double moved = 0.0;
                for (std::size_t i = 0; i < 4; ++i) {
                    Complex value = p[4], apart = p[4];
                    for (std::size_t k = 4; k-- > 0;) {
                        value = value * z[i] + p[k];
                    }
                    for (std::size_t j = 0; j < 4; ++j) {
                        apart *= j == i ? Complex(1.0) : z[i] - z[j];
                    }
                    const Complex move = value / apart;
                    z[i] -= move;
                    moved = std::max(moved, std::abs(move));
                }
                if (moved < 1e-15) {
                    break;
                }
            }
            for (const Complex& root : z) {
                // Nearly multiple roots may be computed off the unit circle, hence the wide margin; an additional point does no harm.
                if (std::abs(std::abs(root) - 1.0) < 1e-2) {
                    double t = std::arg(root);
                    for (int step = 0; step < 4; ++step) {
                        const Complex one = c[1] * std::polar(1.0, t), two = c[2] * std::polar(1.0, 2.0 * t);
                        const double slope = -2.0 * one.imag() - 4.0 * two.imag();
                        const double value = c[0].real() + 2.0 * one.real() + 2.0 * two.real();
                        t -= std::abs(slope) > 1e-9 * size ? value / slope : 0.0;
                    }
                    angles.push_back(t);
                }
            }
        }
        for (const double t : angles) {
            found.push_back(a.on(t));
        }
    }
    static void cross_line(const Part& a, Point p, Point q, std::vector<Point>& found) {
        const double dx = q.x - p.x, dy = q.y - p.y, x = p.x - a.centre_.x, y = p.y - a.centre_.y;
        const double u = (a.cosine_ * x + a.sine_ * y) / a.a_, du = (a.cosine_ * dx + a.sine_ * dy) / a.a_;
        const double v = (a.cosine_ * y - a.sine_ * x) / a.b_, dv = (a.cosine_ * dy - a.sine_ * dx) / a.b_;
        // Minimum of the ellipse's quadratic form along the line through p and q, without cancellation.
        const double two = du * du + dv * dv, one = u * du + v * dv, across = (x * dy - y * dx) / (a.a_ * a.b_);
        const double least = across * across / two;
        if (least > 1.0) {
            return;
        }
        const double half = std::sqrt((1.0 - least) / two);
        for (const double sign : {-1.0, 1.0}) {
            const double t = -one / two + sign * half;
            if (t >= 0.0 && t <= 1.0) {
                found.push_back({p.x + t * dx, p.y + t * dy});
            }
        }
    }

    std::vector<Point> points_;  // corners of a polygon; empty for an ellipse
    Point centre_{0.0, 0.0};
    double a_ = 0.0, b_ = 0.0, cosine_ = 1.0, sine_ = 0.0, ax_ = 0.0, ay_ = 0.0, bx_ = 0.0, by_ = 0.0;
    double low_ = 0.0, high_ = 0.0;
};

// Set combination of parts. steps: postfix expression of part indices and operators both (intersection), either (union), without.
class Region {
   public:
    enum Step : std::int32_t { both = -1, either = -2, without = -3 };

    Region(std::vector<Part> parts, std::vector<std::int32_t> steps) : parts_(std::move(parts)), steps_(std::move(steps)) {
        std::size_t depth = 0;
        for (const std::int32_t step : steps_) {
            const bool part = step >= 0;
            if (part ? static_cast<std::size_t>(step) >= parts_.size() : step < without || depth < 2) {
                throw std::invalid_argument("steps must be numbers of parts, and combine what there is");
            }
            depth += part ? 1 : static_cast<std::size_t>(-1);
        }
        if (depth != 1) {
            throw std::invalid_argument("steps must leave one region");
        }
        inside_.resize(parts_.size());
    }

    const std::vector<Part>& parts() const { return parts_; }
    // Return whether points that lie in exactly the parts with inside[part] != 0 are clear (part of the aperture).
    bool clear(const std::vector<char>& inside) const {
        inside_ = inside;
        return clear();
    }
    // Heights y, increasing, where the number of clear intervals or one of their sides changes; some heights may coincide.
    std::vector<double> heights() const {
        std::vector<double> found;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            for (const Point& at : parts_[i].turning()) {
                if (matters(at, i, i)) {
                    found.push_back(at.y);
                }
            }
            for (std::size_t j = 0; j < i; ++j) {
                for (const Point& at : Part::crossings(parts_[i], parts_[j])) {
                    if (matters(at, i, j)) {
                        found.push_back(at.y);
                    }
                }
            }
        }
        std::sort(found.begin(), found.end());
        return found;
    }

   private:
    bool clear() const {
        stack_.clear();
        for (const std::int32_t step : steps_) {
            if (step >= 0) {
                stack_.push_back(inside_[static_cast<std::size_t>(step)]);
                continue;
            }
            const bool second = stack_.back() != 0;
            stack_.pop_back();
            const bool first = stack_.back() != 0;
            stack_.back() = step == both ? first && second : step == either ? first || second : first && !second;
        }
        return stack_.back() != 0;
    }
    // Return whether the clear region near a point on the boundaries of parts i and j depends on both parts (i = j: on this part).
    bool matters(Point at, std::size_t i, std::size_t j) const {
        constexpr double near = 1e-9;
        for (std::size_t k = 0; k < parts_.size(); ++k) {
            const double away = parts_[k].outside(at);
            if (k != i && k != j && std::abs(away) < near) {
                return true;
            }
            inside_[k] = away < 0.0;
        }
        bool found[2][2];
        for (const int a : {0, 1}) {
            for (const int b : {0, 1}) {
                inside_[j] = static_cast<char>(b);
                inside_[i] = static_cast<char>(a);
                found[a][b] = clear();
            }
        }
        const bool on_first = found[0][0] != found[1][0] || found[0][1] != found[1][1];
        const bool on_second = found[0][0] != found[0][1] || found[1][0] != found[1][1];
        return i == j ? found[0][0] != found[1][1] : on_first && on_second;
    }

    std::vector<Part> parts_;
    std::vector<std::int32_t> steps_;
    mutable std::vector<char> inside_, stack_;
};

}  // namespace lommel
