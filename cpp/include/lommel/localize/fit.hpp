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
#include <vector>

#include "lommel/localize/table.hpp"
#include "lommel/special/log.hpp"

namespace lommel {

constexpr std::size_t most_channels = 4;
constexpr std::size_t most_unknown = 3 + 4 * most_channels;

enum class FitState : std::int32_t { converged, border, steps, undetermined };

// Detection channel. Position in this channel = matrix (2 x 2, by rows) x position in the first channel + offset.
struct Channel {
    MoleculeTable table;
    double matrix[4];
};

// Image of a molecule, rows padded. electrons: counts plus `read`; read: variance of read noise (electrons^2); valid: 1 or 0.
struct Counts {
    Floats electrons, read, valid;
    explicit Counts(std::size_t pixels) : electrons(pixels), read(pixels), valid(pixels) {}
};

// Fit result. value, errors: the unknowns and their standard errors, in the order row, column, z; then for each channel
// photons, background and, if the background is tilted, its slopes along rows and columns.
struct Fitted {
    std::array<double, most_unknown> value{}, errors{};
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

// Light of a channel in electrons: photons in total; background per pixel at the middle of the box; its slopes per row, column.
struct Light {
    double photons, background, down, across;
};

// Sums over the pixels of a channel. score: gradient of the log-likelihood; information: Fisher information (upper triangle,
// row by row); both with respect to row, column, z, photons, background and its two slopes.
struct Sums {
    static constexpr std::size_t unknown = 7, products = 28;
    double score[unknown], information[products], deviance;
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
inline void add_up(const float* images, const float* ramps, std::size_t pixels, const Counts& counts, const Light& light,
                   Sums& sums) {
    dispatch_widest([&](auto isa) LOMMEL_INLINE_LAMBDA {
        using I = decltype(isa);
        using V = typename I::floats;
        constexpr std::size_t lanes = 2 * I::lanes;
        constexpr std::size_t products = Unknown * (Unknown + 1) / 2;
        const V flux = splat<V>(static_cast<float>(light.photons)), level = splat<V>(static_cast<float>(light.background));
        const V down = splat<V>(static_cast<float>(light.down)), across = splat<V>(static_cast<float>(light.across));
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
        const double of[7] = {light.photons, light.photons, light.photons, 1.0, 1.0, 1.0, 1.0};
        std::size_t k = 0;
        for (std::size_t a = 0; a < Unknown; ++a) {
            sums.score[a] = of[a] * total(score[a]);
            for (std::size_t b = a; b < Unknown; ++b, ++k) {
                sums.information[k] = of[a] * of[b] * total(information[k]);
            }
        }
        sums.deviance = 2.0 * total(deviance);
    });
}

// Pearson's chi2 summed over channels, its expectation and variance. A pixel with the expected signal mu has the residual x =
// Poisson(mu) + N(0, read) - mu; x^2 has the mean v = mu + read and the variance mu + 2 v^2. The part mu^2 / v of this
// variance, due to correlation of x^2 with x, is subtracted, as the fit makes the sum of x zero.
struct Pearson {
    double chi2 = 0.0, expected = 0.0, variance = 0.0;
};

inline void compare(const float* images, const float* ramps, std::size_t pixels, const Counts& counts, const Light& light,
                    Pearson& found) {
    dispatch_widest([&](auto isa) LOMMEL_INLINE_LAMBDA {
        using I = decltype(isa);
        using V = typename I::floats;
        constexpr std::size_t lanes = 2 * I::lanes;
        const V flux = splat<V>(static_cast<float>(light.photons)), level = splat<V>(static_cast<float>(light.background));
        const V down = splat<V>(static_cast<float>(light.down)), across = splat<V>(static_cast<float>(light.across));
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
        found.chi2 += total(chi2);
        found.expected += total(count);
        found.variance += total(variance);
    });
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
    MoleculeFit(const std::vector<Channel>& channels, const Limits& limits, bool tilted)
        : channels_(channels), limits_(limits), own_(tilted ? 4 : 2), unknown_(3 + own_ * channels.size()) {
        for (const Channel& channel : channels) {
            const MoleculeTable& table = channel.table;
            images_.emplace_back(table);
            pictures_.emplace_back(molecule_images * table.pixels());
            Floats ramps(2 * table.pixels());
            for (std::size_t i = 0; i < table.pixels(); ++i) {
                ramps[i] = static_cast<float>(i / table.stride()) - 0.5F * static_cast<float>(table.height - 1);
                ramps[table.pixels() + i] = static_cast<float>(i % table.stride()) - 0.5F * static_cast<float>(table.width - 1);
            }
            ramps_.push_back(std::move(ramps));
        }
    }

    // Number of unknowns of each channel: photons, background and, if tilted, two slopes of the background.
    std::size_t own() const { return own_; }

    // Fit from the values `start` of the unknowns. `counts`: one image per channel; `offsets`: (row, column) per channel.
    Fitted from(const double* start, const Counts* counts, const double* offsets) {
        Fitted found;
        std::copy_n(start, unknown_, found.value.begin());
        confine(found.value.data());
        System now, tried;
        look_at(found.value.data(), counts, offsets, now);
        double damping = 0.01;
        found.state = FitState::steps;
        while (found.steps < localize::most_steps) {
            double step[most_unknown], next[most_unknown];
            if (!towards(now, damping, step)) {
                found.state = FitState::undetermined;
                break;
            }
            const bool shortened = move(found.value.data(), step, next);
            bool still = !shortened;
            double before = 0.0, after = 0.0;  // derivative of the log-likelihood along the step, at its start and end
            ++found.steps;
            look_at(next, counts, offsets, tried);
            for (std::size_t k = 0; k < unknown_; ++k) {
                const double by = next[k] - found.value[k];
                still = still && by * by * now.information[k][k] <= localize::settled * localize::settled;
                before += by * now.score[k];
                after += by * tried.score[k];
            }
            if (still || tried.deviance <= now.deviance + localize::noise * (1.0 + std::abs(now.deviance))) {
                std::copy_n(next, unknown_, found.value.begin());
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
        finish(counts, offsets, now, found);
        return found;
    }

    std::size_t unknown() const { return unknown_; }

   private:
    // Fisher information, score and deviance at given values of the unknowns.
    struct System {
        double information[most_unknown][most_unknown], score[most_unknown], deviance;
    };

    void write(std::size_t c, const double* at, const double* offsets) {
        const double* const m = channels_[c].matrix;
        const Place place{m[0] * at[0] + m[1] * at[1] + offsets[2 * c], m[2] * at[0] + m[3] * at[1] + offsets[2 * c + 1],
                          at[2]};
        // Clamp: the map of positions may lead slightly outside the table of channel c.
        images_[c].write(channels_[c].table.within(place), pictures_[c].data());
    }

    void look_at(const double* at, const Counts* counts, const double* offsets, System& system) {
        std::memset(&system, 0, sizeof system);
        for (std::size_t c = 0; c < channels_.size(); ++c) {
            write(c, at, offsets);
            localize::Sums sums;
            const std::size_t pixels = channels_[c].table.pixels(), first = 3 + own_ * c, count = 3 + own_;
            if (own_ == 2) {
                localize::add_up<5>(pictures_[c].data(), nullptr, pixels, counts[c], light(at, c), sums);
            } else {
                localize::add_up<7>(pictures_[c].data(), ramps_[c].data(), pixels, counts[c], light(at, c), sums);
            }
            system.deviance += sums.deviance;
            const std::size_t at_first[] = {0, 1, 2, first, first + 1, first + 2, first + 3};
            double own[7][7] = {};
            std::size_t k = 0;
            for (std::size_t a = 0; a < count; ++a) {
                for (std::size_t b = a; b < count; ++b, ++k) {
                    own[a][b] = own[b][a] = sums.information[k];
                }
            }
            // Chain rule: derivatives with respect to row and column of the first channel, by the transposed matrix.
            const double* const m = channels_[c].matrix;
            const auto turn = [m](double& row, double& column) {
                const double before = row;
                row = m[0] * before + m[2] * column;
                column = m[1] * before + m[3] * column;
            };
            turn(sums.score[0], sums.score[1]);
            for (double (&each)[7] : own) {
                turn(each[0], each[1]);
            }
            for (std::size_t b = 0; b < count; ++b) {
                turn(own[0][b], own[1][b]);
            }
            for (std::size_t a = 0; a < count; ++a) {
                system.score[at_first[a]] += sums.score[a];
                for (std::size_t b = 0; b < count; ++b) {
                    system.information[at_first[a]][at_first[b]] += own[a][b];
                }
            }
        }
    }

    localize::Light light(const double* at, std::size_t c) const {
        const double* const own = at + 3 + own_ * c;
        return {own[0], own[1], own_ == 2 ? 0.0 : own[2], own_ == 2 ? 0.0 : own[3]};
    }

    // Kind of unknown k >= 3: photons (0), background (1), slopes of the background (2, 3).
    std::size_t kind(std::size_t k) const { return (k - 3) % own_; }

    bool towards(const System& system, double damping, double* step) const {
        double a[most_unknown][most_unknown];
        std::memcpy(a, system.information, sizeof a);
        for (std::size_t k = 0; k < unknown_; ++k) {
            a[k][k] *= 1.0 + damping;
        }
        std::copy_n(system.score, unknown_, step);
        if (!localize::factor(unknown_, a)) {
            return false;
        }
        localize::solve(unknown_, a, step);
        return std::all_of(step, step + unknown_, [](double by) { return std::isfinite(by); });
    }

    void confine(double* at) const {
        for (std::size_t k = 0; k < 3; ++k) {
            at[k] = std::clamp(at[k], limits_.low[k], limits_.high[k]);
        }
        for (std::size_t k = 3; k < unknown_; ++k) {
            at[k] = kind(k) < 2 ? std::max(at[k], localize::least_background) : at[k];
        }
    }

    // Take a step from `at`: at most one pixel in row and column, and at most `stride` in z. Photons keep at least 30 % of their
    // value, and the background 20 %. Returns whether these limits (not those of confine()) shortened the step.
    bool move(const double* at, const double* step, double* to) const {
        bool shortened = false;
        for (std::size_t k = 0; k < unknown_; ++k) {
            const double most = k < 2 ? 1.0 : k == 2 ? limits_.stride : std::numeric_limits<double>::infinity();
            double by = std::clamp(step[k], -most, most);
            if (k >= 3 && kind(k) < 2) {
                const double least = (kind(k) == 0 ? 0.3 : 0.2) * at[k];
                by = std::max(by, least - at[k]);
            }
            shortened = shortened || by != step[k];
            to[k] = at[k] + by;
        }
        confine(to);
        return shortened;
    }

    void finish(const Counts* counts, const double* offsets, const System& system, Fitted& found) {
        localize::Pearson pearson;
        for (std::size_t c = 0; c < channels_.size(); ++c) {
            write(c, found.value.data(), offsets);
            localize::compare(pictures_[c].data(), ramps_[c].data(), channels_[c].table.pixels(), counts[c],
                              light(found.value.data(), c), pearson);
        }
        const double free = pearson.expected - static_cast<double>(unknown_);
        found.discrepancy = (pearson.chi2 - free) / std::sqrt(std::max(pearson.variance, 1.0));
        double a[most_unknown][most_unknown];
        std::memcpy(a, system.information, sizeof a);
        bool dark = false;
        for (std::size_t k = 3; k < unknown_; k += own_) {
            dark = dark || found.value[k] <= localize::least_background;
        }
        if (dark || !localize::factor(unknown_, a)) {
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

    std::vector<Channel> channels_;
    Limits limits_;
    std::size_t own_, unknown_;
    std::vector<MoleculeImages> images_;
    std::vector<Floats> pictures_, ramps_;
};

}  // namespace lommel
