#pragma once

#include "ui/view/ContactShape.h"
#include "ui/view/DrawnSpace.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

class vtkActor;
class vtkPolyData;
class vtkRenderer;

namespace asperity {

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
    /// @param surface mesh of the shape's patch as it is drawn, with its colors
    void showDent(const ContactShape& shape, vtkPolyData* surface, const DrawnSpace& space);
    void hide();

private:
    vtkNew<vtkPolyData> inside_;
    vtkSmartPointer<vtkActor> dent_;
    vtkSmartPointer<vtkActor> rim_;
};

}  // namespace asperity
