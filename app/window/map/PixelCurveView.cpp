#include "app/window/map/PixelCurveView.h"

#include "core/scene/Validity.h"
#include "ui/plot/ForceDistancePlot.h"
#include "ui/plot/PlotNavigation.h"
#include "ui/view/ColorScale.h"
#include "ui/view/MapTool.h"
#include "ui/view/OverviewMap.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/PageParts.h"
#include "ui/widgets/ShownText.h"
#include "ui/widgets/Theme.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QScrollArea>
#include <QScrollBar>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr double kOutline = 1.0;      ///< [px]
constexpr double kMark = 2.0;         ///< width of a pixel's frame [px]
constexpr double kMinMark = 9.0;      ///< side of a pixel's frame [px]
constexpr QPointF kLabel(4.0, 12.0);  ///< from the upper left corner of the map [px]

QPainterPath frameOf(const QRectF& around) {
    QPainterPath path;
    path.addRect(around);
    return path;
}

constexpr int kDigits = 4;
constexpr double kBesideShare =
    0.5;  ///< of the width of the contact: how much of the way beside it
constexpr double kMinContact = 0.5e-9;  ///< width of one, so that a stiff one shows its attraction
constexpr int kMinHeight = 100;         ///< [px]

/// "4.3 nN", or a dash.
QString valueText(MapQuantity quantity, double value) {
    if (quantity != MapQuantity::Validity) {
        const QString unit = QString::fromLatin1(rowOf(quantity)->unit);
        return shownValue(value, unit.isEmpty() ? QStringLiteral("1") : unit, kDigits);
    }
    QStringList flags;
    const ValidityFlags set(std::isnan(value) ? 0U : static_cast<std::uint64_t>(value));
    for (const Validity flag : kFlagsByEffect) {
        if (set.has(flag)) {
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

void PixelTool::setPart(const std::optional<MappedPart>& part) {
    if (!part || !part_ || part->region != part_->region || part->pixels != part_->pixels) {
        pixel_.reset();
    }
    part_ = part;
    Q_EMIT marksChanged();
}

void PixelTool::setPixel(const std::optional<QPoint>& pixel) {
    pixel_ = pixel;
    Q_EMIT marksChanged();
}

std::optional<QPoint> PixelTool::pixelAt(const QPointF& position) const {
    if (!part_ || !part_->region.contains(position)) {
        return std::nullopt;
    }
    const QPointF from = position - part_->region.topLeft();
    const auto entry = [](double share, int count) {
        return std::clamp(static_cast<int>(share * count), 0, count - 1);
    };
    return QPoint(entry(from.x() / part_->region.width(), part_->pixels.width()),
                  entry(1.0 - (from.y() / part_->region.height()), part_->pixels.height()));
}

void PixelTool::paint(QPainter& painter, const OverviewMap& map) const {
    if (!part_) {
        return;
    }
    const QRectF& region = part_->region;
    const QRectF drawn =
        QRectF(map.toPixel(region.topLeft()), map.toPixel(region.bottomRight())).normalized();
    if (drawn.size() != map.mapRect().size()) {
        strokeOverWhite(painter, kLightPalette.ink, kOutline, frameOf(drawn.toRect()));
    }
    paintPixel(painter, map);
    if (!part_->label.isEmpty()) {
        labelMark(painter, kLightPalette.ink, drawn.topLeft() + kLabel, part_->label);
    }
}

void PixelTool::paintPixel(QPainter& painter, const OverviewMap& map) const {
    if (!pixel_) {
        return;
    }
    const QRectF& region = part_->region;
    const QSizeF pitch(region.width() / part_->pixels.width(),
                       region.height() / part_->pixels.height());
    const QPointF middle(region.left() + (pixel_->x() + 0.5) * pitch.width(),
                         region.bottom() - (pixel_->y() + 0.5) * pitch.height());
    const QPointF corner(0.5 * pitch.width(), 0.5 * pitch.height());
    QRectF drawn = QRectF(map.toPixel(middle - corner), map.toPixel(middle + corner)).normalized();
    const double widen = 0.5 * std::max(0.0, kMinMark - std::min(drawn.width(), drawn.height()));
    drawn.adjust(-widen, -widen, widen, widen);
    strokeOverWhite(painter, kLightPalette.blue, kMark, frameOf(drawn));
}

void PixelTool::press(const MapPointer& pointer, const OverviewMap& /*map*/) {
    const std::optional<QPoint> pixel = pixelAt(pointer.position);
    if (pixel && pixel != pixel_) {
        setPixel(pixel);
        Q_EMIT pixelChosen(*pixel);
    }
}

void PixelTool::drag(const MapPointer& pointer, const OverviewMap& map) { press(pointer, map); }

Qt::CursorShape PixelTool::cursor(const MapPointer& pointer, const OverviewMap& /*map*/) const {
    return pixelAt(pointer.position) ? Qt::PointingHandCursor : Qt::ForbiddenCursor;
}

QString PixelTool::hint() const { return tr("Click: the force curve of that pixel"); }

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
    heights.high += kBesideShare * std::max(kMinContact, heights.high - heights.low);
    plot_->setCycles({cycle}, heights);
}

}  // namespace asperity
