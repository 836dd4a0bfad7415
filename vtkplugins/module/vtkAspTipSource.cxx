#include "vtkplugins/module/vtkAspTipSource.h"

#include "core/surface/RoundTip.h"
#include "vtkplugins/module/StripGrid.h"

#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace {

using asperity::ProfilePoint;

/// From the apex along a sphere to where it meets its shank, or to the height.
std::vector<ProfilePoint> sphere(double radius, double shankAngle, double height, int rings) {
    const double top = std::acos(std::clamp(1.0 - height / radius, std::cos(shankAngle), 1.0));
    std::vector<ProfilePoint> profile;
    for (int ring = 0; ring <= rings; ++ring) {
        const double angle = top * ring / rings;
        profile.push_back({radius * std::sin(angle), -radius * std::cos(angle), std::sin(angle),
                           -std::cos(angle)});
    }
    return profile;
}

/// The same along a paraboloid of this radius at the apex.
std::vector<ProfilePoint> paraboloid(double radius, double reach, double height, int rings) {
    const double end = std::min(reach, std::sqrt(2.0 * radius * height));
    std::vector<ProfilePoint> profile;
    for (int ring = 0; ring <= rings; ++ring) {
        const double distance = end * ring / rings;
        const double angle = std::atan(distance / radius);
        profile.push_back({distance, 0.5 * distance * distance / radius - radius, std::sin(angle),
                           -std::cos(angle)});
    }
    return profile;
}

/// Goes on straight to the height above the apex, and there inwards to the axis.
void close(std::vector<ProfilePoint>& profile, double topAlong, int rings) {
    const ProfilePoint start = profile.back();
    ProfilePoint end = start;
    for (int ring = 1; ring <= rings && start.along < topAlong; ++ring) {
        end.along = std::lerp(start.along, topAlong, static_cast<double>(ring) / rings);
        end.radius =
            start.radius + (end.along - start.along) * -start.normalAlong / start.normalRadial;
        profile.push_back(end);
    }
    profile.push_back({end.radius, end.along, 0.0, 1.0});
    profile.push_back({0.0, end.along, 0.0, 1.0});
}

}  // namespace

vtkStandardNewMacro(vtkAspTipSource)

vtkAspTipSource::vtkAspTipSource() : HalfAngle(asperity::kShankHalfAngle) {
    this->SetNumberOfInputPorts(0);
}

void vtkAspTipSource::PrintSelf(ostream& os, vtkIndent indent) {
    this->Superclass::PrintSelf(os, indent);
    os << indent << "Center: " << this->Center[0] << " " << this->Center[1] << " "
       << this->Center[2] << "\n";
    os << indent << "Radius: " << this->Radius << "\n";
    os << indent << "Axis: " << this->Axis[0] << " " << this->Axis[1] << " " << this->Axis[2]
       << "\n";
    os << indent << "Height: " << this->Height << "\n";
    os << indent << "HalfAngle: " << this->HalfAngle << "\n";
    os << indent << "ParaboloidReach: " << this->ParaboloidReach << "\n";
    os << indent << "ShankRings: " << this->ShankRings << "\n";
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
    // Sphere and shank share their tangent here; the angle is counted from the apex.
    const double shankAngle = rightAngle - this->HalfAngle;
    const int rings = std::max(4, this->Resolution / 2);
    std::vector<ProfilePoint> profile =
        this->ParaboloidReach > 0.0
            ? paraboloid(this->Radius, this->ParaboloidReach, this->Height, rings)
            : sphere(this->Radius, shankAngle, this->Height, rings);
    close(profile, this->Height - this->Radius, this->ShankRings);
    asperity::revolveProfile(profile, asperity::Vector3(this->Center),
                             asperity::Vector3(this->Axis), this->Resolution,
                             vtkPolyData::GetData(outputVector));
    return 1;
}
