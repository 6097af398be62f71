// Bank of template images of a molecule, which give the starting values of fits; and fits of many molecules.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/base/tasks.hpp"
#include "lommel/localize/fit.hpp"

namespace lommel {

// Bank of templates: (image of a molecule - its mean) / (norm of this difference).
class Bank {
   public:
    // Positions of the templates are sorted by z, `each_layer` of them for each z.
    Bank(const MoleculeTable& table, const std::vector<Place>& positions, std::size_t each_layer)
        : places(positions), layer(each_layer), pixels_(table.pixels()), values_(padded() * table.pixels()) {
        MoleculeImages images(table);
        Floats four(molecule_images * table.pixels());
        for (std::size_t k = 0; k < places.size(); ++k) {
            images.write(places[k], four.data());
            double mean = 0.0, square = 0.0;
            const auto each = [&](const auto& pixel) {
                for (std::size_t y = 0; y < table.height; ++y) {
                    for (std::size_t x = 0; x < table.width; ++x) {
                        pixel(y * table.stride() + x);
                    }
                }
            };
            const double count = static_cast<double>(table.height * table.width);
            each([&](std::size_t i) { mean += static_cast<double>(four[i]) / count; });
            each([&](std::size_t i) { square += std::pow(static_cast<double>(four[i]) - mean, 2); });
            const double norm = std::sqrt(std::max(square, 1e-300));
            float* const to = &values_[k * table.pixels()];
            each([&](std::size_t i) { to[i] = static_cast<float>((static_cast<double>(four[i]) - mean) / norm); });
            means.push_back(mean);
            norms.push_back(norm);
        }
    }

    static constexpr std::size_t together = 4;

    // Write to[image][template]: inner products of `together` images (rows padded to whole vectors) with all templates.
    void products(const float* images, float* to) const {
        const std::size_t length = pixels_, count = padded();
        dispatch_widest([&](auto isa) LOMMEL_INLINE_LAMBDA {
            using V = typename decltype(isa)::floats;
            constexpr std::size_t lanes = 2 * decltype(isa)::lanes;
            for (std::size_t t = 0; t < count; t += 2) {
                const float* const one = &values_[t * length];
                V sum[together][2] = {};
                for (std::size_t i = 0; i < length; i += lanes) {
                    const V a = load<V>(one + i), b = load<V>(one + length + i);
                    for (std::size_t k = 0; k < together; ++k) {
                        const V image = load<V>(images + k * length + i);
                        sum[k][0] = sum[k][0] + a * image;
                        sum[k][1] = sum[k][1] + b * image;
                    }
                }
                for (std::size_t k = 0; k < together; ++k) {
                    to[k * count + t] = static_cast<float>(localize::total(sum[k][0]));
                    to[k * count + t + 1] = static_cast<float>(localize::total(sum[k][1]));
                }
            }
        });
    }

    std::size_t padded() const { return (places.size() + 1) / 2 * 2; }

    std::vector<Place> places;
    std::size_t layer;
    std::vector<double> means, norms;  // mean of each image; norm of (image - its mean)

   private:
    std::size_t pixels_;
    Floats values_;  // [template][pixel]
};

// Images of many molecules in electrons, [molecule][height][width], contiguous; NaN marks invalid pixels. `read`: variance of
// the read noise in electrons^2, in the same layout, or one image for all molecules if read_step is 0.
struct BoxStack {
    const float* electrons;
    const float* read;
    std::size_t read_step;
};

// Fits of molecules, each started from the positions of the most similar templates.
class Localizer {
   public:
    Localizer(const MoleculeTable& table, const Limits& limits, const std::vector<Place>& places, std::size_t layer)
        : table_(table), limits_(limits), bank_(table, places, layer) {}

    // Fit `count` molecules. A fit starts from the most similar template. If its result is in_doubt(), fits from further templates
    // are tried, up to `starts` in all. tilted: fit a linear background.
    void fit(const BoxStack& stack, std::size_t count, int starts, bool tilted, int threads, Fitted* fitted) const {
        constexpr double microseconds = 20.0;
        for_blocks(count, threads, microseconds, [&](std::size_t first, std::size_t last) {
            MoleculeFit fit(table_, limits_, tilted);
            const std::size_t pixels = table_.pixels();
            std::vector<Counts> counts(Bank::together, Counts(pixels));
            Floats centred(Bank::together * pixels), products(Bank::together * bank_.padded());
            double mean[Bank::together];
            for (std::size_t i = first; i < last; i += Bank::together) {
                const std::size_t now = std::min(Bank::together, last - i);
                for (std::size_t k = 0; k < now; ++k) {
                    mean[k] = take(stack, i + k, counts[k], &centred[k * pixels]);
                }
                bank_.products(centred.data(), products.data());
                for (std::size_t k = 0; k < now; ++k) {
                    fitted[i + k] = best(fit, counts[k], &products[k * bank_.padded()], mean[k], starts);
                }
            }
        });
    }

