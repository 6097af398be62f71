// Light through plane layers without Python: windows of all kinds, their derivatives, and planes with a wavefront each, against
// sums by brute force; some callers at once. Returns 1 and says where if one is off.
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <vector>

#include "lommel/base/pi.hpp"
#include "lommel/special/bessel.hpp"
#include "lommel/stratified/images.hpp"
#include "lommel/stratified/rings_image.hpp"

#include "check.hpp"

namespace {

using complex = std::complex<double>;
using Values = std::vector<double>;

using lommel::pi;
constexpr double step = 0.37, allowed = 1e-9, proven = 1e-12;
constexpr std::size_t nodes = 45, planes = 11;
constexpr complex i(0.0, 1.0);

// Some light: angles whose waves fade beyond a place in the pupil, and planes of these.
struct Light {
    Values rho, depth, focus, power;
    std::vector<complex> parts, fixed, by_depth, by_focus;

    Light() {
        for (std::size_t q = 0; q < nodes; ++q) {
            const double x = (static_cast<double>(q) + 0.5) / nodes, c = std::sqrt(1.0 - 0.9 * x * x);
            rho.push_back(x);
            fixed.push_back(0.3 * x * x);
            by_depth.push_back(x < 0.8 ? complex(2.0 * c) : 0.5 * i * x);
            by_focus.push_back(-3.0 * c);
        }
        for (const double size : {2.0, 0.8, 0.3}) {
            for (const double x : rho) {
                parts.push_back(size * x / nodes * complex(1.0, 0.2 * x));
            }
        }
        for (std::size_t p = 0; p < planes; ++p) {
            depth.push_back(0.2 * static_cast<double>(p));
            focus.push_back(0.1 * static_cast<double>(p) - 0.4);
            power.push_back(0.4 + 0.05 * static_cast<double>(p));
        }
    }

    lommel::Planes asked(bool radial) const {
        lommel::Planes made{{rho.data(), nodes, 3, parts.data(), fixed.data(), by_depth.data(), by_focus.data(), proven},
                            depth.data(),
                            focus.data(),
                            power.data(),
                            planes,
                            {},
                            {}};
        lommel::Harmonic steady{{}, 0, 1.0, 0.0}, turned{{}, 2, 0.6, -0.8};
        steady.form[0][0] = steady.form[2][2] = 1.0;
        steady.form[1][1] = turned.form[1][1] = 2.0;
        turned.form[0][2] = turned.form[2][0] = 1.0;
        made.harmonics.push_back(steady);
        if (!radial) {
            made.harmonics.push_back(turned);
        }
        return made;
    }

    // The intensity of a plane, and its derivatives by depth and focus.
    double at(std::size_t p, bool radial, double x, double y, double* slopes = nullptr) const {
        complex K[3] = {}, by[2][3] = {};
        const double v = std::hypot(x, y);
        for (std::size_t q = 0; q < nodes; ++q) {
            double bessel[3];
            lommel::bessel_sequence(v * rho[q], 3, bessel);
            const complex wave = std::exp(i * (fixed[q] + depth[p] * by_depth[q] + focus[p] * by_focus[q]));
            for (std::size_t m = 0; m < 3; ++m) {
                const complex one = parts[m * nodes + q] * wave * bessel[m];
                K[m] += one;
                by[0][m] += i * by_depth[q] * one;
                by[1][m] += i * by_focus[q] * one;
            }
        }
        const double phi = std::atan2(y, x), turn = radial ? 0.0 : 0.6 * std::cos(2.0 * phi) - 0.8 * std::sin(2.0 * phi);
        const auto form = [&](const complex* F, const complex* G) {
            const auto product = [&](std::size_t j, std::size_t l) { return (F[j] * std::conj(G[l])).real(); };
            return product(0, 0) + product(2, 2) + 2.0 * (1.0 + turn) * product(1, 1) + turn * (product(0, 2) + product(2, 0));
        };
        for (std::size_t d = 0; slopes != nullptr && d < 2; ++d) {
            slopes[d] = 2.0 * form(by[d], K) / power[p];
        }
        return form(K, K) / power[p];
    }
};

struct Window {
    std::size_t height, width;
    Values centers;  // of all planes, or of each
    bool radial, integrate, slopes;
};

// The average over a pixel by Gauss's rule with eight nodes, or the value in its middle.
double pixel(const Light& light, std::size_t p, const Window& w, double x, double y) {
    static const double node[] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
    static const double weight[] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745, 0.1012285362903763};
    if (!w.integrate) {
        return light.at(p, w.radial, x, y);
    }
    double sum = 0.0;
    for (std::size_t j = 0; j < 8; ++j) {
        for (std::size_t k = 0; k < 8; ++k) {
            const double u = (j % 2 ? 0.5 : -0.5) * node[j / 2], t = (k % 2 ? 0.5 : -0.5) * node[k / 2];
            sum += 0.25 * weight[j / 2] * weight[k / 2] * light.at(p, w.radial, x + step * u, y + step * t);
        }
    }
    return sum;
}

