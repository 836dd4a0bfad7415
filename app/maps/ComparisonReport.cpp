#include "app/maps/ComparisonReport.h"

#include "app/program/JsonText.h"
#include "core/FormattedText.h"
#include "core/PathText.h"
#include "core/SiFormat.h"
#include "core/Version.h"
#include "core/io/TextValue.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

using Json = nlohmann::ordered_json;

/// Why there are numbers that are not defined; empty: all are.
std::string remarkOn(const MapComparison& numbers) {
    if (numbers.compared == 0) {
        return "no pixel holds data in both maps";
    }
    if (numbers.isMeasuredConstant()) {
        return "the measured map is constant: nothing is to be explained";
    }
    if (numbers.isPredictedConstant()) {
        return "the predicted map is constant: there is no correlation and no line";
    }
    return std::isfinite(numbers.correlation)
               ? ""
               : "too few pixels are compared: there is no correlation and no line";
}

/// "N/m" as the end of a key: "_n_m".
std::string keyEnd(const char* unit) {
    std::string end = "_" + lowerCase(unit);
    std::ranges::replace(end, '/', '_');
    return end;
}

Json planeJson(const std::optional<PlaneFit>& plane) {
    if (!plane) {
        return nullptr;
    }
    return {{"mean_m", plane->mean}, {"slope_x", plane->slopeX}, {"slope_y", plane->slopeY}};
}

Json channelJson(const ComparedMap& map) {
    const MapComparison& numbers = map.values.numbers;
    const MapQuantityRow& quantity = *rowOf(map.quantity);
    const std::string unit = keyEnd(quantity.unit);
    const std::string remark = remarkOn(numbers);
    return {{"channel", map.channel},
            {"quantity", quantity.key},
            {"unit", quantity.unit},
            {"measured_columns", map.grid.columns},
            {"measured_rows", map.grid.rows},
            {"removed_plane", planeJson(map.values.plane)},
            {"plane_removed_from_both", planeJson(map.values.predictedPlane)},
            {"pixels", numbers.pixels},
            {"compared_pixels", numbers.compared},
            {"pixels_without_prediction", numbers.withoutPrediction},
            {"pixels_without_measurement", numbers.withoutMeasurement},
            {"measured_mean" + unit, numbers.measuredMean},
            {"measured_standard_deviation" + unit, numbers.measuredDeviation},
            {"predicted_mean" + unit, numbers.predictedMean},
            {"predicted_standard_deviation" + unit, numbers.predictedDeviation},
            {"mean_difference" + unit, numbers.meanDifference},
            {"rms_difference" + unit, numbers.rmsDifference},
            {"correlation", numbers.correlation},
            {"line_offset" + unit, numbers.offset},
            {"line_slope", numbers.slope},
            {"line_rms_residual" + unit, numbers.rmsResidual},
            {"share_explained_by_line", numbers.shareByLine},
            {"share_explained_as_predicted", numbers.shareAsPredicted},
            {"remark", remark.empty() ? Json(nullptr) : Json(remark)}};
}

/// Means so far apart are hardly of the same quantity. Those of heights are of the mounting.
std::string doubtOn(const ComparedMap& compared) {
    constexpr double kFar = 100.0;
    const MapComparison& numbers = compared.values.numbers;
    const double ratio = std::abs(numbers.measuredMean / numbers.predictedMean);
    if (compared.values.plane || !(ratio > kFar || ratio < 1.0 / kFar)) {
        return "";
    }
    const char* unit = rowOf(compared.quantity)->unit;
    return "; the means, " + formatSi(numbers.measuredMean, unit) + " and " +
           formatSi(numbers.predictedMean, unit) + ", are far apart: are both the same quantity?";
}

}  // namespace

std::string findingOn(const MapComparison& numbers) {
    const std::string remark = remarkOn(numbers);
    if (!remark.empty()) {
        return remark;
    }
    const std::string share =
        formatted("the prediction explains %.3g %% of the variance, correlation %.3f",
                  100.0 * numbers.shareByLine, numbers.correlation);
    return numbers.slope < 0.0 ? share + " (with the opposite sign)" : share;
}

std::string sentenceOn(const ComparedMap& compared) {
    const MapComparison& numbers = compared.values.numbers;
    const MapQuantityRow& quantity = *rowOf(compared.quantity);
    std::string text = "'" + compared.channel + "' against " + quantity.name +
                       formatted(", %zu of %zu pixels: ", numbers.compared, numbers.pixels) +
                       findingOn(numbers);
    if (numbers.compared > 0) {
        text += "; rms difference " + formatSi(numbers.rmsDifference, quantity.unit);
    }
    if (std::isfinite(numbers.rmsResidual)) {
        text += ", of the line " + formatSi(numbers.rmsResidual, quantity.unit);
    }
    text += doubtOn(compared);
    return text;
}

std::string comparisonJson(const MeasuredFile& file, const MapPlan& plan,
                           std::span<const ComparedMap> maps) {
    Json channels = Json::array();
    for (const ComparedMap& map : maps) {
        channels.push_back(channelJson(map));
    }
    const MapRegion& region = plan.region;
    return jsonText(Json{{"program", std::string("Asperity ") + kVersion},
                         {"measured_file", pathText(file.path)},
                         {"measured_sha256", file.sha256},
                         {"map",
                          {{"mode", keyOf(plan.mode)},
                           {"instrument", plan.truth ? "true" : "believed"},
                           {"setpoint_n", plan.setpoint},
                           {"columns", plan.grid.columns},
                           {"rows", plan.grid.rows},
                           {"region_m", {region.left, region.bottom, region.right, region.top}}}},
                         {"channels", channels}});
}

}  // namespace asperity
