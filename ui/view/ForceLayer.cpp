#include "ui/view/ForceLayer.h"

#include "ui/widgets/Steady.h"
#include "ui/widgets/Theme.h"
#include "vtkplugins/module/vtkAspForceGlyphSource.h"
#include "vtkplugins/pictures/SceneParts.h"

#include <vtkActor.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <cmath>

namespace asperity {

namespace {

constexpr int kConeFacets = 24;
constexpr double kMinLength = 0.06;   // shorter arrows are not drawn; part of their room
constexpr double kSignificant = 3.0;  // standard deviations

/// One tick in a few hundred lies beyond three standard deviations by chance, several in a row do
/// not [s].
constexpr double kConfirmation = 0.05;

}  // namespace

bool ForceEvidence::take(const ForceEstimate& estimate, double time) {
    const Vector3 direction = estimate.force.stableNormalized();
    const double sigma = std::sqrt(direction.dot(estimate.covariance * direction));
    if (!(estimate.force.stableNorm() > kSignificant * sigma)) {
        lastNoise_ = time;
    }
    return !lastNoise_ || time < *lastNoise_ || time - *lastNoise_ > kConfirmation;
}

ForceLayer::ForceLayer(vtkRenderer* renderer) {
    source_->SetResolution(kConeFacets);
    arrow_ = plainSurface(source_->GetOutput(), theme::palette().force);
    arrow_->GetProperty()->SetAmbient(0.55);  // red on any side
    renderer->AddActor(arrow_);
    hide();
}

ForceLayer::~ForceLayer() = default;

void ForceLayer::hide() {
    arrow_->VisibilityOff();
    end_.reset();
}

void ForceLayer::show(const ForceEstimate& estimate, const Vector3& start, double time,
                      double usual, double room) {
    const Vector3& force = estimate.force;
    const double magnitude = force.stableNorm();
    const double length = arrowLength(magnitude, usual, room);
    if (!evidence_.take(estimate, time) || !(length > kMinLength * room) || !force.allFinite()) {
        hide();
        return;
    }
    arrow_->GetProperty()->SetColor(theme::palette().force.fractions().data());
    source_->SetContactPoint(start.x(), start.y(), start.z());
    source_->SetForce(force.x(), force.y(), force.z());
    source_->SetMetersPerNewton(length / magnitude);
    source_->Update();
    arrow_->VisibilityOn();
    end_ = start + length * force.stableNormalized();
}

double arrowLength(double magnitude, double usual, double room) {
    return room * magnitude / (magnitude + usual);
}

std::string magnitudeText(const Vector3& force) {
    const double magnitude = force.stableNorm();
    return threeDigitText(magnitude, siScaleFor(magnitude, "N"));
}

}  // namespace asperity
