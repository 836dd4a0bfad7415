#include "vtkplugins/paraview/module/vtkAspContactSource.h"

#include "core/Error.h"
#include "core/io/loading/SceneOnSample.h"
#include "core/io/scene/SceneFile.h"
#include "vtkplugins/module/DeformedTip.h"
#include "vtkplugins/module/vtkAspForceGlyphSource.h"
#include "vtkplugins/module/vtkAspPatchSource.h"
#include "vtkplugins/module/vtkAspTipSource.h"
#include "vtkplugins/paraview/module/AlgorithmProgress.h"
#include "vtkplugins/paraview/module/LengthUnit.h"
#include "vtkplugins/paraview/module/LocalContact.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <initializer_list>

vtkStandardNewMacro(vtkAspContactSource)

namespace {

constexpr int kSurface = 0;
constexpr int kTip = 1;
constexpr int kForce = 2;

void scalePoints(vtkPolyData& data, const asperity::LengthUnit& unit) {
    vtkPoints* points = data.GetPoints();
    for (vtkIdType id = 0; points && id < points->GetNumberOfPoints(); ++id) {
        double point[3];
        points->GetPoint(id, point);
        points->SetPoint(id, unit.fromMeters(point[0]), unit.fromMeters(point[1]),
                         unit.fromMeters(point[2]));
    }
}

void fillSurface(const asperity::LocalContact& contact, const asperity::LengthUnit& unit,
                 vtkPolyData& output) {
    vtkNew<vtkAspPatchSource> source;
    source->SetPatch(contact.patch);
    source->Update();
    output.ShallowCopy(source->GetOutput());
    scalePoints(output, unit);
    vtkDataArray* displacements = output.GetPointData()->GetScalars();
    for (vtkIdType id = 0; id < displacements->GetNumberOfTuples(); ++id) {
        displacements->SetTuple1(id, unit.fromMeters(displacements->GetTuple1(id)));
    }
}

/// From the apex: no wider than the surface below it, which would else be hidden [m].
double shownTipHeight(const asperity::LocalContact& contact) {
    constexpr double kHeight = 3.0;      // in tip radii
    constexpr double kWidthShare = 0.8;  // of the surface's
    const double radius = contact.tip.radius;
    const double wide = kWidthShare * contact.halfWidth;
    return wide < radius ? radius - std::sqrt(radius * radius - wide * wide)
                         : std::min(kHeight * radius, contact.halfWidth);
}

void fillTip(const asperity::LocalContact& contact, const asperity::LengthUnit& unit,
             vtkPolyData& output) {
    const asperity::Vector3 center =
        contact.state.tip + contact.tip.radius * asperity::Vector3::UnitZ();
    vtkNew<vtkAspTipSource> source;
    source->SetCenter(center.x(), center.y(), center.z());
    source->SetRadius(contact.tip.radius);
    source->SetHalfAngle(contact.tip.shankHalfAngle());
    source->SetHeight(shownTipHeight(contact));
    source->Update();
    output.ShallowCopy(source->GetOutput());
    asperity::deformTip(output, center, contact.state.closest.normal, contact.tipDisplacement);
    scalePoints(output, unit);
}

/// At every point: ParaView keeps no field data where it gathers the pieces of ranks.
void addNumbers(const char* name, std::initializer_list<double> numbers, vtkPolyData& output) {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(static_cast<int>(numbers.size()));
    for (vtkIdType id = 0; id < output.GetNumberOfPoints(); ++id) {
        array->InsertNextTuple(numbers.begin());
    }
    output.GetPointData()->AddArray(array);
}

/// @param metersPerNewton 0: as long as half of the surface is wide
void fillForce(const asperity::LocalContact& contact, const asperity::LengthUnit& unit,
               double metersPerNewton, vtkPolyData& output) {
    const asperity::TipState& state = contact.state;
    const asperity::Vector3& force = state.force;
    const double magnitude = force.stableNorm();
    const double usual = magnitude > 0.0 ? contact.halfWidth / magnitude : 0.0;
    const asperity::Vector3& start = contact.contactPoint;
    vtkNew<vtkAspForceGlyphSource> source;
    source->SetContactPoint(start.x(), start.y(), start.z());
    source->SetForce(force.x(), force.y(), force.z());
    source->SetMetersPerNewton(metersPerNewton > 0.0 ? metersPerNewton : usual);
    source->Update();
    output.ShallowCopy(source->GetOutput());
    scalePoints(output, unit);
    addNumbers("force", {force.x(), force.y(), force.z()}, output);
    addNumbers("indentation", {unit.fromMeters(state.contact.indentation)}, output);
    addNumbers("contact_radius", {unit.fromMeters(state.contact.contactRadius)}, output);
    addNumbers("tip",
               {unit.fromMeters(state.tip.x()), unit.fromMeters(state.tip.y()),
                unit.fromMeters(state.tip.z())},
               output);
}

}  // namespace

