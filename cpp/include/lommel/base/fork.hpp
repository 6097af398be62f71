// Notification of fork(), which copies all memory but only the calling thread: locks held by other threads must be freed.
#pragma once

#include <vector>

#include "lommel/base/lock.hpp"

// LOMMEL_FORKS: fork() exists, and may be called while another thread holds a lock.
#if !defined(LOMMEL_SINGLE_THREADED) && (defined(__unix__) || defined(__APPLE__))
#include <pthread.h>
#define LOMMEL_FORKS
#endif

namespace lommel {

// Base of objects that are notified of every fork(). They must be constructed while the program is loaded, when it has one
// thread, and exist as long as the process.
class ForkAware {
   public:
    ForkAware(const ForkAware&) = delete;
    ForkAware& operator=(const ForkAware&) = delete;

   protected:
    ForkAware() {
#if defined(LOMMEL_FORKS)
        if (all().empty()) {
            pthread_atfork(
                [] {
                    for (ForkAware* one : all())
                        one->before_fork();
                },
                [] {
                    for (ForkAware* one : all())
                        one->after_fork(false);
                },
                [] {
                    for (ForkAware* one : all())
                        one->after_fork(true);
                });
        }
#endif
        all().push_back(this);
    }
    ~ForkAware() = default;

    virtual void before_fork() {}
    virtual void after_fork(bool in_child) = 0;

   private:
    static std::vector<ForkAware*>& all() {
        static std::vector<ForkAware*>& list = *new std::vector<ForkAware*>;
        return list;
    }
};

}  // namespace lommel
