#include "bench/surface/SearchTargets.h"

#include "core/surface/closest/ClosestPoint.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

namespace asperity {

namespace {

constexpr const char* kOpenCascade = "OpenCASCADE GenLocateExtPS";
constexpr const char* kEmbree = "Embree";

/// A peer's time over ours.
struct SpeedTarget {
    const char* work;
    const char* peer;  ///< the start of its name
    SearchEffort ours;
    double MethodResult::*time;
    double atLeast;
};

constexpr SpeedTarget kSpeedTargets[] = {
    {"path", kOpenCascade, SearchEffort::Certified, &MethodResult::median, 8.0},
    {"path", kEmbree, SearchEffort::Certified, &MethodResult::median, 3.0},
    {"concave", kOpenCascade, SearchEffort::Certified, &MethodResult::median, 5.0},
    {"concave", kEmbree, SearchEffort::Certified, &MethodResult::median, 2.0},
    {"rough", kEmbree, SearchEffort::Certified, &MethodResult::median, 1.5},
    {"path", kEmbree, SearchEffort::Certified, &MethodResult::p99, 1.0},
    {"concave", kEmbree, SearchEffort::Certified, &MethodResult::p99, 1.0},
    {"rough", kEmbree, SearchEffort::Certified, &MethodResult::p99, 1.0},
    {"path", kEmbree, SearchEffort::Global, &MethodResult::p99, 2.5},
    {"concave", kEmbree, SearchEffort::Global, &MethodResult::p99, 2.5}};

const WorkResult* findWork(const BenchResults& results, const std::string& name) {
    const auto found = std::ranges::find(results.works, name, &WorkResult::name);
    return found == results.works.end() ? nullptr : &*found;
}

const MethodResult* findMethod(const WorkResult& work, const std::string& name) {
    const auto found = std::ranges::find_if(
        work.methods, [&](const MethodResult& method) { return method.name.starts_with(name); });
    return found == work.methods.end() ? nullptr : &*found;
}

/// @param work that ran
BenchRow speedRow(const SpeedTarget& target, const WorkResult& work) {
    const bool isMedian = target.time == &MethodResult::median;
    BenchRow row{.name = std::string("closest point, ") + target.work + ": " +
                         (isMedian ? "median" : "p99") + " of " + target.peer + " over " +
                         keyOf(target.ours),
                 .value = std::nullopt,
                 .unit = "x",
                 .goal = target.atLeast};
    const MethodResult* peer = findMethod(work, target.peer);
    const MethodResult* ours = findMethod(work, std::string("Asperity, ") + keyOf(target.ours));
    if (peer != nullptr && ours != nullptr) {
        row.value = peer->*target.time / ours->*target.time;
    }
    return row;
}

/// Over all queries of the certified search.
void addProof(const BenchResults& results, std::vector<BenchRow>& rows) {
    std::size_t queries = 0;
    std::size_t wrong = 0;
    std::size_t certified = 0;
    const auto add = [&](const auto& result) {
        queries += result.queries;
        wrong += result.wrong;
        certified += result.certified;
    };
    for (const WorkResult& work : results.works) {
        add(work.methods.front());
    }
    for (const RandomResult& random : results.random) {
        add(random);
    }
    if (queries == 0) {
        return;
    }
    const std::string all = "closest point, " + std::to_string(queries) + " queries: ";
    const double share = 100.0 * static_cast<double>(certified) / static_cast<double>(queries);
    rows.push_back({.name = all + "wrong",
                    .value = static_cast<double>(wrong),
                    .unit = "",
                    .goal = 0.0,
                    .kind = GoalKind::AtMost});
    rows.push_back({.name = all + "certified", .value = share, .unit = "%", .goal = 100.0});
}

void addChain(const ChainResult& chain, std::vector<BenchRow>& rows) {
    rows.push_back({.name = "closest point + force + decoupling: CHAI3D (recorded) over ours",
                    .value = kRecordedChai3d.median / chain.time.median,
                    .unit = "x",
                    .goal = 60.0});
    rows.push_back({.name = "closest point + force + decoupling: p99 over median",
                    .value = chain.time.p99 / chain.time.median,
                    .unit = "x",
                    .goal = 3.0,
                    .kind = GoalKind::AtMost});
}

}  // namespace

std::vector<BenchRow> searchRows(const BenchResults& results) {
    std::vector<BenchRow> rows;
    for (const SpeedTarget& target : kSpeedTargets) {
        if (const WorkResult* const work = findWork(results, target.work)) {
            rows.push_back(speedRow(target, *work));
        }
    }
    addProof(results, rows);
    if (results.chain) {
        addChain(*results.chain, rows);
    }
    return rows;
}

}  // namespace asperity
