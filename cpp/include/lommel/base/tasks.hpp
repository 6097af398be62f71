// Division of work among threads: by pupils for a stack of images, by blocks of rows for a large image.
#pragma once

#include <algorithm>
#include <cstddef>

#include "lommel/base/parallel.hpp"

namespace lommel {

// Work that justifies one more thread, in microseconds. To wake a thread takes about 30, more if the other processors are busy.
// Tests lower this value, so that small images use several threads.
inline double& work_per_thread() {
    static double microseconds = 100.0;
    return microseconds;
}

// Number of threads justified by work of this duration, at most `threads` (0: no limit).
inline int worthwhile_threads(int threads, double microseconds) {
    const int worth = static_cast<int>(std::min(1024.0, std::max(1.0, microseconds / work_per_thread())));
    return std::min(threads > 0 ? threads : worth, worth);
}

// Call render(pupil, threads) for each pupil: several pupils concurrently, or a single pupil with all threads.
template <class Render>
void for_pupils(std::size_t count, int threads, const Render& render) {
    const bool one = count == 1;
    parallel_for(count, threads, [&](std::size_t, std::size_t pupil) { render(pupil, one ? threads : 1); });
}

// Call work(first, last) for each block of 64 pupils [first, last); the work on one pupil takes about `microseconds`.
template <class Work>
void for_blocks(std::size_t count, int threads, double microseconds, const Work& work) {
    constexpr std::size_t block = 64;
    parallel_for((count + block - 1) / block, worthwhile_threads(threads, microseconds * static_cast<double>(count)),
                 [&](std::size_t, std::size_t b) { work(b * block, std::min(count, (b + 1) * block)); });
}

// Call paint(first, last) for each block of image rows [first, last); a block has about 2^18 pixels, enough for a task.
template <class Paint>
void for_rows(std::size_t rows, std::size_t width, int threads, const Paint& paint) {
    const std::size_t block = std::max<std::size_t>(1, (std::size_t{1} << 18) / width);
    parallel_for((rows + block - 1) / block, threads,
                 [&](std::size_t, std::size_t task) { paint(task * block, std::min(rows, (task + 1) * block)); });
}

}  // namespace lommel
