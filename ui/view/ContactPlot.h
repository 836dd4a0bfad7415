#pragma once

#include "core/deformation/ContactDeformation.h"
#include "core/haptics/VirtualRun.h"
#include "ui/view/ForceLayer.h"
#include "ui/view/SurfacePick.h"

#include <QPointF>
#include <QRectF>
#include <QWidget>

#include <memory>
#include <optional>
#include <string>
#include <utility>

class QPainter;

namespace asperity {

struct Scene;

/// The section through the contact as a plot: the surface at rest and deformed, the tip's outline,
/// the ends of the contact, the force, in a vertical plane through the tip. True to scale, or with
/// heights larger by a stated factor. The scale is that of the contact at the setpoint, and what is
/// seen moves with the surface below the tip alone: a tip that rises rises in the plot.
class ContactPlot : public QWidget {
    Q_OBJECT

public:
    explicit ContactPlot(QWidget* parent = nullptr);

    /// Null: nothing to show. The scene outlives its use here.
    void setScene(const Scene* scene);
    /// Sets the half-space to draw from the next snapshot on where the scene asks for it; or null.
    void setHalfSpace(std::shared_ptr<const HalfSpaceAnswer> answer);
    void showSnapshot(const Snapshot& snapshot);
    /// See ZoomPicture: from the next snapshot on.
    void setWrittenForce(std::string force) { writtenForce_ = std::move(force); }

    /// Sets the plane's direction, from x, counterclockwise as seen from above [rad]; none: it
    /// turns so that it goes through the contact, however the surface slopes.
    void setAzimuth(std::optional<double> azimuth);
    [[nodiscard]] double azimuth() const { return plane_.azimuth; }
    /// Heights over lengths along the plane, >= 1; 0: as large as they fit.
    void setHeightFactor(double factor);
    /// The factor that is drawn, >= 1.
    [[nodiscard]] double drawnFactor() const { return drawnFactor_; }
    /// Sets half the width that is seen [m]; a low plot shows more, so that the tip above the
    /// sample is in sight.
    void setHalfWidth(double halfWidth);
    [[nodiscard]] double halfWidth() const { return halfWidth_; }
    /// Returns the half width that was set since the scene was shown [m]; none: it is the scene's.
    [[nodiscard]] const std::optional<double>& chosenHalfWidth() const { return chosenHalfWidth_; }

    /// Shows a position of the surface at rest, world x, y [m], where it lies along the plane.
    void showCrossHair(const std::optional<Vector2>& position,
                       const std::optional<SurfaceReading>& reading);
    /// Section that is drawn now; none: nothing.
    [[nodiscard]] const std::optional<ContactSection>& section() const { return section_; }
    /// Returns the section of a state in the plane of this plot, shown or not; none: the state
    /// cannot be drawn.
    [[nodiscard]] std::optional<ContactSection> sectionOf(const Scene& scene,
                                                          const TipState& state) const;
    /// Returns the position at which a point of the section is drawn [pixel].
    [[nodiscard]] QPointF toPixel(const Vector2& point) const;

Q_SIGNALS:
    /// The pointer is over this position of the surface at rest, world x, y [m].
    void positionHovered(double x, double y);
    void pointerLeft();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

private:
    void cut();
    void chooseScale();
    void turnToContact(const TipState& state);
    void follow(const TipState& state);
    [[nodiscard]] double seenHalfWidth() const;
    void fitScale();
    void followSurface();
    [[nodiscard]] QRectF area() const;
    [[nodiscard]] QPolygonF drawn(const std::vector<Vector2>& points) const;
    void drawAxes(QPainter& painter) const;
    void drawBodies(QPainter& painter) const;
    void drawContact(QPainter& painter) const;
    void drawForce(QPainter& painter) const;
    void drawTipAbove(QPainter& painter) const;
    void drawLegend(QPainter& painter) const;
    void drawCrossHair(QPainter& painter) const;

    const Scene* scene_ = nullptr;
    std::shared_ptr<const HalfSpaceAnswer> halfSpace_;
    SectionPlane plane_;
    std::optional<ContactSection> section_;
    std::optional<TickSample> sample_;
    double heightFactor_ = 1.0;  ///< as asked for; 0: as large as it fits
    double drawnFactor_ = 1.0;
    double metersPerPixel_ = 1e-10;       ///< along the plane
    std::optional<double> middleHeight_;  ///< world z in the middle of the plot [m]
    double paraboloidReach_ = 0.0;        ///< see ViewScale [m]
    double forceScale_ = 1e-9;            ///< usual force [N]
    ForceEvidence evidence_;
    bool isForceKnown_ = false;
    std::string writtenForce_;     ///< at the arrow; empty: of the sample
    bool turns_ = false;           ///< with the contact
    double scaledFor_ = 0.0;       ///< setpoint [N]
    double halfWidth_ = 0.0;       ///< see setHalfWidth() [m]
    double leastHalfWidth_ = 0.0;  ///< [m]
    std::optional<double> chosenHalfWidth_;
    std::optional<Vector2> crossHair_;
    std::optional<SurfaceReading> reading_;
};

}  // namespace asperity
