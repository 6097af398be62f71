// Tables of molecules and fits by them, for sanitizers: images against plain sums at odd sizes, fits by one thread and by many.
// Returns 1 and says where if an answer is not what a plain sum, or another number of threads, makes of it.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "lommel/localize/bank.hpp"

#include "check.hpp"

namespace {

constexpr std::size_t terms = lommel::MoleculeTable::terms;

// A table of random smooth coefficients, of two taps that interpolate linearly.
struct Made {
    std::size_t pieces, rows, per, columns;
    std::vector<float> coefficients;
    std::vector<double> polynomials{-0.5, 0.5, 0.5, 0.5};
    lommel::MoleculeTable table{};

    Made(std::size_t height, std::size_t width, std::size_t each, std::size_t many, std::mt19937& random)
        : pieces(many), rows(each * (height + 4) + 2), per(each), columns(width + 5) {
        std::uniform_real_distribution<double> any(-0.02, 0.02);
        coefficients.resize(pieces * terms * rows * per * columns + lommel::MoleculeTable::beyond);
        const double middle = 0.5 * static_cast<double>(rows), across = 0.5 * static_cast<double>(per * columns);
        const double wide = 2.0 * static_cast<double>(per * per);
        for (std::size_t k = 0; k < pieces * terms; ++k) {
            const double share = k % terms == 0 ? 1.0 : any(random);
            for (std::size_t y = 0; y < rows; ++y) {
                for (std::size_t x = 0; x < per * columns; ++x) {
                    const double down = static_cast<double>(y) - middle, right = static_cast<double>(x) - across;
                    coefficients[index(k, y, x)] = static_cast<float>(share * std::exp(-(down * down + right * right) / wide));
                }
            }
        }
        const double step = static_cast<double>(per);
        const double row = 0.5 * static_cast<double>(height - 1), column = 0.5 * static_cast<double>(width - 1);
        table = {coefficients.data(),
                 pieces,
                 rows,
                 per,
                 columns,
                 height,
                 width,
                 polynomials.data(),
                 2,
                 2,
                 -step * (row + 2.0),
                 -step * (column + 2.0),
                 -1.0,
                 1.0,
                 row - 1.0,
                 row + 1.0,
                 column - 1.0,
                 column + 1.0};
    }

    std::size_t index(std::size_t k, std::size_t y, std::size_t x) const {
        return ((k * rows + y) * per + x % per) * columns + x / per;
    }

