#include "ui/view/ViewLabels.h"

#include "core/SiFormat.h"
#include "core/words/SceneWords.h"
#include "ui/widgets/Theme.h"
#include "vtkplugins/pictures/Ticks.h"

#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <QObject>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr int kTicks = 5;  // along an edge, about

// Pixels from the edge, outwards.
constexpr double kTickLength = 6.0;
constexpr double kAxisLabelDistance = 12.0;
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
PixelPoint beside(const Project& project, const Vector3& position, const Vector3& direction,
                  double pixels) {
    const PixelPoint from = project(position);
    const PixelPoint to = project(position + direction);
    const double length = distanceOf(from, to);
    if (!(length > kSeenLength)) {
        return {from.x, from.y - pixels};
    }
    return {from.x + pixels * (to.x - from.x) / length, from.y + pixels * (to.y - from.y) / length};
}

/// Text that lies outwards of its position.
TextStyle textBeside(const Project& project, const Edge& edge) {
    const Vector3 position = edge.at(edge.low);
    const double sideways = beside(project, position, edge.outwards, 1.0).x - project(position).x;
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
        const Vector3 at = edge.at(ticks[i]);
        painter.line({project(at), beside(project, at, edge.outwards, kTickLength)}, line);
        painter.text(beside(project, at, edge.outwards, kAxisLabelDistance), labels[i], text);
    }
    const std::string title = std::string(edge.name) + " [" + scale.unit + "]";
    const Vector3 middle = edge.at(0.5 * (edge.low + edge.high));
    if (distanceOf(project(middle), project(middle + edge.outwards)) > kSeenLength) {
        painter.text(
            beside(project, middle, edge.outwards, kAxisLabelDistance + room + kTitleDistance),
            title, text);
    } else {  // the surface is seen edge-on, and the picture ends below it
        const bool toRight = end.x > start.x;
        painter.text({end.x + (toRight ? kTitleDistance : -kTitleDistance), end.y}, title,
                     {.size = kAxesTextSize,
                      .color = theme::palette().ink,
                      .align = toRight ? Align::Left : Align::Right});
    }
}

// Pixels.
constexpr double kLabelMargin = 18.0;
constexpr double kLabelTextSize = 14.0;
constexpr double kForceTextSize = 17.0;
constexpr double kLineHeight = 1.4;     // in text sizes
constexpr double kCaptionHeight = 1.8;  // same
constexpr double kMaxBarLength = 170.0;
constexpr double kMaxBarHeight = 110.0;
constexpr double kBarShare = 0.25;  // of a small view: of its width and of its height
constexpr double kHeightShare = 0.16;
constexpr double kBarEnd = 4.0;
constexpr double kNameGap = 8.0;
constexpr double kLowView = 310.0;    // in one as low, bars would lie on axes, which have the scale
constexpr double kPlateHeight = 1.5;  ///< of a label, as Painter::label() draws it, in text sizes

