#pragma once

#include "ui/view/ContactShape.h"
#include "ui/view/HiddenContact.h"
#include "ui/view/PatchColors.h"
#include "ui/view/Shading.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

class vtkActor;
class vtkPoints;
class vtkPolyData;
class vtkRenderer;
class vtkUnsignedCharArray;

namespace asperity {

/// How the contact is drawn.
struct ContactStyle {
    const PatchColors& colors;
    DrawnSpace space;
    Shading shading;
    double gridSpacing = 0.0;  ///< of the draped grid [m]; 0: no grid
    ScanWindow gridArea;       ///< that the grid covers
    ScanWindow window;         ///< of the terrain around the contact
    double bottom = 0.0;       ///< world z where the terrain's walls end below [m]
    bool isCut = false;        ///< a section opens the contact to the eye
};

/// The deformed surface around the contact with its draped grid, its walls where it lies at an edge
/// of the terrain, and the contact's rim; what the tip hides of the contact shows through faintly.
class ContactLayer {
public:
    /// @param solid   where the surface goes
    /// @param through what is drawn there shows through everything in `solid`
    ContactLayer(vtkRenderer* solid, vtkRenderer* through);
    ~ContactLayer();
    ContactLayer(const ContactLayer&) = delete;
    ContactLayer& operator=(const ContactLayer&) = delete;

    void show(const Scene& scene, const ContactShape& shape, const ContactStyle& style);
    void hide();

private:
    void fitSize(const SurfacePatch& patch);
    void showSurface(const ContactShape& shape, const ContactStyle& style);
    void showWalls(const ContactStyle& style);
    void showGrid(const Scene& scene, const ContactShape& shape, const ContactStyle& style);
    void showRim(const Scene& scene, const ContactShape& shape, const ContactStyle& style);

    int samples_ = 0;
    vtkNew<vtkPoints> points_;
    vtkNew<vtkUnsignedCharArray> rgb_;
    vtkNew<vtkPolyData> mesh_;
    vtkSmartPointer<vtkActor> surface_;
    vtkSmartPointer<vtkActor> walls_;
    vtkSmartPointer<vtkActor> grid_;
    vtkSmartPointer<vtkActor> rim_;
    HiddenContact hidden_;
};

}  // namespace asperity
