#pragma once

#include "core/Vector.h"
#include "core/deformation/HalfSpaceModel.h"
#include "core/haptics/VirtualRun.h"
#include "ui/view/ContactLayer.h"
#include "ui/view/ForceLayer.h"
#include "ui/view/GhostLayer.h"
#include "ui/view/MarkerLayer.h"
#include "ui/view/SectionLayer.h"
#include "ui/view/Shading.h"
#include "ui/view/StaticLayer.h"
#include "ui/view/SurfaceColors.h"
#include "ui/view/SurfacePick.h"
#include "ui/view/TerrainLayer.h"
#include "ui/view/TipLayer.h"
#include "ui/view/ViewCamera.h"
#include "ui/view/ViewFrame.h"
#include "ui/view/ViewLabels.h"

#include <vtkNew.h>

#include <QObject>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

class vtkOpenGLRenderWindow;
class vtkRenderer;

namespace asperity {

struct Scene;

/// Ranges that a picture has shown since its scene was set. The scales can keep them from then on,
/// so that they do not change through a film.
class ShownRanges {
public:
    void keep() { isKept_ = true; }
    [[nodiscard]] bool isKept() const { return isKept_; }

    /// @param heights lowest and highest that are shown now [m]
    /// @return those that there is to be room for
    std::array<double, 2> heights(const std::array<double, 2>& heights) {
        heights_ = {std::min(heights_[0], heights[0]), std::max(heights_[1], heights[1])};
        return isKept_ ? heights_ : heights;
    }
    /// The same of the largest displacement [m].
    double displacement(double largest) {
        displacement_ = std::max(displacement_, largest);
        return isKept_ ? displacement_ : largest;
    }

private:
    std::array<double, 2> heights_{std::numeric_limits<double>::infinity(),
                                   -std::numeric_limits<double>::infinity()};
    double displacement_ = 0.0;
    bool isKept_ = false;
};

/// State of a view of the window, so that a picture can show its scene alike.
struct ShownView {
    ViewCamera camera;
    ViewOptions options;
    double halfWidth = 0.0;                            ///< of the frame [m]
    SurfaceColors colors;                              ///< with the ranges that they have there
    std::optional<Vector3> trueTip;                    ///< see Snapshot [m]
    std::shared_ptr<const HalfSpaceAnswer> halfSpace;  ///< null: none is drawn
};

/// Picture of the large view: the surface in a frame that moves with the tip; on it the deformed
/// contact, the tip, the force, a guide and labels. It draws into a window's layers; the view
/// decides when.
class ZoomPicture : public QObject {
    Q_OBJECT

public:
    /// @param window outlives this object
    explicit ZoomPicture(vtkOpenGLRenderWindow* window);
    ~ZoomPicture() override;
    ZoomPicture(const ZoomPicture&) = delete;
    ZoomPicture& operator=(const ZoomPicture&) = delete;

    /// Null: nothing. The scene outlives its use here.
    void setScene(const Scene* scene);
    /// Sets the sample to show next, of the present scene. @param trueTip see Snapshot
    void setSample(const TickSample& sample, const std::optional<Vector3>& trueTip = {}) {
        sample_ = sample;
        trueTip_ = trueTip;
    }
    /// Sets the half-space to draw from the next sample on where the scene asks for it; or null.
    void setHalfSpace(std::shared_ptr<const HalfSpaceAnswer> answer) {
        halfSpace_ = std::move(answer);
    }

    /// Brings contact, tip, force and guide up to the sample, and the frame to the tip.
    /// @param dragging the picture stays still under the pointer as long as it can
    void showSample(const ViewCamera& camera, bool dragging);
    void showTerrain(const ViewCamera& camera, TerrainDetail detail);
    /// Sets where the cross-hair is from the next sample on, on the surface at rest [m]; none:
    /// hidden.
    void setCrossHair(const std::optional<Vector2>& position, const QString& reading);
    [[nodiscard]] const std::optional<Vector2>& crossHair() const { return crossHair_; }
    /// The position of the surface at rest whose present position is seen at a drawn pixel, from
    /// the lower left corner [m]; none: there is no surface.
    [[nodiscard]] std::optional<Vector2> positionAt(const Vector2& pixel) const;
    /// Returns the values at a position of the surface at rest. There is a scene.
    [[nodiscard]] SurfaceReading reading(const Vector2& position) const;
    /// @param height     of the view [pixels of the screen's coordinates]
    /// @param pixelRatio drawn pixels per such a pixel
    void showLabels(const ViewCamera& camera, double height, double pixelRatio);
    /// Takes the colors around the sample from the theme; terrain, contact and labels have to be
    /// shown again.
    void showTheme();
    /// The picture is seen so from now on.
    /// @param aspect width over height of the view
    void aim(const ViewCamera& camera, double aspect, const WordRoom& words = {});

