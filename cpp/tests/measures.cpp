// What is measured and recorded without Python: transfer functions, circles, averages over pixels, and pictures, against closed
// forms and sums by brute force. Returns 1 and says where if one is off.
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdio>
#include <vector>

#include "lommel/base/pi.hpp"
#include "lommel/imaging/convolution.hpp"
#include "lommel/imaging/plane_filter.hpp"
#include "lommel/measures/encircled.hpp"
#include "lommel/measures/overlap.hpp"
#include "lommel/pixels/taps.hpp"
#include "lommel/special/bessel.hpp"

#include "check.hpp"

namespace {

using lommel::pi;

double airy(double v) {
    double bessel[2];
    lommel::bessel_sequence(v, 2, bessel);
    return v < 1e-4 ? 1.0 : 4.0 * bessel[1] * bessel[1] / (v * v);
}

// Rayleigh: the Airy pattern holds 1 - J_0^2 - J_1^2 within v, half of int I v dv being 1.
void circles() {
    const lommel::MeanProfile profile(70.0, 1e-12, airy);
    for (double v = 0.0; v <= 70.0; v += 0.37) {
        double bessel[2];
        lommel::bessel_sequence(v, 2, bessel);
        check(std::abs(profile.mean(v) - airy(v)) < 1e-12, "means on circles", v);
        const double within = 1.0 - bessel[0] * bessel[0] - bessel[1] * bessel[1];
        check(std::abs(0.5 * profile.energy(v) - within) < 1e-12, "energy within circles", v);
    }
}

// The overlap as a sum over a grid of points, less exact than anything there is.
std::complex<double> summed(const std::vector<lommel::ZernikeTerm>& terms, const double* edge, double eps, double f,
                            double angle) {
    const auto phase = [&](double x, double y) {
        const double rho = std::hypot(x, y), theta = std::atan2(y, x);
        double sum = 0.0;
        for (std::size_t j = 0; j < terms.size(); ++j) {
            const int n = terms[j].n, m = std::abs(terms[j].m);
            const double radial = n == 2   ? (m == 0 ? 2.0 * rho * rho - 1.0 : rho * rho)
                                  : n == 3 ? (m == 1 ? (3.0 * rho * rho - 2.0) * rho : rho * rho * rho)
                                           : (6.0 * rho * rho - 6.0) * rho * rho + 1.0;
            sum += edge[j] * radial * (terms[j].m >= 0 ? std::cos(m * theta) : std::sin(m * theta));
        }
        return sum;
    };
    const auto clear = [&](double x, double y) { return x * x + y * y <= 1.0 && x * x + y * y >= eps * eps; };
    constexpr int side = 400;
    const double fx = f * std::cos(angle), fy = f * std::sin(angle);
    std::complex<double> sum = 0.0;
    for (int i = 0; i < side; ++i) {
        for (int k = 0; k < side; ++k) {
            const double x = (2.0 * i + 1.0) / side - 1.0, y = (2.0 * k + 1.0) / side - 1.0;
            if (clear(x - fx, y - fy) && clear(x + fx, y + fy)) {
                sum += std::polar(1.0, phase(x - fx, y - fy) - phase(x + fx, y + fy));
            }
        }
    }
    return sum * (4.0 / (side * side) / (pi * (1.0 - eps * eps)));
}

void overlaps() {
    const std::vector<lommel::ZernikeTerm> terms{{2, 0}, {4, 0}, {3, 1}, {3, -1}, {2, 2}, {3, 3}};
    const double all[] = {2.0, 0.7, 1.5, -0.8, 1.1, 0.6}, even[] = {2.0, 0.7, 0.0, 0.0, 1.1, 0.0}, none[] = {0, 0, 0, 0, 0, 0};
    for (const double eps : {0.0, 0.2, 0.6}) {
        for (const double* edge : {all, even, none}) {
            lommel::Overlap overlap(terms, edge, eps);
            for (const double angle : {0.0, 0.5 * pi, 0.6}) {
                overlap.face(angle);
                for (const double f : {0.1, 0.35, 0.7}) {
                    const std::complex<double> exact = summed(terms, edge, eps, f, angle), fine = overlap.at(f, 30);
                    check(std::abs(fine - exact) < 1e-2, "overlap by points", std::abs(fine - exact));
                    check(std::abs(overlap.at(f, 10) - fine) < 1e-7, "nodes of the overlap",
                          std::abs(overlap.at(f, 10) - fine));
                    if (edge == none) {
                        check(std::abs(fine - lommel::flat_overlap(f, eps)) < 1e-15, "overlap of areas", f);
                    }
                }
                check(overlap.at(0.0, 4) == 1.0 && overlap.at(1.0, 4) == 0.0, "ends of the transfer function", eps);
            }
        }
        // As much by nodes as by areas.
        const double little[] = {1e-9, 0, 0, 0, 0, 0};
        lommel::Overlap overlap(terms, little, eps);
        overlap.face(0.3);
        for (double f = 0.02; f < 1.0; f += 0.049) {
            const double off = std::abs(overlap.at(f, 20) - lommel::flat_overlap(f, eps));
            check(off < 1e-9, "lines of the overlap", off);
        }
    }
}

void taps() {
    for (const double step : {0.3, 2.86, 11.0, 60.0}) {
        for (const double allowed : {1e-6, 1e-10}) {
            const lommel::PixelTaps made(step, allowed, 1.05);
            check(made.error <= allowed && made.gain <= 1.5, "filter", made.error);
            const double h = step / static_cast<double>(made.stride);
            for (double w = 0.0; w <= 2.0; w += 0.0371) {
                double response = 0.0;
                for (std::size_t k = 0; k < made.weights.size(); ++k) {
                    response +=
                        made.weights[k] * std::cos(h * w * (static_cast<double>(k) - static_cast<double>(made.margin())));
                }
                const double wanted = w == 0.0 ? 1.0 : std::sin(0.5 * step * w) / (0.5 * step * w);
                check(std::abs(response - wanted) <= made.error, "response of the filter", w);
            }
        }
    }
}

void convolutions() {
    const std::size_t height = 37, width = 22, reach = 9, side = 15;
    std::vector<float> picture(2 * height * width), spread(side * side), out(height * width);
    unsigned state = 1;
    const auto next = [&] { return static_cast<float>((state = state * 1664525u + 1013904223u) >> 8) / 16777216.0F; };
    std::generate(picture.begin(), picture.end(), next);
    std::generate(spread.begin(), spread.end(), next);
    lommel::Convolution convolution(height, width, reach);
    const auto mirrored = [](int at, int size) { return at < 0 ? -1 - at : at >= size ? 2 * size - 1 - at : at; };
    for (const float scale : {1.0F, 0.5F}) {
        convolution.set_spread(spread.data(), side, scale);
        for (std::size_t plane = 0; plane < 2; ++plane) {
            const float* from = picture.data() + plane * height * width;
            convolution.set_plane(plane, from);
            convolution.make(plane, out.data());
            double worst = 0.0;
            for (int y = 0; y < static_cast<int>(height); ++y) {
                for (int x = 0; x < static_cast<int>(width); ++x) {
                    double sum = 0.0;
                    for (int j = 0; j < static_cast<int>(side); ++j) {
                        for (int i = 0; i < static_cast<int>(side); ++i) {
                            const int row = mirrored(y - j + 7, height), column = mirrored(x - i + 7, width);
                            sum += static_cast<double>(spread[static_cast<std::size_t>(j * 15 + i)]) *
                                   static_cast<double>(from[row * static_cast<int>(width) + column]);
                        }
                    }
                    const float found = out[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)];
                    worst = std::max(worst, std::abs(static_cast<double>(scale) * sum - static_cast<double>(found)));
                }
            }
            check(worst < 1e-4, "convolution", worst);
        }
    }
}

