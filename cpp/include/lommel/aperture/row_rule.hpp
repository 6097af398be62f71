// Quadrature along the rows of an aperture: nodes and weights with a proven error for polynomials (docs/certificate.md,
// section 18).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "lommel/aperture/row_bounds.hpp"
#include "lommel/aperture/shapes.hpp"
#include "lommel/base/aligned.hpp"
#include "lommel/base/cache.hpp"
#include "lommel/base/pi.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/base/watch.hpp"
#include "lommel/limits.hpp"
#include "lommel/special/legendre.hpp"

namespace lommel {

// Gauss-Legendre nodes and weights on [-1, 1].
struct GaussRule {
    std::vector<double> x, w;

    explicit GaussRule(std::size_t n) : x(n), w(n) { gauss_legendre(n, x.data(), w.data()); }

    bool is(std::size_t n) const { return x.size() == n; }
    std::size_t bytes() const { return sizeof(double) * 2 * x.size(); }
    static constexpr std::size_t most_bytes = std::size_t{2} << 20;
};

// Clear intervals of the row at the height y, each as its left and right side.
inline std::vector<std::array<Side, 2>> clear_spans(const Region& region, double y) {
    // End, at x, of the interval of the row that lies inside a part (shape) of the region: left or right side of this part.
    struct End {
        double x;
        std::size_t part;
        bool right;
        Side side;
    };
    std::vector<End> ends;
    for (std::size_t i = 0; i < region.parts().size(); ++i) {
        const Part& part = region.parts()[i];
        if (part.low() < y && y < part.high()) {
            const auto sides = part.sides(y);
            for (std::size_t k = 0; k < 2; ++k) {
                ends.push_back({sides[k].at(y), i, k == 1, sides[k]});
            }
        }
    }
    std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.x < b.x; });
    std::vector<std::array<Side, 2>> spans;
    std::vector<char> inside(region.parts().size(), 0);
    Side start;
    bool before = false;
    for (const End& end : ends) {
        inside[end.part] = end.right ? 0 : 1;
        const bool now = region.clear(inside);
        if (now && !before) {
            start = end.side;
        } else if (before && !now) {
            spans.push_back({start, end.side});
        }
        before = now;
    }
    return spans;
}

// Quadrature over a region in the unit disc: (1/pi) int P dx dy = sum over nodes of w P(x, y), with an error of at most `error` for
// polynomials P of the given degree with |P| <= 1 on the unit disc. The weights w are positive.
class RowRule {
   public:
    // Row of nodes at the height y: nodes `first` to first + count - 1.
    struct Row {
        double y;
        std::size_t first, count;
    };

