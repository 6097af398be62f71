// Nodes of a window: few samples, shared by all of its pixels, that give the average over each (certificate, section 10).
//
// Pixels of pitch a, with their centres at X_j, fill a window of half width L along an axis. Pixel j has weights c_jk at nodes
// x_k in the window, for which the error of the frequency response is small up to the cutoff |w| = 2:
//     r_j(w) = sum_k c_jk exp(i w x_k) - sinc(a w / 2) exp(i w X_j).
// The number of nodes is about the Shannon number of the window, 4 L / pi; a filter that is the same for all pixels needs more
// than twice as many samples. Nodes are zeros of a prolate spheroidal function of bandwidth 2 L (H. Xiao, V. Rokhlin and N.
// Yarvin 2001, doi:10.1088/0266-5611/17/4/315), L for a single pixel; no bound depends on this choice.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <numeric>
#include <vector>

#include "lommel/bounds/transfer_rule.hpp"
#include "lommel/base/cache.hpp"
#include "lommel/base/pi.hpp"
#include "lommel/base/product.hpp"
#include "lommel/limits.hpp"
#include "lommel/special/least_squares.hpp"

namespace lommel {

// Zeros from 0 to 1, ascending, of a prolate spheroidal function: a sum of Legendre polynomials of the parity of its degree, whose
// coefficients are an eigenvector of a symmetric tridiagonal matrix (Xiao, Rokhlin and Yarvin 2001, section 3).
std::vector<double> prolate_zeros(std::size_t degree, double bandwidth);

// Nodes along one axis of a window, and the weights of each pixel at these nodes.
class WindowNodes {
   public:
    std::vector<double> places;  // nodes, from the window's middle, in lambda / (2 pi NA), ascending
    std::vector<double> weights;  // [pixel][node]
    double error;  // bound on the mean error of a pixel's frequency response (certificate, section 10)
    double gain;  // largest sum over nodes of the moduli of a pixel's weights
    double spread;  // largest ratio, over nodes, of the largest modulus of a pixel's weight to the sum of all pixels' weights

    // step: pixel pitch, in lambda / (2 pi NA); pixels: number of pixels along the axis; count: number of nodes.
    WindowNodes(double step, std::size_t pixels, std::size_t count) : step_(step), pixels_(pixels) {
        const double half = 0.5 * step * static_cast<double>(pixels);
        // Zeros of half that bandwidth are nodes of a quadrature: enough for one average, but not for many from the same samples.
        std::vector<double> x = prolate_zeros(count, pixels == 1 ? half : 2.0 * half);
        std::transform(x.begin(), x.end(), x.begin(), [&](double zero) { return half * zero; });
        const std::size_t nodes = x.size();
        const std::vector<double> band = band_points(half);
        const TransferRule rule(band.size());
        // The even part of a pixel's weights, about the window's middle, gives the real part of the frequency response; the odd part,
        // the imaginary part. Each part follows by least squares from the nodes on one side of the middle.
        const auto at_rule = [&](std::size_t i) { return std::sqrt(rule.weights[i]); };
        const Waves of_rule = waves(rule.at, at_rule, x), of_band = waves(band, [](std::size_t) { return 1.0; }, x);
        std::vector<double> parts[2], squares(pixels, 0.0), most(pixels, 0.0);
        for (const std::size_t odd : {0, 1}) {
            std::vector<double>& c = parts[odd];
            c.resize(nodes * pixels);
            least_squares(rule.at.size(), nodes, pixels, of_rule.nodes[odd].data(), of_rule.pixels[odd].data(), c.data());
            std::vector<double> largest(pixels, 0.0);
            for (const Waves* each : {&of_rule, &of_band}) {
                const std::vector<double>& wanted = each->pixels[odd];
                std::vector<double> made(wanted.size());
                product(each->nodes[odd].data(), wanted.size() / pixels, nodes, c.data(), pixels, 1, made.data());
                for (std::size_t i = 0; i < made.size(); ++i) {
                    const double off = std::abs(made[i] - wanted[i]);
                    double &sum = squares[i % pixels], &top = largest[i % pixels];
                    each == & of_rule ? sum += off* off : top = std::max(top, off);
                }
            }
            for (std::size_t j = 0; j < pixels; ++j) {
                most[j] = std::hypot(most[j], largest[j]);
            }
        }
        const std::size_t middle = count % 2;  // number of nodes in the middle
        for (std::size_t k = nodes; k-- > middle;) {
            places.push_back(-x[k]);
        }
        const std::size_t before = places.size();
        places.insert(places.end(), x.begin(), x.end());
        gain = 0.0;
        std::vector<double> together(places.size(), 0.0), modulus(places.size(), 0.0);
        for (std::size_t j = 0; j < pixels; ++j) {
            double sum = 0.0;
            for (std::size_t i = 0; i < places.size(); ++i) {
                const std::size_t k = i < before ? nodes - 1 - i : i - before;
                const double even = parts[0][k * pixels + j], odd = parts[1][k * pixels + j];
                const double weight = i < before ? even - odd : even + odd;
                weights.push_back(weight);
                sum += std::abs(weight);
                together[i] += weight;
                modulus[i] = std::max(modulus[i], std::abs(weight));
            }
            gain = std::max(gain, sum);
        }
        const double rounding = 2.0 * unit_roundoff * static_cast<double>(count + 3) * gain;
        const double largest = std::sqrt(2.0) * (*std::max_element(most.begin(), most.end()) + 2.0 * rounding) + 1e-17;
        const double mean = std::sqrt(*std::max_element(squares.begin(), squares.end())) + 4.0 * rounding + 1e-17;
        // Responses along both axes multiply. With their errors e and e', mean |e e'| <= mean * largest, of which each axis takes half.
        error = (1.0 + 0.5 * largest) * mean;
        spread = 0.0;
        for (std::size_t i = 0; i < places.size(); ++i) {
            spread = std::max(spread, together[i] > 0.0 ? modulus[i] / together[i] : std::numeric_limits<double>::infinity());
        }
    }

