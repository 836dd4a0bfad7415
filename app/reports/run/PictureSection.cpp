#include "app/reports/run/PictureSection.h"

#include "app/reports/run/MeasuredText.h"
#include "core/FormattedText.h"
#include "core/uncertainty/ForceBudget.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace asperity {

namespace {

/// A moment of a run, for people.
struct Moment {
    const char* name;
    const std::optional<TickSample>& sample;
};

bool isContact(const std::optional<TickSample>& sample) {
    return sample && sample->output.region() == TipRegion::Contact;
}

std::vector<Moment> momentsOf(const RunEvents& events) {
    return {{"last tick before snap-in", events.beforeSnapIn},
            {"first tick after snap-in", events.snapIn},
            {isContact(events.deepest) ? "maximum indentation" : "nearest to the sample",
             events.deepest},
            {"strongest attraction", events.strongestPull},
            {"before pull-off, signals and model both hold the tip", events.lastHold},
            {"last tick of the model's contact", events.beforePullOff}};
}

/// With its deviation by noise, stiffness and calibration.
Reading estimateOf(const Uncertainty& given, const TickOutput& out) {
    const Vector3& normal = out.model.normal;
    const double force = out.estimate.force.dot(normal);
    const double noise = std::sqrt(std::max(0.0, normal.dot(out.estimate.covariance * normal)));
    return {force, forceBudget(given, force, noise).total()};
}

struct MomentScales {
    SiScale length;
    SiScale force;
};

MomentScales scalesOf(const Uncertainty& given, const std::vector<Moment>& moments) {
    double length = 0.0;
    double force = 0.0;
    for (const Moment& moment : moments) {
        if (moment.sample) {
            const TipState& state = moment.sample->output.model;
            length = std::max(
                {length, std::abs(state.contact.indentation), state.contact.contactRadius});
            const Reading estimate = estimateOf(given, moment.sample->output);
            force = std::max({force, std::abs(state.normalForce), std::abs(estimate.value)});
        }
    }
    return {siScaleFor(length, "m"), siScaleFor(force, "N")};
}

PageTable momentTable(const Uncertainty& given, const RunEvents& events) {
    const std::vector<Moment> moments = momentsOf(events);
    const auto [length, force] = scalesOf(given, moments);
    PageTable table{.columns = {{"moment"},
                                {"time [s]", true},
                                {"indentation [" + length.unit + "]", true},
                                {"contact radius [" + length.unit + "]", true},
                                {"force, model [" + force.unit + "]", true},
                                {"force, signals [" + force.unit + "]", true}},
                    .rows = {}};
    for (const Moment& moment : moments) {
        if (!moment.sample) {
            continue;
        }
        const TickOutput& out = moment.sample->output;
        table.rows.push_back({{moment.name},
                              {formatted("%.3f", moment.sample->time)},
                              {numberText(out.model.contact.indentation, length)},
                              {numberText(out.model.contact.contactRadius, length)},
                              {numberText(out.model.normalForce, force)},
                              {measuredText(estimateOf(given, out), force)}});
    }
    return table;
}

}  // namespace

void addPictures(PageContent& page, const ReportedRun& run) {
    page.addHeading("Contact and deformation");
    if (run.deformation.empty()) {
        page.addParagraph("The contact model has no contact in this run: no deformation is drawn.");
    } else {
        page.addPicture(
            {run.deformation, "The deformed surface of the sample under the tip",
             "The deformed surface as the contact model has it, colored by displacement."});
    }
    page.addTable(momentTable(run.loaded.scene.description.uncertainty, run.history.events()));
    page.addParagraph(
        "Single ticks, along the normal at the contact. Indentation below zero is a gap, or in "
        "contact the height of a neck above the undeformed surface. Signals: the force estimated "
        "from the lever signals, with one standard deviation by noise, stiffness and calibration.");
}

}  // namespace asperity
