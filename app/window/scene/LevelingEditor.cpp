#include "app/window/scene/LevelingEditor.h"

#include "ui/widgets/Card.h"
#include "ui/widgets/NumberBox.h"
#include "ui/widgets/ShownText.h"
#include "ui/widgets/Theme.h"

#include <QAction>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QListWidget>
#include <QMenu>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr int kCoordinateWidth = 104;  // "0.464844 µm" [px]
constexpr int kStepGap = 6;            // [px]
constexpr int kShownSteps = 4;         // without scrolling, where there is room
constexpr int kMinSteps = 2;           // same, where there is none
constexpr double kMicrometer = 1e-6;
constexpr double kInset = 0.1;     // of new points from the edges, of the scan's size
constexpr double kFarthest = 1e6;  // [µm]

QString tipOf(LevelingStep step) {
    switch (step) {
    case LevelingStep::Plane:
        return LevelingEditor::tr("Removes the least-squares plane");
    case LevelingStep::Rows:
        return LevelingEditor::tr("Removes the median of each row, then the mean of all");
    case LevelingStep::ThreePoint:
        return LevelingEditor::tr("Removes the plane through three points");
    case LevelingStep::Facet:
        return LevelingEditor::tr("Makes the prevailing slope level: for terraces and facets");
    case LevelingStep::Quadratic:
        return LevelingEditor::tr("Removes the bow: a polynomial of second degree");
    case LevelingStep::MedianOfDifferences:
        return LevelingEditor::tr("Aligns rows by the median of their differences; a slope across "
                                  "the rows is kept");
    case LevelingStep::Scars:
        return LevelingEditor::tr("Fills in short rows that stand out, and marks them");
    case LevelingStep::Zero:
        return LevelingEditor::tr("Sets the lowest height to 0");
    }
    return {};
}

/// Inset from three corners of a scan; they span a triangle.
LevelPoints pointsOn(const QSizeF& size) {
    const double left = kInset * size.width();
    const double bottom = kInset * size.height();
    return {Vector2(left, bottom), Vector2(size.width() - left, bottom),
            Vector2(left, size.height() - bottom)};
}

bool hasThreePoint(const LevelingSteps& steps) {
    return std::ranges::find(steps, LevelingStep::ThreePoint) != steps.end();
}

}  // namespace

LevelingEditor::LevelingEditor(QWidget* parent) : QWidget(parent), list_(new QListWidget(this)) {
    list_->setObjectName(QStringLiteral("levelingSteps"));
    list_->setToolTip(tr("What levels the heights of the scan, done from the top down"));
    const int line = list_->fontMetrics().lineSpacing() + 2;
    list_->setMinimumHeight(kMinSteps * line + kStepGap);
    list_->setMaximumHeight(kShownSteps * line + kStepGap);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kStepGap);
    column->addWidget(list_);
    column->addWidget(newButtons());
    pointFields_ = newPointFields();
    column->addWidget(pointFields_);
    column->addStretch();
    connect(list_, &QListWidget::currentRowChanged, this, &LevelingEditor::showButtons);
    showSteps(-1);
}

QToolButton* LevelingEditor::newButton(const char* name, const QString& text, const QString& tip) {
    auto* button = new QToolButton(this);
    button->setObjectName(QString::fromUtf8(name));
    button->setText(text);
    button->setToolTip(tip);
    return button;
}

QWidget* LevelingEditor::newButtons() {
    auto* line = new QWidget(this);
    auto* row = new QHBoxLayout(line);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kStepGap);
    add_ = newButton("addLevelingStep", tr("Add"), tr("Add a leveling step at the end"));
    remove_ = newButton("removeLevelingStep", tr("Remove"), tr("Remove the chosen leveling step"));
    up_ = newButton("raiseLevelingStep", QStringLiteral("↑"), tr("Do the chosen step earlier"));
    down_ = newButton("lowerLevelingStep", QStringLiteral("↓"), tr("Do the chosen step later"));
    auto* menu = new QMenu(add_);
    menu->setToolTipsVisible(true);
    for (const LevelingStep step : kValues<LevelingStep>) {
        QAction* entry = menu->addAction(coreWords(nameOf(step)));
        entry->setData(static_cast<int>(step));
        entry->setToolTip(tipOf(step));
        connect(entry, &QAction::triggered, this, [this, step] { add(step); });
    }
    add_->setMenu(menu);
    add_->setPopupMode(QToolButton::InstantPopup);
    connect(remove_, &QToolButton::clicked, this, &LevelingEditor::remove);
    connect(up_, &QToolButton::clicked, this, [this] { move(-1); });
    connect(down_, &QToolButton::clicked, this, [this] { move(1); });
    for (QToolButton* const button : {add_, remove_, up_, down_}) {
        row->addWidget(button);
    }
    row->addStretch();
    return line;
}

