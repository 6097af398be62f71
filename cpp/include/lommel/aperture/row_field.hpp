// Field of an aperture of shapes from nodes along its rows, by non-uniform FFTs along rows, then across them (docs/certificate.md,
// section 18).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <vector>

#include "lommel/aperture/row_rule.hpp"
#include "lommel/base/parallel.hpp"
#include "lommel/bounds/amplitude.hpp"
#include "lommel/limits.hpp"
#include "lommel/special/radial_polynomials.hpp"
#include "lommel/special/sincos.hpp"
#include "lommel/special/wave_sums.hpp"
#include "lommel/zernike/disk_stack.hpp"

namespace lommel {

// Sum of Zernike terms at points (x, y), by Jacobi's recurrence over the degrees of each azimuthal order.
class ZernikeSum {
   public:
    ZernikeSum(const std::vector<ZernikeTerm>& terms, const double* edge) {
        std::int32_t highest = 0;
        for (const ZernikeTerm& term : terms) {
            highest = std::max(highest, std::abs(term.m));
        }
        orders_.resize(static_cast<std::size_t>(highest) + 1);
        for (std::size_t j = 0; j < terms.size(); ++j) {
            if (edge[j] == 0.0) {
                continue;
            }
            Order& order = orders_[static_cast<std::size_t>(std::abs(terms[j].m))];
            const std::size_t k = static_cast<std::size_t>((terms[j].n - std::abs(terms[j].m)) / 2);
            order.terms.resize(std::max(order.terms.size(), k + 1));
            (terms[j].m < 0 ? order.terms[k].sine : order.terms[k].cosine) += edge[j];
            const double n = terms[j].n;
            size_ += std::abs(edge[j]);
            rounding_ += std::abs(edge[j]) * 4.0 * (n * n + 1.0);
            ++count_;
        }
        for (std::size_t m = 0; m < orders_.size(); ++m) {
            for (std::size_t k = 0; k < orders_[m].terms.size(); ++k) {
                const RadialStep<double> step(k, static_cast<double>(m));
                Term& term = orders_[m].terms[k];
                term.slope = step.slope;
                term.shift = step.shift;
                term.back = step.back;
            }
        }
        while (orders_.size() > 1 && orders_.back().terms.empty()) {
            orders_.pop_back();
        }
    }

    double size() const { return size_; }  // bound on the modulus of the sum
    // Rounding error of the sum in units of roundoff. x has three roundings, y two; if the point moves by d, a term of degree n and
    // amplitude 1 changes by at most n^2 d (Markov's inequality on discs). The recurrence and x^2 + y^2 add 0.34 n^2, as measured.
    double rounding() const { return rounding_ + static_cast<double>(count_ + 2 * orders_.size()) * size_; }

    template <class V>
    LOMMEL_INLINE V at(V x, V y) const {
        const V t = x * x + y * y, z = t + t - splat<V>(1.0);
        V re = splat<V>(1.0), im = splat<V>(0.0), total = splat<V>(0.0);
        for (std::size_t m = 0; m < orders_.size(); ++m) {
            if (m > 0) {
                const V next = re * x - im * y;
                im = re * y + im * x;
                re = next;
            }
            V before = splat<V>(0.0), here = splat<V>(1.0), cosine = before, sine = before;
            for (const Term& term : orders_[m].terms) {
                cosine = cosine + splat<V>(term.cosine) * here;
                sine = sine + splat<V>(term.sine) * here;
                const V next = (splat<V>(term.slope) * z + splat<V>(term.shift)) * here - splat<V>(term.back) * before;
                before = here;
                here = next;
            }
            total = total + cosine * re + sine * im;
        }
        return total;
    }

