// Threads that never outnumber the processors, however many callers there are.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#if defined(__linux__)
#include <sched.h>
#endif

namespace lommel {

// Processors this process may run on.
inline int processors() {
#if defined(__linux__)
    cpu_set_t set;
    if (sched_getaffinity(0, sizeof set, &set) == 0) {
        return std::max(1, CPU_COUNT(&set));
    }
#endif
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

// Helper threads of all calls together; the callers' own threads do not count.
inline std::atomic<int>& helpers_at_work() {
    static std::atomic<int> count{0};
    return count;
}

// Runs work(worker, task) for every task below `tasks`, each once, on at most `threads` threads including the
// caller's (0: as many as there are processors). `worker` is below the returned number of threads used at most.
// The first exception is passed on after all threads have stopped.
template <class Work>
void parallel_for(std::size_t tasks, int threads, const Work& work) {
    if (tasks < 2 || threads == 1) {
        for (std::size_t task = 0; task < tasks; ++task) {
            work(std::size_t{0}, task);
        }
        return;
    }
    const int limit = processors();
    int wanted = std::min<int>(threads > 0 ? threads : limit, static_cast<int>(std::min<std::size_t>(tasks, 1024))) - 1;
    // Take from the common pool no more than is left in it.
    std::atomic<int>& busy = helpers_at_work();
    int taken = 0, now = busy.load();
    while (wanted > 0) {
        const int can = std::min(wanted, limit - 1 - now);
        if (can <= 0) {
            break;
        }
        if (busy.compare_exchange_weak(now, now + can)) {
            taken = can;
            break;
        }
    }
    std::atomic<std::size_t> next{0};
    std::exception_ptr failure;
    std::mutex failure_mutex;
    const auto run = [&](std::size_t worker) {
        try {
            for (std::size_t task = next++; task < tasks; task = next++) {
                work(worker, task);
            }
        } catch (...) {
            next = tasks;
            const std::lock_guard<std::mutex> lock(failure_mutex);
            failure = failure ? failure : std::current_exception();
        }
    };
    std::vector<std::thread> helpers;
    try {
        for (int i = 0; i < taken; ++i) {
            helpers.emplace_back(run, static_cast<std::size_t>(i + 1));
        }
    } catch (...) {
        // The system grants no more threads; those it granted, and the caller, do the work.
    }
    run(0);
    for (std::thread& helper : helpers) {
        helper.join();
    }
    busy -= taken;
    if (failure) {
        std::rethrow_exception(failure);
    }
}

}  // namespace lommel
