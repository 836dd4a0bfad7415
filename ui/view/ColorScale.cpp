#include "ui/view/ColorScale.h"

#include "ui/plot/PlotNavigation.h"
#include "ui/widgets/ShownText.h"
#include "ui/widgets/Theme.h"
#include "vtkplugins/pictures/Ticks.h"

#include <QLinearGradient>
#include <QObject>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace asperity {

namespace {

constexpr int kScaleColors = 64;

constexpr std::array kPrefixed = {"m", "V", "A", "N", "Pa", "Hz", "s", "W", "J", "C", "F", "T"};

constexpr double kPercent = 0.01;
constexpr double kPermille = 0.001;

double leftOutBy(RangeRule rule) {
    switch (rule) {
    case RangeRule::Percent:
        return kPercent;
    case RangeRule::Permille:
        return kPermille;
    case RangeRule::Full:
    case RangeRule::Own:
        break;
    }
    return 0.0;
}

/// Values that are all the same get a range around them.
ValueRange widened(const ValueRange& range, double smallest) {
    const double missing = 0.5 * (smallest - (range.high - range.low));
    return missing > 0.0 ? ValueRange{range.low - missing, range.high + missing} : range;
}

bool isSame(const ValueRange& one, const ValueRange& other) {
    return one.low == other.low && one.high == other.high;
}

constexpr int kLeastBarWidth = 76;   ///< two numbers and a part of its name [px]
constexpr int kColorBarHeight = 10;  ///< [px]
constexpr int kBarTickLength = 3;    ///< [px]
constexpr int kSideMargin = 14;      ///< room for half a label at each end [px]
constexpr int kLabelDistance = 30;   ///< between ticks, at least [px]

constexpr int kClipWidth = 7;  ///< of the arrow beyond an end [px]

/// The prefix that suits the whole range.
SiScale siScaleOf(const ColorScale& scale) {
    return shownScale(std::max(std::abs(scale.low), std::abs(scale.high)), scale.unit);
}

QString rangeText(const ColorScale& scale, double low, double high) {
    return QObject::tr("%1 to %2").arg(shownValue(low, scale.unit), shownValue(high, scale.unit));
}

/// What the bar says in whole sentences.
QString explanation(const ColorScale& scale) {
    if (scale.colors.empty()) {
        return {};
    }
    QString text = QObject::tr("Colors of %1: %2")
                       .arg(scale.quantity, rangeText(scale, scale.low, scale.high));
    if (!scale.rule.isEmpty()) {
        text += QObject::tr(" (%1)").arg(scale.rule);
    }
    if (!scale.note.isEmpty()) {
        text += QObject::tr("\nNo values: %1").arg(scale.note);
    } else if (!std::isnan(scale.dataLow)) {
        text +=
            QObject::tr("\nValues shown: %1").arg(rangeText(scale, scale.dataLow, scale.dataHigh));
    }
    if (scale.clipsLow() || scale.clipsHigh()) {
        text += QObject::tr("\nAn arrow marks an end that values lie beyond");
    }
    return text + QObject::tr("\nRight click: other colors, another range or quantity");
}

QFont tickFont() { return theme::textFont(theme::kTickSize); }

}  // namespace

ColorScale scaleOf(const ColorTable& table, const QString& quantity, const QString& unit) {
    ColorScale scale{
        .quantity = quantity, .unit = unit, .low = table.low(), .high = table.high(), .colors = {}};
    for (int i = 0; i < kScaleColors; ++i) {
        const Color color =
            table.of(std::lerp(table.low(), table.high(), i / (kScaleColors - 1.0)));
        scale.colors.emplace_back(color.red, color.green, color.blue);
    }
    return scale;
}

SiScale shownScale(double magnitude, const QString& unit) {
    const std::string name = unit.toStdString();
    if (name == "rad") {
        return {180.0 / std::numbers::pi, "°"};
    }
    if (name == "1") {
        return {1.0, ""};
    }
    constexpr double kSmallEnergy = 1e-14;  // [J]
    if (name == "J" && std::abs(magnitude) < kSmallEnergy) {
        return {1e18, "aJ"};  // 1 aJ is 1 nN nm
    }
    if (std::ranges::find(kPrefixed, name) != kPrefixed.end()) {
        return siScaleFor(magnitude, name);
    }
    return {1.0, name};
}

