#pragma once

#include "ui/ColorScale.h"

#include <QWidget>

namespace asperity {

/// A horizontal bar that shows which colors stand for which values, with name, unit and ticks.
class ColorBarWidget : public QWidget {
public:
    explicit ColorBarWidget(QWidget* parent = nullptr);

    void setScale(const ColorScale& scale);

    /// "height [nm]": what stands above the bar; empty when there is nothing to show.
    [[nodiscard]] QString heading() const;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] QString text(double value) const;
    void drawBar(QPainter& painter, const QRectF& bar) const;
    void drawTicks(QPainter& painter, const QRectF& bar) const;

    ColorScale scale_;
};

}  // namespace asperity
