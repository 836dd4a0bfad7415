#pragma once

#include "bench/surface/MethodRun.h"
#include "bench/surface/RandomRun.h"

#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// One work, how far its reference may be off, and what each method did on it; the product first.
struct WorkResult {
    std::string name;
    double referenceDoubt = 0.0;  ///< [m]
    std::vector<MethodResult> methods;
};

/// The same slide over a small and a large map.
struct SizeResult {
    int smallPixels = 0;  ///< along one axis
    int largePixels = 0;
    MethodResult onSmall;
    MethodResult onLarge;
};

/// Closest point, contact force and decoupling of one instant.
struct ChainResult {
    TimeSummary time;     ///< of the whole chain
    TimeSummary closest;  ///< of its closest point alone
};

/// CHAI3D's whole update as docs of the project record it: it is no Debian package. [ns]
inline constexpr TimeSummary kRecordedChai3d{.median = 29000.0, .p99 = 75000.0};

/// A plain copy of a map of float heights.
struct CopyResult {
    int pixels = 0;     ///< along one axis
    double time = 0.0;  ///< [ns]
};

struct BenchResults {
    std::vector<WorkResult> works;
    std::vector<RandomResult> random;
    std::optional<SizeResult> size;
    std::optional<ChainResult> chain;
    std::vector<CopyResult> copies;
    std::vector<std::string> missingPeers;
};

/// For people, to stdout.
void printTables(const BenchResults& results);
/// For programs, to stdout.
void printJson(const BenchResults& results);

}  // namespace asperity