template <class T>
void windows(const Light& light, const Window& w, int threads) {
    lommel::Planes asked = light.asked(w.radial);
    if (w.slopes) {
        asked.derivatives = {{lommel::By::depth, proven}, {lommel::By::focus, proven}, {lommel::By::radius, proven}};
    }
    const std::size_t pixels = w.height * w.width, outputs = 4;
    std::vector<T> images(planes * pixels);
    std::vector<T> slopes(outputs * planes * pixels);
    Values scales(planes, 1.0), bounds(planes), peaks(planes), errors(outputs * planes);
    const Values own_share(planes, 0.0);
    lommel::LayeredSlopes<T> derivatives{{}, slopes.data(), errors.data()};
    if (w.slopes) {
        using What = lommel::LayeredSlope::What;
        for (const What what : {What::depth, What::focus, What::axis}) {
            derivatives.requested.push_back({what, 1.0, own_share.data()});
        }
    }
    const lommel::PixelWindow first{w.height, w.width, w.centers[0], w.centers[1], step, w.integrate};
    const bool own = w.centers.size() > 2;
    const lommel::PixelWindows all = own ? lommel::PixelWindows(first, w.centers.data(), planes) : lommel::PixelWindows(first);
    check(lommel::LayeredImages<T>::fits(asked, all, w.slopes), "the engine has such windows", static_cast<double>(w.height));
    const lommel::Answer<T> answer{images.data(), scales.data(), bounds.data(), peaks.data(), nullptr, 0, nullptr, nullptr};
    lommel::LayeredImages<T>(asked, all, allowed, threads, answer, derivatives).run();
    for (std::size_t p = 0; p < planes; ++p) {
        const double row = w.centers[own ? 2 * p : 0], column = w.centers[own ? 2 * p + 1 : 1];
        check(bounds[p] < (sizeof(T) == 4 ? 1e-6 : 1e-7), "bounds of layers", bounds[p]);
        for (std::size_t k = 0; k < pixels; k += 1 + pixels / 40) {
            const double y = step * (static_cast<double>(k / w.width) - row),
                         x = step * (static_cast<double>(k % w.width) - column);
            const double off = std::abs(static_cast<double>(images[p * pixels + k]) - pixel(light, p, w, x, y));
            check(off <= bounds[p] * peaks[p] * 1.01 + 1e-13, "pixels of layers", off);
            if (!w.slopes) {
                continue;
            }
            double by[2], far = 1e-4;
            light.at(p, w.radial, x, y, by);
            const double down = (light.at(p, w.radial, x, y - far) - light.at(p, w.radial, x, y + far)) * 0.5 * step / far;
            const double across = (light.at(p, w.radial, x - far, y) - light.at(p, w.radial, x + far, y)) * 0.5 * step / far;
            const double known[] = {by[0], by[1], down, across};
            for (std::size_t d = 0; d < outputs; ++d) {
                const double made = static_cast<double>(slopes[(d * planes + p) * pixels + k]),
                             wrong = std::abs(made - known[d]);
                const double stored = sizeof(T) == 4 ? 6e-8 * std::abs(made) : 0.0;
                check(wrong <= errors[d * planes + p] + stored + (d < 2 ? 1e-13 : 1e-7), "derivatives of layers", wrong);
            }
        }
    }
}

// Lagrange's polynomials of eight equally spaced nodes as powers of 2 t - 1, [highest power first][tap]; t runs from 0 to 1
// between the two middle nodes.
Values taps() {
    constexpr std::size_t count = 8, most = lommel::RingTaps::most;
    Values made(count * most);
    for (std::size_t j = 0; j < count; ++j) {
        Values poly{1.0};
        const double here = 2.0 * static_cast<double>(j) - 7.0;
        for (std::size_t k = 0; k < count; ++k) {
            const double there = 2.0 * static_cast<double>(k) - 7.0;
            if (k == j) {
                continue;
            }
            poly.push_back(0.0);
            for (std::size_t n = poly.size() - 1; n > 0; --n) {
                poly[n] = (poly[n] - (n > 0 ? there * poly[n - 1] : 0.0)) / (here - there);
            }
            poly[0] /= here - there;
        }
        for (std::size_t n = 0; n < count; ++n) {
            made[n * most + j] = poly[n];
        }
    }
    return made;
}

