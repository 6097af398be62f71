// Tables of molecule images, and fits with them.
#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <nanobind/stl/array.h>

#include "lommel/localize/bank.hpp"

#include "python.hpp"

using namespace bindings;

namespace {

// Molecule table with the arrays that it refers to.
class Table {
   public:
    // coefficients: those of lommel::MoleculeTable, flat. sizes: pieces, rows, samples per pixel, columns, height, width.
    // numbers: first row and column, smallest and largest z, row and column (smallest, largest for each).
    Table(In<float, 1> coefficients, In<double, 2> polynomials, const std::array<std::size_t, 6>& sizes,
          const std::array<double, 8>& numbers)
        : coefficients_(std::move(coefficients)), polynomials_(std::move(polynomials)) {
        const auto [pieces, rows, per, columns, height, width] = sizes;
        const auto [first_row, first_column, low, high, least_row, largest_row, least_column, largest_column] = numbers;
        const std::size_t powers = polynomials_.shape(0), taps = polynomials_.shape(1);
        table_ = {coefficients_.data(),
                  pieces,
                  rows,
                  per,
                  columns,
                  height,
                  width,
                  polynomials_.data(),
                  powers,
                  taps,
                  first_row,
                  first_column,
                  low,
                  high,
                  least_row,
                  largest_row,
                  least_column,
                  largest_column};
        require(low < high && std::isfinite(high - low) && least_row <= largest_row && least_column <= largest_column,
                "limits must rise");
    }

    // Values and derivatives with respect to row, column and z at places (n, 3), shape (n, 4, height, width).
    Out<float, 4> images(const In<double, 2>& places, int threads) const {
        const std::size_t n = places.shape(0);
        for (std::size_t i = 0; i < n; ++i) {
            const double* const p = places.data() + 3 * i;
            require(p[0] >= table_.least_row && p[0] <= table_.largest_row && p[1] >= table_.least_column &&
                        p[1] <= table_.largest_column && p[2] >= table_.low && p[2] <= table_.high,
                    "places must be within the table");
        }
        auto made = new_array<float, 4>({n, lommel::molecule_images, table_.height, table_.width});
        released([&] { lommel::molecule_stack(table_, places.data(), n, threads, made.data()); });
        return made;
    }

    const lommel::MoleculeTable& table() const { return table_; }

   private:
    In<float, 1> coefficients_;
    In<double, 2> polynomials_;
    lommel::MoleculeTable table_;
};

// Table; limits (2, 3) of row, column and z; largest step in z; positions of templates (z, places, 3).
class Fitter {
   public:
    Fitter(const nb::typed<nb::object, Table>& table, const In<double, 2>& limits, double stride, const In<double, 3>& places)
        : owner_(table), table_(nb::cast<const Table&>(table).table()) {
        lommel::Limits all{};
        std::copy_n(limits.data(), 3, all.low);
        std::copy_n(limits.data() + 3, 3, all.high);
        all.stride = stride;
        std::vector<lommel::Place> starts;
        for (std::size_t i = 0; i < places.shape(0) * places.shape(1); ++i) {
            const double* const p = places.data() + 3 * i;
            starts.push_back(table_.within({p[0], p[1], p[2]}));
        }
        localizer_.emplace(table_, all, starts, places.shape(1));
    }

    // images: electrons, (n, height, width), NaN for invalid pixels; reads: read variance, (n or 1, height, width). Returns unknowns
    // and their standard errors, (n, k) each; deviance and discrepancy, (n, 2); state and number of steps, (n, 2). See
    // lommel::Fitted.
    std::tuple<Out<double, 2>, Out<double, 2>, Out<double, 2>, Out<std::int32_t, 2>> fit(const In<float, 3>& images,
                                                                                         const In<float, 3>& reads, int starts,
                                                                                         bool tilted, int threads) const {
        const std::size_t n = images.shape(0), unknown = tilted ? 7 : 5;
        const lommel::BoxStack stack{images.data(), reads.data(), reads.shape(0) == 1 ? 0 : table_.height * table_.width};
        std::vector<lommel::Fitted> fitted(n);
        released([&] { localizer_->fit(stack, n, starts, tilted, threads, fitted.data()); });
        auto value = new_array<double, 2>({n, unknown}), errors = new_array<double, 2>({n, unknown});
        auto likely = new_array<double, 2>({n, 2});
        auto state = new_array<std::int32_t, 2>({n, 2});
        for (std::size_t i = 0; i < n; ++i) {
            std::copy_n(fitted[i].value.begin(), unknown, value.data() + i * unknown);
            std::copy_n(fitted[i].errors.begin(), unknown, errors.data() + i * unknown);
            likely.data()[2 * i] = fitted[i].deviance;
            likely.data()[2 * i + 1] = fitted[i].discrepancy;
            state.data()[2 * i] = static_cast<std::int32_t>(fitted[i].state);
            state.data()[2 * i + 1] = fitted[i].steps;
        }
        return {value, errors, likely, state};
    }

   private:
    nb::object owner_;  // keeps the table alive
    lommel::MoleculeTable table_;
    std::optional<lommel::Localizer> localizer_;
};

}  // namespace

void bindings::define_localize(nb::module_& m) {
    nb::class_<Table>(m, "MoleculeTable", "Images of a molecule anywhere, by few products a pixel.")
        .def(nb::init<In<float, 1>, In<double, 2>, const std::array<std::size_t, 6>&, const std::array<double, 8>&>(),
             "coefficients"_a, "polynomials"_a, "sizes"_a, "numbers"_a)
        .def("images", &Table::images, "places"_a, "threads"_a, "Values and slopes by row, column and z.")
        .def_prop_ro_static(
            "terms", [](nb::handle) { return lommel::MoleculeTable::terms; }, "Coefficients of each piece.")
        .def_prop_ro_static("beyond", [](nb::handle) { return lommel::MoleculeTable::beyond; }, "Floats after the last.");
    nb::class_<Fitter>(m, "MoleculeFitter", "Fits of molecules by maximum likelihood.")
        .def(nb::init<const nb::typed<nb::object, Table>&, const In<double, 2>&, double, const In<double, 3>&>(), "table"_a,
             "limits"_a, "stride"_a, "places"_a)
        .def("fit", &Fitter::fit, "images"_a, "reads"_a, "starts"_a, "tilted"_a, "threads"_a,
             "Unknowns, their errors, deviance and discrepancy, state and steps.");
}
