#include "core/studies/extremes/ContactWay.h"

#include "core/contact/laws/HertzLaw.h"
#include "core/studies/extremes/LogSpaced.h"

#include <algorithm>

namespace asperity {

std::vector<ContactStop> contactWay(const ContactModel& reference, const ContactSetting& setting,
                                    int places) {
    constexpr double kShallowest = 1e-4;  // of the tip radius
    constexpr double kDeepest = 3.0;      // of the tip radius
    constexpr double kNearest = 1e-3;     // of the farthest gap
    const double radius = setting.pair.tipRadius;
    const double compliance = setting.compliance();
    const double farthest = -1.5 * std::max({-reference.pullOffApproach(compliance),
                                             -reference.jumpInApproach(compliance), 0.05 * radius});
    std::vector<ContactStop> way;
    for (const double gap : logSpaced(farthest, kNearest * farthest, places / 2)) {
        way.push_back({gap, false});
    }
    const HertzLaw hertz(setting.pair);
    for (const double depth :
         logSpaced(kShallowest * radius, kDeepest * radius, places - (places / 2))) {
        way.push_back({depth + (compliance * hertz.atIndentation(depth).force), false});
    }
    for (std::size_t i = way.size(); i-- > 0;) {
        way.push_back({way[i].approach, true});
    }
    return way;
}

ContactCourse contactCourse(const ContactModel& model, const std::vector<ContactStop>& way,
                            double compliance) {
    ContactCourse course{.jumpIn = model.jumpInApproach(compliance),
                         .pullOff = model.pullOffApproach(compliance)};
    ContactMemory memory;
    for (const ContactStop& stop : way) {
        course.states.push_back(model.equilibrium(stop.approach, compliance, memory));
        memory = course.states.back().memory();
    }
    return course;
}

}  // namespace asperity
