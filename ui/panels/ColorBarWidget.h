#pragma once

#include "ui/ColorScale.h"

#include <QWidget>

namespace asperity {

/// A horizontal bar that shows which colors stand for which values, with name, unit and ticks; how
/// its range was chosen, and by an arrow at an end that values lie beyond it. A right click asks
/// for another coloring (customContextMenuRequested).
class ColorBarWidget : public QWidget {
public:
    explicit ColorBarWidget(QWidget* parent = nullptr);

    void setScale(const ColorScale& scale);

    /// "height [nm]": what stands above the bar; empty when there is nothing to show.
    [[nodiscard]] QString heading() const;
    /// "1–99 %", or why there are no values; empty: all values are shown.
    [[nodiscard]] QString remark() const;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void drawHeading(QPainter& painter, int height) const;
    void drawBar(QPainter& painter, const QRectF& bar) const;
    void drawClips(QPainter& painter, const QRectF& bar) const;
    void drawTicks(QPainter& painter, const QRectF& bar) const;

    ColorScale scale_;
};

}  // namespace asperity
