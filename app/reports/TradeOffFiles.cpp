#include "app/reports/TradeOffFiles.h"

#include "core/Version.h"
#include "core/io/tables/CsvWriter.h"
#include "core/studies/Composition.h"
#include "core/words/ModelWords.h"
#include "vtkplugins/pictures/Charts.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

namespace asperity {

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
         "contact_radius_error_max_m", "foot_error_max_m", "estimate_error_rms_n", "on_front"});
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
    constexpr int kColumns = 2;
    writeCharts(path, charts, kColumns, {.width = 1800, .height = 1300});
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

void writeNeeds(const std::filesystem::path& path, const SceneNeeds& needs) {
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
