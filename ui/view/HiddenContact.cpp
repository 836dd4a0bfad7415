#include "ui/view/HiddenContact.h"

#include "ui/view/Shading.h"
#include "vtkplugins/pictures/Palette.h"
#include "vtkplugins/pictures/SceneParts.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <array>

namespace asperity {

namespace {

constexpr double kDentOpacity = 0.4;
constexpr double kRimOpacity = 0.4;

void makeFaint(vtkActor* actor, double opacity) {
    actor->GetProperty()->SetOpacity(opacity);
    actor->ForceOpaqueOn();  // blended all the same, without VTK's costly passes
}

/// The quadrilaterals of the patch that lie in the contact.
vtkSmartPointer<vtkCellArray> cellsInContact(const ContactShape& shape) {
    const SurfacePatch& patch = shape.patch();
    const TipContact& contact = shape.contact();
    const auto inside = [&](std::size_t i) {
        const Vector3 arm = patch.rest[i] - contact.closest;
        return (arm - arm.dot(contact.normal) * contact.normal).norm() <= contact.contactRadius;
    };
    vtkNew<vtkCellArray> cells;
    for (int row = 0; row + 1 < patch.rows; ++row) {
        for (int column = 0; column + 1 < patch.columns; ++column) {
            const std::array<std::size_t, 4> corners{
                patch.index(row, column), patch.index(row, column + 1),
                patch.index(row + 1, column + 1), patch.index(row + 1, column)};
            if (std::ranges::all_of(corners, inside)) {
                std::array<vtkIdType, 4> ids{};
                std::ranges::copy(corners, ids.begin());
                cells->InsertNextCell(4, ids.data());
            }
        }
    }
    return cells;
}

}  // namespace

HiddenContact::HiddenContact(vtkRenderer* through) : dent_(surfaceAsColored(inside_)) {
    vtkNew<vtkPolyData> nothing;
    rim_ = linesAsDrawn(nothing, palette::kContact, 2.0);
    makeFaint(dent_, kDentOpacity);
    makeFaint(rim_, kRimOpacity);
    through->AddActor(dent_);
    through->AddActor(rim_);
    hide();
}

HiddenContact::~HiddenContact() = default;

void HiddenContact::showRim(vtkPolyData* rim, const DrawnSpace& space) {
    vtkPolyDataMapper::SafeDownCast(rim_->GetMapper())->SetInputData(rim);
    space.apply(rim_);
    rim_->VisibilityOn();
}

void HiddenContact::showDent(const ContactShape& shape, vtkPolyData* surface,
                             const DrawnSpace& space) {
    inside_->ShallowCopy(surface);
    inside_->SetStrips(nullptr);
    inside_->SetPolys(cellsInContact(shape));
    space.apply(dent_);
    dent_->VisibilityOn();
}

void HiddenContact::hide() {
    dent_->VisibilityOff();
    rim_->VisibilityOff();
}

}  // namespace asperity
