// Cache of tables shared by all calls, with a size limit.
#pragma once

#include <atomic>
#include <cstddef>
#include <iterator>
#include <list>
#include <memory>
#include <numeric>
#include <vector>

#include "lommel/base/fork.hpp"
#include "lommel/base/lock.hpp"
#include "lommel/base/watch.hpp"

#if !defined(LOMMEL_SINGLE_THREADED)
#include <chrono>
#include <thread>
#endif

namespace lommel {

// Lock held while a thread computes a table, which may take seconds. Unlike with a mutex, threads that wait for it can be
// interrupted; in a forked child the lock is free, whichever thread held it.
class Turn {
   public:
    class Taken {
       public:
        explicit Taken(Turn& turn) : turn_(turn) {
            while (turn.taken_.exchange(true, std::memory_order_acquire)) {
                look();
#if !defined(LOMMEL_SINGLE_THREADED)
                std::this_thread::sleep_for(std::chrono::microseconds(50));
#endif
            }
        }
        ~Taken() { turn_.taken_.store(false, std::memory_order_release); }
        Taken(const Taken&) = delete;
        Taken& operator=(const Taken&) = delete;

       private:
        Turn& turn_;
    };
    void free() { taken_.store(false, std::memory_order_release); }

   private:
    std::atomic<bool> taken_{false};
};

// Base of the caches that all calls share, constructed when the program is loaded. mutex_ guards look-ups and changes; turn_
// guards computations of tables. A computation must not hold mutex_: it may wait for Python's lock while a thread that holds this
// lock is in fork() and waits for mutex_.
class Shared : protected ForkAware {
   public:
    // bytes_kept(): size of the tables in all caches. bytes_limit(): sum of the limits of the caches, which bytes_kept() may
    // exceed, as a cache keeps its last two tables whatever their size.
    static std::size_t bytes_kept() {
        return std::accumulate(all().begin(), all().end(), std::size_t{0},
                               [](std::size_t sum, Shared* one) { return sum + one->kept(); });
    }
    static std::size_t bytes_limit() {
        return std::accumulate(all().begin(), all().end(), std::size_t{0},
                               [](std::size_t sum, const Shared* one) { return sum + one->limit(); });
    }
    // Drop all tables. Running calls keep the tables they use until they return, and may add a table that they compute.
    static void clear_all() {
        for (Shared* one : all()) {
            one->clear();
        }
    }

   protected:
    Shared() { all().push_back(this); }
    ~Shared() = default;

    Mutex mutex_;
    Turn turn_;

   private:
    virtual std::size_t kept() = 0;
    virtual std::size_t limit() const = 0;
    virtual void clear() = 0;

    static std::vector<Shared*>& all() {
        static std::vector<Shared*>& list = *new std::vector<Shared*>;
        return list;
    }
    void before_fork() override { mutex_.lock(); }
    void after_fork(bool in_child) override {
        mutex_.unlock();
        if (in_child) {
            turn_.free();
        }
    }
};

// Cache of tables of one type: the most recently used, up to Table::most_bytes, and always the last two, as images may alternate
// between tables for an aperture and for its obscuration. Table::is() compares the key from which a table is constructed.
template <class Table>
class Cache final : Shared {
   public:
    template <class... Key>
    std::shared_ptr<const Table> get(const Key&... key) {
        if (auto found = held(key...)) {
            return found;
        }
        const Turn::Taken turn(turn_);
        if (auto found = held(key...)) {
            return found;
        }
        const auto made = std::make_shared<const Table>(key...);
        const Lock lock(mutex_);
        recent_.push_front(made);
        std::size_t bytes = 0;
        for (auto at = recent_.begin(); at != recent_.end();) {
            bytes += (*at)->bytes();
            const bool last_two = at == recent_.begin() || at == std::next(recent_.begin());
            at = bytes > Table::most_bytes && !last_two ? recent_.erase(at) : std::next(at);
        }
        return made;
    }

   private:
    using Tables = std::list<std::shared_ptr<const Table>>;

    template <class... Key>
    std::shared_ptr<const Table> held(const Key&... key) {
        const Lock lock(mutex_);
        for (auto at = recent_.begin(); at != recent_.end(); ++at) {
            if ((*at)->is(key...)) {
                recent_.splice(recent_.begin(), recent_, at);
                return recent_.front();
            }
        }
        return nullptr;
    }

    std::size_t kept() override {
        const Lock lock(mutex_);
        return std::accumulate(recent_.begin(), recent_.end(), std::size_t{0},
                               [](std::size_t sum, const auto& table) { return sum + table->bytes(); });
    }
    std::size_t limit() const override { return Table::most_bytes; }
    void clear() override {
        Tables dropped;  // destroyed after the mutex is released
        const Lock lock(mutex_);
        recent_.swap(dropped);
    }

    Tables recent_;
};

// Never destroyed, as threads that use a cache may outlive main().
template <class Table>
inline Cache<Table>& cache = *new Cache<Table>;

}  // namespace lommel
