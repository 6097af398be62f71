// Maximum-likelihood fit of the position of molecules in their images, by Fisher scoring from the best of a bank of templates.
//
// C. S. Smith et al., Nature Methods 7, 373 (2010), doi:10.1038/nmeth.1449: Fisher information and maximum likelihood; F. Huang et
// al., Nature Methods 10, 653 (2013), doi:10.1038/nmeth.2488: read noise as additional Poisson counts with the same variance.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "lommel/localize/table.hpp"
#include "lommel/special/log.hpp"

namespace lommel {

enum class FitState : std::int32_t { converged, border, steps, undetermined };

// Image of a molecule, rows padded. electrons: counts plus `read`; read: variance of read noise (electrons^2); valid: 1 or 0.
struct Counts {
    Floats electrons, read, valid;
    explicit Counts(std::size_t pixels) : electrons(pixels), read(pixels), valid(pixels) {}
};

// Unknowns of a fit: row, column, z, photons (electrons in total), background per pixel at the middle of the box, and its slopes along
// rows and columns, which are 0 unless the background is tilted.
constexpr std::size_t most_unknown = 7;
using Unknowns = std::array<double, most_unknown>;

// Fit result. value, errors: the unknowns and their standard errors.
struct Fitted {
    Unknowns value{}, errors{};
    double deviance =
        std::numeric_limits<double>::infinity();  // 2 (log-likelihood of the counts themselves - log-likelihood of the model)
    double discrepancy = 0.0;  // (Pearson's chi2 - its expectation) / its standard deviation
    FitState state = FitState::undetermined;
    std::int32_t steps = 0;
};

// low, high: valid range of row, column and z; stride: largest change of z in one step of a fit.
struct Limits {
    double low[3], high[3], stride;
};

namespace localize {

constexpr double least_background = 0.01;  // electrons per pixel; keeps the logarithm finite
constexpr double settled = 0.01;  // converged if no unknown moves by more than this share of its standard error
constexpr double noise = 1e-6;  // relative rounding of the deviance, a sum of floats
constexpr double singular = 1e-6;  // pivots below this share of the diagonal are rounding errors of float sums
constexpr int most_steps = 50;

// Sums over the pixels. information: Fisher information; score: gradient of the log-likelihood; both with respect to the unknowns.
struct Sums {
    double information[most_unknown][most_unknown], score[most_unknown], deviance;
};

template <class V>
LOMMEL_INLINE double total(V v) {
    float lanes[sizeof(V) / sizeof(float)];
    std::memcpy(lanes, &v, sizeof lanes);
    double sum = 0.0;
    for (const float lane : lanes) {
        sum += static_cast<double>(lane);
    }
    return sum;
}

// Score, Fisher information and deviance for expected counts of photons x image + background + read variance. With 7 unknowns
// the background has slopes. `images`: image and its derivatives; `ramps`: row and column of each pixel relative to the middle.
// Sums are in float: the deviance is accurate to about 1e-7 of the number of electrons.
template <std::size_t Unknown>
inline void add_up(const float* images, const float* ramps, std::size_t pixels, const Counts& counts, const Unknowns& at,
                   Sums& sums) {
    dispatch_widest([&](auto isa) LOMMEL_INLINE_LAMBDA {
        using I = decltype(isa);
        using V = typename I::floats;
        constexpr std::size_t lanes = 2 * I::lanes;
        constexpr std::size_t products = Unknown * (Unknown + 1) / 2;
        const V flux = splat<V>(static_cast<float>(at[3])), level = splat<V>(static_cast<float>(at[4]));
        const V down = splat<V>(static_cast<float>(at[5])), across = splat<V>(static_cast<float>(at[6]));
        const V least = splat<V>(static_cast<float>(least_background)), one = splat<V>(1.0F), zero = {};
        V score[Unknown] = {}, information[products] = {}, deviance = {};
        for (std::size_t i = 0; i < pixels; i += lanes) {
            const V psf = load<V>(images + i);
            const V d = load<V>(&counts.electrons[i]), valid = load<V>(&counts.valid[i]);
            V by[Unknown] = {load<V>(images + pixels + i), load<V>(images + 2 * pixels + i), load<V>(images + 3 * pixels + i),
                             psf, one};
            V base = flux * psf + level + load<V>(&counts.read[i]);
            if constexpr (Unknown > 5) {
                by[5] = load<V>(ramps + i);
                by[6] = load<V>(ramps + pixels + i);
                base = base + down * by[5] + across * by[6];
            }
            const V mean = larger(base, least);
            const V weight = valid / mean, excess = weight * (d - mean);
            // Counts d may be 0 or negative: max(|d|, 1) replaces d in the logarithm, which adds a constant to the deviance.
            const V reference = larger(larger(d, zero - d), one);
            deviance = deviance + valid * (mean - d + d * logarithm<V>(reference / mean));
            std::size_t k = 0;
            for (std::size_t a = 0; a < Unknown; ++a) {
                score[a] = score[a] + by[a] * excess;
                const V weighted = by[a] * weight;
                for (std::size_t b = a; b < Unknown; ++b, ++k) {
                    information[k] = information[k] + weighted * by[b];
                }
            }
        }
        const double of[7] = {at[3], at[3], at[3], 1.0, 1.0, 1.0, 1.0};
        std::size_t k = 0;
        for (std::size_t a = 0; a < Unknown; ++a) {
            sums.score[a] = of[a] * total(score[a]);
            for (std::size_t b = a; b < Unknown; ++b, ++k) {
                sums.information[a][b] = sums.information[b][a] = of[a] * of[b] * total(information[k]);
            }
        }
        sums.deviance = 2.0 * total(deviance);
    });
}

// Pearson's chi2, its expectation and variance. A pixel with the expected signal mu has the residual x =
// Poisson(mu) + N(0, read) - mu; x^2 has the mean v = mu + read and the variance mu + 2 v^2. The part mu^2 / v of this
// variance, due to correlation of x^2 with x, is subtracted, as the fit makes the sum of x zero.
struct Pearson {
    double chi2, expected, variance;
};

inline Pearson compare(const float* images, const float* ramps, std::size_t pixels, const Counts& counts, const Unknowns& at) {
    Pearson found{};
    dispatch_widest([&](auto isa) LOMMEL_INLINE_LAMBDA {
        using I = decltype(isa);
        using V = typename I::floats;
        constexpr std::size_t lanes = 2 * I::lanes;
        const V flux = splat<V>(static_cast<float>(at[3])), level = splat<V>(static_cast<float>(at[4]));
        const V down = splat<V>(static_cast<float>(at[5])), across = splat<V>(static_cast<float>(at[6]));
        const V least = splat<V>(static_cast<float>(least_background)), two = splat<V>(2.0F);
        V chi2 = {}, variance = {}, count = {};
        for (std::size_t i = 0; i < pixels; i += lanes) {
            const V valid = load<V>(&counts.valid[i]), read = load<V>(&counts.read[i]);
            const V sky = level + down * load<V>(ramps + i) + across * load<V>(ramps + pixels + i);
            const V signal = larger(flux * load<V>(images + i) + sky, least), mean = signal + read;
            const V off = load<V>(&counts.electrons[i]) - mean, weight = valid / mean;
            chi2 = chi2 + weight * off * off;
            variance = variance + weight * (signal / mean) * (read / mean) + valid * two;
            count = count + valid;
        }
        found = {total(chi2), total(count), total(variance)};
    });
    return found;
}

// Replace the lower triangle of a symmetric matrix by its Cholesky factor; returns whether the matrix is positive definite.
inline bool factor(std::size_t n, double (&a)[most_unknown][most_unknown]) {
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            double sum = a[i][j];
            for (std::size_t k = 0; k < j; ++k) {
                sum -= a[i][k] * a[j][k];
            }
            if (i > j) {
                a[i][j] = sum / a[j][j];
            } else if (sum > singular * a[i][i]) {
                a[i][i] = std::sqrt(sum);
            } else {
                return false;
            }
        }
    }
    return true;
}

