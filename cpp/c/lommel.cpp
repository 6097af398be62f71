// The C interface: arguments checked, engines chosen, and exceptions turned into codes and messages.
#include "lommel.h"

#include "coded.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include "lommel/averages/disks.hpp"
#include "lommel/base/pi.hpp"
#include "lommel/bounds/pixels.hpp"
#include "lommel/chordal/images.hpp"
#include "lommel/limits.hpp"
#include "lommel/radial/average_images.hpp"
#include "lommel/special/legendre.hpp"
#include "lommel/zernike/images.hpp"

using lommel::pi;

struct lommel_plan {
    lommel::PixelWindow window;
    double tol;
    double obscuration = 0.0;
    int normalize = LOMMEL_ENERGY;
    int threads = 1;

    double open() const { return 1.0 - obscuration * obscuration; }
    // Factor of the intensity |U|^2, U = (1/pi) int P, whose integral over the plane is 4 pi times the open part of the disk;
    // 0: divide by the largest value.
    double scale() const {
        if (normalize == LOMMEL_PEAK) {
            return 0.0;
        }
        return normalize == LOMMEL_STREHL ? 1.0 / (open() * open()) : window.step * window.step / (4.0 * pi * open());
    }
    std::size_t pixels() const { return window.height * window.width; }
};

using coding::coded;
using coding::require;

namespace {

template <class Change>
int changed(lommel_plan* plan, const Change& change) noexcept {
    return coded([&] {
        require(plan != nullptr, "plan is NULL");
        change(*plan);
    });
}

// What goes with each image, kept by the thread between calls.
struct Numbers {
    std::vector<double> scales, bounds, peaks;
    void resize(std::size_t pupils, double scale) {
        scales.assign(pupils, scale);
        bounds.resize(pupils);
        peaks.resize(pupils);
    }
};

// Pupils, their coefficients[pupil][term], and where their images go.
template <class T>
struct Asked {
    const lommel_plan& plan;
    std::size_t pupils, terms;
    const double* coefficients;
    T* images;
    double* bounds;

    Asked(const lommel_plan* given, std::int32_t count, std::int32_t each, const double* numbers, T* values, double* errors)
        : plan((require(given != nullptr, "plan is NULL"), *given)), pupils(static_cast<std::size_t>(count)),
          terms(static_cast<std::size_t>(each)), coefficients(numbers), images(values), bounds(errors) {
        require(count > 0, "pupils must be at least 1");
        require(each > 0, "terms must be at least 1");
        require(coefficients != nullptr, "coefficients is NULL");
        require(images != nullptr, "images is NULL");
        require(sizeof(T) == 8 || plan.tol > 1e-7, "images in single precision need a tolerance above 1e-7");
        require(std::all_of(coefficients, coefficients + pupils * terms, [](double c) { return std::isfinite(c); }),
                "coefficients must be finite");
    }

    void radial() const {
        require(terms <= lommel::LegendreRule::most_terms, "terms must be at most 30");
        thread_local Numbers numbers;
        numbers.resize(pupils, plan.scale());
        const lommel::Stack stack{coefficients, pupils, terms, plan.obscuration};
        const lommel::Answer<T> answer{images, numbers.scales.data(), numbers.bounds.data(), numbers.peaks.data()};
        lommel::render_radial<T>(stack, plan.window, plan.tol, plan.threads, answer);
        deliver(numbers.bounds.data());
    }

    void deliver(const double* found) const {
        if (bounds != nullptr) {
            std::copy_n(found, pupils, bounds);
        }
    }
};

// Pupils of Zernike terms: by the chordal rule where that is likely to take less time, otherwise by the series.
template <class T>
class Disks {
   public:
    Disks(const Asked<T>& asked, std::vector<lommel::ZernikeTerm> terms) : asked_(asked), terms_(std::move(terms)) {}

    void run() {
        const lommel_plan& plan = asked_.plan;
        numbers_.resize(asked_.pupils, plan.scale());
        const std::size_t each = std::max<std::size_t>(1, together / plan.pixels());
        if (!plan.window.integrate) {
            samples<T>(asked_.coefficients, asked_.pupils, nullptr, plan.tol, asked_.images, numbers_);
        }
        for (std::size_t pupil = 0; plan.window.integrate && pupil < asked_.pupils; pupil += each) {
            const std::size_t end = std::min(asked_.pupils, pupil + each);
            for (std::size_t one = at_nodes(pupil, end) ? end : pupil; one < end; ++one) {
                average(one);
            }
        }
        asked_.deliver(numbers_.bounds.data());
    }

