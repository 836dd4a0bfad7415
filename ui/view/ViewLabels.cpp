#include "ui/view/ViewLabels.h"

#include "core/SiFormat.h"
#include "ui/Theme.h"
#include "vtkplugins/pictures/PainterItem.h"
#include "vtkplugins/pictures/Ticks.h"

#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

// Pixels.
constexpr double kLabelMargin = 18.0;
constexpr double kLabelTextSize = 14.0;
constexpr double kForceTextSize = 17.0;
constexpr double kLineHeight = 1.4;     // in text sizes
constexpr double kCaptionHeight = 1.8;  // likewise
constexpr double kMaxBarLength = 170.0;
constexpr double kMaxBarHeight = 110.0;
constexpr double kBarShare = 0.25;  // of a small view: of its width and of its height
constexpr double kHeightShare = 0.16;
constexpr double kBarEnd = 4.0;
constexpr double kNameGap = 8.0;

}  // namespace

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

PixelPoint ViewLabels::project(const Vector3& place) const {
    renderer_->SetWorldPoint(place.x(), place.y(), place.z(), 1.0);
    renderer_->WorldToDisplay();
    const double* display = renderer_->GetDisplayPoint();
    return {display[0] / pixelRatio_, display[1] / pixelRatio_};
}

void ViewLabels::paint(Painter& painter) const {
    const int* size = renderer_->GetSize();
    const double width = size[0] / pixelRatio_;
    const double height = size[1] / pixelRatio_;
    if (content_.axes) {
        paintAxes(painter, *content_.axes, [this](const Vector3& place) { return project(place); });
    }
    if (content_.scaleBars) {
        paintScaleBars(painter, width, height);
    }
    paintNotes(painter, width, height);
    paintMarkers(painter, width, height);
    paintNames(painter, width, height);
    paintForce(painter, width, height);
    paintReading(painter, width, height);
}

/// One along the screen, one for heights, from one corner.
void ViewLabels::paintScaleBars(Painter& painter, double viewWidth, double viewHeight) const {
    const double longest = std::min(kMaxBarLength, kBarShare * viewWidth);
    const double highest = std::min(kMaxBarHeight, kHeightShare * viewHeight);
    const LineStyle style{theme::palette().ink, 2.0};
    const TextStyle text{.size = kLabelTextSize, .color = theme::palette().ink};
    const double across = niceBelow(longest * content_.metersPerPixel);
    const double right = kLabelMargin + across / content_.metersPerPixel;
    painter.line({{kLabelMargin, kLabelMargin}, {right, kLabelMargin}}, style);
    painter.line({{right, kLabelMargin - kBarEnd}, {right, kLabelMargin + kBarEnd}}, style);
    painter.text({kLabelMargin + 2.0 * kBarEnd, kLabelMargin + 0.8 * kLabelTextSize},
                 formatSi(across, "m"), text);
    if (!std::isfinite(content_.heightPerPixel)) {  // seen from above, heights have no length
        return;
    }
    const double upwards = niceBelow(highest * content_.heightPerPixel);
    const double top = kLabelMargin + upwards / content_.heightPerPixel;
    painter.line({{kLabelMargin, top}, {kLabelMargin, kLabelMargin}}, style);
    painter.line({{kLabelMargin - kBarEnd, top}, {kLabelMargin + kBarEnd, top}}, style);
    painter.text({kLabelMargin + 2.0 * kBarEnd, std::max(top, kLabelMargin + 2.0 * kLabelTextSize)},
                 "z " + formatSi(upwards, "m"), text);
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
void ViewLabels::paintNames(Painter& painter, double viewWidth, double viewHeight) const {
    double lowest = viewHeight;
    for (const LabelContent::Name& name : content_.names) {
        PixelPoint at = project(name.place);
        at.y = std::min({at.y, lowest, viewHeight - kLabelMargin});
        lowest = at.y - kLineHeight * kLabelTextSize - kNameGap;
        painter.label({at.x + kNameGap, at.y}, name.text,
                      {.size = kLabelTextSize, .bold = true, .color = name.color},
                      {0.0, 0.0, viewWidth, viewHeight}, theme::palette().paper);
    }
}

void ViewLabels::paintMarkers(Painter& painter, double viewWidth, double viewHeight) const {
    for (const LabelContent::Name& marker : content_.markers) {
        const PixelPoint at = project(marker.place);
        painter.label({at.x + kNameGap, at.y}, marker.text,
                      {.size = kLabelTextSize, .color = marker.color},
                      {0.0, 0.0, viewWidth, viewHeight}, theme::palette().paper);
    }
}

void ViewLabels::paintReading(Painter& painter, double viewWidth, double viewHeight) const {
    if (content_.reading.empty()) {
        return;
    }
    const TextStyle style{.size = kLabelTextSize, .color = theme::palette().ink};
    const double left = viewWidth - kLabelMargin - painter.textWidth(content_.reading, style);
    painter.label({left, kLabelMargin}, content_.reading, style, {0.0, 0.0, viewWidth, viewHeight},
                  theme::palette().paper);
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

void ViewLabels::paintForce(Painter& painter, double viewWidth, double viewHeight) const {
    if (!content_.forceEnd) {
        return;
    }
    const PixelPoint end = project(*content_.forceEnd);
    painter.label({end.x + 14.0, end.y}, "|F| " + content_.force,
                  {.size = kForceTextSize, .bold = true, .color = theme::palette().force},
                  {0.0, 0.0, viewWidth, viewHeight}, theme::palette().paper);
}

}  // namespace asperity
