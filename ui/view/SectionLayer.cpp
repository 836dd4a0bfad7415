#include "ui/view/SectionLayer.h"

#include "core/scene/Scene.h"
#include "ui/view/ViewFrame.h"
#include "ui/widgets/Theme.h"
#include "vtkplugins/module/StripGrid.h"
#include "vtkplugins/pictures/SceneParts.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkContourTriangulator.h>
#include <vtkCutter.h>
#include <vtkMapper.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity {

namespace {

constexpr int kSamples = 384;

void paint(vtkPolyData* face, const std::array<unsigned char, 3>& color) {
    vtkNew<vtkUnsignedCharArray> rgb;
    rgb->SetNumberOfComponents(3);
    for (vtkIdType id = 0; id < face->GetNumberOfPoints(); ++id) {
        rgb->InsertNextTypedTuple(color.data());
    }
    face->GetPointData()->SetScalars(rgb);
}

}  // namespace

SectionLayer::SectionLayer(const std::vector<vtkRenderer*>& cut, vtkRenderer* faces)
    : sample_(surfaceAsColored(sampleFace_)), tip_(surfaceAsColored(tipFace_)) {
    for (vtkRenderer* renderer : cut) {
        vtkActorCollection* actors = renderer->GetActors();
        actors->InitTraversal();
        while (vtkActor* actor = actors->GetNextActor()) {
            cut_.emplace_back(actor);
        }
    }
    tip_->ForceOpaqueOn();  // blended all the same, without VTK's costly passes
    vtkNew<vtkPolyData> nothing;
    outline_ = linesAsDrawn(nothing, theme::palette().ink, 2.0);
    for (vtkActor* actor : {sample_, tip_, outline_}) {
        faces->AddActor(actor);
    }
    hide();
}

SectionLayer::~SectionLayer() = default;

void SectionLayer::hide() {
    setCutting(false);
    for (vtkActor* actor : {sample_, tip_, outline_}) {
        actor->VisibilityOff();
    }
}

void SectionLayer::setCutting(bool cutting) {
    if (cutting == cutting_) {
        return;
    }
    cutting_ = cutting;
    for (vtkActor* actor : cut_) {
        if (cutting) {
            actor->GetMapper()->AddClippingPlane(plane_);
        } else {
            actor->GetMapper()->RemoveAllClippingPlanes();
        }
    }
}

void SectionLayer::show(const Scene& scene, const ContactShape& shape, const SectionStyle& style) {
    const Vector3& eye = style.toEye;
    const bool alongX = std::abs(eye.y()) >= std::abs(eye.x());
    const Vector3 away = alongX ? Vector3(0.0, -std::copysign(1.0, eye.y()), 0.0)
                                : Vector3(-std::copysign(1.0, eye.x()), 0.0, 0.0);
    plane_->SetOrigin(Vector3(shape.contact().tipCenter).data());
    plane_->SetNormal(Vector3(away).data());
    setCutting(true);
    outline_->GetProperty()->SetColor(theme::palette().ink.fractions().data());
    fillSample(scene, shape, style);
    fillTip(style);
    for (vtkActor* actor : {sample_, tip_, outline_}) {
        style.space.apply(actor);
        actor->VisibilityOn();
    }
}

void SectionLayer::fillSample(const Scene& scene, const ContactShape& shape,
                              const SectionStyle& style) {
    const ScanWindow& window = style.window;
    const Vector3 normal(plane_->GetNormal());
    const Vector3& through = shape.contact().tipCenter;
    std::vector<Vector3> top;
    for (int i = 0; i < kSamples; ++i) {
        const double part = i / (kSamples - 1.0);
        const double x =
            normal.y() != 0.0 ? std::lerp(window.left, window.right, part) : through.x();
        const double y =
            normal.x() != 0.0 ? std::lerp(window.bottom, window.top, part) : through.y();
        const Vector3 rest(x, y, scene.surface.at(x, y).height);
        top.push_back(holds(shape.area(), rest.head<2>()) ? shape.moved(rest) : rest);
    }
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const double isTop : {0.0, 1.0}) {
        for (const Vector3& position : top) {
            points->InsertNextPoint(position.x(), position.y(),
                                    std::lerp(style.bottom, position.z(), isTop));
        }
    }
    sampleFace_->SetPoints(points);
    sampleFace_->SetStrips(gridStrips(kSamples, 2));
    paint(sampleFace_, style.shading.lit(theme::palette().side, -normal, kWallMatt));
    vtkPolyDataMapper::SafeDownCast(outline_->GetMapper())->SetInputData(polyline(top));
}

void SectionLayer::fillTip(const SectionStyle& style) {
    vtkNew<vtkCutter> cutter;
    cutter->SetInputData(style.tip);
    cutter->SetCutFunction(plane_);
    vtkNew<vtkContourTriangulator> filled;
    filled->SetInputConnection(cutter->GetOutputPort());
    filled->Update();
    tipFace_->ShallowCopy(filled->GetOutput());
    const Color& face = theme::palette().tip;
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(4);
    for (vtkIdType id = 0; id < tipFace_->GetNumberOfPoints(); ++id) {
        const double opacity = style.opacity.fading(tipFace_->GetPoint(id)[2]);
        const auto alpha = static_cast<unsigned char>(std::lround(255.0 * opacity));
        colors->InsertNextTypedTuple(std::array{face.red, face.green, face.blue, alpha}.data());
    }
    tipFace_->GetPointData()->SetScalars(colors);
}

}  // namespace asperity
