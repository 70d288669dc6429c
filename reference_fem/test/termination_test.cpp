// A request to end (SIGTERM) ends a solve at any moment: METIS catches that signal while it orders, and once went on with another ordering.
#include "reference_fem/sparse_solver.hpp"

#include <gtest/gtest.h>

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

namespace cleave::fem {
namespace {

using std::chrono::microseconds;

/// The five-point Laplacian of a square of n x n points: small, so that ordering is a good part of the work.
SparseSystem laplacian(int n) {
    SparseSystem system;
    system.row_start.push_back(0);
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const int row = y * n + x;
            const auto entry = [&](bool inside, int column, double value) {
                if (!inside) return;
                system.column.push_back(column);
                system.value.push_back(value);
            };
            entry(y > 0, row - n, -1);
            entry(x > 0, row - 1, -1);
            entry(true, row, 4);
            entry(x + 1 < n, row + 1, -1);
            entry(y + 1 < n, row + n, -1);
            system.row_start.push_back(static_cast<int>(system.column.size()));
            system.right_hand_side.push_back(1);
        }
    return system;
}

/// Factorises in a process of its own, again and again, until the signal or a thousand times the wait; its status.
int status_after(int signal, microseconds wait, const SparseSystem& system) {
    const pid_t child = ::fork();
    if (child == 0) {
        for (const auto end = std::chrono::steady_clock::now() + 1000 * wait; std::chrono::steady_clock::now() < end;)
            DirectFactor factor(system);
        ::_exit(0);
    }
    std::this_thread::sleep_for(wait);
    ::kill(child, signal);
    int status = 0;
    ::waitpid(child, &status, 0);
    return status;
}

TEST(Termination, EndsASolveAtAnyMoment) {
    const SparseSystem system = laplacian(20);
    for (int moment = 0; moment < 60; ++moment) {
        const int status = status_after(SIGTERM, microseconds(5000 + 137 * moment), system);
        ASSERT_TRUE(WIFSIGNALED(status)) << "moment " << moment << ": the process went on and ended with " << WEXITSTATUS(status);
    }
}

}  // namespace
}  // namespace cleave::fem
