#pragma once

#include "vtkplugins/pictures/ColorBar.h"
#include "vtkplugins/pictures/OffscreenPicture.h"
#include "vtkplugins/pictures/OverviewPicture.h"
#include "vtkplugins/pictures/PictureParts.h"

#include <vtkSmartPointer.h>

#include <vector>

class vtkPolyData;

namespace asperity {

/// The 3-D part of the overview picture, and what its labels need to know.
class OverviewScene {
public:
    /// @param picture, view live as long as this
    OverviewScene(OffscreenPicture& picture, const OverviewView& view, const PixelRect& area,
                  const PictureParts& parts);

    /// Label of the scale bar.
    void paintLabels(Painter& painter) const;
    [[nodiscard]] ColorBar colorBar() const;
    /// How much larger than life heights are drawn; 1: to scale.
    [[nodiscard]] double magnification() const { return magnification_; }
    /// Whether the scan holds no data somewhere.
    [[nodiscard]] bool hasFilled() const { return hasFilled_; }

private:
    void addSurface();
    void markFilled(vtkPolyData* surface);
    void addZoomFrame();
    void addPath();
    void addPin();
    void addScaleBar();
    /// A colored line with a light rim, plain to see on any ground.
    static void addRimmedLine(vtkRenderer* view, const std::vector<Vector3>& points,
                              const Color& color);
    /// Just above the drawn surface, straight from one place to another.
    [[nodiscard]] std::vector<Vector3> draped(double fromX, double fromY, double toX,
                                              double toY) const;

    const OffscreenPicture& picture_;
    const OverviewView& data_;
    PictureParts parts_;
    vtkRenderer* solid_;    ///< the surface and what it may hide
    vtkRenderer* through_;  ///< pin and zoom, which nothing hides
    vtkSmartPointer<vtkLookupTable> colors_;
    double side_ = 0.0;  ///< longer side of the scan [m]
    double low_ = 0.0;   ///< heights shown [m]
    double high_ = 0.0;
    double magnification_ = 1.0;
    bool hasFilled_ = false;
    double bottom_ = 0.0;    ///< of the drawn block, world z [m]
    double scaleBar_ = 0.0;  ///< length that it stands for [m]
    Vector3 scaleBarAt_ = Vector3::Zero();
};

}  // namespace asperity
