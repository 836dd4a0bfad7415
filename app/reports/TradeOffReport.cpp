#include "app/reports/TradeOffReport.h"

#include "app/charts/ChartFile.h"
#include "core/FormattedText.h"
#include "core/PrintableText.h"
#include "core/Version.h"
#include "core/io/tables/CsvWriter.h"
#include "core/studies/TickStudy.h"
#include "core/words/ModelWords.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <string>

namespace asperity {

namespace {

/// Names the doubts in the reference's forces: "without film's base 0.12 nN, adhesion 3 nN".
std::string forceDoubtText(const TradeOffReference& reference) {
    std::string text;
    for (const MissedTerm& missed : reference.missed) {
        text += formatted("%s%s %.2g nN", text.empty() ? "without " : ", ", nameOf(missed.term),
                          missed.force * 1e9);
    }
    return text.empty() ? "it leaves nothing out" : text;
}

/// The quantity that changes most when a term is left out.
const char* quantityOf(const TermNeed& need) {
    return isOfSurface(need.term) ? "surface" : need.effect > 0.0 ? nameOf(need.quantity) : "";
}

const char* surfaceDoubtText(SurfaceDoubt doubt) {
    static constexpr std::array kTexts{"the half-space of half as many pixels a side against it",
                                       "the half-space of half as many pixels a side is not valid",
                                       "no half-space is valid here, and no finer model is known"};
    return kTexts.at(static_cast<std::size_t>(doubt));
}

void printTick(const TickResult& r, char mark) {
    std::printf("%c %-76s %8.2f %8.2f %10.3g %10.3g %9.3g %10.3g\n", mark,
                nameOf(r.options).c_str(), r.median * 1e6, r.p99 * 1e6, r.forceErrorRms * 1e9,
                r.contactRadiusError * 1e9, r.closestPointError * 1e9, r.estimateErrorRms * 1e9);
}

void printTicks(const TradeOff& study, double tolerance) {
    const TradeOffReference& reference = study.reference;
    std::printf("%-78s %8s %8s %10s %10s %9s %10s\n", "tick", "p50", "p99", "force err.",
                "radius err.", "point err", "estimate");
    std::printf("%-78s %8s %8s %10s %10s %9s %10s\n", "", "[us]", "[us]", "rms [nN]", "max [nm]",
                "max [nm]", "rms [nN]");
    for (const TickResult& r : study.ticks) {
        printTick(r, r.onFront ? '*' : ' ');
    }
    std::printf("signals to force, with the scene's own model\n");
    for (const TickResult& r : study.decouplings) {
        printTick(r, ' ');
    }
    std::printf("* Pareto-optimal; reference: %s, %.2f us, force %.3g nN rms\n",
                nameOf(reference.tick).c_str(), reference.tickMedian * 1e6,
                reference.forceScale * 1e9);
    std::printf("  error of the reference: %.2g nN (%s)\n", reference.forceDoubt * 1e9,
                forceDoubtText(reference).c_str());
    std::printf("  errors below that, and times within %.2g %%, count as the same\n",
                study.timeResolution * 100.0);
    const std::size_t best = cheapestWithin(costsAndErrors(study.ticks),
                                            tolerance * reference.forceScale, study.ofTicks());
    std::printf("  cheapest within %.2g %% of the force: %s\n\n", tolerance * 100.0,
                best < study.ticks.size() ? nameOf(study.ticks[best].options).c_str() : "none");
}

void printFrames(const TradeOff& study) {
    std::printf("%-57s %8s %11s %11s\n", "picture", "patch", "surface err.", "");
    std::printf("%-57s %8s %11s %11s\n", "", "[ms]", "rms [nm]", "max [nm]");
    for (const FrameResult& r : study.frames) {
        std::printf("%c %-55s %8.2f %11.3g %11.3g\n", r.onFront ? '*' : ' ',
                    nameOf(r.options).c_str(), r.median * 1e3, r.surfaceErrorRms * 1e9,
                    r.surfaceErrorMax * 1e9);
    }
    const TradeOffReference& reference = study.reference;
    std::printf("  reference, at %d of %d contacts: %s; its error: %.2g nm (%s)\n",
                reference.contacts, reference.contactsAsked, nameOf(reference.frame).c_str(),
                reference.surfaceDoubt * 1e9, surfaceDoubtText(reference.surfaceDoubtBy));
    if (reference.frame.deformation == DeformationModel::HalfSpace) {
        std::printf("  there the law's normal force differs by %.2g nN rms from the half-space's\n",
                    reference.halfSpaceForce * 1e9);
    }
    std::printf("\n");
}

void printRates(const TradeOff& study) {
    std::printf("%-20s %14s %22s\n", "rate [Hz]", "load of a core", "held force, rms [nN]");
    for (const RateResult& r : study.rates) {
        std::printf("%-20.0f %13.2f%% %22.3g\n", r.rate, r.load * 100.0, r.holdErrorRms * 1e9);
    }
    std::printf("\n");
}

void printComposition(const TradeOff& study, const Composition& whole) {
    std::printf("%6.3f %% %8.3g %%  %5.0f Hz, %s; %s\n", whole.load * 100.0, whole.error * 100.0,
                study.rates[whole.rate].rate, nameOf(study.ticks[whole.tick].options).c_str(),
                nameOf(study.frames[whole.frame].options).c_str());
}

void printCompositions(const TradeOff& study, double tolerance) {
    std::printf("Pareto-optimal configurations: load of a core (ticks and 60 pictures a "
                "second), error (of force or indentation, the larger share)\n");
    int number = 0;
    for (const Composition& whole : bestCompositions(study)) {
        std::printf("%2d ", ++number);
        printComposition(study, whole);
    }
    std::printf("the cheapest within %.2g %%:\n   ", tolerance * 100.0);
    if (const auto cheapest = cheapestComposition(study, tolerance)) {
        printComposition(study, *cheapest);
    } else {
        std::printf("none\n");
    }
    if (study.reference.forceDoubt > tolerance * study.reference.forceScale) {
        std::printf("   (the reference is not that accurate)\n");
    }
    std::printf("\n");
}

}  // namespace

void printTradeOff(const TradeOff& study, double tolerance) {
    printTicks(study, tolerance);
    printFrames(study);
    printRates(study);
    printCompositions(study, tolerance);
}

void printNeeds(const RequiredTerms& needs) {
    std::printf(
        "what the scene requires, within %.3g %% in each quantity: terms left out automatically "
        "change the %s most, by %.2g %%, a tick takes %.2f us instead of %.2f us; %s\n",
        needs.tolerance * 100.0, nameOf(needs.modelErrors.worstQuantity()),
        needs.modelErrors.worst() * 100.0, needs.modelTick * 1e6, needs.fullTick * 1e6,
        modelErrorText(needs).c_str());
    for (const TermNeed& need : needs.terms) {
        const char* unit = isOfSurface(need.term) ? "ms a patch" : "us a tick";
        const double time = need.time * (isOfSurface(need.term) ? 1e3 : 1e6);
        std::printf("  %-21s %-4s %8.3g %%  %-21s %+7.2f %-10s  %s%s\n", nameOf(need.term),
                    need.on ? "on" : "off", need.effect * 100.0, quantityOf(need), time, unit,
                    whyOf(need, needs).c_str(), need.overruled ? " (set by the scene)" : "");
    }
    std::printf("\n");
}

void printDeformations(const std::vector<DeformationResult>& results) {
    std::printf("\n%-16s %-6s %-15s %6s %9s %9s %9s %10s %10s\n", "material", "on", "deformation",
                "a/R", "patch", "rms err.", "max err.", "law", "own");
    std::printf("%-16s %-6s %-15s %6s %9s %9s %9s %10s %10s\n", "", "", "", "", "[ms]", "[%]",
                "[%]", "force [nN]", "force [nN]");
    for (const DeformationResult& r : results) {
        std::printf("%-16s %-6s %-15s %6.2f %9.2f", printable(r.material).c_str(),
                    r.surface.c_str(), nameOf(r.model), r.contactRatio, r.time * 1e3);
        if (r.compared) {
            std::printf(" %9.3g %9.3g", r.errorRms * 1e2, r.errorMax * 1e2);
        } else {
            std::printf(" %9s %9s", "-", "-");
        }
        std::printf(" %10.3f %10.3f %s\n", r.lawForce * 1e9, r.ownForce * 1e9,
                    r.halfSpace ? sentenceOf(*r.halfSpace).c_str() : "");
    }
}

namespace {

std::string title(const char* what) { return std::string("Asperity ") + kVersion + ": " + what; }

void writeTicks(const std::filesystem::path& path, const TradeOff& study) {
    const TradeOffReference& reference = study.reference;
    CsvWriter csv(
        path,
        {title("cost and error of each model option of the tick; times are of this machine"),
         "errors on the same inputs against " + nameOf(reference.tick),
         "estimates against the true force inside the simulated instrument"},
        {"tier", "tick_p50_s", "tick_p99_s", "force_error_rms_n", "force_error_max_n",
         "contact_radius_error_max_m", "closest_point_error_max_m", "estimate_error_rms_n",
         "on_front"});
    for (const auto* part : {&study.ticks, &study.decouplings}) {
        for (const TickResult& result : *part) {
            csv.add(nameOf(result.options)).add(result.median).add(result.p99);
            csv.add(result.forceErrorRms).add(result.forceErrorMax).add(result.contactRadiusError);
            csv.add(result.closestPointError).add(result.estimateErrorRms);
            csv.add(part == &study.ticks && result.onFront ? 1.0 : 0.0);
            csv.endRow();
        }
    }
    csv.close();
}

void writeFrames(const std::filesystem::path& path, const TradeOff& study) {
    CsvWriter csv(
        path,
        {title("cost and error of each deformation model; times are of this machine"),
         "displacements against " + nameOf(study.reference.frame)},
        {"tier", "patch_p50_s", "surface_error_rms_m", "surface_error_max_m", "on_front"});
    for (const FrameResult& result : study.frames) {
        csv.add(nameOf(result.options)).add(result.median).add(result.surfaceErrorRms);
        csv.add(result.surfaceErrorMax).add(result.onFront ? 1.0 : 0.0);
        csv.endRow();
    }
    csv.close();
}

void writeCompositions(const std::filesystem::path& path, const TradeOff& study) {
    CsvWriter csv(
        path,
        {title("Pareto-optimal configurations of the scene, the cheapest first; load "
               "of a core by ticks and 60 pictures a second, of this machine"),
         "error: of the force by tick and rate, or of the indentation by the picture, the "
         "larger share"},
        {"number", "tick", "rate_hz", "picture", "load", "error"});
    double number = 0.0;
    for (const Composition& whole : bestCompositions(study)) {
        csv.add(++number)
            .add(nameOf(study.ticks[whole.tick].options))
            .add(study.rates[whole.rate].rate);
        csv.add(nameOf(study.frames[whole.frame].options)).add(whole.load).add(whole.error);
        csv.endRow();
    }
    csv.close();
}

void writeRates(const std::filesystem::path& path, const TradeOff& study) {
    CsvWriter csv(
        path,
        {title("load of a core and error of the held force at each tick rate; the load is "
               "of this machine")},
        {"rate_hz", "load", "hold_error_rms_n"});
    for (const RateResult& result : study.rates) {
        csv.add(result.rate).add(result.load).add(result.holdErrorRms);
        csv.endRow();
    }
    csv.close();
}

/// Errors below the reference's own are drawn at it: nothing is known of them.
template <class Result>
Chart chartOf(const std::string& chartTitle, const std::vector<Result>& results, double floor) {
    Curve others{.label = "", .color = Color{160, 166, 178}, .points = true};
    Curve best{.label = "", .points = true};
    for (const Result& result : results) {
        Curve& curve = result.onFront ? best : others;
        curve.x.push_back(result.costAndError().cost);
        curve.y.push_back(std::max(result.costAndError().error, floor));
        if (result.onFront) {
            curve.pointLabels.push_back(nameOf(result.options));
        }
    }
    return {
        .title = chartTitle, .curves = {others, best}, .xUnit = "s", .logX = true, .logY = true};
}

Chart rateChart(const std::vector<RateResult>& rates) {
    Curve held{.label = "", .points = true};
    for (const RateResult& rate : rates) {
        held.x.push_back(rate.rate);
        held.y.push_back(rate.holdErrorRms);
        held.pointLabels.push_back("");
    }
    return {.title = "Rate: force held from tick to tick",
            .xLabel = "tick rate",
            .yLabel = "rms force error",
            .curves = {held},
            .xUnit = "Hz",
            .yUnit = "N",
            .logX = true,
            .logY = true};
}

/// Numbered as in compositions.csv.
Chart compositionChart(const TradeOff& study) {
    Curve best{.label = "", .points = true};
    for (const Composition& whole : bestCompositions(study)) {
        best.x.push_back(whole.load * 100.0);
        best.y.push_back(whole.error * 100.0);
        best.pointLabels.push_back(std::to_string(best.x.size()));
    }
    return {.title = "Tick, rate and picture together, as numbered in compositions.csv",
            .xLabel = "load of a core, per cent",
            .yLabel = "larger error, per cent",
            .curves = {best},
            .logX = true,
            .logY = true};
}

void drawFigure(const std::filesystem::path& path, const TradeOff& study) {
    constexpr double kNothing = 1e-5;  // of the force: below that errors look alike
    const TradeOffReference& reference = study.reference;
    Chart ticks = chartOf("Tick: force against time", study.ticks,
                          std::max(reference.forceDoubt, kNothing * reference.forceScale));
    ticks.xLabel = "median of a tick";
    ticks.yLabel = "rms force error";
    ticks.yUnit = "N";
    Chart frames = chartOf("Picture: surface against time", study.frames, reference.surfaceDoubt);
    frames.xLabel = "median of a patch";
    frames.yLabel = "rms surface error";
    frames.yUnit = "m";
    const std::array<Chart, 4> charts{ticks, frames, rateChart(study.rates),
                                      compositionChart(study)};
    writePng(path, layOut(charts, {.width = 1800.0, .height = 1300.0, .letters = 1.25}));
}

}  // namespace

FolderContent tradeOffFiles() {
    return {.marks = {"tradeoff.csv"},
            .own = {"frames.csv", "rates.csv", "compositions.csv", "tradeoff.png", "needs.csv",
                    "deformation.csv"},
            .guarded = {}};
}

void writeTradeOff(const std::filesystem::path& folder, const TradeOff& study) {
    writeTicks(folder / "tradeoff.csv", study);
    writeFrames(folder / "frames.csv", study);
    writeRates(folder / "rates.csv", study);
    writeCompositions(folder / "compositions.csv", study);
    drawFigure(folder / "tradeoff.png", study);
}

void writeNeeds(const std::filesystem::path& path, const RequiredTerms& needs) {
    CsvWriter csv(
        path,
        {title("what the scene requires of its model; times are of this machine"),
         "effect: what leaving the term out changes of the quantity that changes most, or "
         "of the surface, as a share"},
        {"term", "on", "overruled", "effect", "quantity", "time_s", "why"});
    for (const TermNeed& need : needs.terms) {
        csv.add(nameOf(need.term)).add(need.on ? 1.0 : 0.0).add(need.overruled ? 1.0 : 0.0);
        csv.add(need.effect);
        csv.add(isOfSurface(need.term) ? "displacement" : keyOf(need.quantity));
        csv.add(need.time).add(whyOf(need, needs));
        csv.endRow();
    }
    csv.close();
}

void writeDeformations(const std::filesystem::path& path,
                       const std::vector<DeformationResult>& results) {
    CsvWriter csv(
        path,
        {std::string("Asperity ") + kVersion +
             ": cost and error of each deformation on the paper's materials; times are "
             "of this machine",
         "errors over the patch, relative to the indentation, against the closed form of "
         "the exact sphere on a flat sample and a half-space of finer pixels on the scan; "
         "nan: no reference holds"},
        {"material", "surface", "deformation", "indentation_m", "contact_ratio", "patch_p50_s",
         "cold_patch_p50_s", "error_rms", "error_max", "law_force_n", "own_force_n", "remark"});
    for (const DeformationResult& result : results) {
        const double none = std::numeric_limits<double>::quiet_NaN();
        csv.add(result.material).add(result.surface).add(nameOf(result.model));
        csv.add(result.indentation).add(result.contactRatio).add(result.time).add(result.coldTime);
        csv.add(result.compared ? result.errorRms : none);
        csv.add(result.compared ? result.errorMax : none);
        csv.add(result.lawForce).add(result.ownForce);
        csv.add(result.halfSpace ? sentenceOf(*result.halfSpace) : "");
        csv.endRow();
    }
    csv.close();
}

}  // namespace asperity
