#pragma once

#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include <QImage>
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
    /// What draws, and is never shown itself.
    [[nodiscard]] vtkOpenGLRenderWindow& renderWindow() const;

Q_SIGNALS:
    /// The last frame has been painted.
    void painted();

protected:
    /// Whether from the next frame on at most half a million pixels are drawn, and enlarged: the
    /// time of a frame is mostly that of its pixels.
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

}  // namespace asperity
