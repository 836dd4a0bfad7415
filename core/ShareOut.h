#pragma once

#include "core/Progress.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>
#include <vector>

namespace asperity {

/// Calls work(index) for 0..count - 1 on as many threads as the machine has cores.
/// @param progress may be null; told by the calling thread alone. @throw Cancelled, what work
/// throws
template <class Work>
void shareOut(int count, Progress* progress, const Work& work) {
    constexpr int kReports = 50;
    std::atomic<int> next = 0;
    const auto run = [&](Progress* told) {
        for (int index = next++; index < count; index = next++) {
            if (index % (count / kReports + 1) == 0) {
                reportTo(told, static_cast<double>(index) / count);
            }
            work(index);
        }
    };
    const int threads = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, count);
    std::vector<std::future<void>> others;
    for (int i = 1; i < threads; ++i) {
        others.push_back(std::async(std::launch::async, run, nullptr));
    }
    try {
        run(progress);
    } catch (...) {
        next = count;  // the others end, too
        throw;
    }
    for (std::future<void>& other : others) {
        other.get();
    }
}

}  // namespace asperity