QString shownValue(double value, const QString& unit, int digits) {
    if (!std::isfinite(value)) {
        return QStringLiteral("–");
    }
    constexpr double kSmallLength = 1e-9;  // [m]
    if (unit == QStringLiteral("m") && std::abs(value) < kSmallLength) {
        return siText(value, "m");
    }
    const SiScale scale = shownScale(value, unit);
    const double shown = value == 0.0 ? 0.0 : value * scale.factor;  // never "-0"
    const QString number = QString::number(shown, 'g', digits);
    return scale.unit.empty() ? number
                              : number + QLatin1Char(' ') + QString::fromStdString(scale.unit);
}

double ColorRange::smallest(SurfaceQuantity quantity) {
    switch (quantity) {
    case SurfaceQuantity::Height:
    case SurfaceQuantity::Gap:
    case SurfaceQuantity::Displacement:
    case SurfaceQuantity::Residual:
        return 1e-10;  // [m]
    case SurfaceQuantity::Pressure:
        return 1e3;  // [Pa]
    case SurfaceQuantity::Slope:
        return 1e-3;  // [rad]
    case SurfaceQuantity::Certainty:
        return 1.0;
    case SurfaceQuantity::YoungsModulus:
    case SurfaceQuantity::WorkOfAdhesion:
    case SurfaceQuantity::FrictionCoefficient:
    case SurfaceQuantity::Channel:
    case SurfaceQuantity::ForceMap:
        break;
    }
    return 1e-30;  // whatever its unit
}

ValueRange ColorRange::wished(std::span<const double> values, const Wish& wish) {
    const QuantityColors& colors = wish.colors;
    if (colors.rule == RangeRule::Own) {
        return {colors.low, colors.high};
    }
    ValueRange range = rangeOf(values, leftOutBy(colors.rule));
    if (wish.isSigned && colors.map == ColorMap::Diverging) {
        const double largest = std::max(std::abs(range.low), std::abs(range.high));
        range = {-largest, largest};
    }
    if (wish.isSteady) {
        const AxisRange& axis = steady_.fit(range.low, range.high);
        return {axis.low, axis.high};
    }
    return range;
}

bool ColorRange::fit(std::span<const double> values, const Wish& wish) {
    const ValueRange dataBefore = data_;
    const ValueRange before = range_;
    const bool had = hasData_;
    hasData_ = std::ranges::any_of(values, [](double value) { return std::isfinite(value); });
    if (hasData_) {
        data_ = rangeOf(values);
        const bool isRest = wish.isSteady && wish.colors.rule != RangeRule::Own && !isOther_ &&
                            data_.low == 0.0 && data_.high == 0.0;
        if (!isRest && (!wish.colors.pinned || !isFitted_)) {
            const double some = 1e-12 * std::max(std::abs(data_.low), std::abs(data_.high));
            range_ = widened(wished(values, wish), std::max(some, smallest_));
            isFitted_ = true;
            isOther_ = false;
        }
    }
    return had != hasData_ || !isSame(before, range_) || !isSame(dataBefore, data_);
}

void ColorRange::describe(ColorScale& scale, const QuantityColors& colors) const {
    if (hasData_) {
        scale.dataLow = data_.low;
        scale.dataHigh = data_.high;
    }
    if (colors.pinned) {
        scale.rule = QObject::tr("pinned");
    } else if (colors.rule == RangeRule::Own) {
        scale.rule = QObject::tr("own range");
    } else if (colors.rule != RangeRule::Full) {
        scale.rule = QObject::tr(nameOf(colors.rule));
    }
}

ColorRanges::ColorRanges() {
    for (const SurfaceQuantity quantity : kValues<SurfaceQuantity>) {
        ranges_.emplace_back(quantity);
    }
}

void ColorRanges::forget() {
    for (ColorRange& range : ranges_) {
        range.forget();
    }
}

void ColorRanges::setChannel(const QString& name) {
    if (!name.isEmpty() && name != channel_) {
        channel_ = name;
        of(SurfaceQuantity::Channel) = ColorRange(SurfaceQuantity::Channel);
    }
}

ColorBarWidget::ColorBarWidget(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setContextMenuPolicy(Qt::CustomContextMenu);
    setToolTip(tr("Color scale of the values"));
}

void ColorBarWidget::setScale(const ColorScale& scale) {
    scale_ = scale;
    const QString text = explanation(scale);
    setToolTip(text.isEmpty() ? tr("Color scale of the values") : text);
    update();
}

QString ColorBarWidget::heading() const {
    if (scale_.colors.empty()) {
        return {};
    }
    const QString unit = QString::fromStdString(siScaleOf(scale_).unit);
    return unit.isEmpty() ? scale_.quantity : QStringLiteral("%1 [%2]").arg(scale_.quantity, unit);
}