inline void solve(std::size_t n, const double (&a)[most_unknown][most_unknown], double* x) {
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            x[i] -= a[i][k] * x[k];
        }
        x[i] /= a[i][i];
    }
    for (std::size_t i = n; i-- > 0;) {
        for (std::size_t k = i + 1; k < n; ++k) {
            x[i] -= a[k][i] * x[k];
        }
        x[i] /= a[i][i];
    }
}

}  // namespace localize

// Maximum-likelihood fit, for one molecule after another with reused memory.
class MoleculeFit {
   public:
    MoleculeFit(const MoleculeTable& table, const Limits& limits, bool tilted)
        : table_(table), limits_(limits), unknown_(tilted ? 7 : 5), images_(table), picture_(molecule_images * table.pixels()),
          ramps_(2 * table.pixels()) {
        for (std::size_t i = 0; i < table.pixels(); ++i) {
            ramps_[i] = static_cast<float>(i / table.stride()) - 0.5F * static_cast<float>(table.height - 1);
            ramps_[table.pixels() + i] = static_cast<float>(i % table.stride()) - 0.5F * static_cast<float>(table.width - 1);
        }
    }

    // Fit from the values `start` of the unknowns.
    Fitted from(const Unknowns& start, const Counts& counts) {
        Fitted found;
        found.value = start;
        confine(found.value);
        localize::Sums now, tried;
        look_at(found.value, counts, now);
        double damping = 0.01;
        found.state = FitState::steps;
        while (found.steps < localize::most_steps) {
            Unknowns step{}, next{};
            if (!towards(now, damping, step)) {
                found.state = FitState::undetermined;
                break;
            }
            const bool shortened = move(found.value, step, next);
            bool still = !shortened;
            double before = 0.0, after = 0.0;  // derivative of the log-likelihood along the step, at its start and end
            ++found.steps;
            look_at(next, counts, tried);
            for (std::size_t k = 0; k < unknown_; ++k) {
                const double by = next[k] - found.value[k];
                still = still && by * by * now.information[k][k] <= localize::settled * localize::settled;
                before += by * now.score[k];
                after += by * tried.score[k];
            }
            if (still || tried.deviance <= now.deviance + localize::noise * (1.0 + std::abs(now.deviance))) {
                found.value = next;
                std::swap(now, tried);
                if (still) {
                    found.state = FitState::converged;
                    break;
                }
                // Fisher information differs from the curvature of the log-likelihood. If the derivative along the step changes
                // sign and keeps more than half of its modulus, the step was far too long: damping increases.
                const double turned = after / before;
                damping = turned < -0.5    ? std::max(4.0 * damping, 0.2)
                          : turned < -0.2  ? damping
                          : damping > 1e-4 ? 0.1 * damping
                                           : 0.0;
            } else if (damping > 1e6) {
                break;
            } else {
                damping = std::max(8.0 * damping, 0.01);
            }
        }
        found.deviance = now.deviance;
        finish(counts, now, found);
        return found;
    }

