#pragma once

#include "app/curves/FitFiles.h"

#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

/// Median and spread of a value over the curves that have it.
struct BatchStatistic {
    std::string key;
    std::string unit;
    std::size_t count = 0;
    double median = 0.0;
    double spread = 0.0;  ///< half the distance of the quantiles 16 % and 84 %
};

/// Statistics of the fitted values of all curves that were not refused, in the order of the first.
[[nodiscard]] std::vector<BatchStatistic> batchStatistics(const std::vector<FittedCurve>& curves);

/// Writes a row a curve, with the statistics as comments. @throw Error
void writeFitTable(const std::filesystem::path& path, const std::vector<FittedCurve>& curves);

/// Returns what fits.json says: the statistics and what fit.json would say of each curve.
[[nodiscard]] nlohmann::ordered_json batchJson(const std::vector<FittedCurve>& curves);

}  // namespace asperity