   private:
    static constexpr std::size_t together = std::size_t{1} << 22;  // averages in double precision, which are stored later

    // Averages of some pupils from samples at nodes of the window, far ones from rims; whether there are such.
    bool at_nodes(std::size_t begin, std::size_t end) {
        const lommel_plan& plan = asked_.plan;
        const lommel::PixelWindow& w = plan.window;
        const std::size_t count = end - begin;
        const lommel::AverageRequest asked{w.height,     w.width, w.step, plan.tol, plan.scale(), lommel::storing<T>(false),
                                           plan.threads, {}};
        const lommel::DiskPupils pupils{terms_, asked_.coefficients + begin * asked_.terms,          count,  plan.obscuration,
                                        {},     {w.height, w.width, w.center_y, w.center_x, w.step}, nullptr};
        const lommel::Answer<T> images{asked_.images + begin * plan.pixels(), numbers_.scales.data() + begin,
                                       numbers_.bounds.data() + begin, numbers_.peaks.data() + begin};
        try {
            return lommel::averaged_images<T>(asked, count, images, nullptr, nullptr, [&](const lommel::AverageAnswer& answer) {
                return lommel::DiskAverages(pupils, asked, false).run(answer);
            });
        } catch (const lommel::LimitExceeded&) {
            return false;
        }
    }

    // Samples of pupils around the axis of the plan, or each around its own.
    template <class S>
    void samples(const double* edge, std::size_t pupils, const double* centers, double tol, S* images, Numbers& numbers) const {
        const lommel_plan& plan = asked_.plan;
        const lommel::Answer<S> answer{images, numbers.scales.data(), numbers.bounds.data(), numbers.peaks.data()};
        const lommel::DiskWindow window{plan.window.height, plan.window.width, plan.window.center_y, plan.window.center_x,
                                        plan.window.step};
        const auto stack_of = [&] {
            lommel::DiskStack stack(terms_, edge, pupils, plan.obscuration, {});
            if (centers != nullptr) {
                stack.tilt_to(centers, window);
            }
            return stack;
        };
        const std::vector<double> scales = numbers.scales;
        try {
            lommel::DiskStack stack = stack_of();
            stack.shrink();
            return lommel::ChordalRenderer<S>(stack, window, tol, plan.threads, answer).run_if_cheaper();
        } catch (const lommel::LimitExceeded&) {
        } catch (const lommel::ToleranceNotMet&) {
        }
        numbers.scales = scales;
        lommel::DiskStack stack = stack_of();
        stack.move_axes(window);
        stack.shrink();
        lommel::ZernikeRenderer<S>(stack, window, tol, plan.threads, answer).run();
    }

    // The average over a pixel by a product of two Gauss rules, which are off by gauss_error() over half the range of the
    // intensity: it is at most the square of the open part of the pupil, and nowhere below 0.
    void average(std::size_t pupil) {
        const lommel_plan& plan = asked_.plan;
        const lommel::PixelWindow& window = plan.window;
        const double most = plan.open() * plan.open(), scale = plan.scale();
        const bool divide = scale == 0.0;
        const double kept = plan.tol - 2.0 * lommel::storing<T>(divide);
        if (kept <= 0.0) {
            throw lommel::ToleranceNotMet(2.0 * lommel::storing<T>(divide));
        }
        // A pixel that all of the light falls on averages less than the peak by so much.
        const double spread = std::min(1.0, 4.0 * pi * plan.open() / (window.step * window.step * most));
        double allowed = 0.25 * kept * spread;
        double bound = 1e300, top = 0.0;
        for (int attempt = 0; attempt < 4; ++attempt) {
            const double wrong = averaged(pupil, allowed, most);
            top = *std::max_element(sums_.begin(), sums_.end());
            const double relative = top > wrong ? wrong / (top - wrong) : 1e300;
            bound = lommel::finished_error<T>(relative, divide, false);
            if (bound <= plan.tol) {
                break;
            }
            // Of wavefronts whose light is spread over many pixels.
            allowed *= relative < 1e10 ? std::max(1e-6, 0.5 * kept / (divide ? 2.0 * relative : relative)) : 1e-3;
            if (allowed < 1e-15) {
                break;
            }
        }
        if (bound > plan.tol) {
            throw lommel::ToleranceNotMet(bound);
        }
        const double factor = divide ? 1.0 / top : scale;
        T* const image = asked_.images + pupil * plan.pixels();
        std::transform(sums_.begin(), sums_.end(), image, [&](double sum) { return static_cast<T>(factor * sum); });
        numbers_.bounds[pupil] = bound;
    }

