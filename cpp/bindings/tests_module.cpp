// The Python module of functions for tests only.
#include "tests.hpp"

using namespace bindings;

NB_MODULE(_core_tests, m) {
    m.doc() = "Functions of the core that only tests call.";
    define_radial_tests(m);
    define_disk_tests(m);
    define_average_tests(m);
    define_table_tests(m);
    define_process(m);
}
