#include "app/reports/TradeOffReport.h"

#include "core/FormattedText.h"
#include "core/PrintableText.h"
#include "core/studies/Composition.h"
#include "core/words/ModelWords.h"

#include <array>
#include <cstdio>
#include <string>

namespace asperity {

namespace {

/// What is unsure of the reference's forces: "without film's base 0.12 nN, adhesion 3 nN".
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

void printNeeds(const SceneNeeds& needs) {
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

}  // namespace asperity
