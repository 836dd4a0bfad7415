#include "ui/playback/ThinnedLine.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

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

QVector<QPointF> thinned(const QVector<QPointF>& points, int from, int to, int stretches) {
    const int count = to - from;
    if (count <= 2 * stretches) {
        return points.mid(from, count);
    }
    QVector<QPointF> line{points[from]};
    for (int i = 0; i < stretches; ++i) {
        const auto place = [&](int stretch) {
            return from + 1 + static_cast<int>(qint64(count - 2) * stretch / stretches);
        };
        addStretch(points, place(i), place(i + 1), line);
    }
    line << points[to - 1];
    return line;
}

}  // namespace asperity