    // Fills sums_ with averages of the intensity; returns the bound on their errors.
    double averaged(std::size_t pupil, double allowed, double most) {
        const lommel_plan& plan = asked_.plan;
        const lommel::PixelWindow& window = plan.window;
        std::size_t points = 1;
        while (0.5 * most * lommel::gauss_error(window.step, points) > allowed) {
            if (++points > 400) {
                throw lommel::LimitExceeded("averages over pixels of " + lommel::shortened(window.step / pi) +
                                            " lambda*N are beyond the limit");
            }
        }
        std::vector<double> x(points), w(points);
        lommel::gauss_legendre(points, x.data(), w.data());
        const std::size_t pixels = plan.pixels(), nodes = points * points;
        const std::size_t group = std::min(nodes, std::max<std::size_t>(1, (std::size_t{1} << 20) / pixels));
        std::vector<double> images(group * pixels), centers(2 * group), edge;
        Numbers numbers;
        sums_.assign(pixels, 0.0);
        double wrong = 0.5 * most * lommel::gauss_error(window.step, points);
        for (std::size_t first = 0; first < nodes; first += group) {
            const std::size_t here = std::min(group, nodes - first);
            edge.clear();
            for (std::size_t i = 0; i < here; ++i) {
                const std::size_t node = first + i;
                centers[2 * i] = window.center_y - 0.5 * x[node / points];
                centers[2 * i + 1] = window.center_x - 0.5 * x[node % points];
                const double* own = asked_.coefficients + pupil * asked_.terms;
                edge.insert(edge.end(), own, own + asked_.terms);
            }
            numbers.resize(here, 1.0);
            samples<double>(edge.data(), here, centers.data(), std::max(allowed, 1e-12), images.data(), numbers);
            for (std::size_t i = 0; i < here; ++i) {
                const double weight = 0.25 * w[(first + i) / points] * w[(first + i) % points];
                wrong += weight * numbers.bounds[i] * numbers.peaks[i];
                const double* image = images.data() + i * pixels;
                for (std::size_t k = 0; k < pixels; ++k) {
                    sums_[k] += weight * image[k];
                }
            }
        }
        // Of weights, products and the sum; and of the nodes, the slope of I being at most twice the square of the open part.
        const double moved = 4.0 * window.step * (2.0 + std::abs(window.center_y) + std::abs(window.center_x));
        const double rounding = lommel::unit_roundoff * (static_cast<double>(nodes) + moved + 16.0);
        return wrong + rounding * most;
    }

    const Asked<T>& asked_;
    std::vector<lommel::ZernikeTerm> terms_;
    Numbers numbers_;
    std::vector<double> sums_;
};

template <class T>
int radial(const lommel_plan* plan, std::int32_t pupils, std::int32_t terms, const double* coefficients, T* images,
           double* bounds) noexcept {
    return coded([&] { Asked<T>(plan, pupils, terms, coefficients, images, bounds).radial(); });
}

template <class T>
int zernike(const lommel_plan* plan, std::int32_t pupils, std::int32_t terms, const std::int32_t* n, const std::int32_t* m,
            const double* coefficients, T* images, double* bounds) noexcept {
    return coded([&] {
        const Asked<T> asked(plan, pupils, terms, coefficients, images, bounds);
        require(n != nullptr && m != nullptr, "n or m is NULL");
        std::vector<lommel::ZernikeTerm> list;
        for (std::size_t j = 0; j < asked.terms; ++j) {
            const lommel::ZernikeTerm term{n[j], m[j]};
            require(n[j] >= 0 && n[j] <= 200 && m[j] >= -n[j] && m[j] <= n[j] && (n[j] - m[j]) % 2 == 0,
                    "n and m must be those of Zernike terms: n from 0 to 200, m from -n to n in steps of 2");
            require(std::find(list.begin(), list.end(), term) == list.end(), "a Zernike term comes twice");
            list.push_back(term);
        }
        const auto largest = std::max_element(list.begin(), list.end(), [](auto a, auto b) { return a.n < b.n; })->n;
        const bool symmetric = std::all_of(list.begin(), list.end(), [](auto term) { return term.m == 0; });
        if (!symmetric || largest > 2 * static_cast<std::int32_t>(lommel::LegendreRule::most_terms)) {
            return Disks<T>(asked, std::move(list)).run();
        }
        // A constant, n = 0, changes no intensity.
        const std::int32_t orders = std::max(1, largest / 2);
        std::vector<double> rows(static_cast<std::size_t>(pupils) * static_cast<std::size_t>(orders));
        for (std::size_t i = 0; i < asked.pupils * asked.terms; ++i) {
            const std::size_t order = static_cast<std::size_t>(list[i % asked.terms].n / 2);
            if (order > 0) {
                rows[i / asked.terms * static_cast<std::size_t>(orders) + order - 1] = coefficients[i];
            }
        }
        Asked<T>(plan, pupils, orders, rows.data(), images, bounds).radial();
    });
}

}  // namespace

