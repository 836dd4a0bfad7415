#include "ui/view/FrameAxes.h"

#include "core/SiFormat.h"
#include "ui/Theme.h"
#include "vtkplugins/pictures/Painter.h"
#include "vtkplugins/pictures/Ticks.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace asperity {

namespace {

constexpr int kTicks = 5;  // along an edge, about

// Pixels from the edge, outwards.
constexpr double kTickLength = 6.0;
constexpr double kLabelDistance = 12.0;
constexpr double kTitleDistance = 10.0;  // from the labels

constexpr double kSeenLength = 1.0;  // of a direction that is seen
constexpr double kSeenEdge = 40.0;   // of an edge that has room for its positions

constexpr double kAxesTextSize = 12.0;
constexpr double kSideways = 0.4;  // share of a direction from which on it leads to a side

using Project = std::function<PixelPoint(const Vector3&)>;

/// One edge: from `low` to `high` along one axis of the scan.
struct Edge {
    const char* name;
    double low;
    double high;
    std::function<Vector3(double)> at;
    Vector3 outwards;  ///< from the frame, level
};

double distanceOf(const PixelPoint& one, const PixelPoint& other) {
    return std::hypot(other.x - one.x, other.y - one.y);
}

/// The pixel at a distance from another one, towards where a direction of the world points;
/// downwards where that points to the eye or away from it.
PixelPoint beside(const Project& project, const Vector3& place, const Vector3& direction,
                  double pixels) {
    const PixelPoint from = project(place);
    const PixelPoint to = project(place + direction);
    const double length = distanceOf(from, to);
    if (!(length > kSeenLength)) {
        return {from.x, from.y - pixels};
    }
    return {from.x + pixels * (to.x - from.x) / length, from.y + pixels * (to.y - from.y) / length};
}

/// Text that lies outwards of its place.
TextStyle textBeside(const Project& project, const Edge& edge) {
    const Vector3 place = edge.at(edge.low);
    const double sideways = beside(project, place, edge.outwards, 1.0).x - project(place).x;
    const Align align = sideways < -kSideways  ? Align::Right
                        : sideways > kSideways ? Align::Left
                                               : Align::Center;
    return {.size = kAxesTextSize, .color = theme::palette().ink, .align = align};
}

/// Nothing of an edge that is seen from its end.
void paintEdge(Painter& painter, const Edge& edge, const Project& project) {
    const PixelPoint start = project(edge.at(edge.low));
    const PixelPoint end = project(edge.at(edge.high));
    if (distanceOf(start, end) < kSeenEdge) {
        return;
    }
    const LineStyle line{.color = theme::palette().ink, .width = 1.0};
    const TextStyle text = textBeside(project, edge);
    painter.line({start, end}, line);
    const std::vector<double> ticks = niceTicks(edge.low, edge.high, kTicks);
    const SiScale scale = siScaleFor(std::max(std::abs(edge.low), std::abs(edge.high)), "m");
    std::vector<double> shown;
    for (const double tick : ticks) {
        shown.push_back(scale.factor * tick);
    }
    const std::vector<std::string> labels = tickLabels(shown);
    double room = kAxesTextSize;
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        room = std::max(room, painter.textWidth(labels[i], text));
        const Vector3 place = edge.at(ticks[i]);
        painter.line({project(place), beside(project, place, edge.outwards, kTickLength)}, line);
        painter.text(beside(project, place, edge.outwards, kLabelDistance), labels[i], text);
    }
    const std::string title = std::string(edge.name) + " [" + scale.unit + "]";
    const Vector3 middle = edge.at(0.5 * (edge.low + edge.high));
    if (distanceOf(project(middle), project(middle + edge.outwards)) > kSeenLength) {
        painter.text(beside(project, middle, edge.outwards, kLabelDistance + room + kTitleDistance),
                     title, text);
    } else {  // the ground is seen edge-on, and the picture ends below it
        const bool toRight = end.x > start.x;
        painter.text({end.x + (toRight ? kTitleDistance : -kTitleDistance), end.y}, title,
                     {.size = kAxesTextSize,
                      .color = theme::palette().ink,
                      .align = toRight ? Align::Left : Align::Right});
    }
}

}  // namespace

void paintAxes(Painter& painter, const FrameAxes& axes, const Project& project) {
    const ScanWindow& window = axes.window;
    const bool fromRight = axes.toEye.x() > 0.0;
    const bool fromBehind = axes.toEye.y() > 0.0;
    const double x = fromRight ? window.right : window.left;
    const double y = fromBehind ? window.top : window.bottom;
    const double step = 0.1 * std::max(window.right - window.left, window.top - window.bottom);
    const double z = axes.bottom;
    paintEdge(painter,
              {"x",
               window.left,
               window.right,
               [y, z](double along) { return Vector3(along, y, z); },
               {0.0, fromBehind ? step : -step, 0.0}},
              project);
    paintEdge(painter,
              {"y",
               window.bottom,
               window.top,
               [x, z](double along) { return Vector3(x, along, z); },
               {fromRight ? step : -step, 0.0, 0.0}},
              project);
}

}  // namespace asperity
