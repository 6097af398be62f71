// Live depth from a file of tables, for a toy lens whose blur is a power of the filter B: frames at candidate c are B^c X and
// B^(8-c) X, so that B^(8-c) Y_1 - B^c Y_2 is noise there alone. All that the stream computes is computed again by plain
// convolutions in double.
//
//     test_live                  all checks, with a few damaged files
//     test_live --damage 100000  as many damaged files, from another seed for each number
//     test_live --write FOLDER   tables.lml, frames.raw and depth.raw, for a program that reads the first two to write the third
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "lommel/focal/file.hpp"

#include "check.hpp"

namespace {

constexpr std::size_t powers = 8, candidates = powers + 1, height = 96, width = 128, block = lommel::FocalFile::block;
constexpr float white = 2.0f, offset = 20.0f, read_noise = 3.0f, first = 0.5f, step = 0.1f;
const std::vector<double> window = {0.375, 0.25, 0.0625};

using Image = std::vector<double>;  // in row order

struct Filter {
    std::vector<double> taps;  // from the middle on

    // B y, of images that continue mirrored.
    Image operator()(const Image& y, std::size_t rows, std::size_t columns) const {
        const auto mirrored = [](std::ptrdiff_t i, std::size_t side) {
            const auto n = static_cast<std::ptrdiff_t>(side);
            return static_cast<std::size_t>(i < 0 ? -1 - i : i >= n ? 2 * n - 1 - i : i);
        };
        const auto along = [&](const Image& from, bool down) {
            Image to(from.size());
            for (std::size_t r = 0; r < rows; ++r) {
                for (std::size_t c = 0; c < columns; ++c) {
                    double sum = 0.0;
                    for (auto k = 1 - static_cast<std::ptrdiff_t>(taps.size()); k < static_cast<std::ptrdiff_t>(taps.size());
                         ++k) {
                        const std::size_t at = down ? mirrored(static_cast<std::ptrdiff_t>(r) + k, rows) * columns + c
                                                    : r * columns + mirrored(static_cast<std::ptrdiff_t>(c) + k, columns);
                        sum += taps[static_cast<std::size_t>(std::abs(k))] * from[at];
                    }
                    to[r * columns + c] = sum;
                }
            }
            return to;
        };
        return along(along(y, true), false);
    }
    Image power(std::size_t p, Image y, std::size_t rows, std::size_t columns) const {
        for (std::size_t k = 0; k < p; ++k) {
            y = (*this)(y, rows, columns);
        }
        return y;
    }
};
const Filter three{{0.5, 0.25}};
const Filter five{{0.5, 2.0 / 9.0, 1.0 / 36.0}};

// Coefficient of T_m in B^p = ((1 + t) / 2)^p.
double chebyshev(std::size_t p, std::size_t m) {
    double choose = 1.0;  // 2 p over p - m
    for (std::size_t k = 1; m <= p && k <= p - m; ++k) {
        choose *= static_cast<double>(2 * p - (p - m) + k) / static_cast<double>(k);
    }
    return m > p ? 0.0 : (m == 0 ? 1.0 : 2.0) * std::ldexp(choose, -2 * static_cast<int>(p));
}

// White noise that a filter lets through, of 1 in each pixel.
double noise_of(const Filter& filter, std::size_t power) {
    constexpr std::size_t side = 64;
    Image point(side * side);
    point[side / 2 * side + side / 2] = 1.0;
    double sum = 0.0;
    for (const double value : filter.power(power, point, side, side)) {
        sum += value * value;
    }
    return sum;
}
double noise_at(const Filter& filter, std::size_t candidate) {
    return noise_of(filter, powers - candidate) + noise_of(filter, candidate);
}

struct Toy {
    Filter filter;
    std::size_t binning;

    std::size_t rows() const { return height / binning; }
    std::size_t columns() const { return width / binning; }
    // Independent squares of a window: one over the sum of its squared weights.
    double pixels() const {
        double along = 0.0;
        for (std::size_t k = 0; k < window.size(); ++k) {
            along += (k == 0 ? 1.0 : 2.0) * window[k] * window[k] * static_cast<double>(binning) / static_cast<double>(block);
        }
        return 1.0 / (along * along);
    }

