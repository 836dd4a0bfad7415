#include "tests/core/identify/SyntheticCurve.h"

#include "core/Random.h"

#include <cmath>

namespace asperity::test {

double SyntheticCurve::force(const TipLaw& law, double beyond) const {
    if (!(beyond > 0.0)) {
        return 0.0;
    }
    double low = 0.0;
    double high = beyond;
    for (int i = 0; i < 200; ++i) {
        const double depth = 0.5 * (low + high);
        const double balance = depth + (reducedModulus * law.exact(depth).force / stiffness);
        (balance < beyond ? low : high) = depth;
    }
    return stiffness * (beyond - (0.5 * (low + high)));
}

MeasuredForceCurve SyntheticCurve::curve(unsigned seed) const {
    const TipLaw law(tip, {}, 1e-6);
    Random random(seed);
    MeasuredForceCurve curve;
    curve.stiffness = stiffness;
    double error = noise * random.normal();
    for (const bool retracts : {false, true}) {
        CurveSegment segment{.kind =
                                 retracts ? CurveSegmentKind::Retract : CurveSegmentKind::Approach};
        for (std::size_t i = 0; i < samples; ++i) {
            const double share = static_cast<double>(i) / static_cast<double>(samples - 1);
            const double way = retracts ? 1.0 - share : share;
            const double beyond = start + (way * (end - start));
            error = (memory * error) + (noise * std::sqrt(1.0 - memory * memory) * random.normal());
            const double total =
                force(law, beyond) + offset + (tilt * beyond) + (retracts ? -drag : drag) + error;
            segment.base.push_back(contact + beyond);
            segment.force.push_back(total);
            segment.deflection.push_back(total / stiffness);
        }
        curve.segments.push_back(segment);
    }
    return curve;
}

}  // namespace asperity::test
