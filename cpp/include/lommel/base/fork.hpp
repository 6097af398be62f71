// Protection against fork() while a lock is held: the child has a copy of the memory, but only the calling thread.
#pragma once

#include <vector>

#include "lommel/base/lock.hpp"
#include "lommel/base/once.hpp"

// With a single thread, no lock is held during fork().
#if !defined(LOMMEL_SINGLE_THREADED) && (defined(__unix__) || defined(__APPLE__))
#include <pthread.h>
#define LOMMEL_FORKS
#endif

namespace lommel {

// Base of objects that are notified of every fork. They must be constructed when the program is loaded, with one thread, and
// exist as long as the process.
class ForkAware {
   public:
    ForkAware(const ForkAware&) = delete;
    ForkAware& operator=(const ForkAware&) = delete;

   protected:
    ForkAware();
    ~ForkAware() = default;

    virtual void before_fork() {}
    virtual void after_fork(bool in_child) = 0;

   private:
    static std::vector<ForkAware*>& all() {
        static std::vector<ForkAware*>& list = *new std::vector<ForkAware*>;
        return list;
    }
};

#if defined(LOMMEL_DEFINES)
LOMMEL_ONCE ForkAware::ForkAware() {
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
#endif

}  // namespace lommel