QString ColorBarWidget::remark() const {
    if (scale_.colors.empty()) {
        return {};
    }
    return scale_.note.isEmpty() ? scale_.rule : scale_.note;
}

QSize ColorBarWidget::sizeHint() const {
    const int heading = QFontMetrics(theme::textFont(theme::kSmallSize)).height();
    const int labels = QFontMetrics(tickFont()).height();
    return {160, heading + 2 + kColorBarHeight + kBarTickLength + 1 + labels};
}

QSize ColorBarWidget::minimumSizeHint() const { return {kLeastBarWidth, sizeHint().height()}; }

void ColorBarWidget::paintEvent(QPaintEvent* /*event*/) {
    if (scale_.colors.size() < 2) {
        return;
    }
    QPainter painter(this);
    painter.setFont(theme::textFont(theme::kSmallSize));
    const int top = painter.fontMetrics().height() + 2;
    drawHeading(painter, top);
    const QRectF bar(kSideMargin, top, width() - (2 * kSideMargin), kColorBarHeight);
    drawBar(painter, bar);
    drawClips(painter, bar);
    drawTicks(painter, bar);
}

void ColorBarWidget::drawHeading(QPainter& painter, int height) const {
    const QRect line(kSideMargin, 0, width() - 2 * kSideMargin, height);
    constexpr int kGap = 6;  // [px]
    const QFontMetrics metrics = painter.fontMetrics();
    const int room = line.width() - metrics.horizontalAdvance(heading());
    // In a narrow bar the unit is worth more than how the range is chosen.
    const bool fits = metrics.horizontalAdvance(remark()) + kGap <= room;
    const QString right = fits ? remark() : QString();
    const int taken = right.isEmpty() ? 0 : metrics.horizontalAdvance(right) + kGap;
    const QString unit = heading().mid(scale_.quantity.size());
    const QString name = metrics.elidedText(scale_.quantity, Qt::ElideRight,
                                            line.width() - taken - metrics.horizontalAdvance(unit));
    painter.setPen(theme::colors().muted);
    painter.drawText(line, Qt::AlignLeft, name + unit);
    painter.drawText(line, Qt::AlignRight, right);
}

/// An arrow that points out of the bar where values lie beyond its end, in that end's color.
void ColorBarWidget::drawClips(QPainter& painter, const QRectF& bar) const {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const auto arrow = [&](double end, double direction, const QColor& color) {
        const QPointF tip(end + direction * (kClipWidth + 2.0), bar.center().y());
        painter.setPen(theme::colors().ink);
        painter.setBrush(color);
        painter.drawPolygon(QPolygonF({QPointF(end + direction * 2.0, bar.top()), tip,
                                       QPointF(end + direction * 2.0, bar.bottom())}));
    };
    if (scale_.clipsLow()) {
        arrow(bar.left(), -1.0, scale_.colors.front());
    }
    if (scale_.clipsHigh()) {
        arrow(bar.right(), 1.0, scale_.colors.back());
    }
    painter.restore();
}

void ColorBarWidget::drawBar(QPainter& painter, const QRectF& bar) const {
    QLinearGradient gradient(bar.topLeft(), bar.topRight());
    const auto last = static_cast<double>(scale_.colors.size() - 1);
    for (std::size_t i = 0; i < scale_.colors.size(); ++i) {
        gradient.setColorAt(static_cast<double>(i) / last, scale_.colors[i]);
    }
    painter.fillRect(bar, gradient);
}

void ColorBarWidget::drawTicks(QPainter& painter, const QRectF& bar) const {
    const SiScale scale = siScaleOf(scale_);
    const double low = scale_.low * scale.factor;
    const double high = scale_.high * scale.factor;
    const int count = std::max(1, static_cast<int>(bar.width()) / kLabelDistance);
    const std::vector<double> ticks = axisTicks(low, high, count);
    const std::vector<std::string> labels = tickLabels(ticks);
    painter.setFont(tickFont());
    painter.setPen(theme::colors().muted);
    for (std::size_t i = 0; i < ticks.size(); ++i) {
        const double share = high > low ? (ticks[i] - low) / (high - low) : 0.5;
        const double x = bar.left() + (share * bar.width());
        painter.drawLine(QPointF(x, bar.bottom()), QPointF(x, bar.bottom() + kBarTickLength));
        painter.drawText(QRectF(x - kLabelDistance, bar.bottom() + kBarTickLength + 1,
                                2 * kLabelDistance, painter.fontMetrics().height()),
                         Qt::AlignHCenter, QString::fromStdString(labels[i]));
    }
}

}  // namespace asperity
