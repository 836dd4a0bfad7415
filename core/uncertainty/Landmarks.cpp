#include "core/uncertainty/Landmarks.h"

#include "core/contact/laws/ForceCurve.h"

#include <cmath>
#include <limits>

namespace asperity {

namespace {

double& at(Landmarks& landmarks, Landmark landmark) {
    return landmarks[static_cast<std::size_t>(landmark)];
}

/// Area over the base's position between the fold, where the force goes as a square root, and the
/// position without force, by Simpson's rule in the root of the distance [J].
double pullingArea(const ContactModel& model, double compliance, double fold, double zero) {
    constexpr int kIntervals = 32;
    const double reach = zero - fold;
    double area = 0.0;
    for (int i = 1; i <= kIntervals; ++i) {  // the integrand is 0 at the fold
        const double root = static_cast<double>(i) / kIntervals;
        const double base = fold + (reach * root * root);
        const double pull = -model.equilibrium(base, compliance, kBondedMemory).force;
        const double weight = i == kIntervals ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
        area += weight * pull * 2.0 * root;
    }
    return area * reach / (3.0 * kIntervals);
}

void takeSnapIn(const ContactModel& model, double compliance, const TipJump& pullOff,
                Landmarks& landmarks) {
    if (const std::optional<TipJump> snapIn = snapInOf(model, compliance)) {
        at(landmarks, Landmark::SnapInForce) = -snapIn->after.force;
        at(landmarks, Landmark::SnapInDistance) = 0.0 - snapIn->basePosition;  // not -0
        at(landmarks, Landmark::Hysteresis) = snapIn->after.energyLost + pullOff.after.energyLost;
    }
}

/// @param pullOff the base's position there [m]
void takeSetpoint(const ContactModel& model, double compliance, double force, double pullOff,
                  Landmarks& landmarks) {
    const std::optional<double> base = basePositionAt(model, compliance, force);
    if (!base) {
        return;
    }
    const ContactState state = model.equilibrium(*base, compliance, kBondedMemory);
    constexpr double kReached = 1e-6;  // of the force: more than the search leaves
    if (!(std::abs(state.force - force) <= kReached * force)) {
        return;
    }
    at(landmarks, Landmark::NormalForce) = state.force;
    at(landmarks, Landmark::Indentation) = state.indentation;
    at(landmarks, Landmark::Stiffness) = state.stiffness;
    at(landmarks, Landmark::ContactRadius) = state.contactRadius;
    at(landmarks, Landmark::ContactTravel) = *base - pullOff;
}

void takeAdhesion(const ContactModel& model, double compliance, const TipJump& pullOff,
                  Landmarks& landmarks) {
    constexpr double kNearlyNone = 1e-4;  // of the strongest pull
    const std::optional<ForceCurvePoint> strongest = strongestPullOf(model, compliance);
    if (!strongest) {
        return;
    }
    const double pull = -strongest->state.force;
    at(landmarks, Landmark::AdhesionForce) = pull;
    at(landmarks, Landmark::PullOffForce) = -pullOff.before.force;
    const std::optional<double> zero = basePositionAt(model, compliance, kNearlyNone * pull);
    if (zero) {
        at(landmarks, Landmark::SeparationWork) =
            pullingArea(model, compliance, pullOff.basePosition, *zero);
    }
}

}  // namespace

Landmarks landmarksOf(const ContactModel& model, double compliance, double force) {
    Landmarks landmarks;
    landmarks.fill(std::numeric_limits<double>::quiet_NaN());
    const std::optional<TipJump> pullOff = pullOffOf(model, compliance);
    if (pullOff) {
        takeAdhesion(model, compliance, *pullOff, landmarks);
        takeSnapIn(model, compliance, *pullOff, landmarks);
    }
    if (force > 0.0) {
        takeSetpoint(model, compliance, force,
                     pullOff ? pullOff->basePosition : std::numeric_limits<double>::quiet_NaN(),
                     landmarks);
    }
    return landmarks;
}

}  // namespace asperity
