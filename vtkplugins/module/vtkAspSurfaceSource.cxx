#include "vtkplugins/module/vtkAspSurfaceSource.h"

#include "vtkplugins/module/StripGrid.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

vtkStandardNewMacro(vtkAspSurfaceSource)

vtkAspSurfaceSource::vtkAspSurfaceSource() { this->SetNumberOfInputPorts(0); }

void vtkAspSurfaceSource::PrintSelf(ostream& os, vtkIndent indent) {
    this->Superclass::PrintSelf(os, indent);
    os << indent << "Surface: " << this->Surface << "\n";
    os << indent << "Window: " << this->Window[0] << " " << this->Window[1] << " "
       << this->Window[2] << " " << this->Window[3] << "\n";
    os << indent << "Resolution: " << this->Resolution[0] << " " << this->Resolution[1] << "\n";
}

void vtkAspSurfaceSource::SetSurface(const asperity::BSplineSurface* surface) {
    this->Surface = surface;
    this->Modified();  // always: a new surface may lie where an old one was
}

int vtkAspSurfaceSource::RequestData(vtkInformation* /*request*/, vtkInformationVector** /*input*/,
                                     vtkInformationVector* outputVector) {
    const int columns = this->Resolution[0];
    const int rows = this->Resolution[1];
    if (this->Surface == nullptr || columns < 2 || rows < 2) {
        vtkErrorMacro("needs a surface and a resolution of at least 2 x 2");
        return 0;
    }
    const vtkIdType count = static_cast<vtkIdType>(columns) * rows;
    vtkNew<vtkPoints> points;
    points->SetDataTypeToFloat();
    points->SetNumberOfPoints(count);
    vtkNew<vtkFloatArray> normals;
    normals->SetName("Normals");
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(count);
    vtkNew<vtkFloatArray> heights;
    heights->SetName("height");
    heights->SetNumberOfTuples(count);

    const double stepX = (this->Window[1] - this->Window[0]) / (columns - 1);
    const double stepY = (this->Window[3] - this->Window[2]) / (rows - 1);
    vtkIdType id = 0;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column, ++id) {
            const double x = this->Window[0] + column * stepX;
            const double y = this->Window[2] + row * stepY;
            const asperity::HeightSample sample = this->Surface->at(x, y);
            points->SetPoint(id, x, y, sample.height);
            normals->SetTuple(id, sample.normal().data());
            heights->SetValue(id, static_cast<float>(sample.height));
        }
    }
    vtkPolyData* output = vtkPolyData::GetData(outputVector);
    output->SetPoints(points);
    output->SetStrips(asperity::gridStrips(columns, rows));
    output->GetPointData()->SetNormals(normals);
    output->GetPointData()->SetScalars(heights);
    return 1;
}
