#include "core/ShareOut.h"

#include <sched.h>

namespace asperity {

int allowedCores() noexcept {
    cpu_set_t cores;
    CPU_ZERO(&cores);
    const int count = sched_getaffinity(0, sizeof cores, &cores) == 0
                          ? CPU_COUNT(&cores)
                          : static_cast<int>(std::thread::hardware_concurrency());
    return std::max(count, 1);
}

}  // namespace asperity
