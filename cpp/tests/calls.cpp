// The compiled core as callers meet it, for sanitizers: asked for what is far out of reach, stopped while it works, and forked.
// Returns 1 and says where if it does not answer as it should.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <complex>
#include <cstddef>
#include <random>
#include <stdexcept>
#include <thread>
#include <vector>

#if defined(__unix__)
#include <sys/wait.h>
#include <unistd.h>
#endif

#include "lommel/base/checkerboard.hpp"
#include "lommel/radial/images.hpp"
#include "lommel/radial/profiles.hpp"
#include "lommel/zernike/images.hpp"

#include "check.hpp"

namespace {

int refuses(const std::function<void()>& ask) {
    try {
        ask();
    } catch (const std::domain_error&) {
        return 1;
    }
    return 0;
}

// Reaches that no double can be turned into an integer for are refused; far ones are done, piece by piece or one by one.
void far_windows(double obscuration) {
    const double coefficients[] = {7.0, 3.0};
    const lommel::Stack stack{coefficients, 1, 2, obscuration};
    for (const double reach : {1.1e6, 1e10, 1e25, 1e300, HUGE_VAL, std::nan("")}) {
        std::complex<double> u;
        double value, bound, peak, image[25], scale = 1.0;
        int refused = refuses([&] { lommel::fields(stack, &reach, 1, 1e-6, &u, &bound); });
        refused += refuses([&] { lommel::profiles(stack, &reach, 1, 1e-6, &value, &bound, &peak); });
        refused +=
            refuses([&] { lommel::Renderer<double>(stack, 5, 5, reach, 1e-6, 1, {image, &scale, &bound, &peak}).run(); });
        const lommel::DiskWindow window{5, 5, 2.0, 2.0, reach};
        lommel::DiskStack general({{2, 0}, {3, 1}}, coefficients, 1, obscuration, {});
        refused += refuses([&] {
            general.move_axes(window);
            general.shrink();
            lommel::ZernikeRenderer<double>(general, window, 1e-6, 1, {image, &scale, &bound, &peak}).run();
        });
        check(refused == 4, "far windows that are refused", refused);
    }
    // Of these radii some crowd in a piece, and some are alone.
    std::vector<double> v;
    for (double at = 3.0; at < 9e5; at *= 1.7) {
        v.push_back(at);
    }
    for (int i = 0; i < 64; ++i) {
        v.push_back(9e5 + 0.1 * i);
    }
    std::vector<std::complex<double>> fine(v.size());
    std::vector<double> found(v.size());
    double bound, relative, peak;
    lommel::fields(stack, v.data(), v.size(), 1e-13, fine.data(), &bound);  // no piece meets this
    lommel::profiles(stack, v.data(), v.size(), 1e-6, found.data(), &relative, &peak);
    for (std::size_t i = 0; i < v.size(); ++i) {
        check(std::abs(found[i] - std::norm(fine[i])) <= (relative + 1e-12) * peak, "far profile", v[i]);
    }
}

// A call that is told to stop does, from every thread and place, and the next one finds all in order.
int times_to_ask = 0;
bool stops() { return --times_to_ask < 0; }

void a_call_stops_where_it_is_told_to() {
    for (int patience = 0; patience < 4; ++patience) {
        const lommel::Watch watch(&stops);
        times_to_ask = patience;
        int stopped = 0;
        try {
            lommel::parallel_for(1000000, 3,
                                 [](std::size_t, std::size_t) { std::this_thread::sleep_for(std::chrono::milliseconds(1)); });
        } catch (const lommel::Stopped&) {
            ++stopped;
        }
        check(stopped == 1, "a call that was stopped", patience);
    }
    std::atomic<int> done{0};
    lommel::parallel_for(100, 3, [&](std::size_t, std::size_t) { ++done; });
    check(done == 100 && lommel::helpers.at_work() == 0, "the call after it", done);
}

// A tile waits for its earlier neighbours, and no two neighbours are written at once; a tile that waits for one that failed gives
// up.
void tiles_keep_their_order(std::size_t rows, std::size_t columns, int threads) {
    std::vector<std::atomic<int>> state(rows * columns);  // 1 at work, 2 done
    const auto parity = [](std::size_t row, std::size_t column) { return 2 * (row % 2) + column % 2; };
    const auto around = [&](std::size_t row, std::size_t column, const auto& visit) {
        for (std::size_t i = row - std::min<std::size_t>(row, 1); i < std::min(rows, row + 2); ++i) {
            for (std::size_t j = column - std::min<std::size_t>(column, 1); j < std::min(columns, column + 2); ++j) {
                if (i != row || j != column) {
                    visit(i, j);
                }
            }
        }
    };
    std::atomic<int> wrong{0};
    const lommel::Checkerboard tiles(rows, columns);
    tiles.each(threads, [&](std::size_t row, std::size_t column) {
        wrong += state[row * columns + column].exchange(1) != 0;
        const auto look_around = [&] {
            around(row, column, [&](std::size_t i, std::size_t j) {
                wrong += state[i * columns + j] != (parity(i, j) < parity(row, column) ? 2 : 0);
            });
        };
        look_around();
        std::this_thread::sleep_for(std::chrono::microseconds(row * 7 % 5 * 40));
        look_around();
        state[row * columns + column] = 2;
    });
    check(wrong == 0, "tiles out of order", wrong);
    check(std::all_of(state.begin(), state.end(), [](const auto& at) { return at == 2; }), "tiles left out", 0);
    int failed = 0;
    try {
        tiles.each(threads, [](std::size_t row, std::size_t column) {
            if (row == 0 && column == 0) {
                std::this_thread::sleep_for(std::chrono::milliseconds(5));  // until others wait for it
                throw std::runtime_error("of a tile");
            }
        });
    } catch (const std::runtime_error&) {
        ++failed;
    }
    check(failed == 1, "a tile that fails", failed);
}

// The thread sanitizer runs a thread of its own, and does not support fork() beside threads.
#if defined(__unix__) && !defined(__SANITIZE_THREAD__)
// The largest value of an image of some defocus.
double image_of(std::size_t side, double defocus) {
    std::vector<double> image(side * side);
    double scale = 1.0, bound = 0.0, peak = 0.0;
    lommel::Renderer<double>({&defocus, 1, 1, 0.0}, side, side, 0.7, 1e-6, 2, {image.data(), &scale, &bound, &peak}).run();
    return *std::max_element(image.begin(), image.end());
}

// A child of a process whose other threads are at work computes as if there were none.
void children_of_busy_parents() {
    std::atomic<bool> enough{false};
    std::vector<std::thread> busy;
    for (unsigned seed = 0; seed < 2; ++seed) {
        busy.emplace_back([&enough, seed] {
            std::mt19937 random(seed);
            while (!enough) {
                image_of(3 + random() % 90, 0.1 * static_cast<double>(random() % 99));
            }
        });
    }
    for (unsigned turn = 0; turn < 20; ++turn) {
        const pid_t child = fork();
        if (child == 0) {
            alarm(20);
            _exit(image_of(31 + turn, 3.0) > 0.9 || lommel::helpers.at_work() != 0);
        }
        int status = -1;
        waitpid(child, &status, 0);
        check(status == 0, "a child of a busy parent", status);
    }
    enough = true;
    for (std::thread& one : busy) {
        one.join();
    }
}
#else
void children_of_busy_parents() {}
#endif

}  // namespace

int main() {
    lommel::work_per_thread() = 1e-3;
    for (const lommel::Level level : {lommel::Level::portable, lommel::Level::avx2, lommel::Level::avx512}) {
        lommel::level_limit() = level;
        far_windows(0.0);
        far_windows(0.4);
    }
    a_call_stops_where_it_is_told_to();
    for (const int threads : {1, 2, 5}) {
        tiles_keep_their_order(1, 1, threads);
        tiles_keep_their_order(7, 1, threads);
        tiles_keep_their_order(6, 9, threads);
    }
    children_of_busy_parents();
    return finished();
}