    double value(const lommel::Place& place, std::size_t y, std::size_t x) const {
        const double at = (place.z + 1.0) * 0.5 * static_cast<double>(pieces);
        const std::size_t piece = std::min(static_cast<std::size_t>(at), pieces - 1);
        const double z = 2.0 * (at - static_cast<double>(piece)) - 1.0;
        const double step = static_cast<double>(per);
        const double down = step * (static_cast<double>(y) - place.row) - table.first_row;
        const double right = step * (static_cast<double>(x) - place.column) - table.first_column;
        const double rest = down - std::floor(down), aside = right - std::floor(right);
        double sum = 0.0;
        for (std::size_t n = 0; n < terms; ++n) {
            for (std::size_t i = 0; i < 2; ++i) {
                for (std::size_t j = 0; j < 2; ++j) {
                    const double weight = (i == 0 ? 1.0 - rest : rest) * (j == 0 ? 1.0 - aside : aside);
                    sum += weight * std::cos(static_cast<double>(n) * std::acos(z)) *
                           static_cast<double>(coefficients[index(piece * terms + n, static_cast<std::size_t>(down) + i,
                                                                  static_cast<std::size_t>(right) + j)]);
                }
            }
        }
        return sum;
    }
};

void images_are_plain_sums(const Made& made, std::mt19937& random) {
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    const lommel::MoleculeTable& table = made.table;
    for (const lommel::Level level : {lommel::Level::portable, lommel::Level::avx2, lommel::Level::avx512}) {
        lommel::level_limit() = level;
        lommel::MoleculeImages images(table);
        lommel::Floats four(lommel::molecule_images * table.pixels());
        for (int k = 0; k < 4; ++k) {
            const lommel::Place place{0.5 * static_cast<double>(table.height - 1) + (k == 0 ? 1.0 : any(random)),
                                      0.5 * static_cast<double>(table.width - 1) + (k == 0 ? -1.0 : any(random)),
                                      k == 0 ? 1.0 : any(random)};
            images.write(place, four.data());
            double worst = 0.0;
            for (std::size_t y = 0; y < table.height; ++y) {
                for (std::size_t x = 0; x < table.width; ++x) {
                    worst =
                        std::max(worst, std::abs(static_cast<double>(four[y * table.stride() + x]) - made.value(place, y, x)));
                }
            }
            check(worst < 3e-6, "an image of a molecule", worst);
        }
    }
    lommel::level_limit() = lommel::Level::avx512;
}

void fits_find_what_is_there(const Made& made, std::mt19937& random) {
    const lommel::MoleculeTable& table = made.table;
    const std::size_t count = 130, pixels = table.height * table.width;
    std::uniform_real_distribution<double> any(-0.6, 0.6);
    std::normal_distribution<double> normal;
    std::vector<float> electrons(count * pixels), read(pixels, 2.0F);
    std::vector<double> rows;
    for (std::size_t k = 0; k < count; ++k) {
        const lommel::Place place{0.5 * static_cast<double>(table.height - 1) + any(random),
                                  0.5 * static_cast<double>(table.width - 1) + any(random), any(random)};
        rows.push_back(place.row);
        for (std::size_t i = 0; i < pixels; ++i) {
            const double mean = 900.0 * made.value(place, i / table.width, i % table.width) + 4.0;
            electrons[k * pixels + i] = i == 5 ? std::nanf("") : static_cast<float>(mean + std::sqrt(mean) * normal(random));
        }
    }
    std::vector<lommel::Place> places;
    for (const double z : {-0.5, 0.5}) {
        for (int k = 0; k < 9; ++k) {
            places.push_back({0.5 * static_cast<double>(table.height - 1) + 0.5 * (k / 3 - 1),
                              0.5 * static_cast<double>(table.width - 1) + 0.5 * (k % 3 - 1), z});
        }
    }
    const lommel::Limits limits{
        {table.least_row, table.least_column, -1.0}, {table.largest_row, table.largest_column, 1.0}, 0.5};
    const lommel::Localizer one({{table, {1.0, 0.0, 0.0, 1.0}}}, limits, places, 9);
    const std::vector<double> offsets(4 * count, 0.0);
    std::vector<lommel::Fitted> alone(count), together(count), both(count);
    one.fit({{electrons.data(), read.data(), 0}}, offsets.data(), count, 3, false, 1, alone.data());
    one.fit({{electrons.data(), read.data(), 0}}, offsets.data(), count, 3, false, 4, together.data());
    double off = 0.0, apart = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
        off += std::pow(alone[k].value[0] - rows[k], 2) / static_cast<double>(count);
        apart = std::max(apart, std::abs(alone[k].value[0] - together[k].value[0]));
    }
    check(std::sqrt(off) < 0.25, "rows of molecules", std::sqrt(off));
    check(apart == 0.0, "rows by other threads", apart);
    // The same seen twice tells no other place.
    const lommel::Channel channel{table, {1.0, 0.0, 0.0, 1.0}};
    const lommel::Localizer two({channel, channel}, limits, places, 9);
    const lommel::BoxStack stack{electrons.data(), read.data(), 0};
    two.fit({stack, stack}, offsets.data(), count, 3, true, 2, both.data());
    std::size_t different = 0;
    for (std::size_t k = 0; k < count; ++k) {
        different += std::abs(both[k].value[0] - alone[k].value[0]) > 0.02 ? 1 : 0;
    }
    check(different <= count / 20, "rows from two channels", static_cast<double>(different));
}

}  // namespace

int main() {
    std::mt19937 random(5);
    for (const std::size_t per : {std::size_t{2}, std::size_t{3}}) {
        for (const std::size_t side : {std::size_t{1}, std::size_t{9}, std::size_t{17}}) {
            const Made made(side, side + 3, per, per, random);
            images_are_plain_sums(made, random);
        }
    }
    const Made made(9, 11, 2, 2, random);
    run({[&] {
             std::mt19937 own(1);
             fits_find_what_is_there(made, own);
         },
         [&] {
             std::mt19937 own(2);
             fits_find_what_is_there(made, own);
         }});
    return finished();
}
