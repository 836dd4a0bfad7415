#include "app/maps/ComparisonReport.h"

#include "app/exports/PictureFile.h"
#include "app/program/JsonText.h"
#include "core/FormattedText.h"
#include "core/PrintableText.h"
#include "core/SiFormat.h"
#include "core/Version.h"
#include "core/io/TextValue.h"
#include "vtkplugins/pictures/Palette.h"

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

constexpr int kMaxPixels = 1024;  // along a side, as drawn
constexpr std::size_t kMapsPerSheet = 6;

/// Every how many pixels one is drawn.
int strideOf(const MapGrid& grid) {
    return (std::max(grid.columns, grid.rows) + kMaxPixels - 1) / kMaxPixels;
}

/// @param index of the quantity in the plan
SheetMap sheetMap(const MapPlan& plan, const MapPart& part, std::size_t index) {
    const MapQuantityRow& quantity = *rowOf(plan.quantities[index]);
    const bool hasBlanks = !unknownDeviations(plan, part, index).empty();
    return sheetMap(plan, quantity.name + std::string(hasBlanks ? " (blank: unknown)" : ""),
                    quantity.unit, [&](int row, double* values) { part.read(row, index, values); });
}

/// Indices in the plan of the quantities that are drawn.
std::vector<std::size_t> shownOf(const MapPlan& plan) {
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < plan.quantities.size(); ++i) {
        if (plan.quantities[i] != MapQuantity::Validity) {
            shown.push_back(i);
        }
    }
    return shown;
}