    static constexpr std::size_t most_bytes = std::size_t{1} << 24;
    bool is(double step, std::size_t pixels, std::size_t count) const {
        return step_ == step && pixels_ == pixels && places.size() == count;
    }
    std::size_t bytes() const { return (places.size() + weights.size()) * sizeof(double); }

   private:
    // Waves cos(w x) (index 0) and sin(w x) (index 1) of several frequencies w; those of frequency i are multiplied by factor(i).
    // nodes[index][frequency, node]: the wave at the node 0, or twice that at a node x > 0, for the nodes x and -x together: a pixel's
    // weights are split into a part even in x, which multiplies cosines, and an odd part, which multiplies sines.
    // pixels[index][frequency, pixel]: average of the wave over a pixel, which a weighted sum over nodes shall equal.
    struct Waves {
        std::vector<double> nodes[2], pixels[2];
    };
    template <class Factor>
    Waves waves(const std::vector<double>& w, const Factor& factor, const std::vector<double>& x) const;

    double step_;
    std::size_t pixels_;
};

// Nodes for averages over pixels of pitch `step`, with a mean error of their frequency response of at most `error`. `nodes` is null
// if the window is too large, if no number of nodes tried meets `error`, or if the weights would amplify errors too much: those of
// small pixels have both signs.
class ChosenNodes {
   public:
    std::shared_ptr<const WindowNodes> nodes;

    ChosenNodes(double step, std::size_t pixels, double error) : step_(step), pixels_(pixels), error_(error) {
        const double bandwidth = step * static_cast<double>(pixels);
        if (bandwidth > largest) {
            return;
        }
        // Number of prolate functions with an eigenvalue above about `error`: the Shannon number plus the width of the transition
        // beyond it (D. Slepian).
        const double count = bandwidth * 2.0 / pi + std::log(bandwidth + 3.0) * std::log(0.3 / error) / (pi * pi);
        const auto least = static_cast<std::size_t>(2.0 * std::max(2.0, std::floor(0.5 * count)));
        for (std::size_t more = 0; more < tried; ++more) {
            const auto made = cache<WindowNodes>.get(step, pixels, least + 2 * more);
            if (made->error <= error) {
                const bool better = nodes == nullptr || made->gain < worth * nodes->gain;
                nodes = nodes == nullptr || made->gain < nodes->gain ? made : nodes;
                if (nodes->gain <= enough || (!better && nodes->gain <= highest)) {
                    break;
                }
            }
        }
        if (nodes != nullptr && nodes->gain > highest) {
            nodes = nullptr;
        }
    }

