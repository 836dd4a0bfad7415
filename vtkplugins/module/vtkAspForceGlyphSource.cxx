#include "vtkplugins/module/vtkAspForceGlyphSource.h"

#include "vtkplugins/module/StripGrid.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkAspForceGlyphSource)

namespace {

/// Outline of an arrow of the given length: flat end, shaft, flat shoulder, cone.
std::vector<asperity::ProfilePoint> arrowProfile(double length) {
    const double shaftRadius = 0.02 * length;
    const double headRadius = 0.06 * length;
    const double neck = 0.72 * length;
    const double side = std::hypot(headRadius, length - neck);
    const double coneRadial = (length - neck) / side;
    const double coneAlong = headRadius / side;
    return {{0.0, 0.0, 0.0, -1.0},
            {shaftRadius, 0.0, 0.0, -1.0},
            {shaftRadius, 0.0, 1.0, 0.0},
            {shaftRadius, neck, 1.0, 0.0},
            {shaftRadius, neck, 0.0, -1.0},
            {headRadius, neck, 0.0, -1.0},
            {headRadius, neck, coneRadial, coneAlong},
            {0.0, length, coneRadial, coneAlong}};
}

}  // namespace

vtkAspForceGlyphSource::vtkAspForceGlyphSource() { this->SetNumberOfInputPorts(0); }

void vtkAspForceGlyphSource::PrintSelf(ostream& os, vtkIndent indent) {
    this->Superclass::PrintSelf(os, indent);
    os << indent << "ContactPoint: " << this->ContactPoint[0] << " " << this->ContactPoint[1] << " "
       << this->ContactPoint[2] << "\n";
    os << indent << "Force: " << this->Force[0] << " " << this->Force[1] << " " << this->Force[2]
       << "\n";
    os << indent << "MetersPerNewton: " << this->MetersPerNewton << "\n";
    os << indent << "Resolution: " << this->Resolution << "\n";
}

int vtkAspForceGlyphSource::RequestData(vtkInformation* /*request*/,
                                        vtkInformationVector** /*input*/,
                                        vtkInformationVector* outputVector) {
    const asperity::Vector3 force(this->Force);
    const double magnitude = force.stableNorm();
    const double length = magnitude * this->MetersPerNewton;
    if (!(length > 0.0) || !std::isfinite(length)) {
        return 1;
    }
    asperity::revolveProfile(arrowProfile(length), asperity::Vector3(this->ContactPoint),
                             force / magnitude, this->Resolution,
                             vtkPolyData::GetData(outputVector));
    return 1;
}
