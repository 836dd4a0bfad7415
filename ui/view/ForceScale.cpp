#include "ui/view/ForceScale.h"

#include "ui/Steady.h"

namespace asperity {

double arrowLength(double magnitude, double usual, double room) {
    return room * magnitude / (magnitude + usual);
}

std::string magnitudeText(const Vector3& force) {
    const double magnitude = force.stableNorm();
    return threeDigitText(magnitude, siScaleFor(magnitude, "N"));
}

}  // namespace asperity
