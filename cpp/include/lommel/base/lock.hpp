// Locks, which are empty where the platform has no threads.
#pragma once

// Defined by whoever wants all work done in the thread that calls, or here where the target has no threads. No header of the
// core then needs <thread>, <mutex>, <condition_variable> or <pthread.h>, and only one thread may call.
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
