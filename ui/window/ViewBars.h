#pragma once

#include <QWidget>

namespace asperity {

class ColorBarWidget;
class ZoomView;

/// The color bars of a view: that of the quantity, and that of displacements where they are shown
/// over it.
class ViewBars : public QWidget {
    Q_OBJECT

public:
    /// @param view outlives this object
    explicit ViewBars(const ZoomView& view, QWidget* parent = nullptr);

Q_SIGNALS:
    /// A right click asks for another coloring, at this place of the screen.
    void colorsRequested(QPoint at);

private:
    void showScales(const ZoomView& view);

    ColorBarWidget* quantity_;
    ColorBarWidget* displacement_;
};

}  // namespace asperity
