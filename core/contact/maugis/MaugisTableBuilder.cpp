#include "core/contact/maugis/MaugisTableBuilder.h"

#include "core/Error.h"
#include "core/contact/Within.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kWanted = 2e-9;
/// The error between the places where it is measured, and what a spring makes of it.
constexpr double kStepSafety = 4.0;

void check(const MaugisTableRange& range) {
    using Range = MaugisTableRange;
    if (!isWithin(range.lambdaLow, Range::kMinLambda, Range::kMaxLambda) ||
        !isWithin(range.lambdaHigh, range.lambdaLow, Range::kMaxSpan * range.lambdaLow)) {
        throw Error("Contact table: expected transition parameters from 1e-4 to 1e4, the maximum "
                    "at most 5 times the minimum");
    }
    if (!isWithin(range.largestIndentation, 0.0, Range::kMaxIndentation)) {
        throw Error("Contact table: expected a maximum indentation from 0 to 1e6 units");
    }
}

double rootAt(std::size_t column, double place) {
    const auto cell = MaugisTableData::kFirstColumn + static_cast<std::int64_t>(column);
    return MaugisTableData::kColumns.valueAt(cell, place) - MaugisTableData::kNear;
}

double errorRelativeToOne(double value, double exact) {
    return std::abs(value - exact) / std::max(std::abs(exact), 1.0);
}

}  // namespace

MaugisTableBuilder::MaugisTableBuilder(const MaugisTableRange& range)
    : columnFit_(MaugisTableData::kColumnTerms)
    , rowFit_(range.lambdaLow == range.lambdaHigh ? 1 : MaugisTableData::kRowTerms) {
    check(range);
    data_.lambdaLow = range.lambdaLow;
    data_.lambdaHigh = range.lambdaHigh;
    data_.rowTerms = rowFit_.nodes().size();
    data_.firstRow =
        MaugisTableData::kRows.cellOf(range.lambdaLow * (1.0 / MaugisTableData::kLambdaOfChange));
    const auto lastRow =
        MaugisTableData::kRows.cellOf(range.lambdaHigh / MaugisTableData::kLambdaOfChange);
    data_.rows = static_cast<std::size_t>(lastRow - data_.firstRow) + 1;
    constexpr double kMinContact = -0.95;  // of any lambda
    data_.largestRoot = std::sqrt(range.largestIndentation - kMinContact);
    const auto lastColumn =
        MaugisTableData::kColumns.cellOf(MaugisTableData::kNear + data_.largestRoot);
    data_.columns = static_cast<std::size_t>(lastColumn - MaugisTableData::kFirstColumn) + 1;
    const std::size_t cells = data_.rows * data_.columns;
    data_.coefficients.assign(
        cells * MaugisTableData::kColumnTerms * data_.rowTerms * MaugisTableData::kQuantities, 0.0);
    data_.accurate.assign(cells, 0);
}

MaugisTableData MaugisTableBuilder::build() {
    for (std::size_t row = 0; row < data_.rows; ++row) {
        const bool one = data_.rowTerms == 1;
        std::vector<Sample> nodes = samplesOf(row, rowFit_.nodes());
        std::vector<Sample> between = one ? nodes : samplesOf(row, rowFit_.worstPlaces());
        for (std::size_t column = 0; column < data_.columns; ++column) {
            fit(row, column, nodes);
            const double error = measure(row, column, between);
            if (error <= kWanted / kStepSafety) {
                data_.accurate[(row * data_.columns) + column] = 1;
                data_.errorBound = std::max(data_.errorBound, kStepSafety * error);
            }
        }
    }
    return std::move(data_);
}

std::vector<MaugisTableBuilder::Sample>
MaugisTableBuilder::samplesOf(std::size_t row, const std::vector<double>& places) const {
    std::vector<Sample> samples;
    for (const double place : places) {
        const double lambda = data_.rowTerms == 1
                                  ? data_.lambdaLow
                                  : MaugisTableData::kLambdaOfChange *
                                        MaugisTableData::kRows.valueAt(
                                            data_.firstRow + static_cast<std::int64_t>(row), place);
        samples.push_back({place, MaugisDugdale(lambda)});
    }
    return samples;
}

/// The exact state, from the one solved before.
MaugisTableData::Quantities MaugisTableBuilder::solve(Sample& sample, double root,
                                                      bool fold) const {
    const MaugisPoint& lowest = sample.law.lowestContact();
    const auto point = sample.law
                           .stable(MaugisControl::displacement(),
                                   lowest.indentation + (root * root), sample.coordinate)
                           .value_or(lowest);
    sample.coordinate = point.coordinate;
    const double stiffness = point.forceRate / point.indentationRate;
    return {point.force, point.contactRadius, point.cohesiveRadius,
            fold ? stiffness * root : stiffness};
}

void MaugisTableBuilder::fit(std::size_t row, std::size_t column, std::vector<Sample>& samples) {
    const std::size_t cell = (row * data_.columns) + column;
    const std::size_t terms = data_.rowTerms;
    double* coefficients = data_.coefficients.data() + (cell * MaugisTableData::kColumnTerms *
                                                        terms * MaugisTableData::kQuantities);
    for (std::size_t k = 0; k < terms; ++k) {
        for (std::size_t n = 0; n < MaugisTableData::kColumnTerms; ++n) {
            const MaugisTableData::Quantities exact =
                solve(samples[k], rootAt(column, columnFit_.nodes()[n]), data_.hasFold(row));
            double* next = coefficients;
            for (std::size_t j = 0; j < MaugisTableData::kColumnTerms; ++j) {
                for (std::size_t i = 0; i < terms; ++i) {
                    const double weight = columnFit_.weight(j, n) * rowFit_.weight(i, k);
                    for (const double quantity : exact) {
                        *next++ += weight * quantity;
                    }
                }
            }
        }
    }
}

double MaugisTableBuilder::measure(std::size_t row, std::size_t column,
                                   std::vector<Sample>& samples) const {
    constexpr double kMinFoldDistance = 1e-3;  // next to a fold rounding spoils the exact solution
    const std::size_t cell = (row * data_.columns) + column;
    double worst = 0.0;
    for (Sample& sample : samples) {
        for (const double place : columnFit_.worstPlaces()) {
            const double nearest =
                column == 0
                    ? MaugisTableData::kColumns.placeOf(MaugisTableData::kNear + kMinFoldDistance)
                    : -1.0;
            const double at = std::max(place, nearest);
            const MaugisTableData::Quantities exact =
                solve(sample, rootAt(column, at), data_.hasFold(row));
            const MaugisTableData::Quantities found = data_.evaluate(cell, at, sample.row);
            for (std::size_t q = 0; q < MaugisTableData::kQuantities; ++q) {
                worst = std::max(worst, errorRelativeToOne(found[q], exact[q]));
            }
        }
    }
    return worst;
}

}  // namespace asperity
