// Blur that varies from pixel to pixel, and its transpose, where points hide one another and where they do not.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "lommel/imaging/field_spread.hpp"
#include "lommel/imaging/spread.hpp"

#include "check.hpp"

// Spreading against collecting, and the light that both hold; arrays end where the interface says that they may.
template <class T>
void spreading_and_collecting(std::mt19937& random, std::size_t height, std::size_t width, std::size_t widest, int threads,
                              bool hiding) {
    using Spreader = lommel::Spreader<T>;
    std::uniform_real_distribution<double> share(0.5, 1.5), place(-0.5, 5.5);
    const std::size_t count = 6, high = height + 2 * widest, margin = Spreader::margin(widest), wide = width + 2 * margin;
    const std::size_t rows = widest + 1;
    std::vector<T> windows((count + 1) * rows * margin, T(0)), image(height * width), taken(height * width);
    std::vector<T> out(high * wide, T(0)), other(high * wide, T(0));
    std::vector<std::int64_t> halves(count);
    std::vector<double> positions(height * width), energies(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t half = random() % rows;
        halves[i] = static_cast<std::int64_t>(half);
        // One quadrant is stored; the others are alike.
        double sum = 0.0;
        for (std::size_t y = 0; y <= half; ++y) {
            for (std::size_t x = 0; x <= half; ++x) {
                const T value = windows[(i * rows + y) * margin + x] = static_cast<T>(share(random));
                sum += (y == 0 ? 1.0 : 2.0) * (x == 0 ? 1.0 : 2.0) * static_cast<double>(value);
            }
        }
        energies[i] = sum;
    }
    double light = 0.0, arrived = 0.0, one = 0.0, two = 0.0;
    for (std::size_t i = 0; i < image.size(); ++i) {
        image[i] = static_cast<T>(share(random));
        positions[i] = place(random);
        light += positions[i] < 0.0 ? 0.0 : static_cast<double>(image[i]);
    }
    for (std::size_t i = 0; i < high * wide; ++i) {
        other[i] = static_cast<T>(share(random));
    }
    const lommel::WindowBank<T> bank{windows.data(), halves.data(), energies.data(), count, widest, margin};
    // Layers in bands of 24 rows, and pixels that see all of them, none or parts.
    std::vector<T> layers(image.size()), seen(out.size());
    for (std::size_t i = 0; i < image.size(); ++i) {
        layers[i] = static_cast<T>(i / width / 24 % 3);
    }
    for (std::size_t i = 0; i < seen.size(); ++i) {
        seen[i] = static_cast<T>(i / wide / 40 % 2 == 0 ? 3.0 : 2.0 * share(random) - 1.0);
    }
    const lommel::Screen<T> screen{hiding ? layers.data() : nullptr, hiding ? seen.data() : nullptr};
    const Spreader spreader(bank, {positions.data(), height, width}, threads, screen);
    spreader.forward(image.data(), static_cast<std::ptrdiff_t>(width), 1, out.data());
    spreader.adjoint(other.data(), taken.data());
    for (std::size_t i = 0; i < high * wide; ++i) {
        const double value = static_cast<double>(out[i]);
        arrived += value;
        one += value * static_cast<double>(other[i]);
    }
    for (std::size_t i = 0; i < image.size(); ++i) {
        two += static_cast<double>(image[i]) * static_cast<double>(taken[i]);
    }
    const double allowed = (sizeof(T) == 4 ? 1e-5 : 1e-12) * (1.0 + light);
    check(hiding || std::abs(arrived - light) <= allowed, "light that was spread", arrived - light);
    check(std::abs(one - two) <= 2.0 * allowed, "transpose of spreading", one - two);
}

// The same of windows mixed of splines over the field, whose weights here are any.
template <class T>
void field_spreading_and_collecting(std::mt19937& random, std::size_t height, std::size_t width, std::size_t side,
                                    std::size_t order, int threads) {
    using Spreader = lommel::FieldSpreader<T>;
    std::uniform_real_distribution<double> share(0.5, 1.5), place(-0.1, 1.1);
    const auto some = [&](std::size_t count) {
        std::vector<T> values(count);
        for (T& value : values) {
            value = static_cast<T>(share(random));
        }
        return values;
    };
    const std::size_t intervals = order == 1 ? 1 : 3, depth = intervals + order - 1, places = 5;
    const std::size_t size = (side * side + Spreader::step - 1) / Spreader::step * Spreader::step;
    const std::size_t high = height + side - 1, wide = width + side - 1 + Spreader::step;
    std::vector<T> windows = some(2 * 9 * depth * size), image = some(height * width), other = some(high * wide);
    for (std::size_t i = 0; i < windows.size(); ++i) {
        windows[i] = i % size < side * side ? windows[i] : T(0);
    }
    const std::vector<T> down = some(height * 2), weights = some(places * 9), shares = some(3 * width);
    const std::vector<T> powers = some(intervals * order * order);
    std::vector<std::int64_t> tiles(width);
    for (std::int64_t& tile : tiles) {
        tile = static_cast<std::int64_t>(random() % 2);
    }
    std::vector<double> defocus(height * width), breaks{0.0, 0.2, 0.7, 1.0};
    for (double& value : defocus) {
        value = place(random);
    }
    std::vector<T> out(high * wide, T(0)), taken(height * width);
    const Spreader spreader({windows.data(), 2, 9, depth, side, size},
                            {down.data(), weights.data(), shares.data(), tiles.data(), places, height, width, defocus.data(),
                             breaks.data(), powers.data(), intervals, order},
                            threads);
    spreader.forward(image.data(), out.data());
    spreader.adjoint(other.data(), taken.data());
    double one = 0.0, two = 0.0;
    for (std::size_t i = 0; i < out.size(); ++i) {
        one += static_cast<double>(out[i]) * static_cast<double>(other[i]);
    }
    for (std::size_t i = 0; i < image.size(); ++i) {
        two += static_cast<double>(image[i]) * static_cast<double>(taken[i]);
    }
    check(std::abs(one - two) <= (sizeof(T) == 4 ? 1e-5 : 1e-12) * one, "transpose of spreading over the field", one - two);
}

inline void every_path_of_the_spreader(unsigned seed) {
    std::mt19937 random(seed);
    for (const std::size_t order : {std::size_t{1}, std::size_t{4}, std::size_t{6}}) {
        for (const std::size_t side : {std::size_t{1}, std::size_t{5}, std::size_t{9}, std::size_t{17}, std::size_t{27}}) {
            field_spreading_and_collecting<float>(random, 3, 5, side, order, 1);
            field_spreading_and_collecting<double>(random, 70, 9, side, order, 3);
            field_spreading_and_collecting<float>(random, 70, 19, side, order, 3);
        }
    }
    for (const std::size_t widest : {std::size_t{0}, std::size_t{1}, std::size_t{4}, std::size_t{9}, std::size_t{35}}) {
        for (const int threads : {1, 3}) {
            for (const bool hiding : {false, true}) {
                spreading_and_collecting<float>(random, 1, 1, widest, threads, hiding);
                spreading_and_collecting<double>(random, 3, 17, widest, threads, hiding);
                spreading_and_collecting<float>(random, 70, 5, widest, threads, hiding);
                spreading_and_collecting<double>(random, 97, 31, widest, threads, hiding);
            }
        }
    }
}
