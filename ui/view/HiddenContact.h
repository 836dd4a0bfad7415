#pragma once

#include "ui/view/ContactShape.h"
#include "ui/view/DrawnSpace.h"
#include "ui/view/PatchColors.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <vector>

class vtkActor;
class vtkPoints;
class vtkPolyData;
class vtkRenderer;
class vtkUnsignedCharArray;

namespace asperity {

/// Where a circle about the contact's axis lies on the deformed surface, closed. World frame.
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

}  // namespace asperity