// Planes with a wavefront each: orders of two fields, on circles 0.1 in v apart.
void rings(std::size_t wavefronts, std::size_t axes, int threads) {
    constexpr std::size_t orders = 3, all = 2 * orders - 1, fields = 2, circles = 130;
    constexpr double apart = 0.1;
    const Light light;
    const std::size_t angles = lommel::RowFft<double>::length(40), height = 9, width = 21;
    Values bessel(orders * circles * nodes), scales, centers, numbers(lommel::RingNumbers::count(fields) * planes);
    std::vector<complex> parts, waves;
    for (std::size_t c = 0; c < circles; ++c) {
        for (std::size_t q = 0; q < nodes; ++q) {
            double found[orders];
            lommel::bessel_sequence(apart * static_cast<double>(c) * light.rho[q], orders, found);
            for (std::size_t m = 0; m < orders; ++m) {
                bessel[(m * circles + c) * nodes + q] = found[m];
            }
        }
    }
    for (std::size_t w = 0; w < wavefronts; ++w) {
        for (std::size_t k = 0; k < all * fields * nodes; ++k) {
            const double a = static_cast<double>(k % 17 + w), b = static_cast<double>(k % 11);
            parts.push_back(complex(std::cos(a), std::sin(b)) / static_cast<double>(nodes));
        }
    }
    for (std::size_t p = 0; p < planes; ++p) {
        scales.push_back(1.0 + 0.1 * static_cast<double>(p));
        for (std::size_t q = 0; q < nodes; ++q) {
            waves.push_back(std::exp(i * (light.depth[p] * light.by_depth[q] + light.focus[p] * light.by_focus[q])));
        }
    }
    for (std::size_t a = 0; a < axes; ++a) {
        centers.push_back(4.0 + 0.13 * static_cast<double>(a));
        centers.push_back(10.0 - 0.21 * static_cast<double>(a));
    }
    const Values polynomials = taps(), gains(all, 1.0), aliases(all, 0.0), filter{1.0};
    const lommel::RingTaps some{polynomials.data(), 8, 8};
    const lommel::RingLight asked{bessel.data(),      orders, circles, nodes, parts.data(), wavefronts, fields, waves.data(),
                                  light.power.data(), planes};
    const lommel::RingSteps steps{angles, filter.data(), 1, some, some, gains.data(), aliases.data(), all};
    const lommel::RingWindow window{height, width, centers.data(), axes, 6.1};
    std::vector<float> images(planes * height * width);
    lommel::RingImages<float>(asked, steps, window, threads)
        .run(scales.data(), images.data(), {numbers.data(), planes, fields});
    for (std::size_t p = 0; p < planes; ++p) {
        const double* center = centers.data() + (axes > 1 ? 2 * p : 0);
        for (std::size_t k = 0; k < height * width; k += 5) {
            const double y = static_cast<double>(k / width) - center[0], x = static_cast<double>(k % width) - center[1];
            const double v = apart * 6.1 * std::hypot(x, y), phi = std::atan2(y, x);
            double exact = 0.0;
            for (std::size_t f = 0; f < fields; ++f) {
                complex field = 0.0;
                for (std::size_t q = 0; q < nodes; ++q) {
                    double found[orders];
                    lommel::bessel_sequence(v * light.rho[q], orders, found);
                    for (std::size_t m = 0; m < all; ++m) {
                        const double order = static_cast<double>(m) - static_cast<double>(orders - 1);
                        field += parts[(((wavefronts > 1 ? p : 0) * all + m) * fields + f) * nodes + q] * waves[p * nodes + q] *
                                 found[static_cast<std::size_t>(std::abs(order))] * std::polar(1.0, order * phi);
                    }
                }
                exact += std::norm(field) / light.power[p];
            }
            const double off = std::abs(static_cast<double>(images[p * height * width + k]) / scales[p] - exact);
            check(off <= 2e-6 * numbers[fields * planes + p], "pixels between circles", off);
        }
    }
}

}  // namespace

int main() {
    lommel::work_per_thread() = 1.0;
    const Light light;
    Values own;
    for (std::size_t p = 0; p < planes; ++p) {
        own.push_back(3.0 + 0.3 * static_cast<double>(p));
        own.push_back(5.5 - 0.4 * static_cast<double>(p));
    }
    const std::vector<Window> kinds{
        {5, 7, {2.0, 3.0}, true, false, false},
        {61, 90, {30.0, 45.0}, true, false, false},
        {61, 90, {30.0, 45.0}, false, false, false},
        {9, 6, {4.0, 3.0}, false, false, false},
        {9, 12, own, true, false, true},
        {9, 12, own, false, false, false},
        {9, 12, own, true, true, false},
        {7, 8, {3.0, 4.0}, true, true, false},
        {8, 7, {2.3, -4.1}, true, true, false},
    };
    std::vector<std::function<void()>> callers;
    for (const Window& w : kinds) {
        callers.emplace_back([&] { windows<float>(light, w, 2); });
        callers.emplace_back([&] { windows<double>(light, w, 3); });
    }
    run(callers);
    for (const std::size_t axes : {std::size_t{1}, planes}) {
        run({[&] { rings(1, axes, 2); }, [&] { rings(planes, axes, 3); }});
    }
    return finished();
}
