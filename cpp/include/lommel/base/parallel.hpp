// Thread pool: all callers together never use more threads than there are processors.
#pragma once

#include <cstddef>

#include "lommel/base/fork.hpp"
#include "lommel/base/lock.hpp"
#include "lommel/base/once.hpp"
#include "lommel/base/reference.hpp"
#include "lommel/base/watch.hpp"

#if !defined(LOMMEL_SINGLE_THREADED)
#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <thread>
#include <vector>
#if defined(__linux__)
#include <sched.h>
#endif
#endif

namespace lommel {

#if defined(LOMMEL_SINGLE_THREADED)
inline int processors() { return 1; }
inline void give_way() {}
#else
// While another thread is waited for that is at work.
inline void give_way() { std::this_thread::yield(); }

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

// Helper threads of all calls together; the callers' own threads do not count. A child begins with none.
struct Helpers final : ForkAware {
    std::atomic<int> at_work{0};

   private:
    void after_fork(bool in_child) override {
        if (in_child) {
            at_work = 0;
        }
    }
};
inline Helpers& helpers = *new Helpers;

// parallel_for() with helpers.
using Work = Reference<void(std::size_t worker, std::size_t task)>;
void share_out(std::size_t tasks, int threads, const Work& work);
#if defined(LOMMEL_DEFINES)
LOMMEL_ONCE void share_out(std::size_t tasks, int threads, const Work& work) {
    const int limit = processors();
    int wanted = std::min<int>(threads > 0 ? threads : limit, static_cast<int>(std::min<std::size_t>(tasks, 1024))) - 1;
    // Take from the common pool no more than is left in it.
    std::atomic<int>& busy = helpers.at_work;
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
    Mutex mutex;  // of the failure and of the number of helpers that are done
    std::condition_variable finished;
    std::size_t done = 0;
    const auto fail = [&] {
        next = tasks;
        const Lock lock(mutex);
        failure = failure ? failure : std::current_exception();
    };
    const auto run = [&](std::size_t worker) {
        try {
            for (std::size_t task = next++; task < tasks; task = next++) {
                look();
                work(worker, task);
            }
        } catch (...) {
            fail();
        }
    };
    Watch* const watch = Watch::mine();
    std::vector<std::thread> others;
    try {
        for (int i = 0; i < taken; ++i) {
            others.emplace_back([&, i] {
                Watch::help(watch);
                run(static_cast<std::size_t>(i + 1));
                const Lock lock(mutex);
                ++done;
                finished.notify_one();
            });
        }
    } catch (...) {
        // The system grants no more threads; those it granted, and the caller, do the work.
    }
    run(0);
    // The caller alone is asked to stop: it goes on looking while others work.
    std::unique_lock<Mutex> lock(mutex);
    while (watch != nullptr && !finished.wait_for(lock, Watch::interval, [&] { return done == others.size(); })) {
        lock.unlock();
        try {
            look();
        } catch (...) {
            fail();
        }
        lock.lock();
    }
    lock.unlock();
    for (std::thread& other : others) {
        other.join();
    }
    busy -= taken;
    if (failure) {
        std::rethrow_exception(failure);
    }
}
#endif
#endif

// Runs work(worker, task) for every task below `tasks`, each once, on at most `threads` threads including the
// caller's (0: as many as there are processors). `worker` is below the number of processors and 1.
// The first exception is passed on after all threads have stopped. All look between tasks.
template <class Work>
void parallel_for(std::size_t tasks, [[maybe_unused]] int threads, const Work& work) {
#if !defined(LOMMEL_SINGLE_THREADED)
    if (tasks > 1 && threads != 1) {
        return share_out(tasks, threads, work);
    }
#endif
    for (std::size_t task = 0; task < tasks; ++task) {
        look();
        work(std::size_t{0}, task);
    }
}

}  // namespace lommel
