#include "app/exports/MomentCaption.h"

#include "app/recording/ForceTrace.h"
#include "core/FormattedText.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

std::string valueText(double value, const SiScale& scale) {
    const double shown = value * scale.factor;
    return formatted("%.2f ", std::abs(shown) < 0.005 ? 0.0 : shown) + scale.unit;
}

/// As pictures of a contact call it: adhesion may hold a tip above the surface at rest.
std::string distanceText(const ContactState& contact, const SiScale& scale) {
    const bool isApart = contact.region() != TipRegion::Contact;
    const char* name = isApart                     ? "gap "
                       : contact.indentation < 0.0 ? "neck height "
                                                   : "indentation ";
    const bool isAbove = isApart || contact.indentation < 0.0;
    return name + valueText(isAbove ? -contact.indentation : contact.indentation, scale);
}

}  // namespace

void MomentCaption::take(const TickSample& sample) {
    force_ = std::max(force_, std::abs(normalForce(sample.output)));
    distance_ = std::max(distance_, std::abs(sample.output.model.contact.indentation));
}

std::string MomentCaption::of(const TickSample& sample) const {
    const TickOutput& out = sample.output;
    return formatted("t = %.3f s, normal force ", sample.time) +
           valueText(normalForce(out), siScaleFor(force_, "N")) + ", " +
           distanceText(out.model.contact, siScaleFor(distance_, "m")) + ", " +
           nameOf(out.model.contact.region());
}

}  // namespace asperity
