// Checks that print where they fail.
#pragma once

#include <atomic>
#include <cstdio>
#include <functional>
#include <vector>

#include "lommel/base/lock.hpp"

#if !defined(LOMMEL_SINGLE_THREADED)
#include <thread>
#endif

inline std::atomic<int> failures{0};

inline void check(bool good, const char* what, double value) {
    if (!good) {
        std::printf("FAILED: %s (%.3g)\n", what, value);
        ++failures;
    }
}

// What a program returns.
inline int finished() {
    std::printf(failures == 0 ? "all good\n" : "%d failures\n", failures.load());
    return failures == 0 ? 0 : 1;
}

// All at once, in a thread each, where there are threads.
inline void run(const std::vector<std::function<void()>>& callers) {
#if defined(LOMMEL_SINGLE_THREADED)
    for (const auto& caller : callers) {
        caller();
    }
#else
    std::vector<std::thread> threads(callers.begin(), callers.end());
    for (std::thread& thread : threads) {
        thread.join();
    }
#endif
}
