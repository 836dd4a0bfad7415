#include "ui/panels/ParameterPanel.h"

#include "ui/CoreWords.h"
#include "ui/Theme.h"
#include "ui/panels/Card.h"
#include "ui/panels/GainSpinBox.h"
#include "ui/panels/RefusalLine.h"
#include "ui/panels/WheelGuard.h"

#include <QGridLayout>
#include <QSignalBlocker>

#include <algorithm>

namespace asperity {

namespace {

constexpr int kGap = 8;         // [px]
constexpr int kBoxWidth = 110;  // [px]

/// Steps by factors where there is no zero.
NumberBox* newBox(const SceneParameterTraits& traits, QWidget* parent) {
    if (traits.low > 0.0) {
        return new GainSpinBox(traits.low / traits.unit, traits.high / traits.unit, parent);
    }
    constexpr int kDecimals = 6;
    auto* box = new NumberBox(parent);
    box->setDecimals(kDecimals);
    box->setRange(traits.low / traits.unit, traits.high / traits.unit);
    box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    return box;
}

}  // namespace

ParameterPanel::ParameterPanel(QWidget* parent) : QWidget(parent, Qt::Tool) {
    setWindowTitle(tr("Scene parameters"));
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(kGap, kGap, kGap, kGap);
    grid->setSpacing(kGap);
    for (const SceneParameterTraits& traits : kEnumTable<SceneParameter>) {
        addRow(*grid, traits);
    }
    grid->addWidget(new RefusalLine(this), grid->rowCount(), 0, 1, 2);
    grid->setRowStretch(grid->rowCount(), 1);
    resize(sizeHint());
}

void ParameterPanel::addRow(QGridLayout& grid, const SceneParameterTraits& traits) {
    NumberBox* box = newBox(traits, this);
    box->setObjectName(QString::fromUtf8(traits.key));
    box->setToolTip(coreWords(traits.toolTip));
    box->setMinimumWidth(theme::scaled(kBoxWidth));
    guardFromWheel(*box);
    const int row = grid.rowCount();
    grid.addWidget(captionLabel(coreWords(traits.caption), this), row, 0);
    grid.addWidget(box, row, 1);
    boxes_[traits.value] = box;
    connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
            [this, parameter = traits.value, unit = traits.unit](double value) {
                Q_EMIT parameterEntered(parameter, value * unit);
            });
}

void ParameterPanel::showScene(const SceneDescription& scene) {
    for (const SceneParameterTraits& traits : kEnumTable<SceneParameter>) {
        NumberBox& box = *boxes_.at(traits.value);
        const QSignalBlocker blocker(box);
        const double value = parameterOf(scene, traits.value) / traits.unit;
        box.setRange(std::min(box.minimum(), value), std::max(box.maximum(), value));
        box.setValue(value);
    }
}

}  // namespace asperity