vtkAspContactSource::vtkAspContactSource() {
    this->SetNumberOfInputPorts(0);
    this->SetNumberOfOutputPorts(3);
}

vtkAspContactSource::~vtkAspContactSource() { this->SetSceneFile(nullptr); }

void vtkAspContactSource::PrintSelf(ostream& os, vtkIndent indent) {
    this->Superclass::PrintSelf(os, indent);
    os << indent << "SceneFile: " << (this->SceneFile ? this->SceneFile : "(none)") << "\n";
    os << indent << "Place: " << this->Place[0] << " " << this->Place[1] << "\n";
    os << indent << "Setpoint: " << this->Setpoint << "\n";
    os << indent << "LengthUnit: " << this->LengthUnit << "\n";
    os << indent << "HalfWidth: " << this->HalfWidth << "\n";
    os << indent << "Samples: " << this->Samples << "\n";
    os << indent << "ArrowScale: " << this->ArrowScale << "\n";
}

int vtkAspContactSource::RequestInformation(vtkInformation* /*request*/,
                                            vtkInformationVector** /*input*/,
                                            vtkInformationVector* output) {
    for (const int port : {kSurface, kTip, kForce}) {
        output->GetInformationObject(port)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
    }
    return 1;
}

void vtkAspContactSource::Compute(vtkInformationVector* output) {
    const asperity::LengthUnit unit(this->LengthUnit);
    if (!unit.isUsable()) {
        throw asperity::Error("the length unit must be a length above zero");
    }
    if (!this->SceneFile || !*this->SceneFile) {
        throw asperity::Error("no scene is named");
    }
    asperity::AlgorithmProgress progress(*this);
    const asperity::Scene scene =
        asperity::sceneOnSample(asperity::sceneFromInput(this->SceneFile), &progress).scene;
    asperity::ContactRequest request{.position = {},
                                     .setpoint = {},
                                     .halfWidth = unit.toMeters(this->HalfWidth),
                                     .samples = this->Samples};
    if (this->Place[0] >= 0.0 && this->Place[1] >= 0.0) {
        request.position = {unit.toMeters(this->Place[0]), unit.toMeters(this->Place[1])};
    }
    if (this->Setpoint != 0.0) {
        request.setpoint = this->Setpoint;
    }
    const asperity::LocalContact contact = asperity::contactAt(scene, request);
    constexpr double kNanonewton = 1e-9;
    fillSurface(contact, unit, *vtkPolyData::GetData(output, kSurface));
    fillTip(contact, unit, *vtkPolyData::GetData(output, kTip));
    fillForce(contact, unit, unit.toMeters(this->ArrowScale) / kNanonewton,
              *vtkPolyData::GetData(output, kForce));
}

int vtkAspContactSource::RequestData(vtkInformation* request, vtkInformationVector** /*input*/,
                                     vtkInformationVector* output) {
    using Pipeline = vtkStreamingDemandDrivenPipeline;
    const int port = request->Has(Pipeline::FROM_OUTPUT_PORT())
                         ? std::max(0, request->Get(Pipeline::FROM_OUTPUT_PORT()))
                         : 0;
    if (output->GetInformationObject(port)->Get(Pipeline::UPDATE_PIECE_NUMBER()) > 0) {
        return 1;
    }
    try {  // no exception may pass through VTK
        this->Compute(output);
        return 1;
    } catch (const asperity::Canceled&) {
        return 0;
    } catch (const std::exception& error) {
        vtkErrorMacro(<< error.what());
        return 0;
    }
}
