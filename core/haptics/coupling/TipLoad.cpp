#include "core/haptics/coupling/TipLoad.h"

#include <algorithm>

namespace asperity {

namespace {

constexpr double kForceControl = 1e3;  // compliance beside which no indentation counts [m/N]

}  // namespace

double inSeries(double first, double second) noexcept { return 1.0 / (1.0 / first + 1.0 / second); }

TipLoad tipLoad(const ProbeSystem& system, double largestForce, PositionControl control) noexcept {
    const ContactModel& contact = system.contact;
    const double lever = 1.0 / system.cantilever.compliance()(2, 2);
    const ContactState pressed =
        contact.equilibrium(kForceControl * largestForce, kForceControl, {});
    const double stiffness =
        control == PositionControl::Tip ? pressed.stiffness : inSeries(lever, pressed.stiffness);
    return {.stiffness = pressed.solved() ? stiffness : lever,
            .adhesion = std::max(0.0, -contact.lastBonded(kForceControl).force)};
}

}  // namespace asperity
