#pragma once

#include "ui/view/ContactShape.h"
#include "ui/view/Shading.h"
#include "ui/view/TipLayer.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <vector>

class vtkActor;
class vtkPlane;
class vtkPolyData;
class vtkRenderer;

namespace asperity {

struct Scene;

/// Parameters of a cut.
struct SectionStyle {
    ScanWindow window;           ///< of the terrain
    double bottom = 0.0;         ///< world z where the block of sample ends below [m]
    vtkPolyData* tip = nullptr;  ///< world frame
    TipOpacity opacity;          ///< of the tip
    Vector3 toEye = Vector3::UnitZ();
    DrawnSpace space;
    Shading shading;
};

/// A section through the tip along x or y: what lies before it, as seen by the eye, is cut away;
/// the faces of sample and tip are filled.
class SectionLayer {
public:
    /// @param cut   whose actors are cut, all that they have now
    /// @param faces where the filled faces go
    SectionLayer(const std::vector<vtkRenderer*>& cut, vtkRenderer* faces);
    ~SectionLayer();
    SectionLayer(const SectionLayer&) = delete;
    SectionLayer& operator=(const SectionLayer&) = delete;

    void show(const Scene& scene, const ContactShape& shape, const SectionStyle& style);
    void hide();

private:
    void setCutting(bool cutting);
    void fillSample(const Scene& scene, const ContactShape& shape, const SectionStyle& style);
    void fillTip(const SectionStyle& style);

    vtkNew<vtkPlane> plane_;
    std::vector<vtkSmartPointer<vtkActor>> cut_;
    bool cutting_ = false;
    vtkNew<vtkPolyData> sampleFace_;
    vtkNew<vtkPolyData> tipFace_;
    vtkSmartPointer<vtkActor> sample_;
    vtkSmartPointer<vtkActor> tip_;
    vtkSmartPointer<vtkActor> outline_;  ///< of the deformed surface in the section
};

}  // namespace asperity
