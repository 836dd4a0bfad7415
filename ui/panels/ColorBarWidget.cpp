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

constexpr int kBarHeight = 10;      ///< [px]
constexpr int kTickLength = 3;      ///< [px]
constexpr int kSideMargin = 14;     ///< room for half a label at each end [px]
constexpr int kLabelDistance = 30;  ///< between ticks, at least [px]

/// The prefix that suits the whole range.
SiScale siScaleOf(const ColorScale& scale) {
    return siScaleFor(std::max(std::abs(scale.low), std::abs(scale.high)),
                      scale.unit.toStdString());
}

QFont tickFont() { return theme::textFont(theme::kTickSize); }

}  // namespace

ColorBarWidget::ColorBarWidget(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void ColorBarWidget::setScale(const ColorScale& scale) {
    scale_ = scale;
    setToolTip(scale_.colors.empty()
                   ? QString()
                   : tr("Color scale: %1, %2 to %3")
                         .arg(scale_.quantity, text(scale_.low), text(scale_.high)));
    update();
}

QString ColorBarWidget::text(double value) const {
    return QString::fromStdString(formatSi(value, scale_.unit.toUtf8().constData()));
}

QString ColorBarWidget::heading() const {
    if (scale_.colors.empty()) {
        return {};
    }
    return QStringLiteral("%1 [%2]").arg(scale_.quantity,
                                         QString::fromStdString(siScaleOf(scale_).unit));
}

QSize ColorBarWidget::sizeHint() const {
    const int heading = QFontMetrics(theme::textFont(theme::kSmallSize)).height();
    const int labels = QFontMetrics(tickFont()).height();
    return {160, heading + 2 + kBarHeight + kTickLength + 1 + labels};
}

QSize ColorBarWidget::minimumSizeHint() const { return {100, sizeHint().height()}; }

void ColorBarWidget::paintEvent(QPaintEvent* /*event*/) {
    if (scale_.colors.size() < 2) {
        return;
    }
    QPainter painter(this);
    painter.setFont(theme::textFont(theme::kSmallSize));
    const int top = painter.fontMetrics().height() + 2;
    painter.setPen(theme::colors().muted);
    painter.drawText(QRect(kSideMargin, 0, width() - kSideMargin, top), Qt::AlignLeft, heading());
    const QRectF bar(kSideMargin, top, width() - (2 * kSideMargin), kBarHeight);
    drawBar(painter, bar);
    drawTicks(painter, bar);
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
        painter.drawLine(QPointF(x, bar.bottom()), QPointF(x, bar.bottom() + kTickLength));
        painter.drawText(QRectF(x - kLabelDistance, bar.bottom() + kTickLength + 1,
                                2 * kLabelDistance, painter.fontMetrics().height()),
                         Qt::AlignHCenter, QString::fromStdString(labels[i]));
    }
}

}  // namespace asperity
