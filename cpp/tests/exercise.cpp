// The compiled core without Python, for sanitizers: every path of the engine at odd sizes, and from many threads at once.
// Returns 1 and says where if an answer is not what another path, or the standard library, makes of it.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "lommel/chordal/images.hpp"
#include "lommel/paper/huygens.hpp"
#include "lommel/radial/images.hpp"
#include "lommel/radial/average_images.hpp"
#include "lommel/radial/profiles.hpp"
#include "lommel/zernike/images.hpp"

#include "check.hpp"
#include "spreading.hpp"

namespace {

// Of one of several images, of so many pixels each.
template <class T>
double largest(const std::vector<T>& images, std::size_t which, std::size_t pixels) {
    const auto first = images.begin() + static_cast<std::ptrdiff_t>(which * pixels);
    return static_cast<double>(*std::max_element(first, first + static_cast<std::ptrdiff_t>(pixels)));
}

// Of defocus alone, whatever the axis and the obscuration, the general engine must say what the radial one says.
template <class T>
void general_images_agree_with_radial_ones(double defocus, double obscuration, std::int64_t height, std::int64_t width,
                                           std::int64_t row, std::int64_t column, int threads) {
    // 2 C rho^2 is C R_2^0 and a constant; the other two terms vanish.
    const std::vector<lommel::ZernikeTerm> terms = {{2, 0}, {3, -1}, {2, 2}};
    const double edge[] = {defocus, 0.0, 1e-300};
    const double step = 0.9, tol = 1e-6;
    std::vector<T> image(static_cast<std::size_t>(height * width), T(-1));
    double scale = 1.0, bound = 0.0, brightest = 0.0;
    const double powers[] = {0.2, 0.4, -0.6};  // 1 at the rim
    const lommel::Amplitude amplitude(powers, 3);
    const lommel::DiskWindow window{static_cast<std::size_t>(height), static_cast<std::size_t>(width), static_cast<double>(row),
                                    static_cast<double>(column), step};
    lommel::DiskStack stack(terms, edge, 1, obscuration, amplitude);
    stack.move_axes(window);
    stack.shrink();
    lommel::ZernikeRenderer<T>(stack, window, tol, threads, {image.data(), &scale, &bound, &brightest}).run();
    check(bound <= tol, "bound of a general image", bound);
    check(brightest >= 0.999999 * largest(image, 0, image.size()), "peak of a general image", brightest);
    const lommel::Stack radial{&defocus, 1, 1, obscuration, amplitude};
    std::vector<double> v;
    for (std::int64_t y = 0; y < height; ++y) {
        for (std::int64_t x = 0; x < width; ++x) {
            v.push_back(step * std::hypot(static_cast<double>(y - row), static_cast<double>(x - column)));
        }
    }
    std::vector<double> sorted = v;
    std::sort(sorted.begin(), sorted.end());
    std::vector<double> values(v.size());
    double radial_bound = 0.0, peak = 0.0, worst = 0.0;
    lommel::profiles(radial, sorted.data(), sorted.size(), tol, values.data(), &radial_bound, &peak);
    for (std::size_t i = 0; i < v.size(); ++i) {
        const std::size_t at = static_cast<std::size_t>(std::lower_bound(sorted.begin(), sorted.end(), v[i]) - sorted.begin());
        worst = std::max(worst, std::abs(values[at] - static_cast<double>(image[i])));
    }
    check(worst <= (bound + std::abs(radial_bound) + 1.2e-7) * peak, "I of the general engine", worst / peak);
}

// Images must be what the same method makes of them at a small tolerance, whatever window, axis, tilt and obscuration; and the
// same to the bit with any number of threads.
void images_between_circles_keep_their_bounds(std::mt19937& random) {
    std::uniform_real_distribution<double> phase(-8.0, 8.0), pitch(0.4, 3.0), shift(-20.0, 20.0);
    std::uniform_int_distribution<std::size_t> side(60, 110);
    const std::vector<lommel::ZernikeTerm> terms = {{1, 1}, {2, 0}, {2, -2}, {3, 1}, {3, -3}, {5, 1}};
    for (const double obscuration : {0.0, 0.4}) {
        std::vector<double> edge(2 * terms.size());
        for (double& c : edge) {
            c = phase(random);
        }
        const double powers[] = {0.0, obscuration};
        const lommel::Amplitude amplitude(powers, 2);
        const std::size_t height = side(random), width = side(random), pixels = height * width;
        const lommel::DiskWindow window{height, width, 0.5 * static_cast<double>(height) + shift(random),
                                        0.5 * static_cast<double>(width) + shift(random), pitch(random)};
        lommel::DiskStack stack(terms, edge.data(), 2, obscuration, amplitude);
        stack.move_axes(window);
        stack.shrink();
        const double tol = 1e-5, fine = 1e-9;
        std::vector<double> exact(2 * pixels), scales = {1.0, 0.0}, bounds(2), peaks(2);
        lommel::ZernikeRenderer<double>(stack, window, fine, 1, {exact.data(), scales.data(), bounds.data(), peaks.data()})
            .run();
        std::vector<float> images[2];
        for (int way = 0; way < 2; ++way) {
            images[way].assign(2 * pixels, -1.0F);
            scales = {1.0, 0.0};
            lommel::ZernikeRenderer<float>(stack, window, tol, 1 + way,
                                           {images[way].data(), scales.data(), bounds.data(), peaks.data()})
                .run();
            for (std::size_t i = 0; i < 2 * pixels; ++i) {
                const double error =
                    std::abs(static_cast<double>(images[way][i]) - exact[i]) / largest(exact, i / pixels, pixels);
                check(error <= bounds[i / pixels] + 2.0 * fine && bounds[i / pixels] <= tol, "I between circles", error);
            }
        }
        check(images[0] == images[1], "an image by one thread and by two", 0.0);
    }
}

template <class T>
void images_keep_their_bounds(std::mt19937& random, std::size_t height, std::size_t width, std::size_t count,
                              double obscuration, double tol, int threads, bool normalize) {
    std::uniform_real_distribution<double> phase(-120.0, 120.0), pitch(0.2, 4.0);
    const double step = pitch(random);
    std::vector<double> coefficients(2 * count), scales(count, normalize ? 0.0 : 1.0), bounds(count), peaks(count);
    for (double& c : coefficients) {
        c = phase(random);
    }
    const std::vector<std::size_t> powers = {1, 2};
    std::vector<T> images(count * height * width), slopes(powers.size() * images.size());
    std::vector<double> slope_bounds(powers.size() * count);
    // Even, Gaussian, and one that rises and falls, to nearly 1 in between.
    const double wavy[] = {0.3, -1.2, 1.2, 0.1};
    const lommel::Amplitude amplitude = count == 1   ? lommel::Amplitude(wavy, 4)
                                        : count == 2 ? lommel::Amplitude::gaussian(1.5)
                                                     : lommel::Amplitude();
    const lommel::Stack stack{coefficients.data(), count, 2, obscuration, amplitude};
    const bool with_slopes = count < 4;
    lommel::Renderer<T>(stack, height, width, step, tol, threads,
                        {images.data(), scales.data(), bounds.data(), peaks.data(), powers.data(),
                         with_slopes ? powers.size() : 0, slopes.data(), slope_bounds.data()})
        .run();
    // The same pixels by the Bessel functions themselves.
    for (std::size_t pupil = 0; pupil < count; pupil += 1 + count / 3) {
        for (const std::size_t pixel : {std::size_t{0}, images.size() / count - 1, width * (height / 2) + width / 2}) {
            const double y = static_cast<double>(pixel / width) - static_cast<double>(height / 2);
            const double x = static_cast<double>(pixel % width) - static_cast<double>(width / 2);
            const double v = step * std::hypot(x, y);
            std::complex<double> u;
            double bound;
            const lommel::Stack one{coefficients.data() + 2 * pupil, 1, 2, obscuration, amplitude};
            lommel::fields(one, &v, 1, 1e-12, &u, &bound);
            const double peak = normalize ? 1.0 : largest(images, pupil, height * width);
            const double found = static_cast<double>(images[pupil * height * width + pixel]);
            const double error = std::abs(found - scales[pupil] * std::norm(u)) / std::max(peak, 1e-30);
            check(bounds[pupil] <= tol, "bound within the tolerance", bounds[pupil]);
            check(error <= tol + (sizeof(T) == 4 ? 1.2e-7 : 1e-12) || peak < 1e-9, "error within the tolerance", error);
        }
    }
}

void every_path_of_the_engine(unsigned seed) {
    std::mt19937 random(seed);
    for (const std::size_t side : {std::size_t{1}, std::size_t{2}, std::size_t{3}, std::size_t{16}, std::size_t{33}}) {
        for (const double obscuration : {0.0, 0.33}) {
            for (const int threads : {1, 3}) {
                images_keep_their_bounds<float>(random, side, side + 5, 1, obscuration, 1e-5, threads, false);
                images_keep_their_bounds<double>(random, side + 4, side, 2, obscuration, 1e-8, threads, true);
                images_keep_their_bounds<double>(random, side, side + 1, 9, obscuration, 1e-6, threads, false);
            }
        }
    }
    images_keep_their_bounds<float>(random, 301, 640, 1, 0.0, 1e-6, 2, false);
    images_keep_their_bounds<double>(random, 40, 41, 37, 0.0, 1e-7, 2, true);
    for (const double defocus : {0.0, 7.0, -40.0}) {
        for (const double obscuration : {0.0, 0.4}) {
            general_images_agree_with_radial_ones<double>(defocus, obscuration, 33, 40, 16, 20, 1);
            general_images_agree_with_radial_ones<float>(defocus, obscuration, 90, 71, 40, 30, 2);
            general_images_agree_with_radial_ones<float>(defocus, obscuration, 9, 12, -3, 20, 1);
        }
    }
}

// Radial wavefronts by the chordal rule against the series; others against themselves, turned by a right angle.
template <class T>
void chordal_windows(std::mt19937& random, std::size_t count, std::size_t side, double obscuration,
                     const lommel::Amplitude& amplitude, int threads, bool normalize) {
    std::uniform_real_distribution<double> phase(-2.0, 2.0);
    const double tol = sizeof(T) == 4 ? 1e-5 : 1e-8, step = 1.3;
    const double middle = static_cast<double>(side / 2);
    std::vector<double> radial(count), edge(2 * count), turned(2 * count);
    for (std::size_t p = 0; p < count; ++p) {
        radial[p] = edge[2 * p] = turned[2 * p] = 2.0 * phase(random);
        if (obscuration == 0.0) {
            edge[2 * p + 1] = phase(random);
            turned[2 * p + 1] = -edge[2 * p + 1];
        }
    }
    const std::vector<lommel::ZernikeTerm> terms = {{2, 0}, {2, 2}};
    std::vector<T> images(count * side * side), others(images.size());
    std::vector<double> scales(count, normalize ? 0.0 : 1.0), bounds(count), peaks(count), other_scales = scales;
    const lommel::DiskWindow window{side, side, middle, middle, step};
    lommel::DiskStack stack(terms, edge.data(), count, obscuration, amplitude),
        around(terms, turned.data(), count, obscuration, amplitude);
    stack.shrink();
    around.shrink();
    lommel::ChordalRenderer<T>(stack, window, tol, threads, {images.data(), scales.data(), bounds.data(), peaks.data()}).run();
    lommel::ChordalRenderer<T>(around, window, tol, threads, {others.data(), other_scales.data(), bounds.data(), peaks.data()})
        .run();
    for (std::size_t p = 0; p < count; ++p) {
        const T* image = images.data() + p * side * side;
        const double peak = largest(images, p, side * side);
        const double allowed = (2.0 * tol + (sizeof(T) == 4 ? 2.4e-7 : 1e-13)) * peak;
        check(bounds[p] <= tol, "bound of the chordal rule", bounds[p]);
        for (std::size_t y = 0; y < side; ++y) {
            for (std::size_t x = 0; x < side; ++x) {
                const double other = static_cast<double>(others[p * side * side + x * side + y]);
                check(std::abs(static_cast<double>(image[y * side + x]) - other) <= allowed, "turned window", other);
            }
        }
        if (obscuration > 0.0) {
            const double v = step * middle;
            std::complex<double> u;
            double bound;
            lommel::fields({radial.data() + p, 1, 1, obscuration, amplitude}, &v, 1, 1e-12, &u, &bound);
            const double found = static_cast<double>(image[(side / 2) * side]);
            check(std::abs(found - scales[p] * std::norm(u)) <= allowed, "chordal against the series", found);
        }
    }
}

void every_path_of_the_chordal_rule(unsigned seed) {
    std::mt19937 random(seed);
    const double fourth[] = {0.0, 0.5, 0.0, 0.0, 1.0};
    const lommel::Amplitude even, beam = lommel::Amplitude::gaussian(1.5), steep(fourth, 5);
    for (const std::size_t side : {std::size_t{1}, std::size_t{2}, std::size_t{7}, std::size_t{12}}) {
        for (const int threads : {1, 3}) {
            chordal_windows<float>(random, 1, side, 0.0, even, threads, false);
            chordal_windows<double>(random, 9, side, 0.4, even, threads, true);
            chordal_windows<double>(random, 19, side, 0.0, steep, threads, false);
            chordal_windows<float>(random, 5, side, 0.2, beam, threads, true);
        }
    }
}

// Windows of every kind: the pixels themselves, one ring, rings with and without harmonics; one pupil, and stacks.
template <class T>
void pixels_around_any_axis(std::mt19937& random) {
    std::uniform_real_distribution<double> share(0.0, 1.0);
    struct Case {
        std::size_t height, width, count;
        double row, column, step;
        bool integrate;
    };
    for (const Case& c :
         {Case{9, 7, 1, 3.3, -40.4, 0.4, false}, Case{33, 33, 6, 16, 16, 9.0, true}, Case{150, 90, 1, 75, 45, 0.5, true},
          Case{60, 90, 5, 20.5, 30.5, 1.6, true}, Case{80, 120, 1, -9.25, 60.0, 0.3, false}, Case{1, 1, 4, 0.0, 0.0, 2.0, true},
          Case{40, 41, 1, 20, 20, 25.0, true}, Case{60, 90, 1, 20.3, 30.9, 1.6, true},
          Case{31, 33, 3, 16.2, 15.7, 7.0, true}}) {
        const std::size_t pixels = c.height * c.width;
        std::vector<double> coefficients(2 * c.count), scales(c.count, share(random) < 0.5 ? 0.0 : 1.0), bounds(c.count),
            peaks(c.count), slope_bounds(2 * c.count);
        for (double& x : coefficients) {
            x = 20.0 * share(random) - 10.0;
        }
        std::vector<T> images(pixels * c.count), slopes(2 * pixels * c.count);
        const std::size_t powers[2] = {1, 3};
        const double obscuration = c.count == 1 ? 0.3 : 0.0;
        const std::size_t derivatives = scales[0] > 0.0 && c.count < 6 ? 2 : 0;
        const double falling[] = {0.0, 0.2, 0.3};
        const lommel::PixelWindow window{c.height, c.width, c.row, c.column, c.step, c.integrate};
        std::vector<double> centers;
        for (std::size_t i = 0; i < c.count; ++i) {
            centers.push_back(c.row + share(random) - 0.5);
            centers.push_back(c.column + share(random) - 0.5);
        }
        const auto render = [&](const lommel::PixelWindows& windows) {
            lommel::PixelRenderer<T>({coefficients.data(), c.count, 2, obscuration, lommel::Amplitude(falling, 3)}, windows,
                                     1e-5, 2,
                                     {images.data(), scales.data(), bounds.data(), peaks.data(), powers, derivatives,
                                      slopes.data(), slope_bounds.data()})
                .run();
        };
        const std::vector<double> asked = scales;
        render({window, centers.data(), c.count});
        for (std::size_t i = 0; i < c.count; ++i) {
            check(bounds[i] > 0.0 && bounds[i] <= 1e-5, "bound around an axis for each", bounds[i]);
        }
        scales = asked;
        render(window);
        for (std::size_t i = 0; i < c.count; ++i) {
            check(bounds[i] > 0.0 && bounds[i] <= 1e-5, "bound of averages", bounds[i]);
            const double top = largest(images, i, pixels);
            check(top <= 1.0 + 1e-6 && top > 0.0, "largest average", top);
        }
    }
}

// Samples interpolated by polynomials of the distance, with and without folding the window: each must be within its bound of |U|^2
// at its pixel.
template <class T>
void samples_around_any_axis(std::mt19937& random) {
    std::uniform_real_distribution<double> share(0.0, 1.0);
    struct Case {
        std::size_t height, width;
        double row, column, step;
    };
    for (const Case& c : {Case{150, 90, 75, 44.5, 0.5}, Case{260, 301, 20, 290.5, 0.8}, Case{90, 140, 0.5, 0, 2.1},
                          Case{190, 340, 95.3, 170.2, 1.3}, Case{64, 200, -40.5, 99, 0.9}, Case{65, 300, 700.3, -200.9, 1.7}}) {
        const double coefficients[] = {20.0 * share(random) - 10.0, 6.0 * share(random) - 3.0};
        const lommel::Stack stack{coefficients, 1, 2, 0.3};
        std::vector<T> image(c.height * c.width);
        double scale = 1.0, bound = 0.0, peak = 0.0;
        lommel::PixelRenderer<T>(stack, lommel::PixelWindow{c.height, c.width, c.row, c.column, c.step, false}, 1e-6, 2,
                                 {image.data(), &scale, &bound, &peak})
            .run();
        check(bound > 0.0 && bound <= 1e-6, "bound of samples", bound);
        for (std::size_t i = 0; i < 60; ++i) {
            const double rows = static_cast<double>(c.height), columns = static_cast<double>(c.width);
            const std::size_t y = i < 4 ? (i % 2) * (c.height - 1) : static_cast<std::size_t>(rows * share(random)),
                              x = i < 4 ? (i / 2) * (c.width - 1) : static_cast<std::size_t>(columns * share(random));
            const double v = c.step * std::hypot(static_cast<double>(y) - c.row, static_cast<double>(x) - c.column);
            std::complex<double> u;
            double exact;
            lommel::fields(stack, &v, 1, 1e-12, &u, &exact);
            const double off = std::abs(static_cast<double>(image[y * c.width + x]) - std::norm(u)) / peak;
            check(off <= bound, "sample around any axis", off / bound);
        }
    }
}

void every_kind_of_pixel(unsigned seed) {
    std::mt19937 random(seed);
    samples_around_any_axis<float>(random);
    samples_around_any_axis<double>(random);
    pixels_around_any_axis<float>(random);
    pixels_around_any_axis<double>(random);
}

void huygens_sum_of_one_source() {
    const double x = 1e-3, y = 0.0, sx = 0.0, sy = 0.0;
    const std::complex<double> a = 1.0;
    std::complex<double> out;
    lommel::huygens_sum(&x, &y, &a, 1, &sx, &sy, 1, 0.1, 1e7, &out);
    check(std::abs(out - std::complex<double>(1.0 / (1.0 + 1e-4), 0.0)) < 1e-12, "wavelet on the axis", out.real());
}

}  // namespace

int main() {
    lommel::work_per_thread() = 1e-3;
    huygens_sum_of_one_source();
    for (const lommel::Level level : {lommel::Level::portable, lommel::Level::avx2, lommel::Level::avx512}) {
        lommel::level_limit() = level;
        every_path_of_the_engine(1);
        std::mt19937 random(1);
        images_between_circles_keep_their_bounds(random);
        every_kind_of_pixel(1);
        every_path_of_the_chordal_rule(1);
        every_path_of_the_spreader(1);
    }
    std::vector<std::function<void()>> callers;
    for (unsigned seed = 2; seed < 6; ++seed) {
        callers.emplace_back([seed] { (seed % 2 == 0 ? every_path_of_the_engine : every_path_of_the_chordal_rule)(seed); });
        callers.emplace_back([seed] { every_path_of_the_spreader(seed); });
        callers.emplace_back([seed] { every_kind_of_pixel(seed); });
    }
    run(callers);
    return finished();
}
