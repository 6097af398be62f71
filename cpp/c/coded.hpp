// Exceptions turned into codes and messages, for all functions of the C interface.
#pragma once

#include <cstdio>
#include <cstring>
#include <new>
#include <stdexcept>

#include "lommel.h"
#include "lommel/limits.hpp"

namespace coding {

// Of this thread, and of a fixed size, so that it is there where memory is short.
struct Message {
    char text[320] = "";
    void set(const char* what) {
        std::strncpy(text, what, sizeof text - 1);
        text[sizeof text - 1] = '\0';
    }
};
inline thread_local Message message;

inline void require(bool holds, const char* otherwise) {
    if (!holds) {
        throw std::invalid_argument(otherwise);
    }
}

// Runs a function and returns its code.
template <class Work>
int coded(const Work& work) noexcept {
    const auto failed = [](int code, const char* what) {
        message.set(what);
        return code;
    };
    try {
        work();
        return LOMMEL_OK;
    } catch (const lommel::ToleranceNotMet& failure) {
        char text[160];
        std::snprintf(text, sizeof text, "the tolerance cannot be met: the bound on the error is %.3g of the peak",
                      failure.bound);
        return failed(LOMMEL_TOLERANCE, text);
    } catch (const lommel::LimitExceeded& failure) {
        return failed(LOMMEL_LIMIT, failure.what());
    } catch (const std::invalid_argument& failure) {
        return failed(LOMMEL_INVALID, failure.what());
    } catch (const std::bad_alloc&) {
        return failed(LOMMEL_MEMORY, "memory could not be allocated");
    } catch (const std::length_error&) {
        return failed(LOMMEL_MEMORY, "memory could not be allocated");
    } catch (const std::exception& failure) {
        return failed(LOMMEL_INTERNAL, failure.what());
    } catch (...) {
        return failed(LOMMEL_INTERNAL, "unknown failure");
    }
}

}  // namespace coding
