#include "ui/view/ViewLabels.h"

#include "core/SiFormat.h"
#include "vtkplugins/pictures/PainterItem.h"
#include "vtkplugins/pictures/Ticks.h"

#include <vtkContextActor.h>
#include <vtkContextScene.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

namespace asperity {

namespace {

// Pixels.
constexpr double kMargin = 18.0;
constexpr double kTextSize = 14.0;
constexpr double kForceTextSize = 17.0;
constexpr double kMaxBarLength = 170.0;
constexpr double kBarEnd = 4.0;

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

void ViewLabels::paint(Painter& painter) const {
    if (!(content_.metersPerPixel > 0.0)) {
        return;
    }
    const int* size = renderer_->GetSize();
    const double width = size[0] / pixelRatio_;
    const double height = size[1] / pixelRatio_;
    paintScaleBar(painter);
    if (content_.magnification > 1.0) {
        painter.text({kMargin, height - kMargin - 0.5 * kTextSize},
                     "displacement ×" + tickLabels({content_.magnification}).front(),
                     {.size = kTextSize, .color = palette::kMuted});
    }
    paintForce(painter, width, height);
}

void ViewLabels::paintScaleBar(Painter& painter) const {
    const double metersPerPixel = content_.metersPerPixel;
    const double length = niceBelow(kMaxBarLength * metersPerPixel);
    const double left = kMargin;
    const double right = left + length / metersPerPixel;
    const LineStyle style{palette::kInk, 2.0};
    painter.line({{left, kMargin}, {right, kMargin}}, style);
    painter.line({{left, kMargin - kBarEnd}, {left, kMargin + kBarEnd}}, style);
    painter.line({{right, kMargin - kBarEnd}, {right, kMargin + kBarEnd}}, style);
    painter.text({0.5 * (left + right), kMargin + kTextSize}, formatSi(length, "m"),
                 {.size = kTextSize, .align = Align::Center});
}

void ViewLabels::paintForce(Painter& painter, double viewWidth, double viewHeight) const {
    if (!content_.forceEnd) {
        return;
    }
    const Vector3& end = *content_.forceEnd;
    renderer_->SetWorldPoint(end.x(), end.y(), end.z(), 1.0);
    renderer_->WorldToDisplay();
    const double* display = renderer_->GetDisplayPoint();
    painter.label({display[0] / pixelRatio_ + 14.0, display[1] / pixelRatio_},
                  formatSi(content_.force, "N"),
                  {.size = kForceTextSize, .bold = true, .color = palette::kForce},
                  {0.0, 0.0, viewWidth, viewHeight});
}

}  // namespace asperity
