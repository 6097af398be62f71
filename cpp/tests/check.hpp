// What programs that exercise the core say where it is wrong.
#pragma once

#include <atomic>
#include <cstdio>

inline std::atomic<int> failures{0};

inline void check(bool good, const char* what, double value) {
    if (!good) {
        std::printf("FAILED: %s (%.3g)\n", what, value);
        ++failures;
    }
}
