#pragma once

#include "ui/view/ContactShape.h"
#include "ui/view/Shading.h"
#include "ui/view/SurfaceColors.h"
#include "ui/view/ViewFrame.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <vector>

class vtkActor;
class vtkPoints;
class vtkPolyData;
class vtkRenderer;
class vtkUnsignedCharArray;

namespace asperity {

/// Returns a circle about the contact's axis on the deformed surface, closed. World frame.
[[nodiscard]] std::vector<Vector3> circleInContact(const Scene& scene, const ContactShape& shape,
                                                   double radius);

/// Rim and dent of the contact, drawn faintly through the tip, which hides them.
class HiddenContact {
public:
    /// @param through what is drawn there shows through everything
    explicit HiddenContact(vtkRenderer* through);
    ~HiddenContact();
    HiddenContact(const HiddenContact&) = delete;
    HiddenContact& operator=(const HiddenContact&) = delete;

    /// @param rim line around the contact, world frame
    void showRim(vtkPolyData* rim, const DrawnSpace& space);
    /// The surface inside of the rim in its colors. There is a contact.
    void showDent(const Scene& scene, const ContactShape& shape, const PatchColors& colors,
                  const DrawnSpace& space);
    void hide();

private:
    vtkNew<vtkPoints> points_;
    vtkNew<vtkUnsignedCharArray> rgb_;
    vtkNew<vtkPolyData> inside_;
    vtkSmartPointer<vtkActor> dent_;
    vtkSmartPointer<vtkActor> rim_;
};

/// Parameters with which the contact is drawn.
struct ContactStyle {
    const PatchColors& colors;
    DrawnSpace space;
    Shading shading;
    double gridSpacing = 0.0;  ///< of the draped grid [m]; 0: no grid
    ScanWindow gridArea;       ///< that the grid covers
    ScanWindow window;         ///< of the terrain around the contact
    double bottom = 0.0;       ///< world z where the terrain's walls end below [m]
    bool hasShadow = true;     ///< the tip darkens the surface below it
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