std::string titleOf(const MapPlan& plan) {
    return "Force map: mode " + std::string(keyOf(plan.mode)) + ", setpoint " +
           formatSi(plan.setpoint, "N") + ", " +
           formatSi(plan.region.right - plan.region.left, "m") + " x " +
           formatSi(plan.region.top - plan.region.bottom, "m") + ", " +
           (plan.truth ? "true instrument" : "believed model") + "; colors: 1st to 99th percentile";
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

namespace {

/// Values of the pixels that hold data in both maps.
struct ValuePairs {
    std::vector<double> predicted;
    std::vector<double> measured;
};

ValuePairs pairsOf(const ComparedMap& compared) {
    ValuePairs pairs;
    const std::vector<double>& predicted = compared.values.predicted;
    const std::vector<double>& measured = compared.values.measured;
    for (std::size_t i = 0; i < predicted.size(); ++i) {
        if (std::isfinite(predicted[i]) && std::isfinite(measured[i])) {
            pairs.predicted.push_back(predicted[i]);
            pairs.measured.push_back(measured[i]);
        }
    }
    return pairs;
}

/// Step between drawn pixels; odd, so that it meets all columns of a usual map.
std::size_t strideOf(std::size_t pixels) {
    constexpr std::size_t kMaxDots = 3000;
    const std::size_t stride = (pixels + kMaxDots - 1) / kMaxDots;
    return stride % 2 == 0 ? stride + 1 : stride;
}

bool holds(const CentralRange& range, double value) {
    return value >= range.low && value <= range.high;
}

/// Without the outermost values, which would press all others into a corner.
Curve dotsOf(const ValuePairs& pairs, const CentralRange& predicted, const CentralRange& measured) {
    const std::size_t stride = strideOf(pairs.predicted.size());
    Curve dots{.label =
                   (stride > 1 ? formatted("one of %zu pixels", stride) : std::string("pixels")) +
                   ", 98 % of each map",
               .x = {},
               .y = {},
               .points = true,
               .dotSize = 4.0};
    for (std::size_t i = 0; i < pairs.predicted.size(); i += stride) {
        if (holds(predicted, pairs.predicted[i]) && holds(measured, pairs.measured[i])) {
            dots.x.push_back(pairs.predicted[i]);
            dots.y.push_back(pairs.measured[i]);
        }
    }
    return dots;
}

/// Without an offset that is rounding, as that of heights, which have lost their means.
std::string lineText(const MapComparison& numbers, const char* unit) {
    constexpr double kRounding = 1e-9;
    if (std::abs(numbers.offset) <= kRounding * numbers.measuredDeviation) {
        return formatted("measured = %.3g predicted", numbers.slope);
    }
    return "measured = " + formatSi(numbers.offset, unit) +
           formatted(numbers.slope < 0.0 ? " - %.3g predicted" : " + %.3g predicted",
                     std::abs(numbers.slope));
}

Chart chartOf(const ComparedMap& compared, const ValuePairs& pairs) {
    const MapComparison& numbers = compared.values.numbers;
    const MapQuantityRow& quantity = *rowOf(compared.quantity);
    const CentralRange x = centralRange(pairs.predicted);
    const CentralRange y = centralRange(pairs.measured);
    Chart chart{.title = findingOn(numbers),
                .xLabel = std::string("predicted ") + quantity.name,
                .yLabel = "measured",
                .curves = {dotsOf(pairs, x, y)},
                .xUnit = quantity.unit,
                .yUnit = quantity.unit};
    const double low = std::max(x.low, y.low);
    const double high = std::min(x.high, y.high);
    if (low < high) {
        chart.curves.push_back({.label = "measured = predicted",
                                .x = {low, high},
                                .y = {low, high},
                                .color = seriesColor(kLightPalette, 1),
                                .dashed = true});
    }
    if (std::isfinite(numbers.slope)) {
        chart.curves.push_back(
            {.label = lineText(numbers, quantity.unit),
             .x = {x.low, x.high},
             .y = {numbers.offset + numbers.slope * x.low, numbers.offset + numbers.slope * x.high},
             .color = seriesColor(kLightPalette, 2)});
    }
    return chart;
}

std::string titleOf(const ComparedMap& compared, const MapPlan& plan) {
    std::string title = "Measured '" + compared.channel + "' against the predicted " +
                        rowOf(compared.quantity)->name + ", setpoint " +
                        formatSi(plan.setpoint, "N");
    if (compared.values.plane) {
        title += "; both without their planes";
    }
    return title + "; colors: 1st to 99th percentile";
}

/// Gives measured and predicted the same colors, so that differences show, unless one of them
/// would be all of one color.
void shareColors(SheetMap& measured, SheetMap& predicted) {
    constexpr double kMin = 0.2;  // of the colors
    const CentralRange one = centralRange(measured.values);
    const CentralRange other = centralRange(predicted.values);
    const CentralRange both{.low = std::min(one.low, other.low),
                            .high = std::max(one.high, other.high)};
    if (std::min(one.high - one.low, other.high - other.low) >= kMin * (both.high - both.low)) {
        measured.range = predicted.range = both;
    }
}

std::vector<SheetMap> mapsOf(const ComparedMap& compared, const MapPlan& plan,
                             const MapPart& part) {
    const char* unit = rowOf(compared.quantity)->unit;
    const auto columns = static_cast<std::ptrdiff_t>(plan.grid.columns);
    const std::vector<ComparisonLayer> layers = layersOf(compared, part);
    const auto rowsOf = [columns](const std::vector<double>& all) {
        return [&all, columns](int row, double* values) {
            std::copy_n(all.begin() + row * columns, columns, values);
        };
    };
    std::vector<SheetMap> maps{sheetMap(plan, "measured", unit, rowsOf(compared.values.measured)),
                               sheetMap(plan, "predicted", unit, rowsOf(compared.values.predicted)),
                               sheetMap(plan, "difference", unit, layers[0].readRow),
                               sheetMap(plan, "residual", unit, layers[1].readRow)};
    shareColors(maps[0], maps[1]);
    maps[2].isSigned = true;
    maps[3].isSigned = true;
    return maps;
}

}  // namespace

void writeComparisonSheets(const MapFiles& files, const MapPlan& plan, const MapPart& part,
                           std::span<const ComparedMap> maps) {
    int number = 0;
    for (const ComparedMap& compared : maps) {
        const Chart chart = chartOf(compared, pairsOf(compared));
        writeMapSheet(files.comparisonSheet(++number), titleOf(compared, plan),
                      mapsOf(compared, plan, part), [&chart](const PictureSize& size) {
                          const PictureSpec spec{.size = {.width = kChartPixels * size.width,
                                                          .height = kChartPixels * size.height},
                                                 .dpi = 96.0 * kChartPixels};
                          return drawnPage(plotPage({{chart}}, spec), spec);
                      });
    }
}

SheetMap sheetMap(const MapPlan& plan, const std::string& name, const char* unit,
                  const RowReader& readRow) {
    const int stride = strideOf(plan.grid);
    SheetMap map{.quantity = name,
                 .unit = unit,
                 .columns = (plan.grid.columns + stride - 1) / stride,
                 .rows = (plan.grid.rows + stride - 1) / stride,
                 .width = plan.region.right - plan.region.left,
                 .height = plan.region.top - plan.region.bottom,
                 .values = {}};
    std::vector<double> values(static_cast<std::size_t>(plan.grid.columns));
    for (int drawn = 0; drawn < plan.grid.rows; drawn += stride) {
        readRow(drawn, values.data());
        for (std::size_t column = 0; column < values.size();
             column += static_cast<std::size_t>(stride)) {
            map.values.push_back(values[column]);
        }
    }
    return map;
}

std::vector<std::filesystem::path> filesOf(const MapFiles& files, const MapPlan& plan,
                                           bool withSheets) {
    std::vector<std::filesystem::path> all{files.gwy(), files.vti(), files.exr()};
    const std::size_t drawn = withSheets ? shownOf(plan).size() : 0;
    for (std::size_t first = 0; first < drawn; first += kMapsPerSheet) {
        all.push_back(files.sheet(static_cast<int>(1 + (first / kMapsPerSheet))));
    }
    return all;
}

void writeMapSheets(const MapFiles& files, const MapPlan& plan, const MapPart& part) {
    const std::vector<std::size_t> shown = shownOf(plan);
    int sheets = 0;
    for (std::size_t first = 0; first < shown.size(); first += kMapsPerSheet) {
        std::vector<SheetMap> maps;
        for (std::size_t i = first; i < std::min(first + kMapsPerSheet, shown.size()); ++i) {
            maps.push_back(sheetMap(plan, part, shown[i]));
        }
        writeMapSheet(files.sheet(++sheets), titleOf(plan), maps);
    }
}

}  // namespace asperity
