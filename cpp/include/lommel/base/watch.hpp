// Interruption of long calls (Ctrl-C), checked at points where a call can be left safely.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <ctime>

namespace lommel {

struct Stopped {};  // exception that look() throws to interrupt a call

// While a Watch exists, the thread that constructed it calls ask() within look(), at most every 50 ms. Once ask() has returned
// true, look() throws in that thread and in all threads that help it.
class Watch {
   public:
    using Ask = bool (*)();

    explicit Watch(Ask ask) : ask_(ask), next_(now() + interval.count()), before_(seat()) {
        if (ask != nullptr) {
            seat() = {this, true};
        }
    }
    ~Watch() { seat() = before_; }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

    static constexpr std::chrono::milliseconds interval{50};

    // The Watch that look() checks in this thread, or null.
    static Watch* mine() { return seat().watch; }
    // Set the Watch that a helper thread checks; only the thread that constructed the Watch calls its ask().
    static void help(Watch* watch) { seat() = {watch, false}; }

    static void look() {
        const Seat here = seat();
        if (here.watch != nullptr) {
            here.watch->look(here.asks);
        }
    }

   private:
    // Time in milliseconds, from the coarse clock where the system has one: reading it takes a tenth of the time.
    static std::int64_t now() {
#if defined(CLOCK_MONOTONIC_COARSE)
        std::timespec t;
        clock_gettime(CLOCK_MONOTONIC_COARSE, &t);
        return std::int64_t{t.tv_sec} * 1000 + t.tv_nsec / 1000000;
#else
        return std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now().time_since_epoch())
            .count();
#endif
    }

    struct Seat {
        Watch* watch = nullptr;
        bool asks = false;
    };
    static Seat& seat() {
        thread_local Seat mine;
        return mine;
    }

    void look(bool asks) {
        if (asks && !stopped_.load(std::memory_order_relaxed)) {
            const std::int64_t here = now();
            if (here < next_) {
                return;
            }
            next_ = here + interval.count();
            if (ask_()) {
                stopped_.store(true, std::memory_order_relaxed);
            }
        }
        if (stopped_.load(std::memory_order_relaxed)) {
            throw Stopped();
        }
    }

    Ask ask_;
    std::int64_t next_;
    Seat before_;
    std::atomic<bool> stopped_{false};
};

// Throw Stopped if the call is to be interrupted. This check takes about 10 ns: it is for loops whose steps take microseconds.
inline void look() { Watch::look(); }

// Check for interruption in loops with short steps: look() is called after every 2^14 operations (some microseconds) of `work`.
class Glance {
   public:
    void operator()(std::size_t work = 1) {
        done_ += work;
        if (done_ >= enough) {
            done_ = 0;
            look();
        }
    }

   private:
    static constexpr std::size_t enough = 1 << 14;
    std::size_t done_ = 0;
};

}  // namespace lommel