    static constexpr std::size_t most_bytes = 64 * 64;
    bool is(double step, std::size_t pixels, double error) const {
        return step_ == step && pixels_ == pixels && error_ == error;
    }
    std::size_t bytes() const { return 64; }

   private:
    static constexpr double largest = 450.0;  // width of windows, in lambda / (2 pi NA), above which filters replace nodes
    static constexpr double enough = 2.0, highest = 5.0;  // gain at which no more nodes are tried; largest accepted gain
    static constexpr double worth = 0.85;  // more nodes are tried while two more multiply the gain by less than this
    static constexpr std::size_t tried = 8;  // maximum number of trials, each with 2 more nodes

    double step_;
    std::size_t pixels_;
    double error_;
};

inline std::shared_ptr<const WindowNodes> window_nodes(double step, std::size_t pixels, double error) {
    return cache<ChosenNodes>.get(step, pixels, error)->nodes;
}

namespace prolate {

// Pivots of Gaussian elimination of (symmetric tridiagonal matrix) - shift * identity; pivots of 0 are replaced by 1e-290.
inline std::vector<double> pivots(const std::vector<double>& diagonal, const std::vector<double>& beside, double shift) {
    const auto not_zero = [](double pivot) { return pivot == 0.0 ? 1e-290 : pivot; };
    std::vector<double> found{not_zero(diagonal[0] - shift)};
    for (std::size_t i = 1; i < diagonal.size(); ++i) {
        found.push_back(not_zero(diagonal[i] - shift - beside[i - 1] * beside[i - 1] / found.back()));
    }
    return found;
}

// Sum of Legendre polynomials of one parity (0: even, 1: odd), evaluated by Clenshaw's recurrence.
class ParitySeries {
   public:
    ParitySeries(const std::vector<double>& terms, std::size_t parity) {
        for (std::size_t k = 0; k + 1 < 2 * terms.size() + parity; ++k) {
            const double j = static_cast<double>(k);
            steps_.push_back({k % 2 == parity ? terms[k / 2] : 0.0, (2.0 * j + 1.0) / (j + 1.0), (j + 1.0) / (j + 2.0)});
        }
    }
    double operator()(double x) const {
        double next = 0.0, after = 0.0;
        for (auto step = steps_.rbegin(); step != steps_.rend(); ++step) {
            const double here = step->term + step->once * x * next - step->twice * after;
            after = next;
            next = here;
        }
        return next;
    }

   private:
    struct Step {
        // Clenshaw's recurrence: b_k = term + once * x * b_{k+1} - twice * b_{k+2}; term: coefficient of P_k in the sum.
        double term, once, twice;
    };
    std::vector<Step> steps_;
};

}  // namespace prolate

// Eigenvector of a symmetric tridiagonal matrix, for the eigenvalue that exceeds `index` others. beside: off-diagonal elements.
//
// Bisection finds the eigenvalue: the number of negative pivots of the shifted matrix is that of eigenvalues below the shift.
// The vector follows from the pivots of two eliminations, from the first row down and from the last row up, which meet in the row
// of the smallest residual (I. S. Dhillon and B. N. Parlett 2004, doi:10.1016/j.laa.2003.12.028, section 3).
inline std::vector<double> eigenvector(const std::vector<double>& diagonal, const std::vector<double>& beside,
                                       std::size_t index) {
    const std::size_t size = diagonal.size();
    const double reach = 2.0 * *std::max_element(beside.begin(), beside.end());
    double low = *std::min_element(diagonal.begin(), diagonal.end()) - reach,
           high = *std::max_element(diagonal.begin(), diagonal.end()) + reach;
    while (high - low > 4e-16 * std::max(std::abs(low), std::abs(high))) {
        const double middle = 0.5 * (low + high);
        if (!(low < middle && middle < high)) {
            break;
        }
        const auto found = prolate::pivots(diagonal, beside, middle);
        const auto below = std::count_if(found.begin(), found.end(), [](double pivot) { return pivot < 0.0; });
        (static_cast<std::size_t>(below) > index ? high : low) = middle;
    }
    const double shift = 0.5 * (low + high);
    const auto down = prolate::pivots(diagonal, beside, shift);
    auto up = prolate::pivots({diagonal.rbegin(), diagonal.rend()}, {beside.rbegin(), beside.rend()}, shift);
    std::reverse(up.begin(), up.end());
    std::size_t meet = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < size; ++i) {
        const double left = std::abs(down[i] + up[i] - (diagonal[i] - shift));
        if (left < least) {
            least = left;
            meet = i;
        }
    }
    std::vector<double> vector(size, 1.0);
    for (std::size_t i = meet + 1; i < size; ++i) {
        vector[i] = -beside[i - 1] / up[i] * vector[i - 1];
    }
    for (std::size_t i = meet; i-- > 0;) {
        vector[i] = -beside[i] / down[i] * vector[i + 1];
    }
    const double norm = std::sqrt(std::inner_product(vector.begin(), vector.end(), vector.begin(), 0.0));
    std::transform(vector.begin(), vector.end(), vector.begin(), [&](double v) { return v / norm; });
    return vector;
}