   private:
    void write(const Unknowns& at) { images_.write(table_.within({at[0], at[1], at[2]}), picture_.data()); }

    void look_at(const Unknowns& at, const Counts& counts, localize::Sums& sums) {
        write(at);
        const auto& add_up = unknown_ == 5 ? localize::add_up<5> : localize::add_up<7>;
        add_up(picture_.data(), ramps_.data(), table_.pixels(), counts, at, sums);
    }

    bool towards(const localize::Sums& sums, double damping, Unknowns& step) const {
        double a[most_unknown][most_unknown];
        std::memcpy(a, sums.information, sizeof a);
        for (std::size_t k = 0; k < unknown_; ++k) {
            a[k][k] *= 1.0 + damping;
        }
        std::copy_n(sums.score, unknown_, step.begin());
        if (!localize::factor(unknown_, a)) {
            return false;
        }
        localize::solve(unknown_, a, step.data());
        return std::all_of(step.begin(), step.end(), [](double by) { return std::isfinite(by); });
    }

    void confine(Unknowns& at) const {
        for (std::size_t k = 0; k < 3; ++k) {
            at[k] = std::clamp(at[k], limits_.low[k], limits_.high[k]);
        }
        for (std::size_t k = 3; k < 5; ++k) {
            at[k] = std::max(at[k], localize::least_background);
        }
    }

    // Take a step from `at`: at most one pixel in row and column, and at most `stride` in z. Photons keep at least 30 % of their
    // value, and the background 20 %. Returns whether these limits (not those of confine()) shortened the step.
    bool move(const Unknowns& at, const Unknowns& step, Unknowns& to) const {
        bool shortened = false;
        for (std::size_t k = 0; k < unknown_; ++k) {
            const double most = k < 2 ? 1.0 : k == 2 ? limits_.stride : std::numeric_limits<double>::infinity();
            double by = std::clamp(step[k], -most, most);
            if (k == 3 || k == 4) {
                const double least = (k == 3 ? 0.3 : 0.2) * at[k];
                by = std::max(by, least - at[k]);
            }
            shortened = shortened || by != step[k];
            to[k] = at[k] + by;
        }
        confine(to);
        return shortened;
    }

    void finish(const Counts& counts, const localize::Sums& sums, Fitted& found) {
        write(found.value);
        const localize::Pearson pearson =
            localize::compare(picture_.data(), ramps_.data(), table_.pixels(), counts, found.value);
        const double free = pearson.expected - static_cast<double>(unknown_);
        found.discrepancy = (pearson.chi2 - free) / std::sqrt(std::max(pearson.variance, 1.0));
        double a[most_unknown][most_unknown];
        std::memcpy(a, sums.information, sizeof a);
        if (found.value[3] <= localize::least_background || !localize::factor(unknown_, a)) {
            found.state = FitState::undetermined;
            found.errors.fill(std::numeric_limits<double>::infinity());
            return;
        }
        for (std::size_t k = 0; k < unknown_; ++k) {
            double unit[most_unknown] = {};
            unit[k] = 1.0;
            localize::solve(unknown_, a, unit);
            found.errors[k] = std::sqrt(unit[k]);
        }
        for (std::size_t k = 0; k < 3; ++k) {
            if (found.value[k] <= limits_.low[k] || found.value[k] >= limits_.high[k]) {
                found.state = FitState::border;
            }
        }
    }

    MoleculeTable table_;
    Limits limits_;
    std::size_t unknown_;
    MoleculeImages images_;
    Floats picture_, ramps_;
};

}  // namespace lommel
