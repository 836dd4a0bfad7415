#pragma once

// Compiled as C++17 too: Qwt's headers are not C++20.
#include <QPointF>
#include <QVector>

namespace asperity {

/// A line with fewer points that looks the same: of each stretch of neighbors the lowest and the
/// highest one, in their order, and the first and the last one of all. A point that is not a number
/// parts the line, and stays one that does.
/// @param from, to range of the points, one behind the last @param stretches > 0
[[nodiscard]] QVector<QPointF> thinned(const QVector<QPointF>& points, int from, int to,
                                       int stretches);

}  // namespace asperity