    /// Part of the scan that is shown; none without a scene.
    [[nodiscard]] const std::optional<ViewFrame>& frame() const { return frame_; }
    /// Takes the nearest width that can be shown [m]. There is a scene.
    void setHalfWidth(double halfWidth);
    /// The frame keeps its width, even where a tip that is pressed in deep leaves it.
    void keepHalfWidth() { isWidthKept_ = true; }
    [[nodiscard]] const ViewScale& scale() const { return scale_; }
    /// Contact and terrain have to be shown again, and the camera to be aimed.
    void setOptions(const ViewOptions& options);
    [[nodiscard]] const ViewOptions& options() const { return options_; }
    /// Sets how the surface is colored. @param field the look's quantity on the surface at rest
    void setLook(const SurfaceLook& look, const SurfaceField& field);
    /// The same with ranges that another picture fitted.
    void setColors(const SurfaceColors& colors);
    /// Returns what the picture does not show by itself: a stretched height, coarse pixels.
    [[nodiscard]] std::vector<std::string> notes(const ViewCamera& camera) const;
    [[nodiscard]] const SurfaceColors& colors() const { return colors_; }
    /// As another picture can show it. There is a scene.
    [[nodiscard]] ShownView shown(const ViewCamera& camera) const {
        return {camera, options_, frame_->halfWidth(), colors_, trueTip_, halfSpace_};
    }
    /// Nothing is behind what is drawn: black and clear, see drawnImage().
    void setTransparent();
    /// Sets the target of the tip's apex from the next sample on, in any scene [m]; none: hidden.
    void setTarget(const std::optional<Vector3>& target) { targetPosition_ = target; }
    [[nodiscard]] const std::optional<Vector3>& target() const { return targetPosition_; }
    /// The magnitude that is written at the arrow, of the present scene: that of the panels, digit
    /// by digit, which are not drawn as often; empty: that of the sample.
    void setWrittenForce(std::string force) { writtenForce_ = std::move(force); }
    [[nodiscard]] std::string writtenForce() const;
    /// Sets the text in a corner of the picture; empty: nothing.
    void setCaption(std::string caption) { caption_ = std::move(caption); }
    /// Size and colors have room for all that was shown of the scene, and stay so. There is a
    /// scene.
    void keepScales();
    /// Cache of the surface at rest from one frame to the next. It copies with Qt's OpenGL: a
    /// window of VTK's own has to switch it off.
    [[nodiscard]] StaticLayer& cache() { return cache_; }
    /// Returns where a world position [m] is drawn, in drawn pixels from the lower left corner.
    [[nodiscard]] Vector2 drawnPosition(const Vector3& position) const;
    /// Returns the size of a pixel of the screen's coordinates, in a view of this height [m].
    [[nodiscard]] double metersPerPixel(double height) const;

Q_SIGNALS:
    void terrainPlaced();  ///< it has to be shown again, and the camera to be aimed
    void frameChanged();   ///< another part of the scan
    void scalesChanged();  ///< of the colors

private:
    void showColors();
    void widenFor(double indentation);
    void follow(const Vector2& tip, double slack);
    void placeTerrain(const TerrainArea& area);
    bool fitColors();
    void fitHeights();
    bool fitLiveColors(const ContactShape& shape, const PatchColors& colors);
    [[nodiscard]] FramedSurface framed() const;
    [[nodiscard]] GearScale gear() const;
    [[nodiscard]] double headroom() const;
    void makeRoomForStart(const TipState& state);
    [[nodiscard]] double roomAbove(const Vector3& apex, const ViewCamera& camera) const;
    [[nodiscard]] bool isTouching() const;
    [[nodiscard]] DrawnSpace space() const { return {options_.heightScale}; }
    [[nodiscard]] Shading shading(const ViewCamera& camera) const;
    void makeRoomFor(const ContactShape& shape, const ViewCamera& camera);
    void keepInPicture(const Vector3& position, const ViewCamera& camera);
    void showContact(const TickSample& sample, const ViewCamera& camera);
    void showSection(const ContactShape& shape, const ViewCamera& camera);
    void showGhosts(const ViewCamera& camera);
    void showCrossHair();
    void showMarkers();
    void showTarget();
    [[nodiscard]] std::string tipAbove(double height, double pixelRatio) const;

    const Scene* scene_ = nullptr;
    ViewScale scale_;
    std::optional<TickSample> sample_;
    std::optional<Vector3> trueTip_;  ///< see Snapshot [m]
    std::shared_ptr<const HalfSpaceAnswer> halfSpace_;
    std::optional<ViewFrame> frame_;
    SurfaceColors colors_;
    ViewOptions options_;
    ViewExtent extent_;
    std::optional<double> startGap_;  ///< below the tip, at the first sample of the scene [m]
    bool isWidthKept_ = false;
    ShownRanges shown_;
    std::unique_ptr<const ContactShape> shape_;  ///< as it is shown; null: none is
    std::optional<Vector2> crossHair_;           ///< on the surface at rest [m]
    QString reading_;                            ///< of the cross-hair
    std::optional<Vector3> targetPosition_;      ///< [m]
    std::string writtenForce_;                   ///< at the arrow; empty: of the sample
    std::string caption_;

    vtkNew<vtkRenderer> still_;    ///< the surface at rest
    vtkNew<vtkRenderer> live_;     ///< what changes from frame to frame
    vtkNew<vtkRenderer> through_;  ///< what shows through everything
    StaticLayer cache_;
    TerrainLayer terrain_;
    ContactLayer contact_;
    TipGear tip_;
    SectionLayer section_;
    ForceLayer force_;
    GuideLayer guide_;
    CrossHairLayer cross_;
    MarkerLayer markers_;
    TargetLayer target_;
    TipGhosts ghosts_;  ///< after what is seen through them
    ViewLabels labels_;
};

}  // namespace asperity
