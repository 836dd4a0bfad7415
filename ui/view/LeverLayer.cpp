#include "ui/view/LeverLayer.h"

#include "ui/Theme.h"

#include <vtkActor.h>
#include <vtkCubeSource.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>

#include <numbers>

namespace asperity {

namespace {

// In half widths of the lever.
constexpr double kClampEnd = -3.0;
constexpr double kFreeEnd = 1.2;
constexpr double kThickness = 0.15;

constexpr double kDegrees = 180.0 / std::numbers::pi;

}  // namespace

LeverLayer::LeverLayer(vtkRenderer* renderer) : slab_(surfaceAsColored(data_)) {
    renderer->AddActor(slab_);
    hide();
}

LeverLayer::~LeverLayer() = default;

void LeverLayer::hide() { slab_->VisibilityOff(); }

void LeverLayer::show(const LeverPlace& place, const Shading& shading) {
    vtkNew<vtkCubeSource> slab;
    slab->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    slab->SetBounds(kClampEnd, kFreeEnd, -1.0, 1.0, 0.0, kThickness);
    vtkNew<vtkTransform> pose;
    pose->Translate(place.shankTop.data());
    pose->RotateZ(kDegrees * place.azimuth);
    pose->RotateY(kDegrees * place.tilt);
    pose->Scale(place.size, place.size, place.size);
    vtkNew<vtkTransformPolyDataFilter> placed;
    placed->SetInputConnection(slab->GetOutputPort());
    placed->SetTransform(pose);
    placed->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    placed->Update();
    data_->ShallowCopy(placed->GetOutput());
    paint(data_, theme::palette().lever, shading);
    slab_->VisibilityOn();
}

}  // namespace asperity
