// Force curve of a silicon tip on polystyrene: where it snaps in, how hard it must be pulled off.
#include "core/contact/ContactState.h"
#include "core/contact/laws/ContactModel.h"
#include "core/contact/laws/ForceCurve.h"

#include <cstdio>

int main() {
    using namespace asperity;
    const Elastic silicon{.youngsModulus = 169e9, .poissonRatio = 0.27};
    const Elastic polystyrene{.youngsModulus = 2e9, .poissonRatio = 0.4};
    const ContactPair pair{.tipRadius = 15e-9,
                           .reducedModulus = reducedModulus(polystyrene, silicon),
                           .workOfAdhesion = 0.066};
    const ContactModel model(ContactLaw::Split, pair);
    const double compliance = 1.0 / 14.0;  // of the lever [m/N]
    const ForceCurve curve = forceCurve(model, compliance, curvePlan(model, compliance));

    std::printf("way,base_m,indentation_m,force_n,contact_radius_m\n");
    const auto print = [](const char* way, const ForceCurvePoint& point) {
        std::printf("%s,%.4e,%.4e,%.4e,%.4e\n", way, point.basePosition, point.state.indentation,
                    point.state.force, point.state.contactRadius);
    };
    for (const ForceCurvePoint& point : curve.approach) {
        print("approach", point);
    }
    for (const ForceCurvePoint& point : curve.retract) {
        print("retract", point);
    }
    if (curve.snapIn && curve.pullOff) {
        std::fprintf(stderr, "snaps in at %.3f nm, pulls off at %.2f nN\n",
                     curve.snapIn->before.indentation * 1e9, curve.pullOff->before.force * 1e9);
    }
}
