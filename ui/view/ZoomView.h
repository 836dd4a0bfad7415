#pragma once

#include "core/haptics/Snapshot.h"
#include "ui/ColorScale.h"
#include "ui/view/GestureWidget.h"
#include "ui/view/ZoomPicture.h"

#include <vtkNew.h>

#include <QTimer>

class vtkGenericOpenGLRenderWindow;

namespace asperity {

/// The large live view: surface, deformed contact, tip and force around the tip, in 3-D.
///
/// Left drag moves the tip in its horizontal plane, right drag turns the view; what the wheel does
/// to the tip is the caller's (GestureWidget::lifted).
class ZoomView : public GestureWidget {
    Q_OBJECT

public:
    explicit ZoomView(QWidget* parent = nullptr);
    ~ZoomView() override;
    ZoomView(const ZoomView&) = delete;
    ZoomView& operator=(const ZoomView&) = delete;

    /// What to show; null: an empty view. The scene outlives its use here.
    void setScene(const Scene* scene);
    /// Shows a tick of the present scene: draws one frame.
    void showSnapshot(const Snapshot& snapshot);

    /// What is drawn from the next snapshot on where the scene asks for the half-space; or null.
    void setHalfSpace(std::shared_ptr<const HalfSpaceAnswer> answer);

    /// The part of the scan that is shown, world [m]; empty without a scene.
    [[nodiscard]] std::optional<ScanWindow> window() const;
    /// Half the width of that part [m]; 0 without a scene.
    [[nodiscard]] double halfWidth() const;
    /// Takes the nearest width that can be shown.
    void setHalfWidth(double halfWidth);
    /// The direction of view.
    [[nodiscard]] const ViewCamera& camera() const { return camera_; }
    /// Back to the direction and the width that a scene starts with.
    void resetCamera();

    void setOptions(const ViewOptions& options);
    [[nodiscard]] const ViewOptions& options() const { return picture_.options(); }

    /// They hold no colors while there is no scene.
    [[nodiscard]] ColorScale heightScale() const;
    [[nodiscard]] ColorScale displacementScale() const;

    /// Where a world place [m] is seen, in pixels of the widget.
    [[nodiscard]] QPointF onScreen(const Vector3& place) const;
    /// Whether what does not change is drawn once and kept; on, but for measurements.
    void setCacheEnabled(bool enabled);

Q_SIGNALS:
    /// The user asks the tip to go along the sample by this much, world [m].
    void tipDragged(double dx, double dy);
    void frameChanged();   ///< window() is another
    void scalesChanged();  ///< a color scale is another
    void frameRendered();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void connectGestures();
    void disturb();
    void renderSoon();
    void renderNow();

    vtkNew<vtkGenericOpenGLRenderWindow> renderWindow_;
    ZoomPicture picture_;
    ViewCamera camera_;
    QTimer settling_;          ///< runs while the view is in motion
    QTimer frameDue_;          ///< runs while a frame is due
    bool terrainDue_ = false;  ///< it is to be shown anew in the next frame
    bool contactDue_ = false;  ///< and so is all the rest
};

}  // namespace asperity
