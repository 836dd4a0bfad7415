#include "tests/support/MachineSpeed.h"

#include "tests/support/Sanitized.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <ctime>
#include <random>
#include <vector>

namespace asperity::test {

namespace {

double processorTime() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// Memory is filled and numbers are sorted: about what drawing a window asks for [s].
double timeOfWork() {
    constexpr std::size_t kPixels = 4000000;
    constexpr std::size_t kNumbers = 1U << 18U;
    const double begin = processorTime();
    std::mt19937_64 random(7);
    std::vector<std::uint32_t> picture(kPixels);
    for (std::uint32_t& pixel : picture) {
        pixel = static_cast<std::uint32_t>(random());
    }
    std::vector<double> numbers(kNumbers);
    for (double& number : numbers) {
        number = static_cast<double>(random() ^ picture[random() % kPixels]);
    }
    std::ranges::sort(numbers);
    return processorTime() - begin;
}

}  // namespace

double machineSlowness() {
    constexpr double kIdle = kSanitized ? 0.1 : 0.035;  // idle EPYC of 2 cores, 2.1 GHz [s]
    std::array<double, 7> times{};
    std::ranges::generate(times, timeOfWork);
    std::ranges::nth_element(times, times.begin() + 3);
    return std::max(1.0, times[3] / kIdle);
}

}  // namespace asperity::test
