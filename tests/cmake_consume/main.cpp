// The Airy pattern, and the axis of a defocused lens, against their closed forms.
#include <cmath>
#include <cstdio>
#include <vector>

#include <lommel/radial/images.hpp>

int main() {
    const double coefficients[] = {0.0, 5.0};  // of R_2^0: no defocus, and 5 rad at the edge against 5 rad on the axis
    const std::size_t side = 33;
    const double step = 0.5, tol = 1e-9;
    std::vector<double> images(2 * side * side), scales(2, 1.0), bounds(2), peaks(2);
    lommel::Renderer<double>({coefficients, 2, 1, 0.0}, side, side, step, tol, 2,
                             {images.data(), scales.data(), bounds.data(), peaks.data(), nullptr, 0, nullptr, nullptr})
        .run();
    double worst = 0.0;
    for (std::size_t x = 0; x < side; ++x) {
        const double v = step * (static_cast<double>(x) - static_cast<double>(side / 2));
        const double airy = v == 0.0 ? 1.0 : std::pow(2.0 * j1(v) / v, 2);
        worst = std::max(worst, std::abs(images[side / 2 * side + x] - airy));
    }
    const double axis = std::pow(std::sin(5.0) / 5.0, 2);
    worst = std::max(worst, std::abs(images[side * side + side / 2 * side + side / 2] - axis));
    std::printf("off by %.3g, bounds %.3g and %.3g\n", worst, bounds[0], bounds[1]);
    return worst < tol && bounds[0] <= tol && bounds[1] <= tol ? 0 : 1;
}
