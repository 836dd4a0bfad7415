#pragma once

#include "bench/surface/GlobalReference.h"
#include "bench/surface/SearchMethod.h"
#include "bench/surface/SearchWork.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace asperity {

/// A distance this far above the reference is wrong [m].
inline constexpr double kWrong = 1e-15;

/// Result of one method on one work.
struct MethodResult {
    std::string name;
    std::size_t queries = 0;
    double median = 0.0;  ///< time of a query; below 1 us its mean over a block of them [ns]
    double p99 = 0.0;     ///< of single queries, to the clock's resolution [ns]
    std::size_t wrong = 0;
    double worst = 0.0;  ///< distance above the reference [m]
    double below = 0.0;  ///< distance below the reference: an error of the reference [m]
    std::size_t certified = 0;
    std::size_t certifiedWrong = 0;
};

/// The reference's answer to each query of a work.
[[nodiscard]] std::vector<GlobalReference::Nearest> referenceOf(const SearchWork& work);

/// Returns how far denser samples in every cell in reach, none skipped, get below the answers, for
/// one query in `stride` [m]: what the reference may be off.
[[nodiscard]] double referenceDoubt(const SearchWork& work,
                                    std::span<const GlobalReference::Nearest> truth,
                                    std::size_t stride);

/// Takes up one answer.
void judge(const SearchWork& work, std::size_t query, const SearchAnswer& answer,
           const GlobalReference::Nearest& truth, MethodResult& result);

/// Runs all methods over the work, taking turns; a time is the best of `passes`, so that what else
/// the machine does stays out of it.
[[nodiscard]] std::vector<MethodResult>
runMethods(const SearchWork& work, std::span<const GlobalReference::Nearest> truth,
           std::span<const std::unique_ptr<SearchMethod>> methods, int passes);

/// Sorts the times: their median and 99th percentile.
struct TimeSummary {
    double median = 0.0;  ///< [ns]
    double p99 = 0.0;     ///< [ns]
};
[[nodiscard]] TimeSummary summaryOf(std::vector<double> times);

/// One method on one work.
struct MethodTask {
    SearchWork work;
    std::unique_ptr<SearchMethod> method;
};

/// Times of one method, unjudged by a reference.
struct MethodTimes {
    TimeSummary time;  ///< of single queries
    std::size_t queries = 0;
    std::size_t certified = 0;
};

/// Runs all tasks, taking turns, so that all meet the same machine; a time is the best of `passes`.
[[nodiscard]] std::vector<MethodTimes> timeTasks(std::span<const MethodTask> tasks, int passes);

/// Returns what reading the clock itself takes [ns].
[[nodiscard]] double clockCost();

}  // namespace asperity
