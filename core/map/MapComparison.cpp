#include "core/map/MapComparison.h"

#include "core/surface/PixelField.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

namespace asperity {

namespace {

/// The line through fewer pixels explains everything.
constexpr std::size_t kMinPixels = 3;

constexpr double kRounding = 1e-9;  // of values, relative

bool isConstant(double mean, double deviation) {
    return !(deviation > kRounding * std::hypot(mean, deviation));
}

bool isRecordedHeight(MapQuantity quantity) {
    return quantity == MapQuantity::Height || quantity == MapQuantity::HeightTrace ||
           quantity == MapQuantity::HeightRetrace;
}

/// Calls visit(predicted, measured) for each pixel that holds data in both.
template <class Visit>
void forEachCompared(std::span<const double> predicted, std::span<const double> measured,
                     const Visit& visit) {
    for (std::size_t i = 0; i < predicted.size(); ++i) {
        if (std::isfinite(predicted[i]) && std::isfinite(measured[i])) {
            visit(predicted[i], measured[i]);
        }
    }
}

void count(MapComparison& result, std::span<const double> predicted,
           std::span<const double> measured) {
    result.pixels = predicted.size();
    for (std::size_t i = 0; i < predicted.size(); ++i) {
        const bool isPredicted = std::isfinite(predicted[i]);
        const bool isMeasured = std::isfinite(measured[i]);
        result.compared += isPredicted && isMeasured ? 1U : 0U;
        result.withoutPrediction += isPredicted ? 0U : 1U;
        result.withoutMeasurement += isMeasured ? 0U : 1U;
    }
}

/// Mean squares about the means, and of the difference.
struct Spread {
    double predicted = 0.0;
    double measured = 0.0;
    double both = 0.0;
    double difference = 0.0;  ///< about its mean
};

Spread spreadOf(const MapComparison& means, std::span<const double> predicted,
                std::span<const double> measured) {
    Spread sum;
    forEachCompared(predicted, measured, [&](double p, double m) {
        const double x = p - means.predictedMean;
        const double y = m - means.measuredMean;
        const double d = m - p - means.meanDifference;
        sum.predicted += x * x;
        sum.measured += y * y;
        sum.both += x * y;
        sum.difference += d * d;
    });
    const auto n = static_cast<double>(means.compared);
    return {sum.predicted / n, sum.measured / n, sum.both / n, sum.difference / n};
}

void takeMeans(MapComparison& result, std::span<const double> predicted,
               std::span<const double> measured) {
    double sumPredicted = 0.0;
    double sumMeasured = 0.0;
    double sumDifference = 0.0;
    forEachCompared(predicted, measured, [&](double p, double m) {
        sumPredicted += p;
        sumMeasured += m;
        sumDifference += m - p;
    });
    const auto n = static_cast<double>(result.compared);
    result.predictedMean = sumPredicted / n;
    result.measuredMean = sumMeasured / n;
    result.meanDifference = sumDifference / n;
}

void fitLine(MapComparison& result, const Spread& spread, std::span<const double> predicted,
             std::span<const double> measured) {
    result.slope = spread.both / spread.predicted;
    result.offset = result.measuredMean - result.slope * result.predictedMean;
    double squares = 0.0;
    forEachCompared(predicted, measured, [&](double p, double m) {
        const double residual = result.residual(m, p);
        squares += residual * residual;
    });
    result.rmsResidual = std::sqrt(squares / static_cast<double>(result.compared));
}

/// The least-squares plane of values(i) over the pixels that hold data in both maps.
template <class Values>
PlaneFit planeOver(const MapPlan& plan, const ComparedQuantity& maps, const Values& values) {
    HeightMap map{.columns = plan.grid.columns,
                  .rows = plan.grid.rows,
                  .pitchX = plan.pitchX(),
                  .pitchY = plan.pitchY(),
                  .heights = {},
                  .invalid = PixelMask(maps.predicted.size(), false)};
    for (std::size_t i = 0; i < maps.predicted.size(); ++i) {
        map.heights.push_back(values(i));
        map.invalid[i] = !std::isfinite(maps.measured[i] - maps.predicted[i]);
    }
    return fitPlane(map);
}

double largestOf(const std::vector<double>& values) {
    double largest = 0.0;
    for (const double value : values) {
        largest = std::isfinite(value) ? std::max(largest, std::abs(value)) : largest;
    }
    return largest;
}

/// Removes the plane. The rounding error left of a plane map is no relief.
void removePlane(const MapPlan& plan, const PlaneFit& plane, std::vector<double>& values) {
    const double before = largestOf(values);
    std::size_t i = 0;
    for (int row = 0; row < plan.grid.rows; ++row) {
        for (int column = 0; column < plan.grid.columns; ++column) {
            values[i++] -= plane.at((column + 0.5) * plan.pitchX(),
                                    (plan.grid.rows - row - 0.5) * plan.pitchY());
        }
    }
    if (largestOf(values) <= kRounding * before) {
        for (double& value : values) {
            value *= 0.0;  // what is not a number stays so
        }
    }
}

/// Planes leave nothing to compare in a few pixels.
void level(const MapPlan& plan, ComparedQuantity& maps) {
    constexpr std::size_t kOfAPlane = 3;
    maps.plane =
        planeOver(plan, maps, [&](std::size_t i) { return maps.measured[i] - maps.predicted[i]; });
    maps.predictedPlane = planeOver(plan, maps, [&](std::size_t i) { return maps.predicted[i]; });
    removePlane(plan, *maps.plane, maps.measured);
    removePlane(plan, *maps.predictedPlane, maps.measured);
    removePlane(plan, *maps.predictedPlane, maps.predicted);
    maps.numbers = compareMaps(maps.predicted, maps.measured);
    if (maps.numbers.compared < kMinPixels + kOfAPlane) {
        maps.numbers.offset = maps.numbers.slope = maps.numbers.rmsResidual = kUndefined;
        maps.numbers.correlation = maps.numbers.shareByLine = kUndefined;
        maps.numbers.shareAsPredicted = kUndefined;
    }
}

bool isUpper(char letter) { return letter >= 'A' && letter <= 'Z'; }
bool isLower(char letter) { return letter >= 'a' && letter <= 'z'; }

/// In lower case; a capital after a small letter begins a word, too.
std::set<std::string> wordsOf(std::string_view text) {
    std::set<std::string> words;
    std::string word;
    const auto end = [&] {
        if (!word.empty()) {
            words.insert(std::move(word));
        }
        word.clear();
    };
    char before = ' ';
    for (const char letter : text) {
        const bool isLetter = isUpper(letter) || isLower(letter);
        if (!isLetter || (isUpper(letter) && isLower(before))) {
            end();
        }
        if (isLetter) {
            word += isUpper(letter) ? static_cast<char>(letter - 'A' + 'a') : letter;
        }
        before = letter;
    }
    end();
    return words;
}

std::ptrdiff_t wordsInCommon(MapQuantity quantity, const std::set<std::string>& title) {
    return std::ranges::count_if(wordsOf(keyOf(quantity)),
                                 [&](const std::string& word) { return title.contains(word); });
}

constexpr double kMaxMisfit = 0.02;  // of a side

/// @param position along a side, 0 at its beginning, 1 at its end @param pixels of the side
BetweenPixels pixelsAt(double position, int pixels) {
    return betweenPixels(onCenter(position * pixels - 0.5), pixels);
}

double valueOf(const HeightMap& map, int row, int column) {
    return map.isValid(row, column) ? map.at(row, column)
                                    : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

bool MapComparison::isMeasuredConstant() const {
    return isConstant(measuredMean, measuredDeviation);
}

bool MapComparison::isPredictedConstant() const {
    return isConstant(predictedMean, predictedDeviation);
}

MapComparison compareMaps(std::span<const double> predicted, std::span<const double> measured) {
    MapComparison result;
    count(result, predicted, measured);
    if (result.compared == 0) {
        return result;
    }
    takeMeans(result, predicted, measured);
    const Spread spread = spreadOf(result, predicted, measured);
    result.predictedDeviation = std::sqrt(spread.predicted);
    result.measuredDeviation = std::sqrt(spread.measured);
    result.rmsDifference =
        std::sqrt(spread.difference + result.meanDifference * result.meanDifference);
    if (!result.isMeasuredConstant()) {
        result.shareAsPredicted = 1.0 - spread.difference / spread.measured;
    }
    if (result.compared >= kMinPixels && !result.isPredictedConstant() &&
        !result.isMeasuredConstant()) {
        fitLine(result, spread, predicted, measured);
        result.correlation = spread.both / std::sqrt(spread.predicted * spread.measured);
        result.shareByLine = result.correlation * result.correlation;
    }
    return result;
}

ComparedQuantity compareQuantity(const MapPlan& plan, MapQuantity quantity,
                                 std::vector<double> predicted, std::vector<double> measured) {
    ComparedQuantity result{.predicted = std::move(predicted),
                            .measured = std::move(measured),
                            .plane = {},
                            .predictedPlane = {},
                            .numbers = {}};
    result.numbers = compareMaps(result.predicted, result.measured);
    if (isRecordedHeight(quantity) && result.numbers.compared > 0) {
        level(plan, result);
    }
    return result;
}

bool isMeasurable(MapQuantity quantity) {
    return quantity != MapQuantity::Validity && quantity != MapQuantity::Iterations &&
           !rowOf(quantity)->onRequest;
}

std::vector<MapQuantity> quantitiesLike(const MapPlan& plan, std::string_view unit,
                                        std::string_view title) {
    const std::set<std::string> words = wordsOf(title);
    std::vector<MapQuantity> best;
    std::ptrdiff_t most = 0;
    for (const MapQuantity quantity : plan.quantities) {
        if (!isMeasurable(quantity) || rowOf(quantity)->unit != unit) {
            continue;
        }
        const std::ptrdiff_t common = wordsInCommon(quantity, words);
        if (common > most) {
            most = common;
            best.clear();
        }
        if (common == most) {
            best.push_back(quantity);
        }
    }
    return best;
}

std::optional<MapRegion> measuredArea(double width, double height, const MapPlan& plan,
                                      const MapRegion& scan) {
    std::optional<MapRegion> nearest;
    double least = kMaxMisfit;
    for (const MapRegion& area : {plan.region, scan}) {
        const double misfit = std::max(std::abs(width / (area.right - area.left) - 1.0),
                                       std::abs(height / (area.top - area.bottom) - 1.0));
        if (misfit <= least && !(nearest && misfit == least)) {
            nearest = area;
            least = misfit;
        }
    }
    return nearest;
}

std::vector<double> valuesAt(const MapPlan& plan, const HeightMap& measured,
                             const MapRegion& area) {
    std::vector<BetweenPixels> columns;
    for (int column = 0; column < plan.grid.columns; ++column) {
        columns.push_back(
            pixelsAt((plan.position(0, column).x() - area.left) / (area.right - area.left),
                     measured.columns));
    }
    const auto pixel = [&](int row, int column) { return valueOf(measured, row, column); };
    std::vector<double> values;
    for (int row = 0; row < plan.grid.rows; ++row) {
        const BetweenPixels rows = pixelsAt(
            (area.top - plan.position(row, 0).y()) / (area.top - area.bottom), measured.rows);
        for (const BetweenPixels& around : columns) {
            values.push_back(bilinear(rows, around, pixel));
        }
    }
    return values;
}

}  // namespace asperity
