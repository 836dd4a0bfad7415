#include "ui/plot/CurveHistory.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr double kJoinedShare = 0.05;  ///< of the span
/// Times beyond this many intervals have no index (and no clock runs that long).
constexpr double kMaxIndex = 1e15;

/// Adds what is to be seen of [from, to).
void addStretch(const QVector<QPointF>& points, int from, int to, QVector<QPointF>& line) {
    int low = -1;
    int high = -1;
    int gap = -1;
    for (int i = from; i < to; ++i) {
        const double value = points[i].y();
        if (!std::isfinite(value)) {
            gap = i;
            continue;
        }
        low = low < 0 || value < points[low].y() ? i : low;
        high = high < 0 || value > points[high].y() ? i : high;
    }
    QVector<int> kept;
    for (const int index : {low, high, gap}) {
        if (index >= 0 && !kept.contains(index)) {
            kept << index;
        }
    }
    std::sort(kept.begin(), kept.end());
    for (const int index : kept) {
        line << points[index];
    }
}

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
    const double whole = std::floor(time / width_);
    if (!std::isfinite(value) || !(std::abs(whole) < kMaxIndex)) {
        return;
    }
    const auto index = static_cast<std::int64_t>(whole);
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

CurveHistory::Span CurveHistory::kept() const noexcept {
    return {newest_ - static_cast<std::int64_t>(ring_.size()) + 1, newest_};
}

/// Calls visitor(interval) for each interval of the span that holds samples and is not too old.
template <typename Visitor>
void CurveHistory::visit(const Span& span, const Visitor& visitor) const {
    if (!started_) {
        return;
    }
    for (std::int64_t index = span.first; index <= span.last; ++index) {
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
    visit(kept(), [&extent](const Interval& interval) {
        extent.low = std::min(extent.low, interval.low.value);
        extent.high = std::max(extent.high, interval.high.value);
    });
    return extent;
}

std::vector<CurvePoint> CurveHistory::points() const { return points(kept(), 1); }

std::vector<CurvePoint> CurveHistory::points(double begin, double end, int pieces) const {
    const Span all = kept();
    const auto indexOf = [&](double time) {
        const double interval = std::floor(time / width_);
        const auto low = static_cast<double>(all.first);
        const auto high = static_cast<double>(all.last);
        return static_cast<std::int64_t>(std::clamp(interval, low, high));
    };
    const Span asked{indexOf(begin), indexOf(end)};
    const std::int64_t group =
        std::max<std::int64_t>(1, (asked.last - asked.first + pieces - 1) / pieces);
    return points(
        {std::max(all.first, asked.first - group), std::min(all.last, asked.last + group)}, group);
}

/// Groups begin at multiples of their size, so that they stay the same as time goes on.
std::vector<CurvePoint> CurveHistory::points(const Span& span, std::int64_t group) const {
    std::vector<CurvePoint> points;
    points.reserve(2 * static_cast<std::size_t>((span.last - span.first) / group) + 6);
    Interval merged;
    std::int64_t present = kUnused;
    visit(span, [&](const Interval& interval) {
        const auto number = static_cast<std::int64_t>(
            std::floor(static_cast<double>(interval.index) / static_cast<double>(group)));
        if (number == present) {
            merged.low = interval.low.value < merged.low.value ? interval.low : merged.low;
            merged.high = interval.high.value > merged.high.value ? interval.high : merged.high;
            return;
        }
        if (present != kUnused) {
            append(points, merged);
        }
        merged = interval;
        present = number;
    });
    if (present != kUnused) {
        append(points, merged);
    }
    return points;
}

void CurveHistory::append(std::vector<CurvePoint>& points, const Interval& interval) const {
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
}

QVector<QPointF> thinned(const QVector<QPointF>& points, int from, int to, int stretches) {
    const int count = to - from;
    if (count <= 2 * stretches) {
        return points.mid(from, count);
    }
    QVector<QPointF> line{points[from]};
    for (int i = 0; i < stretches; ++i) {
        const auto begin = [&](int stretch) {
            return from + 1 + static_cast<int>(qint64(count - 2) * stretch / stretches);
        };
        addStretch(points, begin(i), begin(i + 1), line);
    }
    line << points[to - 1];
    return line;
}

}  // namespace asperity
