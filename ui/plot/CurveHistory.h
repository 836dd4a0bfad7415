#pragma once

#include <QPointF>
#include <QVector>

#include <cstdint>
#include <vector>

// Compiled as C++17 too: Qwt's headers are not C++20.

namespace asperity {

/// One point of a curve.
struct CurvePoint {
    double time = 0.0;  ///< [s]
    double value = 0.0;
};

/// The smallest and the largest value of a curve.
struct CurveExtent {
    double low = 0.0;
    double high = 0.0;
};

/// The last seconds of a quantity. Time is cut into short intervals; each keeps its smallest and
/// its largest value, so that every peak stays however many samples come. O(1) a sample.
class CurveHistory {
public:
    /// @param span how far it reaches back [s], > 0
    /// @param intervals into how many intervals that is cut, >= 1
    CurveHistory(double span, int intervals);

    /// Values and times that are not finite are left out. Time may leap ahead: nothing stands for
    /// what was leapt over. When it goes back, a new run begins and the old curve is dropped.
    void add(double time, double value) noexcept;
    void clear() noexcept;

    [[nodiscard]] bool isEmpty() const noexcept { return !started_; }
    [[nodiscard]] double newestTime() const noexcept { return newestTime_; }  ///< [s]
    /// Zeros when empty.
    [[nodiscard]] CurveExtent extent() const noexcept;
    /// The curve in the order of time; a value that is not a number parts two pieces between which
    /// nothing is known for longer than a twentieth of the span.
    [[nodiscard]] std::vector<CurvePoint> points() const;
    /// The part between two times [s], and one point more beyond each where there is one, as
    /// smallest and largest values of at most about `pieces` equal times, >= 1.
    [[nodiscard]] std::vector<CurvePoint> points(double begin, double end, int pieces) const;

private:
    struct Interval {
        std::int64_t index = kUnused;  ///< which interval since time zero
        CurvePoint low;
        CurvePoint high;
    };
    static constexpr std::int64_t kUnused = INT64_MIN;

    [[nodiscard]] std::size_t slotOf(std::int64_t index) const noexcept;
    /// The range of indices of a run of intervals, both ends in it.
    struct Span {
        std::int64_t first = 0;
        std::int64_t last = 0;
    };

    [[nodiscard]] Span kept() const noexcept;
    template <typename Visitor>
    void visit(const Span& span, const Visitor& visitor) const;
    /// In groups of this many intervals.
    [[nodiscard]] std::vector<CurvePoint> points(const Span& span, std::int64_t group) const;
    void append(std::vector<CurvePoint>& points, const Interval& interval) const;

    double width_;        ///< of an interval [s]
    double longestJoin_;  ///< time without samples over which the curve is still drawn [s]
    std::vector<Interval> ring_;
    std::int64_t newest_ = 0;  ///< index of the newest interval
    double newestTime_ = 0.0;
    bool started_ = false;
};

/// A line with fewer points that looks the same: of each stretch of neighbors the lowest and the
/// highest one, in their order, and the first and the last one of all. A point that is not a number
/// parts the line, and stays one that does.
/// @param from, to range of the points, one behind the last @param stretches > 0
[[nodiscard]] QVector<QPointF> thinned(const QVector<QPointF>& points, int from, int to,
                                       int stretches);

}  // namespace asperity
