#include "vtkplugins/paraview/module/vtkAspForceMap.h"

#include "core/Error.h"
#include "core/ShareOut.h"
#include "core/io/loading/SceneOnSample.h"
#include "core/io/scene/SceneFile.h"
#include "core/map/MapPlan.h"
#include "vtkplugins/paraview/module/AlgorithmProgress.h"
#include "vtkplugins/paraview/module/GivenHeights.h"

#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkExtentTranslator.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <exception>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

vtkStandardNewMacro(vtkAspForceMap)

using Pipeline = vtkStreamingDemandDrivenPipeline;

namespace {

std::vector<std::string> keysIn(const char* text) {
    std::vector<std::string> keys;
    std::istringstream stream(text ? text : "");
    for (std::string key; std::getline(stream, key, ',');) {
        const std::size_t first = key.find_first_not_of(" \t");
        if (first != std::string::npos) {
            keys.push_back(key.substr(first, key.find_last_not_of(" \t") + 1 - first));
        }
    }
    return keys;
}

/// The rows of a piece of the map, or parts of them where ranks are many. UPDATE_EXTENT of a
/// filter's output is the whole one on every rank: the piece alone says what is asked for.
void pieceOf(vtkInformation& asked, const asperity::MapGrid& grid, int extent[6]) {
    int whole[6] = {0, grid.columns - 1, 0, grid.rows - 1, 0, 0};
    vtkNew<vtkExtentTranslator> translator;
    translator->PieceToExtentThreadSafe(asked.Get(Pipeline::UPDATE_PIECE_NUMBER()),
                                        asked.Get(Pipeline::UPDATE_NUMBER_OF_PIECES()),
                                        asked.Get(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS()), whole,
                                        extent, vtkExtentTranslator::Y_SLAB_MODE, 0);
}

/// An array of the image for each quantity of the plan.
std::vector<vtkSmartPointer<vtkDoubleArray>> addArrays(const asperity::MapPlan& plan,
                                                       vtkImageData& image) {
    std::vector<vtkSmartPointer<vtkDoubleArray>> arrays;
    for (const asperity::MapQuantity quantity : plan.quantities) {
        auto array = vtkSmartPointer<vtkDoubleArray>::New();
        array->SetName(asperity::rowOf(quantity)->key);
        array->SetNumberOfValues(image.GetNumberOfPoints());
        image.GetPointData()->AddArray(array);
        arrays.push_back(array);
    }
    image.GetPointData()->SetActiveScalars(arrays.front()->GetName());
    return arrays;
}

/// @param file of the scene; null or empty: the scene of a height map alone
asperity::Scene sceneOn(std::variant<asperity::HeightMap, asperity::ScanMap> heights,
                        const char* file, asperity::Progress& progress) {
    const bool isNamed = file && *file;
    try {
        return asperity::sceneOnHeights(isNamed ? asperity::readScene(file)
                                                : asperity::defaultScene(),
                                        std::move(heights), &progress);
    } catch (const asperity::InputError&) {
        throw;
    } catch (const asperity::Error& error) {
        throw asperity::Error((isNamed ? std::string(file) + ": " : std::string()) + error.what());
    }
}

/// Computes the rows of the image's extent, each of them whole: in mode contact it is one line.
void fillRows(const asperity::Scene& scene, const asperity::MapPlan& plan,
              const asperity::LengthUnit& unit, vtkImageData& image, int threads,
              asperity::Progress& progress) {
    const std::vector<vtkSmartPointer<vtkDoubleArray>> arrays = addArrays(plan, image);
    const int* extent = image.GetExtent();
    const int rows = extent[3] - extent[2] + 1;
    if (rows <= 0) {
        return;
    }
    const asperity::MapInstrument instrument(scene, plan.truth);
    const auto columns = static_cast<std::size_t>(plan.grid.columns);
    const auto first = static_cast<std::size_t>(extent[0]);
    const auto count = static_cast<std::size_t>(extent[1] - extent[0] + 1);
    const auto compute = [&](int index, const asperity::CancelCheck& check) {
        const int row = plan.grid.rows - 1 - (extent[2] + index);  // VTK's rows go up
        const std::vector<double> values = asperity::mapRow(instrument, plan, row, check);
        for (std::size_t i = 0; i < arrays.size(); ++i) {
            const bool isLength = std::string(asperity::rowOf(plan.quantities[i])->unit) == "m";
            double* target = arrays[i]->GetPointer(static_cast<vtkIdType>(count) * index);
            for (std::size_t column = 0; column < count; ++column) {
                const double value = values[i * columns + first + column];
                target[column] = isLength ? unit.fromMeters(value) : value;
            }
        }
    };
    asperity::shareOut(rows, &progress, compute, threads);
}

}  // namespace

vtkAspForceMap::vtkAspForceMap() {
    this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS,
                                 vtkDataSetAttributes::SCALARS);
}

vtkAspForceMap::~vtkAspForceMap() {
    this->SetSceneFile(nullptr);
    this->SetQuantities(nullptr);
}