    std::vector<char> tables() const {
        const auto whole = [](std::size_t x) { return static_cast<std::int32_t>(x); };
        const std::size_t reach = filter.taps.size() - 1, side = block / binning;
        const std::vector<std::int32_t> header = {lommel::FocalFile::magic,
                                                  lommel::FocalFile::version,
                                                  whole(binning),
                                                  whole(side),
                                                  1,
                                                  2,
                                                  whole(powers),
                                                  whole(reach),
                                                  whole(candidates),
                                                  whole(candidates),
                                                  whole(window.size()),
                                                  whole(powers),
                                                  whole(reach),
                                                  2};
        std::vector<float> body;
        const auto add = [&](double x) { body.push_back(static_cast<float>(x)); };
        for (int set = 0; set < 2; ++set) {
            for (std::size_t k = 0; k < 3; ++k) {
                add(k < filter.taps.size() ? filter.taps[k] : 0.0);
            }
        }
        const double read = static_cast<double>(binning) * static_cast<double>(read_noise);
        add(white), add(offset), add(3e38), add(read * read), add(pixels());
        add(first), add(step), add(0.0), add(powers), add(2.0);
        for (std::size_t c = 0; c < candidates; ++c) {
            for (std::size_t m = 0; m <= powers; ++m) {
                add(chebyshev(powers - c, m));
            }
            for (std::size_t m = 0; m <= powers; ++m) {
                add(-chebyshev(c, m));
            }
        }
        for (const double weight : window) {
            add(weight);
        }
        for (std::size_t c = 0; c < candidates; ++c) {  // the energy of candidate c is that of image c
            for (std::size_t k = 0; k < candidates; ++k) {
                for (std::size_t l = k; l < candidates; ++l) {
                    add(k == c && l == c ? 1.0 : 0.0);
                }
            }
        }
        for (std::size_t c = 0; c < candidates; ++c) {
            add(noise_at(filter, c));
        }
        // The variance of half of the energy's derivative over its curvature, at most: filters that do not amplify, of two
        // frames. It has no other part, and the curvature is taken as measured.
        for (std::size_t c = 0; c < (lommel::FocalCandidates::rows - 1) * candidates; ++c) {
            add(c < candidates ? 2.0 : 0.0);
        }
        for (std::size_t k = 0; k < 2; ++k) {  // B^3 of the first frame, and B^2 of the second
            for (std::size_t i = 0; i < 2; ++i) {
                for (std::size_t m = 0; m <= powers; ++m) {
                    add(k == i ? chebyshev(3 - k, m) : 0.0);
                }
            }
        }
        for (std::size_t c = 0; c < candidates; ++c) {
            add(0.25), add(0.75);
        }
        std::vector<char> bytes(header.size() * sizeof(std::int32_t) + body.size() * sizeof(float));
        std::memcpy(bytes.data(), header.data(), header.size() * sizeof(std::int32_t));
        std::memcpy(bytes.data() + header.size() * sizeof(std::int32_t), body.data(), body.size() * sizeof(float));
        return bytes;
    }

    // Two frames at a candidate, of so many electrons a pixel on average.
    template <class T>
    std::vector<T> frames(std::size_t candidate, double light, unsigned seed) const {
        std::mt19937 draw(seed);
        std::normal_distribution<double> normal;
        Image scene(rows() * columns());
        for (double& x : scene) {
            x = 1.4 * light * static_cast<double>(binning * binning) * ((draw() & 1u) != 0 ? 1.0 : 3.0 / 7.0);
        }
        std::vector<T> out;
        for (const std::size_t power : {candidate, powers - candidate}) {
            const Image seen = filter.power(power, scene, rows(), columns());
            for (std::size_t y = 0; y < height; ++y) {
                for (std::size_t x = 0; x < width; ++x) {
                    const double here = seen[y / binning * columns() + x / binning] / static_cast<double>(binning * binning);
                    const double noisy = here + std::sqrt(here + 9.0) * normal(draw);
                    out.push_back(
                        static_cast<T>(std::lround(static_cast<double>(offset) + noisy / static_cast<double>(white))));
                }
            }
        }
        return out;
    }
};

struct Maps {
    std::vector<float> depth = std::vector<float>(height / block * (width / block)), errors = depth, misfit = depth,
                       image = std::vector<float>(height * width);

    template <class T>
    Maps(const std::vector<char>& tables, const std::vector<T>& frames, std::size_t threads, std::size_t stride = width) {
        const lommel::FocalFile file(tables.data(), tables.size());
        lommel::FocalCamera camera(file, height, width, threads);
        const void* const both[] = {frames.data(), frames.data() + frames.size() / 2};
        for (int again = 0; again < 2; ++again) {
            camera.take(both, sizeof(T) == 2, stride, depth.data(), errors.data(), misfit.data());
            camera.sharpen(image.data());
        }
    }
    bool operator==(const Maps& other) const {
        const auto same = [](const std::vector<float>& a, const std::vector<float>& b) {
            return std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0;
        };
        return same(depth, other.depth) && same(errors, other.errors) && same(misfit, other.misfit) && same(image, other.image);
    }
};

// The energies of all candidates less those of noise, over the noise, by plain convolutions of squares of pixels.
struct Plain {
    std::vector<Image> over_noise;  // [candidate][block]
    Image image;  // of pixels

