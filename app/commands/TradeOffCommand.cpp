#include "app/commands/TradeOffCommand.h"

#include "app/commands/OptionChecks.h"
#include "app/commands/ProgressLine.h"
#include "app/commands/VirtualDisplay.h"
#include "app/program/DataFolder.h"
#include "app/program/LoadedScene.h"
#include "app/reports/OutputFolder.h"
#include "app/reports/TradeOffFiles.h"
#include "core/PrintableText.h"
#include "core/fidelity/ForceErrorText.h"
#include "core/studies/Composition.h"
#include "core/studies/DeformationStudy.h"
#include "core/studies/TradeOffStudy.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

namespace asperity {

namespace {

struct TradeOffOptions {
    std::string scene;
    std::string out;
    bool force = false;
};

void printDeformations(const std::vector<DeformationResult>& results) {
    std::printf("\n%-16s %-6s %-15s %6s %9s %9s %9s %10s %10s\n", "material", "on", "deformation",
                "a/R", "patch", "rms err.", "max err.", "law", "own");
    std::printf("%-16s %-6s %-15s %6s %9s %9s %9s %10s %10s\n", "", "", "", "", "[ms]", "[%]",
                "[%]", "force [nN]", "force [nN]");
    for (const DeformationResult& r : results) {
        std::printf("%-16s %-6s %-15s %6.2f %9.2f", printable(r.material).c_str(),
                    r.surface.c_str(), nameOf(r.tier), r.contactRatio, r.time * 1e3);
        if (r.compared) {
            std::printf(" %9.3g %9.3g", r.errorRms * 1e2, r.errorMax * 1e2);
        } else {
            std::printf(" %9s %9s", "-", "-");
        }
        std::printf(" %10.3f %10.3f %s\n", r.lawForce * 1e9, r.ownForce * 1e9, r.remark.c_str());
    }
}

void printTick(const TickResult& r, char mark) {
    std::printf("%c %-76s %8.2f %8.2f %10.3g %10.3g %9.3g %10.3g\n", mark, r.tier.name().c_str(),
                r.median * 1e6, r.p99 * 1e6, r.forceErrorRms * 1e9, r.contactRadiusError * 1e9,
                r.footError * 1e9, r.estimateErrorRms * 1e9);
}

void printTicks(const TradeOff& study, double tolerance) {
    const TradeOffReference& reference = study.reference;
    std::printf("%-78s %8s %8s %10s %10s %9s %10s\n", "tick", "p50", "p99", "force err.",
                "radius err.", "foot err.", "estimate");
    std::printf("%-78s %8s %8s %10s %10s %9s %10s\n", "", "[us]", "[us]", "rms [nN]", "max [nm]",
                "max [nm]", "rms [nN]");
    for (const TickResult& r : study.ticks) {
        printTick(r, r.onFront ? '*' : ' ');
    }
    std::printf("signals to force, with the scene's own model\n");
    for (const TickResult& r : study.decouplings) {
        printTick(r, ' ');
    }
    std::printf(
        "* no other is cheaper and as near to the reference: %s, %.2f us, force %.3g nN rms\n",
        reference.tick.name().c_str(), reference.tickMedian * 1e6, reference.forceScale * 1e9);
    std::printf("  the reference itself: %.2g nN (%s)\n", reference.forceDoubt * 1e9,
                reference.forceDoubtBy.empty() ? "it leaves nothing out"
                                               : reference.forceDoubtBy.c_str());
    std::printf("  errors below that, and times within %.2g %%, count as the same\n",
                study.timeResolution * 100.0);
    const std::size_t best = cheapestWithin(costsAndErrors(study.ticks),
                                            tolerance * reference.forceScale, study.ofTicks());
    std::printf("  cheapest within %.2g %% of the force: %s\n\n", tolerance * 100.0,
                best < study.ticks.size() ? study.ticks[best].tier.name().c_str() : "none");
}

void printFrames(const TradeOff& study) {
    std::printf("%-57s %8s %11s %11s\n", "picture", "patch", "surface err.", "");
    std::printf("%-57s %8s %11s %11s\n", "", "[ms]", "rms [nm]", "max [nm]");
    for (const FrameResult& r : study.frames) {
        std::printf("%c %-55s %8.2f %11.3g %11.3g\n", r.onFront ? '*' : ' ', r.tier.name().c_str(),
                    r.median * 1e3, r.surfaceErrorRms * 1e9, r.surfaceErrorMax * 1e9);
    }
    const TradeOffReference& reference = study.reference;
    std::printf("  reference, at %d of %d contacts: %s; itself: %.2g nm (%s)\n", reference.contacts,
                reference.contactsAsked, reference.frame.name().c_str(),
                reference.surfaceDoubt * 1e9, reference.surfaceDoubtBy.c_str());
    if (reference.frame.deformation == DeformationTier::HalfSpace) {
        std::printf("  there the law's normal force is %.2g nN rms off the half-space's own\n",
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
                study.rates[whole.rate].rate, study.ticks[whole.tick].tier.name().c_str(),
                study.frames[whole.frame].tier.name().c_str());
}

void printCompositions(const TradeOff& study, double tolerance) {
    std::printf("whole ways, none cheaper and as near: load of a core (ticks and 60 pictures a "
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
        std::printf("   (the reference itself is not known so well)\n");
    }
    std::printf("\n");
}

void printNeeds(const SceneNeeds& needs) {
    std::printf(
        "what the scene requires, within %.3g %%: what is left out automatically moves forces "
        "by %.2g %%, a tick takes %.2f us instead of %.2f us; %s\n",
        needs.tolerance * 100.0, needs.forceError * 100.0, needs.modelTick * 1e6,
        needs.fullTick * 1e6, forceErrorText(needs).c_str());
    for (const TermNeed& need : needs.terms) {
        const char* unit = isOfSurface(need.term) ? "ms a patch" : "us a tick";
        const double time = need.time * (isOfSurface(need.term) ? 1e3 : 1e6);
        std::printf("  %-21s %-4s %8.3g %%  %+7.2f %-10s  %s%s\n", nameOf(need.term),
                    need.on ? "on" : "off", need.effect * 100.0, time, unit, need.why.c_str(),
                    need.overruled ? " (as the scene says)" : "");
    }
    std::printf("\n");
}

void tradeOff(const TradeOffOptions& options) {
    const VirtualDisplay display;  // before anything is written: the figure needs it at the end
    const std::filesystem::path scene =
        options.scene.empty() ? defaultSceneFile() : std::filesystem::path(options.scene);
    LoadedScene loaded = loadSceneOnTerminal(scene, {});
    OutputFolder out(options.out, {.own = tradeOffFileNames(), .guarded = {}}, options.force);
    ProgressLine line("measuring");
    ProgressPart running(&line, 0.0, 0.7);
    const TradeOff study = studyTradeOff(loaded.scene, {}, &running);
    ProgressPart deforming(&line, 0.7, 1.0);
    const std::vector<DeformationResult> deformations =
        studyDeformation(loaded.scene, {}, &deforming);
    out.collect([&](const std::filesystem::path& folder) {
        writeTradeOff(folder, study);
        writeNeeds(folder / "needs.csv", loaded.needs);
        writeDeformations(folder / "deformation.csv", deformations);
    });
    out.commit();
    printTicks(study, loaded.needs.tolerance);
    printFrames(study);
    printRates(study);
    printCompositions(study, loaded.needs.tolerance);
    printNeeds(loaded.needs);
    printDeformations(deformations);
}

}  // namespace

void addTradeOffCommand(CLI::App& program) {
    CLI::App* command =
        program.add_subcommand("tradeoff", "Measured cost and error of every fidelity tier");
    const auto options = std::make_shared<TradeOffOptions>();
    command->add_option("SCENE", options->scene,
                        "scene.toml or height map (default: the default scene)");
    addOutputFolder(*command, options->out, "folder for the table and the figure");
    addForce(*command, options->force);
    command->callback([options] { tradeOff(*options); });
}

}  // namespace asperity
