#include "app/reports/RunCurves.h"

#include "core/haptics/cycle/CurveBranch.h"

#include <cmath>
#include <utility>

namespace asperity {

namespace {

/// The component of every vector along one axis.
std::vector<double> component(const std::vector<Vector3>& vectors, int axis) {
    std::vector<double> values;
    values.reserve(vectors.size());
    for (const Vector3& vector : vectors) {
        values.push_back(vector[axis]);
    }
    return values;
}

}  // namespace

void RunCurves::take(const TickSample& sample) {
    const TickOutput& out = sample.output;
    time_.push_back(sample.time);
    tip_.push_back(out.tip);
    estimate_.push_back(out.estimate.force);
    model_.push_back(out.model.force);
    indentation_.push_back(out.model.contact.indentation);
    contactRadius_.push_back(out.model.contact.contactRadius);
    bending_.push_back(sample.input.measurement.signals.bending);
    torsion_.push_back(sample.input.measurement.signals.torsion);
    takeLegs(sample);
}

void RunCurves::takeLegs(const TickSample& sample) {
    const TickOutput& out = sample.output;
    const Vector3& velocity = out.base.velocity;
    // Legs are where the base moves along z alone.
    if (std::hypot(velocity.x(), velocity.y()) >= 1e-3 * std::abs(velocity.z())) {
        return;
    }
    Leg& leg = velocity.z() < 0.0 ? approach_ : retract_;
    // The gap that the undeflected tip would have, taken from along the normal to along z.
    const Vector3& normal = out.model.closest.normal;
    const double gap =
        -out.model.contact.indentation + normal.dot(out.base.position - out.model.tip);
    leg.height.push_back(gap / normal.z());
    leg.force.push_back(out.estimate.force.z());
}

std::vector<Chart> RunCurves::charts() const {
    return {Chart{.title = "Force on the tip, estimated from the two signals",
                  .xLabel = "time",
                  .yLabel = "force",
                  .curves = {{.label = "Fx", .x = time_, .y = component(estimate_, 0)},
                             {.label = "Fy", .x = time_, .y = component(estimate_, 1)},
                             {.label = "Fz", .x = time_, .y = component(estimate_, 2)},
                             {.label = "Fz, contact model",
                              .x = time_,
                              .y = component(model_, 2),
                              .dashed = true}},
                  .xUnit = "s",
                  .yUnit = "N"},
            Chart{.title = "Approach and retract",
                  .xLabel = "height of the base above first touch",
                  .yLabel = "force along z",
                  .curves = {{.label = nameOf(CurveBranch::Approach),
                              .x = approach_.height,
                              .y = approach_.force},
                             {.label = nameOf(CurveBranch::Retract),
                              .x = retract_.height,
                              .y = retract_.force}},
                  .xUnit = "m",
                  .yUnit = "N"},
            Chart{.title = "Contact",
                  .xLabel = "time",
                  .yLabel = "length",
                  .curves = {{.label = "indentation", .x = time_, .y = indentation_},
                             {.label = "contact radius", .x = time_, .y = contactRadius_}},
                  .xUnit = "s",
                  .yUnit = "m"},
            Chart{.title = "Signals of the optical lever",
                  .xLabel = "time",
                  .yLabel = "angle",
                  .curves = {{.label = "bending", .x = time_, .y = bending_},
                             {.label = "torsion", .x = time_, .y = torsion_}},
                  .xUnit = "s",
                  .yUnit = "rad"}};
}

void RunCurves::write(const std::filesystem::path& path) const {
    constexpr int kColumns = 2;
    writeCharts(path, charts(), kColumns);
}

}  // namespace asperity