    template <class T>
    Plain(const Toy& toy, const std::vector<T>& frames) {
        const std::size_t rows = toy.rows(), columns = toy.columns(), binning = toy.binning, side = block / binning;
        std::vector<Image> pixels, squares;
        double mean = 0.0;
        for (std::size_t i = 0; i < 2; ++i) {
            Image one(height * width), sums(rows * columns);
            double total = 0.0;
            for (std::size_t at = 0; at < one.size(); ++at) {
                one[at] = (static_cast<double>(frames[i * one.size() + at]) - static_cast<double>(offset)) *
                          static_cast<double>(white);
                total += one[at];
            }
            mean = i == 0 ? total : mean;
            for (std::size_t at = 0; at < one.size(); ++at) {
                one[at] *= mean / total;
                sums[at / width / binning * columns + at % width / binning] += one[at];
            }
            pixels.push_back(one), squares.push_back(sums);
        }
        const Image a = toy.filter.power(3, pixels[0], height, width), b = toy.filter.power(2, pixels[1], height, width);
        for (std::size_t at = 0; at < a.size(); ++at) {
            image.push_back(0.25 * a[at] + 0.75 * b[at]);
        }
        const double read = static_cast<double>(read_noise) * static_cast<double>(binning);
        Image light(rows * columns);
        for (std::size_t at = 0; at < light.size(); ++at) {
            light[at] = 0.5 * (squares[0][at] + squares[1][at]);
        }
        const Image variance = averages(light, rows, columns, side);
        for (std::size_t c = 0; c < candidates; ++c) {
            Image e = toy.filter.power(powers - c, squares[0], rows, columns);
            const Image other = toy.filter.power(c, squares[1], rows, columns);
            for (std::size_t at = 0; at < e.size(); ++at) {
                e[at] = (e[at] - other[at]) * (e[at] - other[at]);
            }
            const double noise = noise_at(toy.filter, c);
            Image energy = averages(e, rows, columns, side);
            for (std::size_t at = 0; at < energy.size(); ++at) {
                energy[at] = energy[at] / (variance[at] + read * read) - noise;
            }
            over_noise.push_back(energy);
            noises.push_back(noise);
        }
    }

