#include "ui/window/ViewBars.h"

#include "ui/panels/ColorBarWidget.h"
#include "ui/view/ZoomView.h"

#include <QHBoxLayout>

namespace asperity {

namespace {

constexpr int kBarGap = 18;  // [px]

}  // namespace

ViewBars::ViewBars(const ZoomView& view, QWidget* parent)
    : QWidget(parent)
    , quantity_(new ColorBarWidget(this))
    , displacement_(new ColorBarWidget(this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kBarGap);
    for (ColorBarWidget* bar : {quantity_, displacement_}) {
        row->addWidget(bar);
        connect(bar, &QWidget::customContextMenuRequested, this,
                [this, bar](const QPoint& at) { Q_EMIT colorsRequested(bar->mapToGlobal(at)); });
    }
    connect(&view, &ZoomView::scalesChanged, this, [this, &view] { showScales(view); });
    showScales(view);
}

void ViewBars::showScales(const ZoomView& view) {
    const ColorScale quantity = view.colorScale();
    const ColorScale displacement = view.displacementScale();
    quantity_->setScale(quantity);
    displacement_->setScale(displacement);
    displacement_->setHidden(!quantity.colors.empty() && displacement.colors.empty());
}

}  // namespace asperity
