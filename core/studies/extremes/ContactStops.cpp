#include "core/studies/extremes/ContactStops.h"

#include "core/contact/laws/HertzLaw.h"
#include "core/studies/extremes/LogSpaced.h"

#include <algorithm>

namespace asperity {

std::vector<ContactStop> contactStops(const ContactModel& reference, const ContactSetting& setting,
                                      int places) {
    constexpr double kMinDepth = 1e-4;  // of the tip radius
    constexpr double kMaxDepth = 3.0;   // of the tip radius
    constexpr double kMinGap = 1e-3;    // of the farthest gap
    const double radius = setting.pair.tipRadius;
    const double compliance = setting.compliance();
    const double farthest = -1.5 * std::max({-reference.pullOffApproach(compliance),
                                             -reference.jumpInApproach(compliance), 0.05 * radius});
    std::vector<ContactStop> stops;
    for (const double gap : logSpaced(farthest, kMinGap * farthest, places / 2)) {
        stops.push_back({gap, false});
    }
    const HertzLaw hertz(setting.pair);
    for (const double depth :
         logSpaced(kMinDepth * radius, kMaxDepth * radius, places - (places / 2))) {
        stops.push_back({depth + (compliance * hertz.atIndentation(depth).force), false});
    }
    for (std::size_t i = stops.size(); i-- > 0;) {
        stops.push_back({stops[i].approach, true});
    }
    return stops;
}

ContactCourse contactCourse(const ContactModel& model, const std::vector<ContactStop>& stops,
                            double compliance) {
    ContactCourse course{.jumpIn = model.jumpInApproach(compliance),
                         .pullOff = model.pullOffApproach(compliance)};
    ContactMemory memory;
    for (const ContactStop& stop : stops) {
        course.states.push_back(model.equilibrium(stop.approach, compliance, memory));
        memory = course.states.back().memory();
    }
    return course;
}

}  // namespace asperity
