#include "vtkplugins/paraview/module/vtkAspHeightMapReader.h"

#include "core/Error.h"
#include "core/io/heightmap/ImageScale.h"
#include "core/io/heightmap/ScanFile.h"
#include "vtkplugins/paraview/module/LengthUnit.h"

#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkStringArray.h>

#include <exception>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkAspHeightMapReader)

using Pipeline = vtkStreamingDemandDrivenPipeline;

struct vtkAspHeightMapReader::Opened {
    Opened(const char* file, const asperity::GivenScale& given, const std::string& name,
           vtkMTimeType opened)
        : scan(file, given)
        , channel(asperity::heightChannel(scan.contents(), file, name))
        , time(opened) {
        const std::string& usual = asperity::heightChannel(scan.contents(), file, "").name;
        names->InsertNextValue(usual);
        for (const std::string& other : asperity::heightChannels(scan.contents())) {
            if (other != usual) {
                names->InsertNextValue(other);
            }
        }
    }

    asperity::ScanFile scan;
    const asperity::ScanChannel& channel;
    vtkMTimeType time;  ///< of the reader when it was opened
    vtkNew<vtkStringArray> names;
};

vtkAspHeightMapReader::vtkAspHeightMapReader() { this->SetNumberOfInputPorts(0); }

vtkAspHeightMapReader::~vtkAspHeightMapReader() {
    this->SetFileName(nullptr);
    this->SetChannel(nullptr);
}

void vtkAspHeightMapReader::PrintSelf(ostream& os, vtkIndent indent) {
    this->Superclass::PrintSelf(os, indent);
    os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
    os << indent << "Channel: " << (this->Channel ? this->Channel : "(default)") << "\n";
    os << indent << "LengthUnit: " << this->LengthUnit << "\n";
    os << indent << "Size: " << this->Size[0] << " " << this->Size[1] << "\n";
    os << indent << "HeightPerValue: " << this->HeightPerValue << "\n";
}

int vtkAspHeightMapReader::CanReadFile(const char* name) {
    try {
        return asperity::ScanFile(name).contents().channels.empty() ? 0 : 1;
    } catch (const std::exception&) {
        return 0;
    }
}

vtkStringArray* vtkAspHeightMapReader::GetChannels() {
    return this->File ? this->File->names.Get() : nullptr;
}

const vtkAspHeightMapReader::Opened& vtkAspHeightMapReader::Open() {
    if (this->File && this->File->time == this->GetMTime()) {
        return *this->File;
    }
    this->File.reset();
    if (!this->FileName || !*this->FileName) {
        throw asperity::Error("no file is named");
    }
    if (!asperity::LengthUnit(this->LengthUnit).isUsable()) {
        throw asperity::Error("the length unit must be a length above zero");
    }
    try {
        this->File =
            std::make_unique<Opened>(this->FileName,
                                     asperity::GivenScale{.sizeX = this->Size[0],
                                                          .sizeY = this->Size[1],
                                                          .heightPerValue = this->HeightPerValue},
                                     this->Channel ? this->Channel : "", this->GetMTime());
    } catch (const asperity::MissingScale&) {
        throw asperity::Error(std::string(this->FileName) +
                              ": the file lacks the size of the scan or the unit of its heights: "
                              "set Scan Size and Height per Value");
    }
    return *this->File;
}

int vtkAspHeightMapReader::Inform(vtkInformationVector* output) {
    const asperity::HeightMap& map = this->Open().channel.map;
    const asperity::LengthUnit unit(this->LengthUnit);
    const double pitchX = unit.fromMeters(map.pitchX);
    const double pitchY = unit.fromMeters(map.pitchY);
    const int whole[6] = {0, map.columns - 1, 0, map.rows - 1, 0, 0};
    vtkInformation* out = output->GetInformationObject(0);
    out->Set(Pipeline::WHOLE_EXTENT(), whole, 6);
    out->Set(vtkDataObject::SPACING(), pitchX, pitchY, 1.0);
    out->Set(vtkDataObject::ORIGIN(), 0.5 * pitchX, 0.5 * pitchY, 0.0);
    out->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
    vtkDataObject::SetPointDataActiveScalarInfo(out, VTK_DOUBLE, 1);
    return 1;
}

int vtkAspHeightMapReader::Read(vtkInformationVector* output) {
    const Opened& file = this->Open();
    const asperity::LengthUnit unit(this->LengthUnit);
    int extent[6];
    output->GetInformationObject(0)->Get(Pipeline::UPDATE_EXTENT(), extent);
    vtkImageData* image = vtkImageData::GetData(output);
    image->SetExtent(extent);
    vtkNew<vtkDoubleArray> heights;
    heights->SetName("height");
    heights->SetNumberOfValues(image->GetNumberOfPoints());
    const asperity::HeightRows rows = file.scan.rowsOf(file.channel);
    std::vector<double> row(static_cast<std::size_t>(rows.columns));
    vtkIdType id = heights->GetNumberOfValues();
    // From the top, as files have them; VTK's rows go up.
    for (int up = extent[3]; up >= extent[2]; --up) {
        rows.readRow(rows.rows - 1 - up, row.data());
        id -= extent[1] - extent[0] + 1;
        for (int column = extent[0]; column <= extent[1]; ++column) {
            heights->SetValue(id + column - extent[0],
                              unit.fromMeters(row[static_cast<std::size_t>(column)]));
        }
    }
    image->GetPointData()->SetScalars(heights);
    return 1;
}

// No exception may pass through VTK.

int vtkAspHeightMapReader::RequestInformation(vtkInformation* /*request*/,
                                              vtkInformationVector** /*input*/,
                                              vtkInformationVector* output) {
    try {
        return this->Inform(output);
    } catch (const std::exception& error) {
        vtkErrorMacro(<< error.what());
        return 0;
    }
}

int vtkAspHeightMapReader::RequestData(vtkInformation* /*request*/,
                                       vtkInformationVector** /*input*/,
                                       vtkInformationVector* output) {
    try {
        return this->Read(output);
    } catch (const std::exception& error) {
        vtkErrorMacro(<< error.what());
        return 0;
    }
}
