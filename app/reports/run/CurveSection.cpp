#include "app/reports/run/CurveSection.h"

#include "core/haptics/cycle/CurveBranch.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

namespace {

constexpr double kApproachWidth = 0.7;  // [pt]
constexpr double kRetractWidth = 1.5;   // [pt]
constexpr double kFreeShare = 0.5;      // of the contact's width, shown of the way before it

/// Both branches of a curve; where they meet they have a point in common.
struct Branches {
    std::vector<PlotPoint> approach;
    std::vector<PlotPoint> retract;

    std::vector<PlotPoint>& of(CurveBranch branch) {
        return branch == CurveBranch::Approach ? approach : retract;
    }
};

Branches branchesOf(const CycleTrace& trace) {
    Branches branches;
    const PlotPoint part{0.0, std::numeric_limits<double>::quiet_NaN()};
    for (std::size_t i = 0; i < trace.size(); ++i) {
        const TracePoint& point = trace[i];
        const PlotPoint place{point.baseDistance, point.force};
        if (i > 0 && trace[i - 1].branch != point.branch) {
            std::vector<PlotPoint>& ended = branches.of(trace[i - 1].branch);
            ended.push_back(place);
            ended.push_back(part);
        }
        branches.of(point.branch).push_back(place);
    }
    return branches;
}

struct Way {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
};

/// The contacts with some of the free way beside them.
Way wayOf(const std::vector<TouchCurve>& curves) {
    Way way;
    for (const TouchCurve& curve : curves) {
        for (std::size_t i = 0; i < curve.trace.size(); ++i) {
            if (curve.trace[i].contact) {
                way.low = std::min(way.low, curve.trace[i].baseDistance);
                way.high = std::max(way.high, curve.trace[i].baseDistance);
            }
        }
    }
    const double free = kFreeShare * (way.high - way.low);
    return {way.low - 0.1 * free, way.high + free};
}

/// Whether the tip kept its distance: at rest, or in a single tick.
bool isOnePlace(const RunHistory& history) {
    std::vector<const CycleTrace*> traces{&history.present()};
    for (const TouchCurve& curve : history.curves()) {
        traces.push_back(&curve.trace);
    }
    std::optional<double> first;
    for (const CycleTrace* trace : traces) {
        for (std::size_t i = 0; i < trace->size(); ++i) {
            const double distance = (*trace)[i].baseDistance;
            if (distance != first.value_or(distance)) {
                return false;
            }
            first = distance;
        }
    }
    return true;
}

/// How a touch is drawn.
struct TouchStyle {
    std::string approachName;  ///< in the legend; empty: not there
    std::string retractName;
    PlotInk approach = PlotInk::Blue;
    PlotInk retract = PlotInk::Orange;
};

/// One touch has two colors, of several each has its own.
TouchStyle styleOf(std::size_t touch, std::size_t touches) {
    if (touches <= 1) {
        return {.approachName = nameOf(CurveBranch::Approach),
                .retractName = nameOf(CurveBranch::Retract)};
    }
    const PlotInk ink = curveInk(touch);
    return {.approachName = "",
            .retractName = "touch " + std::to_string(touch + 1),
            .approach = ink,
            .retract = ink};
}

void addCurve(Plot& plot, const CycleTrace& trace, const TouchStyle& style) {
    Branches branches = branchesOf(trace);
    plot.curves.push_back(
        {style.approachName, std::move(branches.approach), style.approach, kApproachWidth});
    plot.curves.push_back(
        {style.retractName, std::move(branches.retract), style.retract, kRetractWidth});
}

Plot plotOf(const RunHistory& history) {
    Plot plot{.description = "Force on the tip over the distance of the undeflected tip",
              .x = {"gap of the undeflected tip", "m"},
              .y = {"force along the normal", "N"}};
    const std::vector<TouchCurve>& curves = history.curves();
    if (curves.empty()) {
        addCurve(plot, history.present(), styleOf(0, 1));
        return plot;
    }
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const TouchStyle style = styleOf(i, curves.size());
        addCurve(plot, curves[i].trace, style);
        const ContactCycle& cycle = curves[i].cycle;
        if (const std::optional<Reading> pullOff = cycle.pullOffForce()) {
            plot.marks.push_back({{cycle.pullOffBaseDistance, -pullOff->value}, style.retract});
        }
    }
    const Way way = wayOf(curves);
    plot.low = way.low;
    plot.high = way.high;
    return plot;
}

}  // namespace

void addCurves(PageContent& page, const RunHistory& history) {
    const std::size_t touches = history.events().cycles.size();
    std::string caption =
        "Force along the normal at the contact, estimated from the lever signals; positive: the "
        "sample pushes. The distance is the gap that the tip would have if the lever were not "
        "deflected. Thin: approach, thick: retract, rings: pull-off. A point is the mean of "
        "neighboring ticks.";
    if (touches > RunHistory::kDrawnTouches) {
        caption += " Of " + std::to_string(touches) + " touches the first " +
                   std::to_string(RunHistory::kDrawnTouches) + " are drawn.";
    }
    page.addHeading("Force–distance curve");
    if (isOnePlace(history)) {
        page.addParagraph("The tip did not move to or from the sample: there is no curve.");
        return;
    }
    page.addPlot({plotOf(history), caption});
}

}  // namespace asperity