   private:
    // Copy an image in padded rows: to `counts` with the read variance added, to `centred` without its mean. Returns the mean.
    double take(const BoxStack& stack, std::size_t index, Counts& counts, float* centred) const {
        const std::size_t size = table_.height * table_.width;
        const float* const electrons = stack.electrons + index * size;
        const float* const read = stack.read + index * stack.read_step;
        double sum = 0.0, valid = 0.0;
        for (std::size_t i = 0; i < size; ++i) {
            if (std::isfinite(electrons[i])) {
                sum += static_cast<double>(electrons[i]);
                valid += 1.0;
            }
        }
        const float mean = static_cast<float>(sum / std::max(valid, 1.0));
        for (std::size_t y = 0; y < table_.height; ++y) {
            for (std::size_t x = 0; x < table_.width; ++x) {
                const std::size_t from = y * table_.width + x, to = y * table_.stride() + x;
                const bool counted = std::isfinite(electrons[from]);
                counts.valid[to] = counted ? 1.0F : 0.0F;
                counts.read[to] = read[from];
                counts.electrons[to] = counted ? electrons[from] + read[from] : 0.0F;
                centred[to] = counted ? electrons[from] - mean : 0.0F;
            }
        }
        return static_cast<double>(mean);
    }

    // products: inner products of the image with all templates; mean: mean of the image.
    Fitted best(MoleculeFit& fit, const Counts& counts, const float* products, double mean, int starts) const {
        // Find the most similar template for each z.
        const std::size_t layers = bank_.places.size() / bank_.layer;
        std::vector<std::size_t> found(layers);
        std::vector<double> alike(layers);
        for (std::size_t z = 0; z < layers; ++z) {
            found[z] = z * bank_.layer;
            alike[z] = static_cast<double>(products[found[z]]);
            for (std::size_t t = found[z] + 1; t < (z + 1) * bank_.layer; ++t) {
                if (const double here = static_cast<double>(products[t]); here > alike[z]) {
                    alike[z] = here;
                    found[z] = t;
                }
            }
        }
        Fitted best;
        for (int attempt = 0; attempt < starts && (attempt == 0 || in_doubt(best)); ++attempt) {
            const auto z = static_cast<std::size_t>(std::max_element(alike.begin(), alike.end()) - alike.begin());
            if (alike[z] == tried) {
                break;
            }
            const Place& place = bank_.places[found[z]];
            const double photons = std::max(static_cast<double>(products[found[z]]) / bank_.norms[found[z]], 1.0);
            // The least-squares number of photons, and the mean that is left over.
            const double background = std::max(mean - photons * bank_.means[found[z]], 0.1);
            const Unknowns start{place.row, place.column, place.z, photons, background};
            // Exclude this z and its neighbours, from which the fit would converge to the same position.
            for (std::size_t near = z > 0 ? z - 1 : z; near < std::min(z + 2, layers); ++near) {
                alike[near] = tried;
            }
            const Fitted other = fit.from(start, counts);
            const std::int32_t steps = best.steps + other.steps;
            if (attempt == 0 || better(other, best)) {
                best = other;
            }
            best.steps = steps;
        }
        return best;
    }

    static constexpr double tried = -1e300;
    static bool in_doubt(const Fitted& fitted) { return fitted.state != FitState::converged || fitted.discrepancy > 2.5; }
    // Prefer converged fits: a fit that ended otherwise must have a deviance lower by more than 9; an undetermined fit never wins.
    static bool better(const Fitted& a, const Fitted& b) {
        const auto cost = [](const Fitted& each) {
            return each.deviance + (each.state == FitState::converged      ? 0.0
                                    : each.state == FitState::undetermined ? 1e30
                                                                           : 9.0);
        };
        return cost(a) < cost(b);
    }

    MoleculeTable table_;
    Limits limits_;
    Bank bank_;
};

}  // namespace lommel