    // Over the window around each block; those near the border are of no use.
    static Image averages(const Image& values, std::size_t rows, std::size_t columns, std::size_t side) {
        const std::size_t down = rows / side, across = columns / side, reach = window.size() - 1;
        Image blocks(down * across), out(down * across);
        for (std::size_t at = 0; at < values.size(); ++at) {
            blocks[at / columns / side * across + at % columns / side] += values[at] / static_cast<double>(side * side);
        }
        const auto weight = [&](std::size_t i, std::size_t j) { return window[i > j ? i - j : j - i]; };
        for (std::size_t y = reach; y + reach < down; ++y) {
            for (std::size_t x = reach; x + reach < across; ++x) {
                for (std::size_t i = y - reach; i <= y + reach; ++i) {
                    for (std::size_t j = x - reach; j <= x + reach; ++j) {
                        out[y * across + x] += weight(y, i) * weight(x, j) * blocks[i * across + j];
                    }
                }
            }
        }
        return out;
    }
    std::vector<double> noises;
};

template <class T>
void agrees(const Toy& toy, std::size_t candidate, double light) {
    const std::vector<char> tables = toy.tables();
    const std::vector<T> frames = toy.frames<T>(candidate, light, static_cast<unsigned>(candidate));
    const Maps maps(tables, frames, 1);
    const Plain plain(toy, frames);
    const double truth = static_cast<double>(first) + static_cast<double>(step) * static_cast<double>(candidate);
    double worst = 0.0, apart = 0.0, squares = 0.0, count = 0.0, all = 0.0;
    for (std::size_t y = 3; y + 3 < height / block; ++y) {
        for (std::size_t x = 3; x + 3 < width / block; ++x, ++all) {
            const std::size_t at = y * (width / block) + x;
            if (!std::isfinite(maps.errors[at])) {
                continue;
            }
            std::size_t best = 0;
            for (std::size_t c = 1; c < candidates; ++c) {
                best = plain.over_noise[c][at] < plain.over_noise[best][at] ? c : best;
            }
            // The least energy is below that of the true depth, by half a chi-squared of one degree.
            const double misfit = 1.0 + (plain.over_noise[best][at] + 1.0 / toy.pixels()) / plain.noises[best];
            const double vergence = 1.0 / static_cast<double>(maps.depth[at]);
            worst = std::max(worst, std::abs(static_cast<double>(maps.misfit[at]) / misfit - 1.0));
            apart = std::max(apart, std::abs((vergence - static_cast<double>(first)) / static_cast<double>(step) -
                                             static_cast<double>(best)));
            const double errors = static_cast<double>(maps.errors[at]) * vergence * vergence;
            squares += (vergence - truth) * (vergence - truth) / (errors * errors);
            ++count;
        }
    }
    check(count > 0.95 * all, "blocks whose depth is known", count / all);
    check(worst < 3e-4, "misfit by plain convolutions", worst);
    check(apart < 0.8, "candidates between the least energy by plain convolutions and the depth", apart);
    const double z = std::sqrt(squares / std::max(count, 1.0));
    check(z > 0.3 && z < 1.0, "errors over standard errors", z);
    double off = 0.0, mean = 0.0;
    for (std::size_t at = 0; at < plain.image.size(); ++at) {
        off = std::max(off, std::abs(static_cast<double>(maps.image[at]) - plain.image[at]));
        mean += plain.image[at] / static_cast<double>(plain.image.size());
    }
    check(off < 2e-6 * mean, "sharp image by plain convolutions", off / mean);

    check(Maps(tables, frames, 3) == maps, "three strips", 3.0);
    constexpr std::size_t stride = width + 24;
    std::vector<T> apart_rows(2 * height * stride, T{77});
    for (std::size_t row = 0; row < 2 * height; ++row) {
        std::copy_n(frames.data() + row * width, width, apart_rows.data() + row * stride);
    }
    check(Maps(tables, apart_rows, 2, stride) == maps, "rows apart", 2.0);
}

// Files cut short, with bytes or numbers changed, and of random contents and sizes, are refused or used, and no more.
struct Damage {
    explicit Damage(unsigned seed) : draw(seed) {}

    std::size_t below(std::size_t end) { return draw() % end; }

    std::vector<char> damaged(std::vector<char> tables) {
        constexpr std::size_t wholes = lommel::FocalFile::wholes, numbers = lommel::FocalFile::numbers;
        const auto put = [&](std::size_t at, const auto& value) {
            static_assert(sizeof value == 4, "of 32 bits");
            std::memcpy(tables.data() + 4 * at, &value, 4);
        };
        const auto odd = [&]() -> float {
            const float values[] = {0.0f, -1.0f, 1.0f, 1e-38f, 1e38f, -1e38f, NAN, INFINITY, 1e9f, -1e-9f};
            return values[below(10)];
        };
        switch (below(5)) {
            case 0:
                tables.resize(below(tables.size()));
                break;
            case 1:
                for (std::size_t k = below(8) + 1; k-- > 0;) {
                    tables[below(tables.size())] ^= static_cast<char>(1u << below(8));
                }
                break;
            case 2: {
                const std::int32_t values[] = {0,  -1, 1,  2,    3,    4,       9,         13,       16,
                                               31, 48, 60, 1001, 4096, 1 << 30, INT32_MAX, INT32_MIN};
                const std::size_t at = below(wholes);
                put(at, values[below(17)]);
                break;
            }
            case 3:
                for (std::size_t k = below(4) + 1; k-- > 0;) {
                    const std::size_t at = below(below(2) == 0 ? std::size_t{numbers} : tables.size() / 4 - wholes);
                    put(wholes + at, odd());
                }
                break;
            default: {  // sound counts and as many values, of any size
                const auto one = [&](std::size_t least, std::size_t most) { return least + below(most - least + 1); };
                const std::size_t binning = std::size_t{1} << below(3), blur = below(8) == 0 ? one(0, 40) : one(0, 7);
                const std::size_t frames = one(2, below(6) == 0 ? 16 : 3), degree = one(1, below(6) == 0 ? 32 : 14);
                const std::size_t reach = one(1, 2), count = one(1, below(6) == 0 ? 48 : 10), places = 9 + 4 * below(8);
                const std::size_t around = one(1, 16), further = one(1, 32), far = one(1, 2),
                                  kept = one(0, below(6) == 0 ? 60 : 8);
                const std::size_t header[wholes] = {0,     0,     binning, block / binning, blur,    frames, degree,
                                                    reach, count, places,  around,          further, far,    kept};
                const std::size_t body = numbers + count * frames * (degree + 1) + around + places * count * (count + 1) / 2 +
                                         lommel::FocalCandidates::rows * places + kept * frames * (further + 1) + kept * places;
                tables.resize(4 * (wholes + body));
                for (std::size_t k = 2; k < wholes; ++k) {
                    put(k, static_cast<std::int32_t>(header[k]));
                }
                const bool wild = below(4) == 0;
                for (std::size_t k = 0; k < body; ++k) {
                    const float tame = static_cast<float>(draw()) / 4294967296.0f - (k < numbers ? 0.0f : 0.5f);
                    put(wholes + k, wild && below(20) == 0 ? (k % 2 == 0 ? 1e38f : -1e30f) : tame);
                }
            }
        }
        return tables;
    }

