#include "app/curves/FitBatch.h"

#include "core/FormattedText.h"
#include "core/PrintableText.h"
#include "core/Version.h"
#include "core/io/tables/CsvWriter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

/// Values of the table, each with its deviations.
constexpr std::array kBatchKeys{"youngs_modulus_pa",     "youngs_modulus_sqrt_radius_pa_m05",
                                "work_of_adhesion_j_m2", "work_of_adhesion_radius_n",
                                "pull_off_force_n",      "contact_point_m",
                                "stiffness_n_m"};
constexpr std::array kBatchResiduals{"rms_approach_contact", "rms_contact", "rms_forward_cycle"};

/// The quantile of sorted values, linear between them.
double sortedQuantile(const std::vector<double>& sorted, double share) {
    const double position = share * static_cast<double>(sorted.size() - 1);
    const auto low = static_cast<std::size_t>(position);
    const std::size_t high = std::min(low + 1, sorted.size() - 1);
    return sorted[low] + ((position - static_cast<double>(low)) * (sorted[high] - sorted[low]));
}

double residualOf(const CurveIdentification& found, const std::string& key) {
    const auto row = std::find_if(found.residuals.begin(), found.residuals.end(),
                                  [&](const FitNumber& number) { return number.key == key; });
    return row != found.residuals.end() ? row->value : std::numeric_limits<double>::quiet_NaN();
}

std::string flagsOf(const FittedCurve& curve) {
    std::string text = curve.error;
    for (const std::string& reason : curve.found.reasons) {
        text += (text.empty() ? "" : "; ") + reason;
    }
    return text;
}

const char* verdictOf(const FittedCurve& curve) {
    return curve.error.empty() ? keyOf(curve.found.verdict) : "unreadable";
}

void addValueCells(CsvWriter& csv, const CurveIdentification& found, const char* key) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const IdentifiedValue* const value = found.find(key);
    csv.add(value != nullptr ? value->value : kNone);
    csv.add(value != nullptr && value->std > 0.0 ? value->std : kNone);
    csv.add(value != nullptr && value->stdCalibration > 0.0 ? value->stdCalibration : kNone);
}

}  // namespace

std::vector<BatchStatistic> batchStatistics(const std::vector<FittedCurve>& curves) {
    std::vector<BatchStatistic> result;
    std::vector<std::vector<double>> values;
    for (const FittedCurve& curve : curves) {
        if (curve.found.verdict == FitVerdict::Refused) {
            continue;
        }
        for (const IdentifiedValue& value : curve.found.parameters) {
            if (value.source != ValueSource::Fitted) {
                continue;
            }
            auto row = std::find_if(result.begin(), result.end(),
                                    [&](const BatchStatistic& s) { return s.key == value.key; });
            if (row == result.end()) {
                result.push_back({.key = value.key, .unit = value.unit});
                values.emplace_back();
                row = result.end() - 1;
            }
            values[static_cast<std::size_t>(row - result.begin())].push_back(value.value);
        }
    }
    for (std::size_t i = 0; i < result.size(); ++i) {
        std::sort(values[i].begin(), values[i].end());
        result[i].count = values[i].size();
        result[i].median = sortedQuantile(values[i], 0.5);
        result[i].spread =
            0.5 * (sortedQuantile(values[i], 0.84) - sortedQuantile(values[i], 0.16));
    }
    return result;
}

void writeFitTable(const std::filesystem::path& path, const std::vector<FittedCurve>& curves) {
    std::vector<std::string> comments{std::string("Asperity ") + kVersion + ": fitted curves"};
    for (const BatchStatistic& row : batchStatistics(curves)) {
        comments.push_back(formatted("median %s %.6g, spread %.3g %s, of %zu curves",
                                     row.key.c_str(), row.median, row.spread, row.unit.c_str(),
                                     row.count));
    }
    std::vector<std::string> columns{"file",    "index", "x_m",           "y_m",
                                     "verdict", "model", "force_range_n", "noise_n"};
    for (const std::string key : kBatchKeys) {
        columns.insert(columns.end(), {key, key + "_std", key + "_std_calibration"});
    }
    columns.insert(columns.end(), kBatchResiduals.begin(), kBatchResiduals.end());
    columns.emplace_back("flags");
    CsvWriter csv(path, comments, columns);
    for (const FittedCurve& curve : curves) {
        constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
        csv.add(curve.file).add(static_cast<double>(curve.index));
        csv.add(curve.position ? curve.position->x : kUnknown);
        csv.add(curve.position ? curve.position->y : kUnknown).add(verdictOf(curve));
        csv.add(curve.found.model).add(curve.found.forceRange).add(curve.found.noise);
        for (const char* key : kBatchKeys) {
            addValueCells(csv, curve.found, key);
        }
        for (const char* key : kBatchResiduals) {
            csv.add(residualOf(curve.found, key));
        }
        csv.add(flagsOf(curve)).endRow();
    }
    csv.close();
}

nlohmann::ordered_json batchJson(const std::vector<FittedCurve>& curves) {
    nlohmann::ordered_json json{{"statistics", nlohmann::ordered_json::object()}};
    for (const BatchStatistic& row : batchStatistics(curves)) {
        json["statistics"][row.key] = {{"median", row.median},
                                       {"spread", row.spread},
                                       {"unit", row.unit},
                                       {"count", row.count}};
    }
    json["curves"] = nlohmann::ordered_json::array();
    for (const FittedCurve& curve : curves) {
        json["curves"].push_back(
            curve.error.empty()
                ? fitJson(curve)
                : nlohmann::ordered_json{{"file", pathText(curve.file)}, {"error", curve.error}});
    }
    return json;
}

}  // namespace asperity
