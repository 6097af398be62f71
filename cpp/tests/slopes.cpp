// Every path of derivatives by the chordal rule, and of their reverse, against differences of images and against their sums.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "lommel/chordal/gradient.hpp"
#include "lommel/chordal/images.hpp"
#include "lommel/chordal/sums.hpp"

#include "check.hpp"

namespace {

using Terms = std::vector<lommel::ZernikeTerm>;

struct Case {
    Terms terms;
    std::size_t count, height, width;
    double obscuration;
    lommel::Amplitude amplitude;
    bool own_axes;

    lommel::DiskWindow window() const { return {height, width, 2.0, 1.5, 1.1}; }

    template <class More, class T>
    std::vector<double> render(const std::vector<double>& edge, double tol, int threads, T* images, const More& more) const {
        lommel::DiskStack stack(terms, edge.data(), count, obscuration, amplitude);
        std::vector<double> scales(count, 1.0), bounds(count), peaks(count), centers;
        for (std::size_t p = 0; p < 2 * count && own_axes; ++p) {
            centers.push_back(1.0 + 0.1 * static_cast<double>(p));
        }
        if (own_axes) {
            stack.tilt_to(centers.data(), window());
        }
        stack.shrink();
        lommel::ChordalRenderer<T, More>(stack, window(), tol, threads, {images, scales.data(), bounds.data(), peaks.data()},
                                         more)
            .run();
        return peaks;
    }
};

template <class T>
void slopes(std::mt19937& random, const Case& given, int threads) {
    std::normal_distribution<double> normal;
    const Terms wanted = {{1, -1}, {2, 0}, {3, 1}, {2, -2}, {4, 4}, {3, -3}, {1, 1}};
    const std::size_t pixels = given.height * given.width, count = given.count, kinds = wanted.size(), n = given.terms.size();
    std::vector<double> edge(count * n), weights(count * pixels), gradients(count * kinds), bounds(kinds * count);
    for (double& c : edge) {
        c = normal(random);
    }
    for (double& w : weights) {
        w = normal(random);
    }
    const double tol = sizeof(T) == 4 ? 1e-4 : 1e-9;
    std::vector<T> images(count * pixels), found(kinds * images.size());
    const std::vector<double> peaks =
        given.render(edge, tol, threads, images.data(), lommel::ChordalDerivatives<T>{wanted, found.data(), bounds.data()});
    given.render(edge, tol, threads, static_cast<double*>(nullptr),
                 lommel::ChordalGradient{wanted, weights.data(), gradients.data()});
    // The wavefront has the terms that derivatives are by: of those it begins with.
    for (std::size_t k = 0; k < kinds; ++k) {
        const auto at =
            static_cast<std::size_t>(std::find(given.terms.begin(), given.terms.end(), wanted[k]) - given.terms.begin());
        std::vector<double> above(images.size()), below(images.size()), moved = edge;
        const double step = 1e-4;
        for (std::size_t p = 0; p < count && at < n; ++p) {
            moved[p * n + at] += step;
        }
        given.render(moved, 1e-11, threads, above.data(), lommel::NoDerivatives{});
        for (std::size_t p = 0; p < count && at < n; ++p) {
            moved[p * n + at] -= 2.0 * step;
        }
        given.render(moved, 1e-11, threads, below.data(), lommel::NoDerivatives{});
        for (std::size_t p = 0; p < count; ++p) {
            const std::size_t from = k * count + p;
            double sum = 0.0, size = 0.0;
            for (std::size_t q = 0; q < pixels; ++q) {
                const double here = static_cast<double>(found[from * pixels + q]);
                const double slope = (above[p * pixels + q] - below[p * pixels + q]) / (2.0 * step);
                check(at == n || std::abs(here - slope) <= bounds[from] * peaks[p] + 3e-7, "derivative", here - slope);
                sum += weights[p * pixels + q] * here;
                size += std::abs(weights[p * pixels + q]);
            }
            check(bounds[from] < 10.0 * tol, "bound of a derivative", bounds[from]);
            const double off = sum - gradients[p * kinds + k];
            check(std::abs(off) <= 2.0 * size * (tol + 1e-7), "gradient", off);
        }
    }
    if (!given.own_axes) {
        // By more chords and nodes than either takes.
        lommel::DiskStack stack(given.terms, edge.data(), count, given.obscuration, given.amplitude);
        stack.shrink();
        std::vector<float> sums(count * pixels);
        std::vector<double> again(gradients.size());
        lommel::ChordalSums<>(stack, given.window(), {90, 90}).run(sums.data(), threads);
        lommel::ChordalSums<lommel::ChordalGradient>(stack, given.window(), {90, 90}, {wanted, weights.data(), again.data()})
            .run(nullptr, threads);
        for (std::size_t j = 0; j < sums.size(); ++j) {
            const std::size_t p = j / pixels, x = j % pixels / given.height, y = j % given.height;
            const double off =
                static_cast<double>(sums[j]) - static_cast<double>(images[(p * given.height + y) * given.width + x]);
            check(std::abs(off) <= peaks[p] * (tol + 1e-5), "sum", off);
        }
        for (std::size_t j = 0; j < again.size(); ++j) {
            const double off = again[j] - gradients[j];
            check(std::abs(off) <= static_cast<double>(pixels) * (10.0 * tol + 1e-5), "gradient of sums", off);
        }
    }
}

void every_path(unsigned seed) {
    std::mt19937 random(seed);
    const Terms tilted = {{2, 0}, {1, 1}, {3, 1}, {1, -1}, {2, -2}, {5, 3}}, few = {{4, 4}, {3, -3}};
    for (const lommel::Level level : {lommel::Level::portable, lommel::Level::avx2, lommel::Level::avx512}) {
        lommel::level_limit() = level;
        for (const std::size_t count : {1, 3, 9, 19}) {
            const Case plain{tilted, count, 5, 4, 0.0, lommel::Amplitude::gaussian(1.5), false};
            const Case ring{few, count, 4, 7, 0.5, {}, count == 3};
            for (const int threads : {1, 3}) {
                slopes<float>(random, plain, threads);
                slopes<double>(random, plain, threads);
                slopes<float>(random, ring, threads);
                slopes<double>(random, ring, threads);
            }
        }
    }
}

}  // namespace

int main() {
    every_path(11);
    return finished();
}