QWidget* LevelingEditor::newPointFields() {
    auto* part = new QWidget(this);
    auto* grid = new QGridLayout(part);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(kStepGap);
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        const auto point = static_cast<int>(i / 2);
        const bool isX = i % 2 == 0;
        auto* box = new NumberBox(part);
        box->setDecimals(6);
        box->setRange(-kFarthest, kFarthest);
        box->setObjectName(QStringLiteral("levelPlace%1%2").arg(point).arg(isX ? 'x' : 'y'));
        box->setSuffix(QStringLiteral(" µm"));
        box->setMinimumWidth(theme::scaled(kCoordinateWidth));
        box->setToolTip(tr("%1 of point %2 of the plane through three points [µm], from the lower "
                           "left corner of the scan")
                            .arg(isX ? QStringLiteral("x") : QStringLiteral("y"))
                            .arg(point + 1));
        guardFromWheel(*box);
        boxes_.at(i) = box;
        if (isX) {
            grid->addWidget(captionLabel(tr("Place %1").arg(point + 1), part), point, 0);
        }
        grid->addWidget(box, point, isX ? 1 : 2);
        connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
                &LevelingEditor::enterPoints);
    }
    return part;
}

void LevelingEditor::setScanSize(const QSizeF& size) {
    size_ = size;
    for (QAction* const entry : add_->menu()->actions()) {
        if (entry->data().toInt() == static_cast<int>(LevelingStep::ThreePoint)) {
            entry->setEnabled(!size.isEmpty());
        }
    }
}

void LevelingEditor::setLeveling(const LevelingSteps& steps,
                                 const std::optional<LevelPoints>& points) {
    if (steps == steps_ && points == points_) {
        return;  // what is chosen in the list stays
    }
    steps_ = steps;
    points_ = points;
    showSteps(list_->currentRow());
}

void LevelingEditor::add(LevelingStep step) {
    steps_.push_back(step);
    if (step == LevelingStep::ThreePoint && !points_) {
        points_ = pointsOn(size_);
    }
    showSteps(static_cast<int>(steps_.size()) - 1);
    Q_EMIT edited();
}

void LevelingEditor::remove() {
    const int row = list_->currentRow();
    steps_.erase(steps_.begin() + row);
    showSteps(std::min(row, static_cast<int>(steps_.size()) - 1));
    Q_EMIT edited();
}

void LevelingEditor::move(int by) {
    const int row = list_->currentRow();
    std::swap(steps_.at(static_cast<std::size_t>(row)),
              steps_.at(static_cast<std::size_t>(row + by)));
    showSteps(row + by);
    Q_EMIT edited();
}

/// Points on one line are refused: the boxes show the ones before.
void LevelingEditor::enterPoints() {
    LevelPoints points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        points.at(i) =
            kMicrometer * Vector2(boxes_.at(2 * i)->value(), boxes_.at((2 * i) + 1)->value());
    }
    if (refusalOf(points).empty()) {
        points_ = points;
        Q_EMIT edited();
    }
    showSteps(list_->currentRow());
}

void LevelingEditor::showSteps(int row) {
    {
        const QSignalBlocker blocker(list_);
        list_->clear();
        for (const LevelingStep step : steps_) {
            auto* item = new QListWidgetItem(coreWords(nameOf(step)), list_);
            item->setToolTip(tipOf(step));
        }
        list_->setCurrentRow(row);
    }
    pointFields_->setVisible(hasThreePoint(steps_) && points_.has_value());
    for (std::size_t i = 0; points_ && i < boxes_.size(); ++i) {
        const QSignalBlocker blocker(boxes_.at(i));
        boxes_.at(i)->setValue(points_->at(i / 2)[static_cast<Eigen::Index>(i % 2)] / kMicrometer);
    }
    showButtons();
}

void LevelingEditor::showButtons() {
    const int row = list_->currentRow();
    remove_->setEnabled(row >= 0);
    up_->setEnabled(row > 0);
    down_->setEnabled(row >= 0 && row < list_->count() - 1);
}

}  // namespace asperity
