#include "vtkplugins/module/vtkAspTipSource.h"

#include "vtkplugins/module/StripGrid.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

vtkStandardNewMacro(vtkAspTipSource)

vtkAspTipSource::vtkAspTipSource() { this->SetNumberOfInputPorts(0); }

void vtkAspTipSource::PrintSelf(ostream& os, vtkIndent indent) {
    this->Superclass::PrintSelf(os, indent);
    os << indent << "Center: " << this->Center[0] << " " << this->Center[1] << " "
       << this->Center[2] << "\n";
    os << indent << "Radius: " << this->Radius << "\n";
    os << indent << "Axis: " << this->Axis[0] << " " << this->Axis[1] << " " << this->Axis[2]
       << "\n";
    os << indent << "Height: " << this->Height << "\n";
    os << indent << "HalfAngle: " << this->HalfAngle << "\n";
    os << indent << "Resolution: " << this->Resolution << "\n";
}

int vtkAspTipSource::RequestData(vtkInformation* /*request*/, vtkInformationVector** /*input*/,
                                 vtkInformationVector* outputVector) {
    const double rightAngle = std::numbers::pi / 2.0;
    if (!(this->Radius > 0.0) || !(this->Height > 0.0) || !(this->HalfAngle > 0.0) ||
        !(this->HalfAngle < rightAngle)) {
        vtkErrorMacro("needs a positive radius and height and a half angle in (0, pi/2)");
        return 0;
    }
    // Angles are counted from the apex; sphere and cone share their tangent at `tangent`.
    const double tangent = rightAngle - this->HalfAngle;
    const double top =
        std::acos(std::clamp(1.0 - this->Height / this->Radius, std::cos(tangent), 1.0));
    const int rings = std::max(4, this->Resolution / 2);
    std::vector<asperity::ProfilePoint> profile;
    for (int ring = 0; ring <= rings; ++ring) {
        const double angle = top * ring / rings;
        profile.push_back({this->Radius * std::sin(angle), -this->Radius * std::cos(angle),
                           std::sin(angle), -std::cos(angle)});
    }
    const double coneHeight = this->Height - this->Radius * (1.0 - std::cos(tangent));
    if (coneHeight > 0.0) {
        asperity::ProfilePoint end = profile.back();
        end.radius += coneHeight * std::tan(this->HalfAngle);
        end.along += coneHeight;
        profile.push_back(end);
    }
    asperity::revolveProfile(profile, asperity::Vector3(this->Center),
                             asperity::Vector3(this->Axis), this->Resolution,
                             vtkPolyData::GetData(outputVector));
    return 1;
}