inline std::vector<double> prolate_zeros(std::size_t degree, double bandwidth) {
    const std::size_t size = (degree + 60) / 2 + static_cast<std::size_t>(std::ceil(0.35 * bandwidth));
    const std::size_t parity = degree % 2;
    const double square = bandwidth * bandwidth;
    std::vector<double> diagonal, beside;
    for (std::size_t i = 0; i < size; ++i) {
        const double k = static_cast<double>(2 * i + parity);
        diagonal.push_back(k * (k + 1.0) + (2.0 * k * (k + 1.0) - 1.0) / ((2.0 * k + 3.0) * (2.0 * k - 1.0)) * square);
        beside.push_back((k + 2.0) * (k + 1.0) / ((2.0 * k + 3.0) * std::sqrt((2.0 * k + 1.0) * (2.0 * k + 5.0))) * square);
    }
    beside.pop_back();
    std::vector<double> terms = eigenvector(diagonal, beside, degree / 2);
    for (std::size_t i = 0; i < size; ++i) {
        terms[i] *= std::sqrt(static_cast<double>(2 * i + parity) + 0.5);
    }
    const prolate::ParitySeries series(terms, parity);
    std::vector<double> zeros(parity, 0.0);
    const std::size_t points = 3 * degree;  // at least four from one zero of the series to the next
    double low = 0.0, below = series(0.0);
    for (std::size_t i = 1; i < points; ++i) {
        const double x = std::sin(1.5707963267948966 * static_cast<double>(i) / static_cast<double>(points - 1));
        const double value = series(x);
        if (below != 0.0 && std::signbit(value) != std::signbit(below)) {
            // False position: accurate enough, as no bound depends on the positions of the nodes.
            double left = low, right = x, at_left = below, at_right = value;
            const auto middle = [&] { return (left * at_right - right * at_left) / (at_right - at_left); };
            for (int step = 0; step < 3; ++step) {
                const double here = middle(), found = series(here);
                const bool same = std::signbit(found) == std::signbit(at_left);
                (same ? left : right) = here;
                (same ? at_left : at_right) = found;
            }
            zeros.push_back(middle());
        }
        low = x;
        below = value;
    }
    return zeros;
}

template <class Factor>
WindowNodes::Waves WindowNodes::waves(const std::vector<double>& w, const Factor& factor, const std::vector<double>& x) const {
    Waves made;
    for (std::size_t i = 0; i < w.size(); ++i) {
        const double angle = 0.5 * step_ * w[i], mean = angle == 0.0 ? 1.0 : std::sin(angle) / angle, by = factor(i);
        for (const double place : x) {
            made.nodes[0].push_back(by * (place > 0.0 ? 2.0 : 1.0) * std::cos(w[i] * place));
            made.nodes[1].push_back(by * 2.0 * std::sin(w[i] * place));
        }
        for (std::size_t j = 0; j < pixels_; ++j) {
            const double middle = step_ * (static_cast<double>(j) - 0.5 * static_cast<double>(pixels_ - 1));
            made.pixels[0].push_back(by * (mean * std::cos(w[i] * middle)));
            made.pixels[1].push_back(by * (mean * std::sin(w[i] * middle)));
        }
    }
    return made;
}

}  // namespace lommel
