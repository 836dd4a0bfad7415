#include "core/contact/maugis/MaugisTable.h"

#include "core/contact/Within.h"
#include "core/contact/maugis/MaugisTableBuilder.h"

#include <algorithm>
#include <array>
#include <cmath>
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

}  // namespace asperity
