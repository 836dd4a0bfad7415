#pragma once

#include "ui/InputHelp.h"
#include "ui/view/PixelView.h"

#include <QPointF>

namespace asperity {

/// A view that signals what a user does to it by mouse and keys: the left button drags, the right
/// one turns, the wheel lifts (Shift: a tenth of a drag and a lift); Ctrl and the wheel, + and -
/// zoom.
class GestureWidget : public PixelView {
    Q_OBJECT

public:
    explicit GestureWidget(QWidget* parent = nullptr);

    /// What mouse and keys do to it.
    [[nodiscard]] static InputHelps help();
    /// Whether a shortcut of this key would take it from the view.
    [[nodiscard]] static bool takes(int key, Qt::KeyboardModifiers modifiers);

    /// Whether the left button is held.
    [[nodiscard]] bool isDragging() const { return dragging_; }

Q_SIGNALS:
    void dragged(QPointF pixels);
    void turned(QPointF pixels);
    void lifted(double notches);
    void zoomed(double steps);
    /// The pointer is here and no button is held [pixel].
    void hovered(QPointF pixel);
    /// The pointer has left the view.
    void unhovered();

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    QPointF pointer_;  ///< where the last event of the mouse was
    bool dragging_ = false;
};

}  // namespace asperity