    RowRule(const Region& region, std::size_t degree, double error) : spans_(degree, 0.5 * error) {
        // Merge heights that differ by rounding only. lost_ includes the change of the area: the strip between them, at most 2 wide.
        constexpr double same = 4e-15;
        std::vector<double> heights;
        for (const double y : region.heights()) {
            if (heights.empty() || y - heights.back() >= same) {
                heights.push_back(y);
            } else {
                lost_ += 2.0 / pi * (y - heights.back());
            }
        }
        for (std::size_t k = 0; k + 1 < heights.size(); ++k) {
            look();
            const double low = heights[k], high = heights[k + 1];
            Panel panel{low, high, 0, clear_spans(region, 0.5 * (low + high))};
            if (panel.spans.empty()) {
                continue;
            }
            bool roots[2] = {false, false};
            for (auto& span : panel.spans) {
                for (Side& side : span) {
                    // A limit of an arc that equals a limit of the panel up to rounding is set to exactly that limit.
                    const double below = side.low - low, above = side.high - high;
                    if (side.k != 0.0 && std::abs(below) < 2.0 * same) {
                        side.low = low;
                        roots[0] = true;
                        lost_ += 2.0 / pi * std::abs(below);
                    }
                    if (side.k != 0.0 && std::abs(above) < 2.0 * same) {
                        side.high = high;
                        roots[1] = true;
                        lost_ += 2.0 / pi * std::abs(above);
                    }
                }
            }
            const double share = 0.25 * error / static_cast<double>(heights.size());
            if (roots[0] && roots[1]) {
                const double middle = 0.5 * (low + high);
                split({low, middle, -1, panel.spans}, static_cast<double>(degree), share, 0);
                split({middle, high, 1, panel.spans}, static_cast<double>(degree), share, 0);
            } else {
                panel.root = roots[0] ? -1 : roots[1] ? 1 : 0;
                split(panel, static_cast<double>(degree), share, 0);
            }
        }
        gauss_.clear();
        finish();
    }
    // Construct from samples of a mask. y, counts: height and number of samples of each row; x, weights, phase: of each sample.
    RowRule(const double* y, const std::int64_t* counts, std::size_t rows, const double* x, const double* weights,
            const double* phase)
        : spans_(0, 1.0) {
        for (std::size_t i = 0; i < rows; ++i) {
            rows_.push_back({y[i], x_.size(), static_cast<std::size_t>(counts[i])});
            x_.insert(x_.end(), x + x_.size(), x + x_.size() + counts[i]);
        }
        weights_.assign(weights, weights + x_.size());
        phase_.assign(phase, phase == nullptr ? phase : phase + x_.size());
        finish();
    }

    const std::vector<Row>& rows() const { return rows_; }
    const Doubles& x() const { return x_; }
    const Doubles& weights() const { return weights_; }
    double weight() const { return weight_; }  // sum of the weights
    // Bound on the change of the quadrature sum as rounding displaces the aperture's edges, for integrands of modulus at most 1.
    double lost() const { return lost_; }
    const Doubles& phase() const { return phase_; }  // phases in radians of the samples of a mask, or empty
    double largest_phase() const { return largest_phase_; }
    std::size_t panels() const { return panels_; }
    std::size_t bytes() const { return sizeof(Row) * rows_.capacity() + 8 * (x_.capacity() + weights_.capacity()); }

