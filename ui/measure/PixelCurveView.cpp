#include "ui/measure/PixelCurveView.h"

#include "core/scene/FlagOrder.h"
#include "ui/ColorScale.h"
#include "ui/CoreWords.h"
#include "ui/Theme.h"
#include "ui/measure/ReadingGrid.h"
#include "ui/panels/Card.h"
#include "ui/panels/ForceDistancePlot.h"
#include "ui/panels/PlotNavigation.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr int kDigits = 4;
constexpr double kFreeShare = 0.5;  ///< of the width of the contact: how much of the way beside it
constexpr double kLeastContact =
    0.5e-9;                      ///< width of one, so that a stiff one shows its attraction
constexpr int kMinHeight = 100;  ///< [px]

/// "4.3 nN", or a dash.
QString valueText(MapQuantity quantity, double value) {
    if (quantity != MapQuantity::Validity) {
        const QString unit = QString::fromLatin1(rowOf(quantity)->unit);
        return shownValue(value, unit.isEmpty() ? QStringLiteral("1") : unit, kDigits);
    }
    QStringList flags;
    const auto bits = std::isnan(value) ? 0U : static_cast<std::uint32_t>(value);
    for (const Validity flag : kFlagsByEffect) {
        if ((bits & static_cast<std::uint32_t>(flag)) != 0U) {
            flags << coreWords(traitsOf(flag).brief);
        }
    }
    if (std::isnan(value)) {
        return {};
    }
    return flags.isEmpty() ? PixelCurveView::tr("none") : flags.join(QLatin1Char('\n'));
}

/// As wide as what it holds, and as high as there is room.
class ReadingScroll : public QScrollArea {
public:
    explicit ReadingScroll(QWidget& readings) {
        setFrameShape(QFrame::NoFrame);
        setWidgetResizable(true);
        setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
        setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Ignored);
        setWidget(&readings);
    }
    [[nodiscard]] QSize sizeHint() const override {
        const int held =
            std::max(widget()->sizeHint().width(), widget()->minimumSizeHint().width());
        return {held + verticalScrollBar()->sizeHint().width(), QScrollArea::sizeHint().height()};
    }
    [[nodiscard]] QSize minimumSizeHint() const override {
        return {sizeHint().width(), QScrollArea::minimumSizeHint().height()};
    }
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (watched == widget() && event->type() == QEvent::LayoutRequest) {
            updateGeometry();  // texts are wider, or have their fonts now
        }
        return QScrollArea::eventFilter(watched, event);
    }

protected:
    void showEvent(QShowEvent* event) override {
        QScrollArea::showEvent(event);
        updateGeometry();
    }
};

bool isShown(MapMode mode, const MapQuantityRow& row) {
    return hasQuantity(mode, row) && !row.onRequest && row.value != MapQuantity::Iterations;
}

QString titleOf(const MapQuantityRow& row) {
    return coreWords(row.value == MapQuantity::Validity ? "flags" : row.name);
}

}  // namespace

PixelCurveView::PixelCurveView(QWidget* parent)
    : QWidget(parent)
    , title_(captionLabel(QString(), this))
    , axis_(new QComboBox(this))
    , plot_(new ForceDistancePlot(this))
    , stack_(new QStackedWidget(this)) {
    title_->setObjectName(QStringLiteral("pixelTitle"));
    title_->setToolTip(tr("Which pixel of the map the curve and the values are of"));
    title_->setWordWrap(true);
    axis_->setObjectName(QStringLiteral("pixelAxis"));
    axis_->addItems({tr("tip z"), tr("base z")});
    axis_->setToolTip(tr("Distance axis: height of the tip as the instrument records it, base plus "
                         "deflection along z; or of the base"));
    axis_->setFont(theme::textFont(theme::kSmallSize));
    axis_->setFocusPolicy(Qt::TabFocus);
    axis_->setProperty("compact", true);
    plot_->heading().addWidget(axis_);
    plot_->setObjectName(QStringLiteral("pixelPlot"));
    plot_->setMinimumHeight(theme::scaled(kMinHeight));
    plot_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);  // as high as there is room
    plot_->setToolTip(tr("Force along z over height, approach and retract at one pixel; rings mark "
                         "the snap-in and the pull-off") +
                      QLatin1Char('\n') + PlotNavigation::help());
    for (const MapMode mode : kValues<MapMode>) {
        stack_->addWidget(newReadings(mode));
    }
    auto* left = new QVBoxLayout;
    left->setSpacing(2);
    left->addWidget(title_);
    left->addWidget(plot_, 1);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(12);
    row->addLayout(left, 1);
    row->addWidget(new ReadingScroll(*stack_));
    connect(axis_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] {
        plot_->forgetRange();
        draw();
    });
}

ReadingGrid* PixelCurveView::newReadings(MapMode mode) {
    auto* grid = new ReadingGrid(this);
    for (const MapQuantityRow& row : kEnumTable<MapQuantity>) {
        if (isShown(mode, row)) {
            grid->add(row.key, titleOf(row), tr("What the map has at this pixel"));
        }
    }
    return grid;
}

ReadingGrid& PixelCurveView::readings() const {
    return *static_cast<ReadingGrid*>(stack_->widget(static_cast<int>(mode_)));
}

QString PixelCurveView::title() const { return title_->text(); }

QString PixelCurveView::reading(MapQuantity quantity) const {
    return readings().text(rowOf(quantity)->key);
}

void PixelCurveView::setPixel(const QString& title, const PixelCurve& curve, MapMode mode,
                              const MapValues& values) {
    title_->setText(title);
    curve_ = curve;
    mode_ = mode;
    stack_->setCurrentIndex(static_cast<int>(mode));
    showValues(values);
    plot_->forgetRange();
    draw();
}

void PixelCurveView::clear(const QString& title) {
    title_->setText(title);
    curve_.reset();
    showValues({});
    plot_->forgetRange();
    draw();
}

void PixelCurveView::showValues(const MapValues& values) {
    for (const MapQuantityRow& row : kEnumTable<MapQuantity>) {
        if (isShown(mode_, row)) {
            readings().set(row.key, valueText(row.value, values[row.value]));
        }
    }
}

/// The contact, with some of the free way beside it.
void PixelCurveView::draw() {
    if (!curve_) {
        plot_->setCycles({}, {});
        return;
    }
    const bool showsBase = axis_->currentIndex() == 1;
    const auto placed = [showsBase](const PixelCurvePoint& point) {
        return QPointF(showsBase ? point.base : point.tip, point.force);
    };
    AxisRange heights{std::numeric_limits<double>::infinity(),
                      -std::numeric_limits<double>::infinity()};
    const auto hold = [&heights](double height) {
        heights = {std::min(heights.low, height), std::max(heights.high, height)};
    };
    DrawnCycle cycle;
    for (const PixelCurvePoint& point : curve_->approach) {
        cycle.approach << placed(point);
        heights.low = std::min(heights.low, placed(point).x());
    }
    for (const PixelCurvePoint& point : curve_->retract) {
        cycle.retract << placed(point);
    }
    if (cycle.approach.isEmpty()) {
        plot_->setCycles({}, {});
        return;
    }
    hold(heights.low);
    if (curve_->snapIn) {
        cycle.snapIn = placed(*curve_->snapIn);
        hold(cycle.snapIn->x());
    }
    if (curve_->pullOff) {
        cycle.pullOff = placed(*curve_->pullOff);
        hold(cycle.pullOff->x());
    }
    heights.high += kFreeShare * std::max(kLeastContact, heights.high - heights.low);
    plot_->setCycles({cycle}, heights);
}

}  // namespace asperity
