#include "app/window/live/OverviewPanel.h"

#include "core/SiFormat.h"
#include "core/scene/Scene.h"
#include "core/words/SceneWords.h"
#include "ui/plot/CopyablePlot.h"
#include "ui/view/ColorScale.h"
#include "ui/view/MapTool.h"
#include "ui/view/OverviewMap.h"
#include "ui/widgets/ShownText.h"
#include "ui/widgets/Theme.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QPixmap>
#include <QVBoxLayout>

#include <algorithm>

namespace asperity {

namespace {

constexpr int kSideWidth = 140;    ///< of color bar and legend [px]
constexpr int kLegendIndent = 10;  ///< [px]
constexpr int kMarkSize = 20;      ///< [px]

template <typename Draw>
QPixmap markPixmap(const Draw& draw) {
    QPixmap pixmap(kMarkSize, kMarkSize);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    draw(painter);
    return pixmap;
}

void drawHatching(QPainter& painter) {
    constexpr int kInset = 3;  // [px]
    for (int row = kInset; row < kMarkSize - kInset; ++row) {
        for (int column = kInset; column < kMarkSize - kInset; ++column) {
            painter.fillRect(column, row, 1, 1, hatched(row, column));
        }
    }
}

/// "1.00 x 0.50 µm"
QString sizeText(double width, double height) {
    const SiScale scale = siScaleFor(std::max(width, height), "m");
    return QStringLiteral("%1 × %2 %3")
        .arg(width * scale.factor, 0, 'g', 3)
        .arg(height * scale.factor, 0, 'g', 3)
        .arg(QString::fromStdString(scale.unit));
}

}  // namespace

OverviewPanel::OverviewPanel(QWidget* parent)
    : Card(tr("Overview"), parent)
    , map_(new OverviewMap(this))
    , colorBar_(new ColorBarWidget(this))
    , scanNote_(captionLabel(QString(), this))
    , filledLegend_(new QWidget(this))
    , filledWords_(captionLabel(QString(), this)) {
    map_->setObjectName(QStringLiteral("overviewMap"));
    new CopyablePlot(*map_);
    auto* side = new QVBoxLayout;
    side->setSpacing(3);
    colorBar_->setFixedWidth(theme::scaled(kSideWidth));
    side->addWidget(colorBar_);
    map_->setToolTip(tr("The whole scan from above, colored by height; double click: go there"));
    side->addSpacing(6);
    addLegend(*side);
    side->addSpacing(6);
    scanNote_->setObjectName(QStringLiteral("scanNote"));
    scanNote_->setContentsMargins(kLegendIndent, 0, 0, 0);
    scanNote_->setWordWrap(true);
    scanNote_->setFixedWidth(theme::scaled(kSideWidth));
    side->addWidget(scanNote_);
    side->addStretch(1);
    auto* hint = captionLabel(tr("Double click: go there"), this);
    hint->setContentsMargins(kLegendIndent, 0, 0, 0);
    side->addWidget(hint);
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    row->addWidget(map_, 1);
    row->addLayout(side);
    body().addLayout(row, 1);
    connect(map_, &OverviewMap::positionChosen, this, &OverviewPanel::positionChosen);
}

void OverviewPanel::addLegend(QVBoxLayout& side) {
    const auto rowOf = [this](const QPixmap& mark, QLabel* words) {
        auto* row = new QHBoxLayout;
        row->setContentsMargins(kLegendIndent, 0, 0, 0);
        auto* sign = new QLabel(this);
        sign->setPixmap(mark);
        row->addWidget(sign);
        row->addWidget(words, 1);
        return row;
    };
    const auto add = [&](const QPixmap& mark, const QString& text) {
        side.addLayout(rowOf(mark, captionLabel(text, this)));
    };
    const QPointF center(kMarkSize / 2.0, kMarkSize / 2.0);
    add(markPixmap([&](QPainter& painter) { drawTipMark(painter, center); }), tr("tip"));
    add(markPixmap([](QPainter& painter) {
            drawFrameMark(painter, QRectF(3, 4, kMarkSize - 6, kMarkSize - 8));
        }),
        tr("zoomed view"));
    add(markPixmap([&](QPainter& painter) {
            drawPathMark(painter,
                         QVector<QPointF>{{2.0, center.y()}, {kMarkSize - 2.0, center.y()}});
        }),
        tr("path"));
    filledLegend_->setLayout(rowOf(markPixmap(drawHatching), filledWords_));
    filledLegend_->setObjectName(QStringLiteral("filledLegend"));
    filledLegend_->hide();
    side.addWidget(filledLegend_);
}

void OverviewPanel::begin(const Scene& scene) {
    setSurface(scene.surface);
    setScanNote(coreWords(imagingTipWords(scene)), coreWords(imagingTipNote(scene)));
}

void OverviewPanel::setSurface(const BSplineSurface& surface) {
    map_->setSurface(surface);
    colorBar_->setScale(map_->colors());
    showFilledLegend();
    setNote(sizeText(surface.sizeX(), surface.sizeY()));
}

void OverviewPanel::setLook(const SurfaceLook& look, const SurfaceField& field) {
    map_->setLook(look, field);
    colorBar_->setScale(map_->colors());
    showFilledLegend();
}

/// What is hatched: heights that are filled in, or values that the quantity shown misses.
void OverviewPanel::showFilledLegend() {
    filledWords_->setText(map_->hasGaps() ? tr("no data") : tr("no data: filled in"));
    filledLegend_->setVisible(map_->hasFilled() || map_->hasGaps());
}

void OverviewPanel::setScanNote(const QString& words, const QString& whole) {
    scanNote_->setText(words);
    scanNote_->setToolTip(whole);
}

void OverviewPanel::showFrame(const QRectF& frame) { map_->showFrame(frame); }

void OverviewPanel::showPath(const QPolygonF& path) { map_->showPath(path); }

void OverviewPanel::show(const Snapshot& snapshot) {
    const Vector3& tip = snapshot.sample.output.tip;
    map_->showTip({tip.x(), tip.y()});
}

void OverviewPanel::clear() { map_->hideTip(); }

}  // namespace asperity