// Eleven columns are more than eight: those of the second group stand alone. Light beyond the outermost planes is like theirs.
void stacks() {
    using Complex = std::complex<float>;
    const lommel::StackPlanes planes{9, 5, 2, 3, 1};
    const std::size_t length = 16, rows = 4, columns = 11, groups = 2, kernels = 2, places = rows * columns;
    unsigned state = 1;
    const auto next = [&] { return static_cast<float>((state = state * 1664525u + 1013904223u) >> 8) / 16777216.0F - 0.5F; };
    std::vector<Complex> kernel(kernels * places * length), specimen(planes.specimen * places), other(specimen);
    for (std::vector<Complex>* each : {&kernel, &specimen, &other}) {
        std::generate(each->begin(), each->end(), [&] { return Complex(next(), next()); });
    }
    std::vector<float> weights(kernels * planes.specimen);
    std::generate(weights.begin(), weights.end(), next);
    std::vector<float> transfers(kernels * rows * groups * length * 16);
    const std::size_t order[] = {0, 2, 4, 6, 1, 3, 5, 7};
    for (std::size_t k = 0; k < kernels; ++k) {
        for (std::size_t at = 0; at < places; ++at) {
            for (std::size_t f = 0; f < length; ++f) {
                std::complex<double> sum = 0.0;
                for (std::size_t d = 0; d < length; ++d) {
                    sum += std::complex<double>(kernel[(k * places + at) * length + d]) *
                           std::polar(1.0 / 16.0, -2.0 * pi * static_cast<double>(f * d) / 16.0);
                }
                const std::size_t row = at / columns, column = at % columns;
                float* const to = &transfers[(((k * rows + row) * groups + column / 8) * length + f) * 16 + order[column % 8]];
                to[0] = static_cast<float>(sum.real());
                to[8] = static_cast<float>(sum.imag());
            }
        }
    }
    const std::size_t each = rows * groups * length * 16;
    const lommel::PlaneFilter filter(planes, length, rows, columns,
                                     {{transfers.data(), rows, length}, {transfers.data() + each, rows, length}},
                                     weights.data());
    std::vector<Complex> seen(specimen), back(other);
    filter.run(seen.data(), false, 1);
    filter.run(back.data(), true, 2);
    std::complex<double> forth_and_other = 0.0, one_and_back = 0.0;
    for (std::size_t at = 0; at < places; ++at) {
        for (std::size_t p = 0; p < planes.recording; ++p) {
            std::complex<double> sum = 0.0;
            for (int q = -3; q < 10; ++q) {
                const auto inside = static_cast<std::size_t>(std::clamp(q, 0, 8));
                const auto apart = static_cast<std::size_t>(static_cast<int>(p) + 2 - q + 16) % 16;
                for (std::size_t k = 0; k < kernels; ++k) {
                    sum += std::complex<double>(kernel[(k * places + at) * length + apart] * specimen[inside * places + at]) *
                           static_cast<double>(weights[k * planes.specimen + inside]);
                }
            }
            const std::complex<double> found(seen[p * places + at]);
            check(std::abs(found - sum) < 1e-5, "a plane of a stack", std::abs(found - sum));
            forth_and_other += std::conj(found) * std::complex<double>(other[p * places + at]);
        }
        for (std::size_t p = 0; p < planes.specimen; ++p) {
            one_and_back +=
                std::conj(std::complex<double>(specimen[p * places + at])) * std::complex<double>(back[p * places + at]);
        }
    }
    check(std::abs(forth_and_other - one_and_back) < 1e-4, "the transpose of a stack",
          std::abs(forth_and_other - one_and_back));
}

}  // namespace

int main() {
    circles();
    overlaps();
    taps();
    convolutions();
    stacks();
    return finished();
}
