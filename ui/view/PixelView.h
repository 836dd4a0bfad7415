#pragma once

#include "ui/widgets/InputHelp.h"

#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include <QImage>
#include <QPointF>
#include <QWidget>

class vtkOpenGLRenderWindow;
class vtkRenderWindow;

namespace asperity {

/// A widget that shows what VTK draws in a window off the screen. A widget of OpenGL would have Qt
/// compose the whole main window by OpenGL in each frame, which takes longer than the picture
/// itself where the processor draws.
class PixelView : public QWidget {
    Q_OBJECT

public:
    explicit PixelView(QWidget* parent = nullptr);
    ~PixelView() override;

    /// The last frame, in pixels of the screen or, while coarse, fewer; null: there is none yet.
    [[nodiscard]] const QImage& frame() const { return frame_; }
    /// Window that draws, and is never shown itself.
    [[nodiscard]] vtkOpenGLRenderWindow& renderWindow() const;

Q_SIGNALS:
    /// The last frame has been painted.
    void painted();

protected:
    /// Sets whether from the next frame on at most half a million pixels are drawn, and enlarged:
    /// most of the time of a frame is spent on its pixels.
    void setCoarse(bool coarse);
    /// Pixels that are drawn for each of the widget, along each side.
    [[nodiscard]] double drawnRatio() const;

    /// Makes larger buffers where frames of the present size need them, which takes longer than a
    /// frame where the processor draws: a call of its own for each, so that neither holds up the
    /// window for long.
    /// @return whether it did; not twice in a row, so that frames come while a border is dragged
    bool makeBuffers();
    /// Draws a frame and has it painted; not while the widget is hidden. @return whether it did
    bool drawFrame();

    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] QSize pixels(double ratio) const;

    vtkNew<vtkRenderWindow> window_;
    vtkNew<vtkUnsignedCharArray> drawn_;
    QImage frame_;
    QSize buffers_{0, 0};  ///< of the frames that the buffers are for
    bool hasJustMadeBuffers_ = false;
    bool coarse_ = false;
};

/// A view that signals what a user does to it by mouse and keys: the left button drags, the right
/// one turns, the wheel lifts (Shift: a tenth of a drag and a lift); Ctrl and the wheel, + and -
/// zoom.
class GestureWidget : public PixelView {
    Q_OBJECT

public:
    explicit GestureWidget(QWidget* parent = nullptr);

    /// Returns what mouse and keys do to the view, for help.
    [[nodiscard]] static InputHelps help();
    /// Returns whether the view needs this key, so that no shortcut may take it.
    [[nodiscard]] static bool takes(int key, Qt::KeyboardModifiers modifiers);

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
