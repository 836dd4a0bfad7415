#include "ui/panels/CurveHistory.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr double kJoinedShare = 0.05;  ///< of the span
/// Times beyond this many intervals have no index (and no clock runs that long).
constexpr double kMaxIndex = 1e15;

}  // namespace

CurveHistory::CurveHistory(double span, int intervals)
    : width_(span / intervals)
    , longestJoin_(kJoinedShare * span)
    , ring_(static_cast<std::size_t>(intervals)) {}

std::size_t CurveHistory::slotOf(std::int64_t index) const noexcept {
    const auto size = static_cast<std::int64_t>(ring_.size());
    return static_cast<std::size_t>(((index % size) + size) % size);
}

void CurveHistory::add(double time, double value) noexcept {
    const double place = std::floor(time / width_);
    if (!std::isfinite(value) || !(std::abs(place) < kMaxIndex)) {
        return;
    }
    const auto index = static_cast<std::int64_t>(place);
    if (started_ && time < newestTime_) {
        clear();
    }
    Interval& interval = ring_[slotOf(index)];
    const CurvePoint point{time, value};
    if (interval.index != index) {
        interval = {index, point, point};
    } else if (value < interval.low.value) {
        interval.low = point;
    } else if (value > interval.high.value) {
        interval.high = point;
    }
    newest_ = index;
    newestTime_ = time;
    started_ = true;
}

void CurveHistory::clear() noexcept {
    std::fill(ring_.begin(), ring_.end(), Interval{});
    started_ = false;
    newestTime_ = 0.0;
}

/// Calls visitor(interval) for each interval that holds samples and is not too old.
template <typename Visitor>
void CurveHistory::visit(const Visitor& visitor) const {
    if (!started_) {
        return;
    }
    const auto count = static_cast<std::int64_t>(ring_.size());
    for (std::int64_t index = newest_ - count + 1; index <= newest_; ++index) {
        const Interval& interval = ring_[slotOf(index)];
        if (interval.index == index) {
            visitor(interval);
        }
    }
}

CurveExtent CurveHistory::extent() const noexcept {
    if (!started_) {
        return {};
    }
    CurveExtent extent{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
    visit([&extent](const Interval& interval) {
        extent.low = std::min(extent.low, interval.low.value);
        extent.high = std::max(extent.high, interval.high.value);
    });
    return extent;
}

std::vector<CurvePoint> CurveHistory::points() const {
    std::vector<CurvePoint> points;
    points.reserve(2 * ring_.size() + 1);
    visit([&](const Interval& interval) {
        const bool lowFirst = interval.low.time <= interval.high.time;
        const CurvePoint& first = lowFirst ? interval.low : interval.high;
        const CurvePoint& second = lowFirst ? interval.high : interval.low;
        if (!points.empty() && first.time - points.back().time > longestJoin_) {
            points.push_back({first.time, std::numeric_limits<double>::quiet_NaN()});
        }
        points.push_back(first);
        if (second.time > first.time) {
            points.push_back(second);
        }
    });
    return points;
}

}  // namespace asperity