void vtkAspForceMap::PrintSelf(ostream& os, vtkIndent indent) {
    this->Superclass::PrintSelf(os, indent);
    os << indent << "SceneFile: " << (this->SceneFile ? this->SceneFile : "(none)") << "\n";
    os << indent << "Mode: " << this->Mode << "\n";
    os << indent << "Setpoint: " << this->Setpoint << "\n";
    os << indent << "Quantities: " << (this->Quantities ? this->Quantities : "(all)") << "\n";
    os << indent << "Grid: " << this->Grid[0] << " " << this->Grid[1] << "\n";
    os << indent << "Truth: " << this->Truth << "\n";
    os << indent << "LengthUnit: " << this->LengthUnit << "\n";
    os << indent << "Threads: " << this->Threads << "\n";
}

void vtkAspForceMap::GridOf(const int extent[6], int grid[2]) const {
    for (int axis = 0; axis < 2; ++axis) {
        const int pixels = extent[2 * axis + 1] - extent[2 * axis] + 1;
        grid[axis] = this->Grid[axis] > 0 ? this->Grid[axis] : pixels;
    }
}

int vtkAspForceMap::RequestInformation(vtkInformation* /*request*/, vtkInformationVector** input,
                                       vtkInformationVector* output) {
    vtkInformation* in = input[0]->GetInformationObject(0);
    vtkInformation* out = output->GetInformationObject(0);
    int extent[6];
    double spacing[3] = {1.0, 1.0, 1.0};
    double origin[3] = {0.0, 0.0, 0.0};
    in->Get(Pipeline::WHOLE_EXTENT(), extent);
    if (in->Has(vtkDataObject::SPACING())) {
        in->Get(vtkDataObject::SPACING(), spacing);
    }
    if (in->Has(vtkDataObject::ORIGIN())) {
        in->Get(vtkDataObject::ORIGIN(), origin);
    }
    int grid[2];
    this->GridOf(extent, grid);
    for (int axis = 0; axis < 2; ++axis) {
        const int pixels = extent[2 * axis + 1] - extent[2 * axis] + 1;
        const double edge = origin[axis] + (extent[2 * axis] - 0.5) * spacing[axis];
        spacing[axis] *= static_cast<double>(pixels) / grid[axis];
        origin[axis] = edge + 0.5 * spacing[axis];
    }
    const int whole[6] = {0, grid[0] - 1, 0, grid[1] - 1, 0, 0};
    out->Set(Pipeline::WHOLE_EXTENT(), whole, 6);
    out->Set(vtkDataObject::SPACING(), spacing, 3);
    out->Set(vtkDataObject::ORIGIN(), origin, 3);
    vtkDataObject::SetPointDataActiveScalarInfo(out, VTK_DOUBLE, 1);
    return 1;
}

int vtkAspForceMap::RequestUpdateExtent(vtkInformation* /*request*/, vtkInformationVector** input,
                                        vtkInformationVector* /*output*/) {
    vtkInformation* in = input[0]->GetInformationObject(0);
    int whole[6];
    in->Get(Pipeline::WHOLE_EXTENT(), whole);
    in->Set(Pipeline::UPDATE_EXTENT(), whole, 6);
    // Without these a source still cuts the extent to the rank's piece.
    in->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
    in->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
    in->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    return 1;
}

int vtkAspForceMap::Compute(vtkInformationVector** input, vtkInformationVector* output) {
    const asperity::LengthUnit unit(this->LengthUnit);
    if (!unit.isUsable()) {
        throw asperity::Error("the length unit must be a length above zero");
    }
    vtkImageData* in = vtkImageData::GetData(input[0]);
    vtkDataArray* heights = this->GetInputArrayToProcess(0, input);
    if (!heights) {
        throw asperity::Error("the input has no such height array");
    }
    asperity::AlgorithmProgress progress(*this);
    asperity::ProgressPart fitting(&progress, 0.0, 0.05);
    asperity::ProgressPart mapping(&progress, 0.05, 1.0);
    const asperity::Scene scene =
        sceneOn(asperity::givenHeights(*in, *heights, unit), this->SceneFile, fitting);
    asperity::MapRequest request{.mode = asperity::kEnumTable<asperity::MapMode>[this->Mode].value,
                                 .quantities = keysIn(this->Quantities),
                                 .truth = this->Truth};
    int grid[2];
    this->GridOf(in->GetExtent(), grid);
    request.grid = {.columns = grid[0], .rows = grid[1]};
    if (this->Setpoint != 0.0) {
        request.setpoint = this->Setpoint;
    }
    const asperity::MapPlan plan = asperity::planMap(scene, request);
    vtkInformation* asked = output->GetInformationObject(0);
    int extent[6];
    pieceOf(*asked, plan.grid, extent);
    vtkImageData* out = vtkImageData::GetData(output);
    out->SetExtent(extent);
    const bool isAlone = asked->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) <= 1;
    const int threads = this->Threads > 0 || isAlone ? this->Threads : 1;
    fillRows(scene, plan, unit, *out, threads, mapping);
    return 1;
}

int vtkAspForceMap::RequestData(vtkInformation* /*request*/, vtkInformationVector** input,
                                vtkInformationVector* output) {
    try {  // no exception may pass through VTK
        return this->Compute(input, output);
    } catch (const asperity::Canceled&) {
        return 0;
    } catch (const std::exception& error) {
        vtkErrorMacro(<< error.what());
        return 0;
    }
}
