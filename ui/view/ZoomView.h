#pragma once

#include "core/haptics/VirtualRun.h"
#include "ui/view/ColorScale.h"
#include "ui/view/PixelView.h"
#include "ui/view/SurfacePick.h"
#include "ui/view/ZoomPicture.h"

#include <QElapsedTimer>
#include <QTimer>

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

    /// Sets the scene to show; null: an empty view. The scene outlives its use here.
    void setScene(const Scene* scene);
    /// Shows a tick of the present scene: draws one frame.
    void showSnapshot(const Snapshot& snapshot);

    /// See ZoomPicture: from the next snapshot on.
    void setWrittenForce(std::string force) { picture_.setWrittenForce(std::move(force)); }

    /// Sets the half-space to draw from the next snapshot on where the scene asks for it; or null.
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
    void lookFrom(ViewDirection side);
    /// See ViewCamera [rad].
    void setDirection(double azimuth, double elevation);
    void setPerspective(bool perspective);

    void setOptions(const ViewOptions& options);
    [[nodiscard]] const ViewOptions& options() const { return picture_.options(); }

    /// Sets how the surface is colored. @param field the look's quantity on the surface at rest
    void setLook(const SurfaceLook& look, const SurfaceField& field);
    /// Scales of the quantity, and of displacements over it. Without a scene they hold no colors.
    [[nodiscard]] ColorScale colorScale() const;
    [[nodiscard]] ColorScale displacementScale() const;

    /// Shows a cross-hair at a position of the surface at rest, world x, y [m], with what is read
    /// there; none: no cross-hair. While the loop runs it costs no frame of its own.
    void showCrossHair(const std::optional<Vector2>& position);
    [[nodiscard]] const std::optional<Vector2>& crossHair() const { return picture_.crossHair(); }
    /// Shows where the tip's apex shall be, from the next snapshot on, in whatever scene [m]; none:
    /// nowhere.
    void setTarget(const std::optional<Vector3>& target) { picture_.setTarget(target); }
    [[nodiscard]] const std::optional<Vector3>& target() const { return picture_.target(); }
    /// Reads the values at a position of the surface at rest; none without a scene.
    [[nodiscard]] std::optional<SurfaceReading> reading(const Vector2& position) const;
    /// Position of the surface at rest seen at a pixel of the widget; none: there is none.
    [[nodiscard]] std::optional<Vector2> positionAt(const QPointF& pixel) const;

    /// As a picture can show it; none without a scene.
    [[nodiscard]] std::optional<ShownView> shown() const {
        return picture_.frame() ? std::optional(picture_.shown(camera_)) : std::nullopt;
    }

    /// Returns whether the last frame is final: no other is due, and none is still drawn coarsely.
    [[nodiscard]] bool isSettled() const;

    /// Returns where a world position [m] is seen, in pixels of the widget.
    [[nodiscard]] QPointF onScreen(const Vector3& position) const;
    /// Sets whether what does not change is drawn once and kept; on, but for measurements.
    void setCacheEnabled(bool enabled);

Q_SIGNALS:
    /// The user asks the tip to go along the sample by this much, world [m].
    void tipDragged(double dx, double dy);
    void frameChanged();   ///< window() is another
    void scalesChanged();  ///< a color scale is another
    void frameRendered();
    /// The pointer is over this position of the surface at rest, world [m].
    void positionHovered(double x, double y);
    /// The pointer is over no surface any more.
    void pointerLeft();
    /// The values at the cross-hair changed with the tip.
    void readingChanged();

protected:
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void connectGestures();
    void aim();
    void disturb();
    void showTurned();
    [[nodiscard]] bool isTurning() const;
    void read();
    void renderSoon();
    void renderNow();

    ZoomPicture picture_;
    ViewCamera camera_;
    QTimer settling_;  ///< runs while the view is in motion
    QTimer frameDue_;  ///< runs while a frame is due
    QElapsedTimer sinceTurn_;
    QElapsedTimer sinceSnapshot_;
    QElapsedTimer sinceReading_;
    bool cacheEnabled_ = true;
    bool terrainDue_ = false;  ///< it is to be shown again in the next frame
    bool contactDue_ = false;  ///< and so is all the rest
};

}  // namespace asperity