extern "C" {

lommel_plan* lommel_plan_new(int32_t height, int32_t width, double pixel, double tol) noexcept {
    lommel_plan* plan = nullptr;
    coded([&] {
        require(height > 0 && width > 0 && height <= 40000 && width <= 40000, "height and width must be from 1 to 40000");
        require(pixel > 0.0 && pixel <= 1e6, "pixel must be above 0, and 1e6 at most");
        require(tol >= 1e-12 && tol <= 0.1, "tol must be from 1e-12 to 0.1");
        const auto rows = static_cast<std::size_t>(height), columns = static_cast<std::size_t>(width);
        plan = new lommel_plan{
            {rows, columns, static_cast<double>(rows / 2), static_cast<double>(columns / 2), pi * pixel, false}, tol};
    });
    return plan;
}

void lommel_plan_free(lommel_plan* plan) noexcept { delete plan; }

int lommel_plan_center(lommel_plan* plan, double row, double column) noexcept {
    return changed(plan, [&](lommel_plan& p) {
        require(std::abs(row) <= 1e6 && std::abs(column) <= 1e6, "row and column must be within 1e6 pixels");
        p.window.center_y = row;
        p.window.center_x = column;
    });
}
int lommel_plan_integrate(lommel_plan* plan, int integrate) noexcept {
    return changed(plan, [&](lommel_plan& p) {
        require(integrate == 0 || integrate == 1, "integrate must be 0 or 1");
        p.window.integrate = integrate == 1;
    });
}
int lommel_plan_obscuration(lommel_plan* plan, double obscuration) noexcept {
    return changed(plan, [&](lommel_plan& p) {
        require(obscuration >= 0.0 && obscuration < 1.0, "obscuration must be from 0 to below 1");
        p.obscuration = obscuration;
    });
}
int lommel_plan_normalize(lommel_plan* plan, int normalize) noexcept {
    return changed(plan, [&](lommel_plan& p) {
        require(normalize >= LOMMEL_ENERGY && normalize <= LOMMEL_PEAK,
                "normalize must be LOMMEL_ENERGY, LOMMEL_STREHL or LOMMEL_PEAK");
        p.normalize = normalize;
    });
}
int lommel_plan_threads(lommel_plan* plan, int threads) noexcept {
    return changed(plan, [&](lommel_plan& p) {
        require(threads >= 0, "threads must be at least 0");
        p.threads = threads;
    });
}

int lommel_psf_radial(const lommel_plan* plan, int32_t pupils, int32_t terms, const double* coefficients, double* images,
                      double* bounds) noexcept {
    return radial(plan, pupils, terms, coefficients, images, bounds);
}
int lommel_psf_radial_float(const lommel_plan* plan, int32_t pupils, int32_t terms, const double* coefficients, float* images,
                            double* bounds) noexcept {
    return radial(plan, pupils, terms, coefficients, images, bounds);
}
int lommel_psf_zernike(const lommel_plan* plan, int32_t pupils, int32_t terms, const int32_t* n, const int32_t* m,
                       const double* coefficients, double* images, double* bounds) noexcept {
    return zernike(plan, pupils, terms, n, m, coefficients, images, bounds);
}
int lommel_psf_zernike_float(const lommel_plan* plan, int32_t pupils, int32_t terms, const int32_t* n, const int32_t* m,
                             const double* coefficients, float* images, double* bounds) noexcept {
    return zernike(plan, pupils, terms, n, m, coefficients, images, bounds);
}
}