   private:
    // Coefficients of a term's cosine and sine; slope, shift, back: coefficients of the recurrence of its radial polynomial.
    struct Term {
        double cosine = 0.0, sine = 0.0, slope = 0.0, shift = 0.0, back = 0.0;
    };
    struct Order {
        std::vector<Term> terms;
    };
    std::vector<Order> orders_;
    double size_ = 0.0, rounding_ = 0.0;
    std::size_t count_ = 0;
};

// Quadrature rule of a region, and the phase added on this region: {constant, slope along x, slope along y} in radians.
struct PhasedRule {
    const RowRule* rule;
    double phase[3];
};

// Field of one or several regions, each with an added phase, at the pixels of a window.
class RowField {
   public:
    // precision: error of the wave sums to aim at, relative to the sum of the quadrature weights.
    RowField(const std::vector<PhasedRule>& regions, const DiskWindow& window, double precision) : window_(window) {
        const std::size_t longest = std::max(window.height, window.width);
        std::size_t taps = 4;
        do {
            taps += 2;
            across_ = std::make_unique<WaveKernel>(window.width, taps);
        } while (taps < WaveKernel::most_taps && WaveKernel(longest, taps).error(0.0) > precision);
        down_ = std::make_unique<WaveKernel>(window.height, taps);
        // Pixel k of n in a row is at v = step (k - n / 2 + half_x_) from the axis; likewise in a column, with half_y_.
        half_y_ = static_cast<double>(window.height / 2) - window.row;
        half_x_ = static_cast<double>(window.width / 2) - window.column;
        for (const PhasedRule& region : regions) {
            Turn turn{region.rule,
                      {region.phase[0], region.phase[1] - window.step * half_x_, region.phase[2] - window.step * half_y_}};
            turned_ = std::max(turned_, std::abs(turn.phase[0]) + std::abs(turn.phase[1]) + std::abs(turn.phase[2]));
            weight_ += region.rule->weight();
            lost_ += region.rule->lost();
            samples_ = std::max(samples_, region.rule->largest_phase());
            for (const RowRule::Row& row : region.rule->rows()) {
                rows_.push_back({&row, turns_.size()});
                longest_ = std::max(longest_, row.count);
            }
            turns_.push_back(turn);
        }
        std::vector<std::uint32_t> reached;
        for (const Row& row : rows_) {
            const double* const x = &turns_[row.turn].rule->x()[row.row->first];
            along_ = std::max(along_,
                              across_->most_waves(row.row->count, reached, [&](std::size_t k) { return window.step * x[k]; }));
        }
        across_rows_ = down_->most_waves(rows_.size(), reached, [&](std::size_t i) { return window.step * rows_[i].row->y; });
    }