    // Whether they are used.
    bool operator()(const std::vector<char>& tables, const std::vector<std::uint16_t>& frames) {
        const std::size_t rows = 64 + below(height - 63), columns = 64 + below(width - 63), threads = 1 + below(3);
        std::vector<float> maps(3 * (rows / block) * (columns / block)), image(rows * columns);
        const std::size_t blocks = maps.size() / 3;
        const void* from[16];
        for (std::size_t i = 0; i < 16; ++i) {
            from[i] = frames.data() + i % 2 * height * width;
        }
        try {
            const std::vector<char> exact(tables.begin(), tables.end());  // of a size that a sanitizer knows
            const lommel::FocalFile file(exact.data(), exact.size());
            lommel::FocalCamera camera(file, rows, columns, threads);
            camera.take(from, true, width, maps.data(), maps.data() + blocks, maps.data() + 2 * blocks);
            camera.sharpen(image.data());
        } catch (const std::invalid_argument&) {
            return false;
        }
        return true;
    }

    std::mt19937 draw;
};

void damage(std::size_t count) {
    const Toy toy{five, 1};
    const std::vector<char> tables = toy.tables();
    const std::vector<std::uint16_t> frames = toy.frames<std::uint16_t>(3, 4000.0, 9);
    Damage damage(static_cast<unsigned>(count));
    std::size_t used = 0;
    for (std::size_t k = 0; k < count; ++k) {
        used += damage(damage.damaged(tables), frames) ? 1 : 0;
    }
    std::printf("%zu of %zu damaged files are used\n", used, count);
    check(used > count / 20 && used < count, "share of damaged files that are used", static_cast<double>(used));
    for (std::size_t size = 0; size < tables.size(); size += 1 + size / 16) {
        const std::vector<char> cut(tables.begin(), tables.begin() + static_cast<std::ptrdiff_t>(size));
        check(!damage(cut, frames), "a file that is cut is refused", static_cast<double>(size));
    }
}

void write(const std::string& folder) {
    const Toy toy{three, 1};
    const auto file = [&](const char* name, const void* data, std::size_t bytes) {
        std::ofstream(folder + "/" + name, std::ios::binary)
            .write(static_cast<const char*>(data), static_cast<std::streamsize>(bytes));
    };
    const std::vector<char> tables = toy.tables();
    std::vector<std::uint16_t> all;
    std::vector<float> depth;
    for (const std::size_t candidate : {3, 0, 5}) {
        std::vector<std::uint16_t> frames = toy.frames<std::uint16_t>(candidate, 4000.0, 1);
        std::vector<float> one(height / block * (width / block), NAN);
        if (candidate == 0) {  // one of them black
            std::fill(frames.begin(), frames.begin() + height * width, std::uint16_t{0});
        } else {
            one = Maps(tables, frames, 1).depth;
        }
        all.insert(all.end(), frames.begin(), frames.end());
        depth.insert(depth.end(), one.begin(), one.end());
    }
    file("tables.lml", tables.data(), tables.size());
    file("frames.raw", all.data(), all.size() * sizeof all[0]);
    file("depth.raw", depth.data(), depth.size() * sizeof depth[0]);
}

}  // namespace

int main(int arguments, char** argument) {
    if (arguments == 3 && std::string(argument[1]) == "--write") {
        write(argument[2]);
        return 0;
    }
    if (arguments == 3 && std::string(argument[1]) == "--damage") {
        damage(static_cast<std::size_t>(std::atol(argument[2])));
        return finished();
    }
    for (const Filter& filter : {three, five}) {
        for (const std::size_t binning : {1, 2}) {
            const Toy toy{filter, binning};
            agrees<std::uint16_t>(toy, 3, 4000.0);
            agrees<std::uint16_t>(toy, 5, 4000.0);
        }
    }
    agrees<std::uint8_t>(Toy{three, 1}, 3, 250.0);
    damage(100);
    return finished();
}