/// Words with values for %1, %2.
std::string filled(QString words, const std::vector<std::string>& values) {
    for (const std::string& value : values) {
        words = words.arg(QString::fromStdString(value));
    }
    return words.toStdString();
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

ViewLabels::ViewLabels(vtkRenderer* renderer)
    : renderer_(renderer), item_(vtkSmartPointer<PainterItem>::New()) {
    vtkNew<vtkContextActor> actor;
    actor->GetScene()->SetRenderer(renderer);
    actor->GetScene()->AddItem(item_);
    renderer->AddActor(actor);
    setPixelRatio(1.0);
}

ViewLabels::~ViewLabels() {
    item_->setDraw([](Painter&) {}, pixelRatio_);
}

void ViewLabels::setPixelRatio(double pixelRatio) {
    pixelRatio_ = pixelRatio;
    item_->setDraw([this](Painter& painter) { paint(painter); }, pixelRatio);
}

PixelPoint ViewLabels::project(const Vector3& position) const {
    renderer_->SetWorldPoint(position.x(), position.y(), position.z(), 1.0);
    renderer_->WorldToDisplay();
    const double* display = renderer_->GetDisplayPoint();
    return {display[0] / pixelRatio_, display[1] / pixelRatio_};
}

void ViewLabels::paint(Painter& painter) {
    const int* size = renderer_->GetSize();
    const double width = size[0] / pixelRatio_;
    const double height = size[1] / pixelRatio_;
    if (content_.axes) {
        paintAxes(painter, *content_.axes, [this](const Vector3& at) { return project(at); });
    }
    view_ = {0.0, 0.0, width, height};
    bars_ = {};
    if (content_.scaleBars && !(content_.axes && height < kLowView)) {
        const ScaleBars bars = scaleBars(painter, width, height);
        bars_ = bars.area;
        paintScaleBars(painter, bars);
    }
    paintNotes(painter, width, height);
    paintMarkers(painter);
    paintNames(painter);
    paintForce(painter);
    paintReading(painter);
}

/// One along the screen, one for heights, from one corner.
ViewLabels::ScaleBars ViewLabels::scaleBars(Painter& painter, double viewWidth,
                                            double viewHeight) const {
    const TextStyle text{.size = kLabelTextSize, .color = theme::palette().ink};
    const double longest = std::min(kMaxBarLength, kBarShare * viewWidth);
    const double highest = std::min(kMaxBarHeight, kHeightShare * viewHeight);
    ScaleBars bars{.across = niceBelow(longest * content_.metersPerPixel)};
    bars.acrossText = formatSi(bars.across, "m");
    bars.right = kLabelMargin + bars.across / content_.metersPerPixel;
    double width = painter.textWidth(bars.acrossText, text);
    double height = kLabelTextSize;
    if (std::isfinite(content_.heightPerPixel)) {  // seen from above, heights have no length
        bars.upwards = niceBelow(highest * content_.heightPerPixel);
        bars.upwardsText = "z " + formatSi(bars.upwards, "m");
        bars.top = kLabelMargin + bars.upwards / content_.heightPerPixel;
        width = std::max(width, painter.textWidth(bars.upwardsText, text));
        height = std::max(bars.top - kLabelMargin, 2.0 * kLabelTextSize);
    }
    bars.area = {0.0, 0.0,
                 std::max(bars.right + kBarEnd, kLabelMargin + 2.0 * kBarEnd + width) + kNameGap,
                 kLabelMargin + height + kLabelTextSize};
    return bars;
}

void ViewLabels::paintScaleBars(Painter& painter, const ScaleBars& bars) {
    const LineStyle style{theme::palette().ink, 2.0};
    const TextStyle text{.size = kLabelTextSize, .color = theme::palette().ink};
    painter.line({{kLabelMargin, kLabelMargin}, {bars.right, kLabelMargin}}, style);
    painter.line({{bars.right, kLabelMargin - kBarEnd}, {bars.right, kLabelMargin + kBarEnd}},
                 style);
    painter.text({kLabelMargin + 2.0 * kBarEnd, kLabelMargin + 0.8 * kLabelTextSize},
                 bars.acrossText, text);
    if (bars.upwards == 0.0) {
        return;
    }
    painter.line({{kLabelMargin, bars.top}, {kLabelMargin, kLabelMargin}}, style);
    painter.line({{kLabelMargin - kBarEnd, bars.top}, {kLabelMargin + kBarEnd, bars.top}}, style);
    painter.text(
        {kLabelMargin + 2.0 * kBarEnd, std::max(bars.top, kLabelMargin + 2.0 * kLabelTextSize)},
        bars.upwardsText, text);
}

void ViewLabels::paintLabel(Painter& painter, const PixelPoint& at, const std::string& text,
                            const TextStyle& style) const {
    const PixelRect plate{at.x, at.y - 0.5 * kPlateHeight * style.size,
                          painter.textWidth(text, style) + style.size, kPlateHeight * style.size};
    painter.label(at, text, style, labelBounds(plate, view_, bars_), theme::palette().paper);
}

void ViewLabels::paintNotes(Painter& painter, double viewWidth, double viewHeight) const {
    double y = viewHeight - kLabelMargin - 0.5 * kLabelTextSize;
    if (!content_.caption.empty()) {
        paintCaption(painter, y, viewWidth, viewHeight);
        y -= kCaptionHeight * kLabelTextSize;
    }
    for (const std::string& note : content_.notes) {
        painter.text({kLabelMargin, y}, note,
                     {.size = kLabelTextSize, .color = theme::palette().ink});
        y -= kLineHeight * kLabelTextSize;
    }
    if (!content_.tipAbove.empty()) {
        painter.text({0.5 * viewWidth, y}, content_.tipAbove,
                     {.size = kForceTextSize,
                      .bold = true,
                      .color = theme::palette().ink,
                      .align = Align::Center});
    }
}

/// Each below the one before where they would lie on top of each other.
void ViewLabels::paintNames(Painter& painter) const {
    double lowest = view_.height;
    for (const LabelContent::Name& name : content_.names) {
        PixelPoint at = project(name.position);
        at.y = std::min({at.y, lowest, view_.height - kLabelMargin});
        lowest = at.y - kLineHeight * kLabelTextSize - kNameGap;
        paintLabel(painter, {at.x + kNameGap, at.y}, name.text,
                   {.size = kLabelTextSize, .bold = true, .color = name.color});
    }
}

void ViewLabels::paintMarkers(Painter& painter) const {
    for (const LabelContent::Name& marker : content_.markers) {
        const PixelPoint at = project(marker.position);
        paintLabel(painter, {at.x + kNameGap, at.y}, marker.text,
                   {.size = kLabelTextSize, .color = marker.color});
    }
}

void ViewLabels::paintReading(Painter& painter) const {
    if (content_.reading.empty()) {
        return;
    }
    const TextStyle style{.size = kLabelTextSize, .color = theme::palette().ink};
    const double left = view_.width - kLabelMargin - painter.textWidth(content_.reading, style);
    paintLabel(painter, {left, kLabelMargin}, content_.reading, style);
}

/// In one line, however narrow the view.
void ViewLabels::paintCaption(Painter& painter, double y, double viewWidth,
                              double viewHeight) const {
    TextStyle style{.size = kLabelTextSize, .color = theme::palette().ink};
    const double room = viewWidth - 2.0 * kLabelMargin;
    style.size *= std::min(1.0, room / painter.textWidth(content_.caption, style));
    painter.label({kLabelMargin - 0.5 * style.size, y}, content_.caption, style,
                  {0.0, 0.0, viewWidth, viewHeight}, theme::palette().paper);
}

void ViewLabels::paintForce(Painter& painter) const {
    if (!content_.forceEnd) {
        return;
    }
    const PixelPoint end = project(*content_.forceEnd);
    paintLabel(painter, {end.x + 14.0, end.y}, "|F| " + content_.force,
               {.size = kForceTextSize, .bold = true, .color = theme::palette().force});
}

PixelRect labelBounds(const PixelRect& plate, const PixelRect& view, const PixelRect& bars) {
    PixelRect inside = plate;
    inside.left = std::max(view.left, std::min(plate.left, view.right() - plate.width));
    inside.bottom = std::max(view.bottom, std::min(plate.bottom, view.top() - plate.height));
    return inside.overlaps(bars)
               ? PixelRect{view.left, bars.top(), view.width, view.top() - bars.top()}
               : view;
}

std::vector<std::string> viewNotes(const ViewNoteFacts& facts) {
    std::vector<std::string> notes;
    if (facts.hasPerspective) {
        notes.push_back(filled(QObject::tr("perspective: lengths not to scale"), {}));
    }
    if (facts.isFromBelow) {
        notes.push_back(filled(QObject::tr("from below: hills are hollows"), {}));
    }
    if (facts.heightScale > 1.0) {
        notes.push_back(filled(QObject::tr("heights ×%1"), tickLabels({facts.heightScale})));
    }
    if (facts.missesTrueTip) {
        notes.push_back(filled(QObject::tr("true tip: the instrument does not know it"), {}));
    }
    if (facts.hidesDeformation) {
        notes.push_back(filled(QObject::tr("deformation is not drawn"), {}));
    }
    if (facts.showsLever) {
        notes.push_back(filled(QObject::tr("lever not to scale"), {}));
    }
    if (facts.showsCap) {
        notes.push_back(filled(QObject::tr("tip radius %1: only its lowest part is drawn"),
                               {formatSi(facts.tipRadius, "m")}));
    }
    if (facts.pixel > kWidePixel * facts.tipRadius) {
        notes.push_back(filled(QObject::tr("Scan pixel %1: coarse for a tip radius of %2"),
                               {formatSi(facts.pixel, "m"), formatSi(facts.tipRadius, "m")}));
    } else if (facts.pixel > kWidePixel * facts.width) {
        notes.push_back(filled(QObject::tr("Scan pixel %1: coarse for this view"),
                               {formatSi(facts.pixel, "m")}));
    }
    return notes;
}

std::string tipAboveNote(double gap) {
    return filled(QObject::tr("tip %1 above the surface"), {formatSi(gap, "m")});
}

}  // namespace asperity
