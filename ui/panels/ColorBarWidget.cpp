#include "ui/panels/ColorBarWidget.h"

#include "core/SiFormat.h"
#include "ui/Theme.h"
#include "ui/panels/AxisTicks.h"
#include "vtkplugins/pictures/Ticks.h"

#include <QLinearGradient>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

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

ColorBarWidget::ColorBarWidget(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setContextMenuPolicy(Qt::CustomContextMenu);
    setToolTip(tr("Which colors stand for which values"));
}

void ColorBarWidget::setScale(const ColorScale& scale) {
    scale_ = scale;
    const QString text = explanation(scale);
    setToolTip(text.isEmpty() ? tr("Which colors stand for which values") : text);
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

QSize ColorBarWidget::minimumSizeHint() const { return {100, sizeHint().height()}; }

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
