// Process-wide state of each core module: exceptions, signals, instruction set, and the caches shared by all calls.
#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "lommel/base/cache.hpp"
#include "lommel/base/fork.hpp"
#include "lommel/base/simd.hpp"
#include "lommel/limits.hpp"

#include "python.hpp"

#if defined(__GLIBC__)
#include <malloc.h>
#endif

using namespace bindings;

namespace {

// Identifier of the thread in which Python runs signal handlers; after fork(), in the child, the thread that called fork().
struct MainThread final : lommel::ForkAware {
    unsigned long id = 0;

   private:
    void after_fork(bool in_child) override {
        if (in_child) {
            id = PyThread_get_thread_ident();
        }
    }
};
MainThread& main_thread = *new MainThread;

// If `threading` has not been imported, the importing thread is the only one; importing it here would take as long as loading
// this module.
unsigned long this_or_main_thread() {
    const nb::object threads = nb::steal(PyImport_GetModule(nb::str("threading").ptr()));
    return threads.is_valid() ? nb::cast<unsigned long>(threads.attr("main_thread")().attr("ident"))
                              : PyThread_get_thread_ident();
}

bool signalled() {
    const nb::gil_scoped_acquire gil;
    return PyErr_CheckSignals() != 0;
}

constexpr const char* levels[] = {"portable", "avx2", "avx512"};  // in the order of lommel::Level

const char* instructions() { return levels[static_cast<int>(lommel::processor_level())]; }

void limit_instructions(const std::string& level) {
    const auto found = std::find(std::begin(levels), std::end(levels), level);
    require(found != std::end(levels), "level must be portable, avx2 or avx512");
    lommel::level_limit() = static_cast<lommel::Level>(found - std::begin(levels));
}

void clear_caches() {
    released([] {
        lommel::Shared::clear_all();
#if defined(__GLIBC__)
        malloc_trim(0);  // return freed memory to the system, which glibc otherwise keeps
#endif
    });
}

}  // namespace

lommel::Watch::Ask bindings::ask_python() { return PyThread_get_thread_ident() == main_thread.id ? &signalled : nullptr; }

void bindings::define_process(nb::module_& m) {
    // Python keeps objects alive until the process ends, plans among them; nanobind would report these as leaks.
    nb::set_leak_warnings(false);
    main_thread.id = this_or_main_thread();
    // Stopped: the signal handler that stopped the call has already set the exception. LimitExceeded becomes Declined, a
    // ValueError: callers then try the next method, but not after a programming error.
    nb::register_exception_translator([](const std::exception_ptr& thrown, void*) {
        try {
            std::rethrow_exception(thrown);
        } catch (const lommel::Stopped&) {
        } catch (const lommel::LimitExceeded& failure) {
            PyErr_SetString(nb::module_::import_("lommel.core.answers").attr("Declined").ptr(), failure.what());
        }
    });
    m.def(
        "cached_bytes", [] { return std::make_pair(lommel::Shared::bytes_kept(), lommel::Shared::bytes_limit()); },
        "Bytes of the tables that calls share, and the sum of the limits of all kinds.");
    m.def("clear_caches", &clear_caches, "Drop the tables that calls share, and return the memory to the system.");
    m.def("instructions", &instructions, "The widest instructions in use: portable, avx2 or avx512.");
    m.def("limit_instructions", &limit_instructions, "level"_a, "Use no wider instructions than these.");
}
