#pragma once

#include "vtkplugins/pictures/DeformationPicture.h"
#include "vtkplugins/pictures/OffscreenPicture.h"
#include "vtkplugins/pictures/Panel.h"
#include "vtkplugins/pictures/RasterImage.h"
#include "vtkplugins/pictures/SceneParts.h"

#include <vtkSmartPointer.h>

#include <optional>
#include <vector>

class vtkPolyData;

namespace asperity {

class RestingPatch;

/// The 3-D part of one panel of the deformation picture, and what its labels need to know.
class DeformationScene {
public:
    /// @param area         where the scene lies in the picture
    /// @param picture, view live as long as this
    DeformationScene(OffscreenPicture& picture, const DeformationView& view, const PixelRect& area,
                     const PictureParts& parts);

    /// Labels of the scale bars and of the force.
    void paintLabels(Painter& painter) const;
    [[nodiscard]] ColorBar colorBar() const;
    /// The factor of all heights; 1: true to scale.
    [[nodiscard]] double heightScale() const { return stretch_.factor(); }

private:
    void addSample(vtkPolyData* surface);
    void addCutFace(vtkPolyData* surface);
    void findContactLine();
    void addHorizontalBar(const Vector3& start, const Vector3& along);
    void addVerticalBar(const Vector3& corner, const Vector3& right);
    /// Returns whether the sample hides much of a contact that is pressed into it from the eye.
    [[nodiscard]] bool isContactHidden() const;
    [[nodiscard]] bool isHidden(const RestingPatch& sample, const Vector3& point) const;
    void addTip();
    [[nodiscard]] double shownTipHeight() const;
    void addContactCircle();
    void addForce();
    void addScaleBars();

    const OffscreenPicture& picture_;
    const DeformationView& data_;
    PixelRect area_;
    PictureParts parts_;
    vtkRenderer* solid_;    ///< surface and tip
    vtkRenderer* through_;  ///< contact circle and force, seen through the surface
    vtkSmartPointer<vtkLookupTable> colors_;
    double low_ = 0.0;  ///< displacements shown [m]
    double high_ = 0.0;
    Stretch stretch_{1.0};
    Vector3 outward_ = Vector3::UnitZ();             ///< unit, from the contact to the tip's center
    Vector3 contact_ = Vector3::Zero();              ///< its middle, on the surface as it is drawn
    std::vector<std::vector<Vector3>> contactLine_;  ///< its edge, as it is drawn
    std::optional<CutPlane> cut_;                    ///< that opens the block; none: it is whole
    Vector3 cutLeft_ = Vector3::Zero();              ///< ends of the opened face, at its bottom
    Vector3 cutRight_ = Vector3::Zero();
    double width_ = 0.0;          ///< of the patch [m]
    double bottom_ = 0.0;         ///< of the drawn block, world z [m]
    double horizontalBar_ = 0.0;  ///< lengths that the scale bars show [m]
    double verticalBar_ = 0.0;
    Vector3 horizontalBarAt_ = Vector3::Zero();  ///< where their labels belong
    Vector3 verticalBarAt_ = Vector3::Zero();
    Vector3 forceEnd_ = Vector3::Zero();
};

}  // namespace asperity
