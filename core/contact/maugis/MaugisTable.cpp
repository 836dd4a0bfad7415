#include "core/contact/maugis/MaugisTable.h"

#include "core/Error.h"
#include "core/contact/Within.h"

#include <algorithm>
#include <limits>
#include <mutex>
#include <utility>

namespace asperity {

namespace {

/// Beyond what any material makes of a kilometer or of a soft lever, in the units of MaugisPoint.
constexpr double kMaxDistance = 1e40;

MaugisState stateOf(const MaugisPoint& point) noexcept {
    constexpr double kMinRatio = 1e-100;
    const bool atFold = point.indentationRate <= kMinRatio * std::abs(point.forceRate);
    return {.indentation = point.indentation,
            .force = point.force,
            .stiffness = atFold ? std::numeric_limits<double>::lowest()
                                : point.forceRate / point.indentationRate,
            .contactRadius = point.contactRadius,
            .cohesiveRadius = point.cohesiveRadius};
}

/// The curve's coordinate of a state, cot(phi); 0 where that is unknown.
double coordinateOf(const MaugisState& state) noexcept {
    const double squares =
        (state.cohesiveRadius - state.contactRadius) * (state.cohesiveRadius + state.contactRadius);
    return squares > 0.0 ? state.contactRadius / std::sqrt(squares) : 0.0;
}

std::optional<MaugisState> exact(const MaugisDugdale& law, const MaugisControl& control,
                                 double value, double start) noexcept {
    const auto point = law.stable(control, value, start);
    return point ? std::optional(stateOf(*point)) : std::nullopt;
}

constexpr double kWanted = 2e-9;
/// The error between the positions where it is measured, and what a spring makes of it.
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

double rootAt(std::size_t column, double position) {
    const auto cell = MaugisTableData::kFirstColumn + static_cast<std::int64_t>(column);
    return MaugisTableData::kColumns.valueAt(cell, position) - MaugisTableData::kNear;
}

double errorRelativeToOne(double value, double exact) {
    return std::abs(value - exact) / std::max(std::abs(exact), 1.0);
}

}  // namespace

MaugisTable::MaugisTable(const MaugisTableRange& range)
    : data_(MaugisTableBuilder(range).build()) {}

double MaugisTable::exactShare() const noexcept {
    const auto left = std::count(data_.accurate.begin(), data_.accurate.end(), 0);
    return static_cast<double>(left) / static_cast<double>(data_.accurate.size());
}

std::size_t MaugisTable::bytes() const noexcept {
    return (data_.coefficients.size() * sizeof(double)) + data_.accurate.size();
}

std::optional<MaugisState> MaugisTable::exactAt(const MaugisDugdale& law,
                                                double indentation) const noexcept {
    const auto near = entry(law, indentation);
    return exact(law, MaugisControl::displacement(), indentation,
                 near ? coordinateOf(near->state) : 0.0);
}

std::optional<MaugisState> MaugisTable::stable(const MaugisDugdale& law, double compliance,
                                               double value, double start) const noexcept {
    if (!isWithin(value, -kMaxDistance, kMaxDistance) || !isWithin(compliance, 0.0, kMaxDistance)) {
        return std::nullopt;
    }
    constexpr int kMaxIterations = 6;
    constexpr double kSettled = 1e-12;  // relative
    double coordinate = 0.0;
    double indentation = std::isfinite(start) ? start : 0.0;
    if (compliance == 0.0) {
        indentation = value;  // a rigid lever holds it: one look-up
    }
    for (int i = 0; i < kMaxIterations; ++i) {
        const auto found = entry(law, indentation);
        if (!found || !found->accurate) {
            break;
        }
        const MaugisState& state = found->state;
        coordinate = coordinateOf(state);
        // The table's error must reach neither force nor radii enlarged, nor move a fold.
        const double slope = 1.0 + (compliance * state.stiffness);
        if (slope < 0.5 || compliance * std::max(found->root, 0.5) > 2.0 * slope * found->root) {
            break;
        }
        const double step = (value - indentation - (compliance * state.force)) / slope;
        if (std::abs(step) <= kSettled * std::max(1.0, std::abs(indentation))) {
            return state;
        }
        indentation += step;
    }
    return exact(law, MaugisControl::spring(compliance), value, coordinate);
}

std::shared_ptr<const MaugisTable> sharedMaugisTable(const MaugisTableRange& range) {
    struct Kept {
        MaugisTableRange range;
        std::shared_ptr<const MaugisTable> table;
    };
    constexpr std::size_t kKept = 4;  // two laws, of truth and belief
    static std::mutex mutex;
    static std::array<Kept, kKept> kept;
    static std::size_t next = 0;
    {
        const std::lock_guard lock(mutex);
        const auto found = std::ranges::find(kept, range, &Kept::range);
        if (found != kept.end() && found->table) {
            return found->table;
        }
    }
    auto table = std::make_shared<const MaugisTable>(range);  // nobody waits for it behind the lock
    const std::lock_guard lock(mutex);
    kept[std::exchange(next, (next + 1) % kKept)] = {range, table};
    return table;
}

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
        std::vector<Sample> between = one ? nodes : samplesOf(row, rowFit_.worstPositions());
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
MaugisTableBuilder::samplesOf(std::size_t row, const std::vector<double>& positions) const {
    std::vector<Sample> samples;
    for (const double position : positions) {
        const double lambda =
            data_.rowTerms == 1
                ? data_.lambdaLow
                : MaugisTableData::kLambdaOfChange *
                      MaugisTableData::kRows.valueAt(
                          data_.firstRow + static_cast<std::int64_t>(row), position);
        samples.push_back({position, MaugisDugdale(lambda)});
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
        for (const double position : columnFit_.worstPositions()) {
            const double nearest = column == 0 ? MaugisTableData::kColumns.positionOf(
                                                     MaugisTableData::kNear + kMinFoldDistance)
                                               : -1.0;
            const double at = std::max(position, nearest);
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