    // Write the field of a pupil to out[pixel][re, im]; factor: Zernike term by which the pupil function is multiplied, or null.
    // Returns an error bound of the sums.
    double sum(const ZernikeSum& phase, const Amplitude& light, const ZernikeSum* factor, int threads, Doubles& out) const {
        const std::size_t count = rows_.size(), strips = (count + wide - 1) / wide, blocks = (window_.width + wide - 1) / wide;
        // Sums along each row for each column of pixels: sums[group of eight columns][row][re, im][column in the group].
        Doubles sums(2 * wide * count * blocks);
        const double step = window_.step;
        parallel_for(strips, threads, [&](std::size_t, std::size_t strip) {
            WaveSums waves(*across_);
            Doubles re(longest_ + row_lanes), im(longest_ + row_lanes);
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                const std::size_t first = strip * wide, here = std::min(wide, count - first);
                waves.start();
                for (std::size_t r = 0; r < here; ++r) {
                    const Turn& turn = turns_[rows_[first + r].turn];
                    const RowRule::Row& row = *rows_[first + r].row;
                    strengths(isa, turn, row, phase, light, factor, re.data(), im.data());
                    for (std::size_t k = 0; k < row.count; ++k) {
                        waves.add(isa, r, re[k], im[k], step * turn.rule->x()[row.first + k]);
                    }
                }
                waves.finish(isa, [&](std::size_t k, const double* sum, double gain) LOMMEL_INLINE_LAMBDA {
                    double* const to = &sums[2 * wide * (k / wide * count + first) + k % wide];
                    for (std::size_t r = 0; r < here; ++r) {
                        to[2 * wide * r] = gain * sum[r];
                        to[2 * wide * r + wide] = gain * sum[wide + r];
                    }
                });
            });
        });
        const std::size_t width = window_.width;
        parallel_for(blocks, threads, [&](std::size_t, std::size_t b) {
            WaveSums waves(*down_);
            dispatch([&](auto isa) LOMMEL_INLINE_LAMBDA {
                waves.start();
                for (std::size_t r = 0; r < count; ++r) {
                    waves.add(isa, &sums[2 * wide * (b * count + r)], step * rows_[r].row->y);
                }
                waves.finish(isa, [&](std::size_t k, const double* sum, double gain) LOMMEL_INLINE_LAMBDA {
                    double* const to = &out[2 * (k * width + b * wide)];
                    for (std::size_t i = 0; i < std::min(wide, width - b * wide); ++i) {
                        to[2 * i] = gain * sum[i];
                        to[2 * i + 1] = gain * sum[wide + i];
                    }
                });
            });
        });
        const double first = across_->error(static_cast<double>(along_)),
                     second = down_->error(static_cast<double>(across_rows_));
        // Error of the phases and weights in units of roundoff: Zernike terms, tilts, samples of a mask, exponent of the amplitude.
        // Nodes have two roundings each, which matter most at the corners of the window (reach).
        const double reach = step * std::hypot(static_cast<double>(window_.height) + std::abs(half_y_),
                                               static_cast<double>(window_.width) + std::abs(half_x_));
        const double turned = phase.rounding() + 4.0 * phase.size() + 8.0 * turned_ + 4.0 * samples_ + 4.0 * reach +
                              light.sensitivity() + 16.0 + (factor == nullptr ? 0.0 : factor->rounding());
        return lost_ + weight_ * (first + second + first * second + unit_roundoff * turned);
    }

   private:
    static constexpr std::size_t wide = fft_rows;

    // Rule of a region and its added phase {constant, slope along x, along y}; a tilt in it moves the window's middle to v = 0.
    struct Turn {
        const RowRule* rule;
        double phase[3];
    };
    struct Row {
        const RowRule::Row* row;
        std::size_t turn;
    };

    template <class I>
    LOMMEL_INLINE void strengths(I isa, const Turn& turn, const RowRule::Row& row, const ZernikeSum& phase,
                                 const Amplitude& light, const ZernikeSum* factor, double* re, double* im) const {
        using V = typename I::pack;
        const RowRule& rule = *turn.rule;
        const V y = splat<V>(row.y), still = splat<V>(turn.phase[0] + turn.phase[2] * row.y);
        for (std::size_t k = 0; k < row.count; k += I::lanes) {
            // Lanes beyond the end of the row contain nodes of the next row or zeros; their results are not used.
            const V x = load<V>(&rule.x()[row.first + k]);
            V w = load<V>(&rule.weights()[row.first + k]), sine, cosine;
            V angle = phase.at(x, y) + splat<V>(turn.phase[1]) * x + still;
            if (!rule.phase().empty()) {
                angle = angle + load<V>(&rule.phase()[row.first + k]);
            }
            sincos(isa, angle, sine, cosine);
            if (factor != nullptr) {
                w = w * factor->at(x, y);
            }
            store(re + k, w * cosine);
            store(im + k, w * sine);
        }
        if (!light.uniform()) {
            for (std::size_t k = 0; k < row.count; ++k) {
                const double x = rule.x()[row.first + k], a = light.at(x * x + row.y * row.y);
                re[k] *= a;
                im[k] *= a;
            }
        }
    }

    DiskWindow window_;
    std::unique_ptr<WaveKernel> across_, down_;
    std::vector<Turn> turns_;
    std::vector<Row> rows_;
    std::size_t longest_ = 0, along_ = 0, across_rows_ = 0;
    double half_y_ = 0.0, half_x_ = 0.0, turned_ = 0.0, samples_ = 0.0, weight_ = 0.0, lost_ = 0.0;
};

}  // namespace lommel
