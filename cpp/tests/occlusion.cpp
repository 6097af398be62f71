// Occlusion without Python: what points hide, and light that is composited by layers; some callers at once. Returns 1 and says
// where if something is off.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

#include "lommel/imaging/composite.hpp"
#include "lommel/imaging/depth_layers.hpp"

#include "check.hpp"

namespace {

// Composites a white scene with occlusion, in which light must equal coverage; then again, the visibility of each pixel given.
template <class T>
void compositing(std::mt19937& random, std::size_t height, std::size_t width, std::size_t widest, int threads, std::size_t pad,
                 bool dark) {
    const std::size_t count = 5, rows = widest + 1, stride = lommel::Spreader<T>::margin(widest), size = height * width;
    std::vector<T> windows((count + 1) * rows * stride, T(0));
    std::vector<std::int64_t> halves(count, static_cast<std::int64_t>(widest)), down(height + 2 * pad), right(width + 2 * pad);
    const double side = 2.0 * static_cast<double>(widest) + 1.0;
    std::vector<double> energies(count, side * side), defocus(size), positions(size);
    for (std::size_t i = 0; i < count * rows; ++i) {
        std::fill_n(windows.data() + i * stride, rows, T(1));
    }
    const auto copied = [&](std::vector<std::int64_t>& indices, std::size_t last) {
        for (std::size_t i = 0; i < indices.size(); ++i) {
            indices[i] = static_cast<std::int64_t>(std::min(i > pad ? i - pad : 0, last - 1));
        }
    };
    copied(down, height), copied(right, width);
    std::uniform_int_distribution<int> step(0, 3);
    for (std::size_t i = 0; i < size; ++i) {
        defocus[i] = static_cast<double>(step(random)) - (i / width > height / 2 ? 3.0 : 0.0);
        positions[i] = 1.0 + 0.1 * defocus[i];
    }
    const double radii[] = {-12.0, 9.0};
    std::vector<std::uint8_t> layers(size);
    std::vector<std::int32_t> behind(size);
    std::vector<float> radius(size);
    lommel::sort_into_layers(defocus.data(), size, {radii, 2, -3.0, 3.0, 0.5, 64}, threads, layers.data(), radius.data());
    lommel::HiddenPoints(layers.data(), radius.data(), height, width, threads).find(behind.data());
    const std::size_t number = lommel::renumber(layers.data(), size);
    const lommel::WindowBank<T> bank{windows.data(), halves.data(), energies.data(), count, widest, stride};
    const lommel::Scene scene{positions.data(), width, down.data(), right.data(), down.size(), right.size()};
    const lommel::LayeredScene layered{scene, layers.data(), behind.data(), number, pad, pad == 0, dark};
    const std::vector<T> image(size, T(1));
    lommel::Compositor<T> made(bank, layered, threads, image.data(), static_cast<std::ptrdiff_t>(width), 1);
    std::vector<T> seen(size, made.beyond()), total(size, T(0)), out(size, T(0)), again(size, T(0));
    made(0, number, false, {seen.data(), total.data(), out.data()});
    made(0, number, true, {seen.data(), nullptr, again.data()});
    double off = 0.0, twice = 0.0;
    for (std::size_t i = 0; i < size; ++i) {
        off = std::max(off, dark ? 0.0 : std::abs(static_cast<double>(out[i] - total[i])));
        twice = std::max(twice, std::abs(static_cast<double>(out[i] - again[i])));
    }
    check(off <= (sizeof(T) == 4 ? 1e-4 : 1e-12), "light of a white scene", off);
    check(twice == 0.0, "light where what pixels see is known", twice);
}

void every_path(unsigned seed) {
    std::mt19937 random(seed);
    for (const std::size_t widest : {std::size_t{0}, std::size_t{4}, std::size_t{35}}) {
        for (const int threads : {1, 3}) {
            for (const std::size_t pad : {std::size_t{0}, widest}) {
                compositing<float>(random, 1, 1, widest, threads, pad, false);
                compositing<double>(random, 70, 97, widest, threads, pad, false);
                compositing<float>(random, 131, 30, widest, threads, pad, pad > 0);
            }
        }
    }
}

}  // namespace

int main() {
    for (const lommel::Level level : {lommel::Level::portable, lommel::Level::avx2, lommel::Level::avx512}) {
        lommel::level_limit() = level;
        every_path(1);
    }
    run({[] { every_path(2); }, [] { every_path(3); }});
    return finished();
}
