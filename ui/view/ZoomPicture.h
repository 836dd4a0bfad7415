#pragma once

#include "core/deformation/HalfSpaceAnswer.h"
#include "core/haptics/VirtualRun.h"
#include "ui/view/ContactLayer.h"
#include "ui/view/CrossHairLayer.h"
#include "ui/view/ForceLayer.h"
#include "ui/view/GuideLayer.h"
#include "ui/view/MarkerLayer.h"
#include "ui/view/PatchColors.h"
#include "ui/view/SectionLayer.h"
#include "ui/view/ShownRanges.h"
#include "ui/view/ShownView.h"
#include "ui/view/StaticLayer.h"
#include "ui/view/SurfaceColors.h"
#include "ui/view/SurfaceReading.h"
#include "ui/view/TargetLayer.h"
#include "ui/view/TerrainLayer.h"
#include "ui/view/TipGear.h"
#include "ui/view/TipGhosts.h"
#include "ui/view/ViewCamera.h"
#include "ui/view/ViewExtent.h"
#include "ui/view/ViewFrame.h"
#include "ui/view/ViewLabels.h"
#include "ui/view/ViewOptions.h"
#include "ui/view/ViewScale.h"

#include <vtkNew.h>

#include <QObject>

#include <memory>
#include <optional>
#include <string>
#include <utility>

class vtkOpenGLRenderWindow;
class vtkRenderer;

namespace asperity {

struct Scene;

/// What the large view draws: the surface in a frame that goes with the tip; on it the deformed
/// contact, the tip, the force, a guide and labels. It draws into a window's layers; when is the
/// view's matter.
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
    /// What to show next, of the present scene. @param trueTip see Snapshot
    void setSample(const TickSample& sample, const std::optional<Vector3>& trueTip = {}) {
        sample_ = sample;
        trueTip_ = trueTip;
    }
    /// What is drawn from the next sample on where the scene asks for the half-space; or null.
    void setHalfSpace(std::shared_ptr<const HalfSpaceAnswer> answer) {
        halfSpace_ = std::move(answer);
    }

    /// Brings contact, tip, force and guide up to the sample, and the frame to the tip.
    /// @param dragging the picture stays still under the pointer as long as it can
    void showSample(const ViewCamera& camera, bool dragging);
    void showTerrain(const ViewCamera& camera, TerrainDetail detail);
    /// Where the cross-hair is from the next sample on, of the surface at rest [m]; none: nowhere.
    void setCrossHair(const std::optional<Vector2>& place, const QString& reading);
    [[nodiscard]] const std::optional<Vector2>& crossHair() const { return crossHair_; }
    /// The place of the surface at rest whose present place is seen at a drawn pixel, from the
    /// lower left corner [m]; none: there is no surface.
    [[nodiscard]] std::optional<Vector2> placeAt(const Vector2& pixel) const;
    /// What there is to read at a place of the surface at rest. There is a scene.
    [[nodiscard]] SurfaceReading reading(const Vector2& place) const;
    /// @param height     of the view [pixels of the screen's coordinates]
    /// @param pixelRatio drawn pixels per such a pixel
    void showLabels(const ViewCamera& camera, double height, double pixelRatio);
    /// Takes the colors around the sample from the theme; terrain, contact and labels have to be
    /// shown anew.
    void showTheme();
    /// The picture is seen so from now on.
    /// @param aspect width over height of the view
    void aim(const ViewCamera& camera, double aspect, const WordRoom& words = {});

    /// What is shown of the scan; none without a scene.
    [[nodiscard]] const std::optional<ViewFrame>& frame() const { return frame_; }
    /// Takes the nearest width that can be shown [m]. There is a scene.
    void setHalfWidth(double halfWidth);
    /// The frame keeps its width, even where a tip that is pressed in deep leaves it.
    void keepHalfWidth() { isWidthKept_ = true; }
    [[nodiscard]] const ViewScale& scale() const { return scale_; }
    /// Contact and terrain have to be shown anew, and the camera to be aimed.
    void setOptions(const ViewOptions& options);
    [[nodiscard]] const ViewOptions& options() const { return options_; }
    /// How the surface is colored. @param field what the look's quantity is on the surface at rest
    void setLook(const SurfaceLook& look, const SurfaceField& field);
    /// The same with ranges that another picture fitted.
    void setColors(const SurfaceColors& colors);
    /// What the picture does not say by itself: a stretched height, coarse pixels.
    [[nodiscard]] std::vector<std::string> notes(const ViewCamera& camera) const;
    [[nodiscard]] const SurfaceColors& colors() const { return colors_; }
    /// As another picture can show it. There is a scene.
    [[nodiscard]] ShownView shown(const ViewCamera& camera) const {
        return {camera, options_, frame_->halfWidth(), colors_, trueTip_, halfSpace_};
    }
    /// Nothing is behind what is drawn: black and clear, see drawnImage().
    void setTransparent();
    /// Where the tip's apex shall be, from the next sample on, in whatever scene [m]; none:
    /// nowhere.
    void setTarget(const std::optional<Vector3>& target) { targetPlace_ = target; }
    [[nodiscard]] const std::optional<Vector3>& target() const { return targetPlace_; }
    /// The magnitude that is written at the arrow, of the present scene: that of the panels, digit
    /// by digit, which are not drawn as often; empty: that of the sample.
    void setWrittenForce(std::string force) { writtenForce_ = std::move(force); }
    [[nodiscard]] std::string writtenForce() const;
    /// What is written in a corner of the picture; empty: nothing.
    void setCaption(std::string caption) { caption_ = std::move(caption); }
    /// Size and colors have room for all that was shown of the scene, and stay so. There is a
    /// scene.
    void keepScales();
    /// What keeps the surface at rest from one frame to the next. It copies with Qt's OpenGL: a
    /// window of VTK's own has to switch it off.
    [[nodiscard]] StaticLayer& cache() { return cache_; }
    /// Where a world place [m] is drawn, in drawn pixels from the lower left corner.
    [[nodiscard]] Vector2 drawnPlace(const Vector3& place) const;
    /// Of the screen's coordinates in a view of this height.
    [[nodiscard]] double metersPerPixel(double height) const;

Q_SIGNALS:
    void terrainPlaced();  ///< it has to be shown anew, and the camera to be aimed
    void frameChanged();   ///< another part of the scan
    void scalesChanged();  ///< of the colors

private:
    void showColors();
    void widenFor(double indentation);
    void follow(const Vector2& tip, double slack);
    void placeTerrain(const TerrainPlace& place);
    bool fitColors();
    void fitHeights();
    bool fitLiveColors(const ContactShape& shape, const PatchColors& colors);
    [[nodiscard]] FramedSurface framed() const;
    [[nodiscard]] GearScale gear() const;
    [[nodiscard]] bool isTouching() const;
    [[nodiscard]] DrawnSpace space() const { return {options_.heightScale}; }
    [[nodiscard]] Shading shading(const ViewCamera& camera) const;
    void makeRoomFor(const ContactShape& shape, const ViewCamera& camera);
    void keepInPicture(const Vector3& place, const ViewCamera& camera);
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
    bool isWidthKept_ = false;
    ShownRanges shown_;
    std::unique_ptr<const ContactShape> shape_;  ///< as it is shown; null: none is
    std::optional<Vector2> crossHair_;           ///< on the surface at rest [m]
    QString reading_;                            ///< of the cross-hair
    std::optional<Vector3> targetPlace_;         ///< [m]
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
