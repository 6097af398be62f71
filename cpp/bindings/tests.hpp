// Functions for tests only: each term of the error bounds, to be compared with the formulas of docs/certificate.md. No image
// is computed from them, and users do not compile them.
#pragma once

#include <nanobind/stl/vector.h>

#include <algorithm>
#include <vector>

#include "lommel/base/aligned.hpp"

#include "pupils.hpp"

namespace bindings {

// Each defined in the source file of this name.
void define_radial_tests(nb::module_& m);
void define_disk_tests(nb::module_& m);
void define_average_tests(nb::module_& m);
void define_table_tests(nb::module_& m);

using Doubles1 = In<double, 1>;
using Terms = In<std::int64_t, 2>;
using Named = nb::typed<nb::dict, nb::str, nb::object>;

template <class... Values>
Named named(const Values&... values) {
    nb::dict made;
    ((made[values.name_] = values.value), ...);
    return nb::cast<Named>(made);
}
inline std::vector<double> listed(const lommel::Doubles& values) { return {values.begin(), values.end()}; }
template <class F>
std::vector<double> each(const Doubles1& at, const F& f) {
    std::vector<double> values(at.size());
    std::transform(at.data(), at.data() + at.size(), values.begin(), f);
    return values;
}

}  // namespace bindings
