#pragma once

#include "core/deformation/HalfSpaceModel.h"
#include "core/haptics/Snapshot.h"
#include "core/scene/Scene.h"
#include "ui/ColourScale.h"
#include "ui/view/ContactLayer.h"
#include "ui/view/ForceLayer.h"
#include "ui/view/GuideLayer.h"
#include "ui/view/Magnification.h"
#include "ui/view/StaticLayer.h"
#include "ui/view/SurfaceColours.h"
#include "ui/view/TerrainLayer.h"
#include "ui/view/TipLayer.h"
#include "ui/view/ViewCamera.h"
#include "ui/view/ViewFrame.h"
#include "ui/view/ViewLabels.h"
#include "ui/view/ViewScale.h"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkNew.h>

#include <QPointF>
#include <QTimer>

#include <memory>
#include <optional>

class vtkGenericOpenGLRenderWindow;
class vtkRenderer;

namespace asperity {

/// The large live view: surface, deformed contact, tip and force around the tip, in 3-D.
///
/// Left drag moves the tip in its horizontal plane, the wheel moves it up and down (Shift: a tenth
/// of both); right drag turns the view; Ctrl and the wheel, + and - zoom.
class ZoomView : public QVTKOpenGLNativeWidget {
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

    /// How much larger than life displacements are drawn; empty: chosen by the view.
    void setMagnification(std::optional<double> factor);
    [[nodiscard]] double magnification() const { return magnification_.factor(); }

    /// They hold no colours while there is no scene.
    [[nodiscard]] ColourScale heightScale() const;
    [[nodiscard]] ColourScale displacementScale() const;

    /// Where a world place [m] is seen, in pixels of the widget.
    [[nodiscard]] QPointF onScreen(const Vector3& place) const;
    /// Whether what does not change is drawn once and kept; on, but for measurements.
    void setCacheEnabled(bool enabled);

Q_SIGNALS:
    /// The person asks the tip to go by this much, world [m].
    void tipDragged(double dx, double dy, double dz);
    void frameChanged();   ///< window() is another
    void scalesChanged();  ///< a colour scale is another
    void frameRendered();

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void addLayers();
    void showPicture();
    void follow(const Vector2& tip);
    void placeTerrain(const TerrainPlace& place);
    void showContact(const TickSample& sample);
    void hideContact();
    void showLabels();

    void zoomBy(double steps);
    void turnBy(const QPointF& pixels);
    void dragBy(const QPointF& pixels, bool finely);
    void aimCamera();
    [[nodiscard]] FrameBox frameBox() const;
    [[nodiscard]] double metresPerPixel() const;

    void disturb();
    void settle();
    void renderSoon();
    void renderNow();

    const Scene* scene_ = nullptr;
    ViewScale scale_;
    std::optional<TickSample> sample_;
    std::shared_ptr<const HalfSpaceAnswer> halfSpace_;
    std::optional<ViewFrame> frame_;
    ViewCamera camera_;
    SurfaceColours colours_;
    Magnification magnification_;

    vtkNew<vtkGenericOpenGLRenderWindow> renderWindow_;
    vtkNew<vtkRenderer> still_;    ///< the surface at rest
    vtkNew<vtkRenderer> live_;     ///< what changes from frame to frame
    vtkNew<vtkRenderer> through_;  ///< what shows through everything
    StaticLayer cache_;
    TerrainLayer terrain_;
    ContactLayer contact_;
    TipLayer tip_;
    ForceLayer force_;
    GuideLayer guide_;
    ViewLabels labels_;

    QTimer settling_;          ///< runs while the view is in motion
    QTimer frameDue_;          ///< runs while a frame is due
    bool terrainDue_ = false;  ///< it is to be shown anew in the next frame
    bool contactDue_ = false;  ///< and so is all the rest
    QPointF pointer_;          ///< where the last event of the mouse was
    bool dragging_ = false;
};

}  // namespace asperity