   private:
    static constexpr std::size_t most_nodes = std::size_t{1} << 26;
    const GaussRule& gauss(std::size_t n) {
        auto& rule = gauss_[n];
        if (!rule) {
            rule = cache<GaussRule>.get(n);
        }
        return *rule;
    }
    static constexpr double few = 24.0;  // panels with fewer rows than this are not halved
    // Number of rows that a panel (range of heights y) needs. Gauss nodes are mapped to it linearly if panel.root is 0; a quadratic
    // map that needs fewer rows may then replace the linear one.
    GaussNodes needed(Panel& panel, double degree, double error) {
        const auto nodes = [&](int root) {
            Panel one = panel;
            one.root = root;
            return GaussNodes(error, [&](double eta, double limit) { return one.largest(eta, degree, limit); });
        };
        GaussNodes best = nodes(panel.root);
        // If an arc begins just outside an end of the panel, the quadratic map at this end moves the arc's branch point farther away.
        if (panel.root == 0 && best.blocked) {
            for (const int root : {-1, 1}) {
                const GaussNodes other = nodes(root);
                if (other.count < best.count) {
                    panel.root = root;
                    best = other;
                }
            }
        }
        return best;
    }
    void split(Panel panel, double degree, double error, int depth) {
        const int root = panel.root;
        const GaussNodes whole = needed(panel, degree, error);
        if (whole.blocked && whole.count > few && depth < 64) {
            const double middle = 0.5 * (panel.low + panel.high);
            const Panel first{panel.low, middle, std::min(root, 0), panel.spans},
                second{middle, panel.high, std::max(root, 0), panel.spans};
            Panel tried[2] = {first, second};
            const double halves = needed(tried[0], degree, 0.5 * error).count + needed(tried[1], degree, 0.5 * error).count;
            if (whole.count >= GaussNodes::none || halves < 0.9 * whole.count) {
                split(first, degree, 0.5 * error, depth + 1);
                split(second, degree, 0.5 * error, depth + 1);
                return;
            }
        }
        if (whole.count > 1e6) {
            throw LimitExceeded("the edges of the aperture cannot be resolved");
        }
        fill(panel, static_cast<std::size_t>(whole.count));
    }
    void fill(const Panel& panel, std::size_t rows) {
        const PanelMap map(panel.low, panel.high, panel.root);
        const GaussRule& outer = gauss(rows);
        ++panels_;
        for (std::size_t i = 0; i < rows; ++i) {
            const double y = map.y(outer.x[i]), weight = map.slope(outer.x[i]) * outer.w[i] / pi;
            const double half = std::sqrt(std::max(0.0, (1.0 - y) * (1.0 + y)));
            const std::size_t first = x_.size();
            for (const auto& span : panel.spans) {
                const double low = span[0].at(y), high = span[1].at(y), middle = 0.5 * (low + high), reach = 0.5 * (high - low);
                lost_ += weight * (misplaced(span[0], y) + misplaced(span[1], y));
                if (!(reach > 0.0)) {
                    lost_ -= weight * 2.0 * reach;
                    continue;  // empty up to rounding, at an end of the panel
                }
                const GaussRule& inner = gauss(spans_(low, high, half));
                for (std::size_t k = 0; k < inner.x.size(); ++k) {
                    x_.push_back(middle + reach * inner.x[k]);
                    weights_.push_back(weight * reach * inner.w[k]);
                }
            }
            if (x_.size() > most_nodes) {
                throw LimitExceeded("the aperture takes more than " + std::to_string(most_nodes) + " nodes");
            }
            rows_.push_back({y, first, x_.size() - first});
        }
    }
    // Bound on the displacement of a side at the height y, from rounding of the side itself, of y, and of the ends of its arc.
    static double misplaced(const Side& side, double y) {
        const double below = std::max(0.0, y - side.low), above = std::max(0.0, side.high - y);
        const double root = side.k == 0.0 ? 0.0 : std::abs(side.k) * std::sqrt(below * above);
        // Rotated ellipses have four more roundings: sine, cosine and their products with the axes.
        const double turned = side.terms > 0.0 ? 5.0 : 1.0;
        const double off = unit_roundoff * (4.0 + turned * (std::abs(side.low) + std::abs(side.high)));
        // Change of a root if d is displaced by off: |sqrt(d + off) - sqrt(d)| <= off / sqrt(d), and <= sqrt(off).
        const auto moved = [&](double d, double other) {
            return std::abs(side.k) * std::sqrt(other) * std::min(std::sqrt(off), off / std::sqrt(d + 1e-300));
        };
        const double arcs = side.k == 0.0 ? 0.0 : moved(below, above + off) + moved(above, below + off);
        return arcs +
               unit_roundoff * (2.0 * std::abs(side.p) + 4.0 * std::abs(side.q * (y - side.origin)) + 4.0 * std::abs(side.q) +
                                20.0 * side.terms * std::abs(y - side.origin) + (turned > 1.0 ? 14.0 : 6.0) * root);
    }
    void finish() {
        for (const double p : phase_) {
            largest_phase_ = std::max(largest_phase_, std::abs(p));
        }
        for (const double w : weights_) {
            weight_ += w;
        }
        // Padding: vectors may start at the last node.
        for (Doubles* numbers : {&x_, &weights_, &phase_}) {
            numbers->resize(numbers->empty() ? 0 : numbers->size() + row_lanes, 0.0);
        }
    }

    std::vector<Row> rows_;
    Doubles x_, weights_, phase_;
    double weight_ = 0.0, lost_ = 0.0, largest_phase_ = 0.0;
    std::size_t panels_ = 0;
    std::map<std::size_t, std::shared_ptr<const GaussRule>> gauss_;
    SpanNodes spans_;
};

}  // namespace lommel
