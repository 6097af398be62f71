// Thread pool: all callers share the same helper threads, at most one fewer than there are processors.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "lommel/base/fork.hpp"
#include "lommel/base/lock.hpp"
#include "lommel/base/reference.hpp"
#include "lommel/base/watch.hpp"

#if !defined(LOMMEL_SINGLE_THREADED)
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <new>
#include <thread>
#include <vector>
#if defined(LOMMEL_FORKS)
#include <csignal>
#endif
#if defined(__linux__)
#include <sched.h>
#endif
#endif

namespace lommel {

#if defined(LOMMEL_SINGLE_THREADED)
inline int processors() { return 1; }
inline std::size_t workers(int) { return 1; }
inline void give_way() {}
#else
// Yield the processor, in a loop that waits for another thread.
inline void give_way() { std::this_thread::yield(); }

// Number of processors that this process may use: on Linux, those of its affinity mask.
inline int processors() {
#if defined(__linux__)
    cpu_set_t set;
    if (sched_getaffinity(0, sizeof set, &set) == 0) {
        return std::max(1, CPU_COUNT(&set));
    }
#endif
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

// Number of threads that share a loop, including the caller's: at most `threads` (0: no limit) and the number of processors.
inline std::size_t workers(int threads) {
    return static_cast<std::size_t>(threads > 0 ? std::min(threads, processors()) : processors());
}

// Pool of helper threads, created when first needed and asleep between calls. A forked child begins without helpers.
class Helpers final : ForkAware {
   public:
    // Work that a caller, worker 0, shares with helpers: these call run(worker) with worker = 1, 2, ...; run() must not throw.
    struct Offer {
        Reference<void(std::size_t)> run;
        Watch* watch;
        int open = 0;   // number of helpers still requested
        int taken = 0;  // number of helpers that have joined
        std::atomic<int> at_work{0};
        std::condition_variable left{};  // notified when the last helper has left
    };

    // Request up to `wanted` helpers for the offer `one`, which must exist until withdraw() has returned.
    void offer(Offer& one, int wanted) {
        {
            const Lock lock(mutex_);
            one.open = wanted;
            open_ += wanted;
            offers_.push_back(&one);
            const int most = std::min(processors() - 1, at_work_ + wanted);
            while (made_ < most && make()) {
            }
        }
        wake(wanted);
    }

    // Let no more helpers join an offer; wait for those at work. fail() is called, in a catch clause, if the wait is interrupted.
    template <class Fail>
    void withdraw(Offer& one, const Fail& fail) {
        const auto done = [&] { return one.at_work == 0; };
        std::unique_lock<Mutex> lock(mutex_);
        open_ -= one.open;
        one.open = 0;
        offers_.erase(std::find(offers_.begin(), offers_.end(), &one));
        lock.unlock();
        await(done);
        lock.lock();
        while (!one.left.wait_for(lock, Watch::interval, done)) {
            lock.unlock();
            try {
                look();
            } catch (...) {
                fail();
            }
            lock.lock();
        }
    }

    int at_work() {
        const Lock lock(mutex_);
        return at_work_;
    }

   private:
    // Create a helper with all signals blocked, so that the application receives them; false if the system refuses.
    bool make() {
#if defined(LOMMEL_FORKS)
        sigset_t all, before;
        sigfillset(&all);
        pthread_sigmask(SIG_BLOCK, &all, &before);
#endif
        bool granted = true;
        try {
            std::thread([this] { serve(); }).detach();
            ++made_;
        } catch (...) {
            granted = false;  // the system refused a thread: existing ones do the work
        }
#if defined(LOMMEL_FORKS)
        pthread_sigmask(SIG_SETMASK, &before, nullptr);
#endif
        return granted;
    }

    // Poll done() for at most 50 us, about the time that a thread needs to fall asleep and wake.
    template <class Done>
    static void await(const Done& done) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::microseconds(50);
        while (!done() && std::chrono::steady_clock::now() < end) {
            give_way();
        }
    }

    // Each woken thread wakes two more, so that the caller need not wake all.
    void wake(int wanted) {
        for (int i = 0; i < std::min(2, wanted); ++i) {
            wake_.notify_one();
        }
    }

    void serve() {
#if defined(__linux__)
        pthread_setname_np(pthread_self(), "lommel");
#endif
        std::unique_lock<Mutex> lock(mutex_);
        for (;;) {
            const auto found = std::find_if(offers_.begin(), offers_.end(), [](const Offer* one) { return one->open > 0; });
            if (found == offers_.end() || at_work_ >= processors() - 1) {
                wake_.wait(lock);
                continue;
            }
            Offer& one = **found;
            const int others = --one.open;
            --open_;
            const auto worker = static_cast<std::size_t>(++one.taken);
            ++one.at_work;
            ++at_work_;
            lock.unlock();
            wake(others);
            Watch::help(one.watch);
            one.run(worker);
            Watch::help(nullptr);
            lock.lock();
            --at_work_;
            if (--one.at_work == 0) {
                one.left.notify_one();
            }
            lock.unlock();
            await([this] { return open_ > 0; });
            lock.lock();
        }
    }

    void before_fork() override { mutex_.lock(); }
    void after_fork(bool in_child) override {
        if (in_child) {
            made_ = at_work_ = open_ = 0;
            offers_.clear();
            new (&wake_) std::condition_variable;  // initialized anew: the child has no waiting threads
        }
        mutex_.unlock();
    }

    Mutex mutex_;  // guards all members, and the members of offers
    std::condition_variable wake_;
    std::vector<Offer*> offers_;
    int made_ = 0, at_work_ = 0;
    std::atomic<int> open_{0};
};
inline Helpers& helpers = *new Helpers;

// Implementation of parallel_for() for more than one thread.
using Work = Reference<void(std::size_t worker, std::size_t task)>;
inline void share_out(std::size_t tasks, int threads, const Work& work) {
    // The tasks are cut into `stretches` stretches, each of one range per worker (at most `most` ranges). In each stretch a worker
    // begins with its own range and then helps others: it mostly runs neighbouring tasks, and the same ones in the next call, whose
    // data are in its processor's cache. Worker 0, the caller, takes tasks in ascending order: a task may wait for earlier tasks.
    struct alignas(64) Range {
        std::atomic<std::size_t> next{0};
        std::size_t end = 0;
    };
    constexpr std::size_t stretches = 4, most = 16;
    std::array<Range, stretches * most> ranges;
    const std::size_t wanted = std::min(tasks, workers(threads));
    const std::size_t count = std::min(wanted, most);
    for (std::size_t r = 0; r < stretches * count; ++r) {
        ranges[r].next = tasks * r / (stretches * count);
        ranges[r].end = tasks * (r + 1) / (stretches * count);
    }
    std::atomic<bool> failed{false};
    std::exception_ptr failure;
    Mutex mutex;  // guards `failure`, the first exception
    const auto fail = [&] {
        failed = true;
        const Lock lock(mutex);
        failure = failure ? failure : std::current_exception();
    };
    const auto run = [&](std::size_t worker) {
        try {
            for (std::size_t r = 0; r < stretches * count; ++r) {
                Range& range = ranges[r / count * count + (worker + r) % count];
                while (range.next < range.end && !failed) {
                    const std::size_t task = range.next++;
                    if (task < range.end) {
                        look();
                        work(worker, task);
                    }
                }
            }
        } catch (...) {
            fail();
        }
    };
    Helpers::Offer offer{run, Watch::mine()};
    helpers.offer(offer, static_cast<int>(wanted) - 1);
    run(0);
    helpers.withdraw(offer, fail);
    if (failure) {
        std::rethrow_exception(failure);
    }
}
#endif

// Run work(worker, task) once for every task below `tasks`, on at most `threads` threads including the caller's (0: one for
// each processor). `worker` is below the number of processors. The first exception is rethrown after all threads have stopped.
// All threads check for interruption between tasks.
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
