#include "bench/surface/SearchTargets.h"

#include "core/surface/closest/ClosestPoint.h"

#include <algorithm>
#include <cstdio>

namespace asperity {

namespace {

/// A peer's time over ours.
struct SpeedTarget {
    const char* peer;  ///< the start of its name
    SearchEffort ours;
    double TimeSummary::*time;
    double atLeast;
};

constexpr SpeedTarget kSpeedTargets[] = {
    {"OpenCASCADE GenLocateExtPS", SearchEffort::Certified, &TimeSummary::median, 8.0},
    {"Embree", SearchEffort::Certified, &TimeSummary::median, 3.0},
    {"Embree", SearchEffort::Global, &TimeSummary::p99, 2.5},
    {"Embree", SearchEffort::Certified, &TimeSummary::p99, 1.0}};

const MethodResult* find(const WorkResult& work, const std::string& name) {
    const auto found = std::ranges::find_if(
        work.methods, [&](const MethodResult& method) { return method.name.starts_with(name); });
    return found == work.methods.end() ? nullptr : &*found;
}

void printSpeed(const WorkResult& work, const SpeedTarget& target) {
    const MethodResult* peer = find(work, target.peer);
    const MethodResult* ours = find(work, std::string("Asperity, ") + keyOf(target.ours));
    if (peer == nullptr || ours == nullptr) {
        return;
    }
    const TimeSummary theirs{.median = peer->median, .p99 = peer->p99};
    const TimeSummary own{.median = ours->median, .p99 = ours->p99};
    std::printf("  %s of %s over %s: x %.2f (target >= %g)\n",
                target.time == &TimeSummary::median ? "median" : "p99", target.peer,
                keyOf(target.ours), theirs.*target.time / own.*target.time, target.atLeast);
}

}  // namespace

void printPointTargets(const WorkResult& work) {
    if (work.name != "path" && work.name != "concave") {
        return;
    }
    const MethodResult& ours = work.methods.front();
    std::printf("  wrong: %zu (target 0), certified: %.2f %% (target >= 99)\n", ours.wrong,
                100.0 * static_cast<double>(ours.certified) / static_cast<double>(ours.queries));
    for (const SpeedTarget& target : kSpeedTargets) {
        printSpeed(work, target);
    }
}

}  // namespace asperity
