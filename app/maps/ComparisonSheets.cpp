#include "app/maps/ComparisonSheets.h"

#include "app/maps/ComparisonReport.h"
#include "app/maps/MapSheets.h"
#include "core/FormattedText.h"
#include "core/SiFormat.h"
#include "vtkplugins/pictures/Palette.h"

#include <algorithm>
#include <cmath>

namespace asperity {

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

/// Every so many pixels one is drawn; odd, so that it meets all columns of a usual map.
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

/// What differs must look different: measured and predicted in the same colors, unless one of them
/// would be all of one color.
void shareColors(SheetMap& measured, SheetMap& predicted) {
    constexpr double kLeast = 0.2;  // of the colors
    const CentralRange one = centralRange(measured.values);
    const CentralRange other = centralRange(predicted.values);
    const CentralRange both{.low = std::min(one.low, other.low),
                            .high = std::max(one.high, other.high)};
    if (std::min(one.high - one.low, other.high - other.low) >= kLeast * (both.high - both.low)) {
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
                      mapsOf(compared, plan, part), &chart);
    }
}

}  // namespace asperity
