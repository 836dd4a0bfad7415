#pragma once

#include "vtkplugins/pictures/ColorBar.h"
#include "vtkplugins/pictures/DeformationPicture.h"
#include "vtkplugins/pictures/OffscreenPicture.h"

#include <vtkSmartPointer.h>

class vtkPolyData;

namespace asperity {

class Stretch;

/// The 3-D part of one panel of the deformation picture, and what its labels need to know.
class DeformationScene {
public:
    /// @param area         where the scene lies in the picture
    DeformationScene(OffscreenPicture& picture, const DeformationView& view, const PixelRect& area);

    /// Labels of the scale bars and of the force.
    void paintLabels(Painter& painter) const;
    [[nodiscard]] ColorBar colorBar() const;
    /// How much larger than life displacements are drawn; 1: to scale.
    [[nodiscard]] double magnification() const { return magnification_; }

private:
    void addSample(vtkPolyData* surface);
    void addTip(const Stretch& stretch);
    void addContactCircle(const Stretch& stretch);
    void addForce(const Stretch& stretch);
    void addScaleBars();

    const DeformationView& data_;
    PixelRect area_;
    vtkRenderer* solid_;    ///< surface and tip
    vtkRenderer* through_;  ///< contact circle and force, seen through the surface
    vtkSmartPointer<vtkLookupTable> colors_;
    double low_ = 0.0;  ///< displacements shown [m]
    double high_ = 0.0;
    double magnification_ = 1.0;
    Vector3 outward_ = Vector3::UnitZ();  ///< unit, from the contact to the tip's center
    double width_ = 0.0;                  ///< of the patch [m]
    double bottom_ = 0.0;                 ///< of the drawn block, world z [m]
    double horizontalBar_ = 0.0;          ///< lengths that the scale bars stand for [m]
    double verticalBar_ = 0.0;
    Vector3 horizontalBarAt_ = Vector3::Zero();  ///< where their labels belong
    Vector3 verticalBarAt_ = Vector3::Zero();
    Vector3 forceEnd_ = Vector3::Zero();
};

}  // namespace asperity
