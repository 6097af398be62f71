// Mutex and lock guard, which do nothing if LOMMEL_SINGLE_THREADED is defined.
#pragma once

// LOMMEL_SINGLE_THREADED: all work is done in the calling thread, and only one thread may call. It is defined by the user, or
// here if the target has no threads. The headers then include no <thread>, <mutex>, <condition_variable> or <pthread.h>.
#if !defined(LOMMEL_SINGLE_THREADED) && (!defined(__STDCPP_THREADS__) || (defined(__wasm__) && !defined(_REENTRANT)))
#define LOMMEL_SINGLE_THREADED
#endif

#if !defined(LOMMEL_SINGLE_THREADED)
#include <mutex>
#endif

namespace lommel {

#if defined(LOMMEL_SINGLE_THREADED)
struct Mutex {
    void lock() {}
    void unlock() {}
};
struct Lock {
    explicit Lock(Mutex&) {}
};
#else
using Mutex = std::mutex;
using Lock = std::lock_guard<std::mutex>;
#endif

}  // namespace lommel
