#include "core/studies/extremes/TickExtremes.h"

#include "core/FormattedText.h"
#include "core/Units.h"
#include "core/contact/maugis/MaugisDugdale.h"
#include "core/haptics/HapticTick.h"
#include "core/haptics/VirtualRun.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Scene.h"
#include "core/studies/extremes/BenchHold.h"
#include "core/surface/synthetic/SyntheticSurface.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace asperity {

namespace {

constexpr std::array kEfforts{SearchEffort::Certified, SearchEffort::Global, SearchEffort::Local};

/// A scan some tips wide, whose waves are as long as the tip is wide and shorter.
HeightMap roughMap(const RoughSample& sample) {
    constexpr int kPixels = 96;
    constexpr double kSize = 8.0;  // in tip radii
    const double size = kSize * sample.tipRadius;
    const ScanSize scan{.columns = kPixels, .rows = kPixels, .sizeX = size, .sizeY = size};
    if (sample.roughness == 0.0) {
        return flatMap(scan);
    }
    return selfAffineMap(scan, {.rms = sample.roughness * sample.tipRadius,
                                .longestWave = 0.5 * size,
                                .rollOffWave = 0.25 * size,
                                .shortestWave = 0.05 * size});
}

/// One run of the tick, less the effort.
struct TickSetting {
    SampleMaterial material;
    double leverStiffness = 0.0;  ///< [N/m]
    double depth = 0.0;           ///< of the base below first touch, over the tip radius
};

/// What relaxes is in water, whose drag depends on the tip.
SampleMaterial materialUnder(double tipRadius, SampleMaterial material) {
    constexpr double kWater = 1e-3;   // viscosity [Pa s]
    constexpr double kOffset = 0.05;  // of the drag, in tip radii
    if (material.relaxingModulus > 0.0) {
        material.drag = 6.0 * std::numbers::pi * kWater * tipRadius * tipRadius;
        material.dragOffset = kOffset * tipRadius;
    }
    return material;
}

SceneDescription sceneOf(const RoughSample& sample, const TickSetting& setting) {
    SceneDescription scene = defaultScene();
    scene.sample.material = materialUnder(sample.tipRadius, setting.material);
    scene.sample.smoothingPixels = 0.0;
    scene.sample.leveling = {};
    scene.truth.material = scene.sample.material;
    scene.truth.stiffness = setting.leverStiffness;
    scene.probe.thickness = thicknessForStiffness(scene.probe, setting.leverStiffness);
    scene.tip.radius = sample.tipRadius;
    return scene;
}

std::string describe(const RoughSample& sample, const TickSetting& setting, const char* effort,
                     std::size_t tick) {
    return formatted(
        "tick %zu (%s), tip radius %.17g m, roughness %.17g of it, %s, lever %.17g N/m, "
        "depth of the base %.17g tip radii",
        tick, effort, sample.tipRadius, sample.roughness, setting.material.name.c_str(),
        setting.leverStiffness, setting.depth);
}

/// All ticks of one run along an approach, a slide and a retract.
std::vector<TickOutput> ticksOf(const Scene& scene, double depth, int ticks) {
    const double radius = scene.belief.tipRadius();
    const PathPlan plan{.duration = (ticks - 1) * scene.timeStep(),
                        .clearance = 0.2 * radius,
                        .indentation = depth * radius,
                        .slideLength = 2.0 * radius};
    SimulatedAfm afm(scene.trueSurface(), truthOf(scene));
    std::vector<TickOutput> outputs;
    runVirtually(scene, slidePath(scene, plan), afm, ticks,
                 [&](const TickSample& sample) { outputs.push_back(sample.output); });
    return outputs;
}

/// Returns what a state does not hold for. A jump that is announced takes nothing back of what is;
/// that the reference has no proof either is the reference's doubt.
ValidityFlags doubts(ValidityFlags flags, bool referenceHolds) {
    ValidityFlags left;
    for (const ValidityTraits& one : kValidityTraits) {
        const bool counts = one.severity != Severity::Notice &&
                            (referenceHolds || one.flag != Validity::SearchNotExhaustive);
        left.set(one.flag, counts && flags.has(one.flag));
    }
    return left;
}

/// Why the operator feels nothing; null where it feels a force.
const char* refusalOf(const TickOutput& output) {
    if (output.model.locked) {
        return "tick: friction would drag the tip deeper faster than the lever lifts it; no "
               "equilibrium exists and force output is zero";
    }
    if (!output.model.converged && output.flags.has(Validity::OutsideScan)) {
        return "tick: the lever bends so far that the tip leaves the scan, and what lies there is "
               "not known";
    }
    if (!output.model.converged) {
        return "tick: tip equilibrium did not converge (alternates between contact points, or "
               "leaves the scan); force output is zero";
    }
    return nullptr;
}

class RoughSampleStudy {
public:
    RoughSampleStudy(const TickGrid& grid, const RoughSample& sample, const CancelCheck& check)
        : grid_(grid), sample_(sample), check_(check) {
        for (const SearchEffort effort : kEfforts) {
            findings_.regions.emplace_back(RegionKey{.model = "tick",
                                                     .setting = keyOf(effort),
                                                     .sample = "rough",
                                                     .tipRadius = sample.tipRadius,
                                                     .roughness = sample.roughness});
        }
    }

    void meet(const Scene& built, const TickSetting& setting) {
        const double pull = maugisUnits(built.belief.contact.pair()).force;
        std::vector<TickOutput> reference;
        Scene scene = built;
        findings_.states += grid_.ticks;
        for (std::size_t i = 0; i < kEfforts.size(); ++i) {
            check_();
            scene.model.closestPointSearch = kEfforts[i];
            const std::vector<TickOutput> outputs = ticksOf(scene, setting.depth, grid_.ticks);
            if (i == 0) {
                reference = outputs;
            }
            for (std::size_t tick = 0; tick < outputs.size(); ++tick) {
                const auto sayWhere = [&] {
                    return describe(sample_, setting, keyOf(kEfforts[i]), tick);
                };
                judge(findings_.regions[i], outputs[tick], reference[tick], pull, sayWhere);
            }
        }
    }

    [[nodiscard]] ExtremesFindings take() { return std::move(findings_); }

private:
    template <class Describe>
    void judge(ExtremesRegion& region, const TickOutput& output, const TickOutput& reference,
               double unit, const Describe& sayWhere) {
        if (output.fault == Fault::NotFinite) {
            findings_.addDefect(sayWhere() + ": a value is not finite");
            return;
        }
        if (const char* refusal = refusalOf(output)) {
            region.refuse(refusal);
            return;
        }
        const bool referenceHolds = !reference.flags.has(Validity::SearchNotExhaustive);
        const double radius = output.model.contact.contactRadius;
        const double force = (output.model.force - reference.model.force).norm();
        const double size =
            std::max({output.model.force.norm(), reference.model.force.norm(), unit});
        region.add({.flags = doubts(output.flags, referenceHolds),
                    .referenceHolds = referenceHolds && refusalOf(reference) == nullptr,
                    .errors = {.force = size > 0.0 ? force / size : 0.0,
                               .contactRadius = relativeError(
                                   radius, reference.model.contact.contactRadius, 0.0)}},
                   sayWhere);
    }

    const TickGrid& grid_;
    RoughSample sample_;
    const CancelCheck& check_;
    ExtremesFindings findings_;
};

/// As docs/haptics.md has it.
constexpr DeviceSpecification kDevice{.maxForce = kPhantomClass.maxForce,
                                      .maxStiffness = kPhantomClass.maxStiffness,
                                      .maxDamping = kPhantomClass.maxDamping,
                                      .effectiveMass = kPhantomClass.mass};

constexpr double kDetectorNoise = 1e-7;  // of a signal [rad]

Scene sceneOf(const HoldBench& bench, double signalNoise) {
    constexpr int kPixels = 32;
    constexpr double kSize = 4e-6;  // wider than the softest lever takes the tip sideways
    SceneDescription scene = defaultScene();
    scene.sample.material = bench.material;
    scene.sample.smoothingPixels = 0.0;
    scene.sample.leveling = {};
    scene.truth.material = bench.material;
    scene.truth.signalNoise = signalNoise;
    scene.truth.stiffness = bench.leverStiffness;
    scene.probe.thickness = thicknessForStiffness(scene.probe, bench.leverStiffness);
    scene.tickRate = bench.tickRate;
    scene.choices.law = ContactLaw::Split;
    return buildScene(
        scene, flatMap({.columns = kPixels, .rows = kPixels, .sizeX = kSize, .sizeY = kSize}));
}

std::string describe(const HoldSetting& hold) {
    return formatted("hold on %s (%.17g J/m^2), lever %.17g N/m, %.17g Hz, delay %.17g s, position "
                     "gain %.17g, force gain %.17g, grip %s, %s",
                     hold.material.c_str(), hold.workOfAdhesion, hold.leverStiffness, hold.tickRate,
                     hold.delay, hold.scale.positionGain, hold.scale.forceGain, nameOf(hold.grip),
                     hold.coupled ? "coupled" : "not coupled");
}

class BenchStudy {
public:
    BenchStudy(const HoldBench& bench, const CancelCheck& check)
        : bench_(bench)
        , check_(check)
        , scene_(sceneOf(bench, kDetectorNoise))
        , quiet_(sceneOf(bench, 0.0)) {}

    void meet(HoldSetting hold) {
        hold.material = bench_.material.name;
        hold.workOfAdhesion = bench_.material.workOfAdhesion;
        hold.leverStiffness = bench_.leverStiffness;
        hold.tickRate = bench_.tickRate;
        for (const bool coupled : {true, false}) {
            hold.coupled = coupled;
            ++findings_.states;
            findings_.holds.push_back(coupled ? held(hold) : free(hold));
        }
    }

    [[nodiscard]] ExtremesFindings take() { return std::move(findings_); }

private:
    HoldOutcome held(const HoldSetting& hold) {
        HoldOutcome outcome{
            .setting = hold,
            .device = coupleDevice(scene_.belief,
                                   {.device = kDevice,
                                    .timing = {.timeStep = scene_.timeStep(), .delay = hold.delay},
                                    .scale = hold.scale,
                                    .own = {},
                                    .maxForce = kDevice.maxForce})};
        if (outcome.device.holds()) {
            return tried(outcome);
        }
        outcome.verdict =
            outcome.device.noCoupling.empty() ? HoldVerdict::ScaleTooHigh : HoldVerdict::NoCoupling;
        return outcome;
    }

    HoldOutcome free(const HoldSetting& hold) {
        const TipLoad tip = tipLoad(scene_.belief, kDevice.maxForce / hold.scale.forceGain);
        const ScaleBounds bounds{.stiffness = kDevice.maxStiffness,
                                 .force = kDevice.maxForce,
                                 .timeStep = scene_.timeStep()};
        HoldOutcome outcome{.setting = hold, .device = {}};
        outcome.device.judgment = judgeScale(tip, hold.scale, std::nullopt, bounds);
        return tried(outcome);
    }

    HoldOutcome tried(HoldOutcome outcome) {
        const HoldSetting& setting = outcome.setting;
        const BenchHold hold{.scale = setting.scale,
                             .coupling = outcome.device.gains,
                             .delay = setting.delay,
                             .grip = setting.grip};
        std::optional<double> swing = swingOnBench(scene_, hold, check_);
        outcome.swing = swing.value_or(0.0);
        if (outcome.swing >= kStillWithin) {
            swing = swingOnBench(quiet_, hold, check_);
            outcome.verdict =
                swing.value_or(0.0) >= kStillWithin ? HoldVerdict::Oscillates : HoldVerdict::Noisy;
        }
        if (!swing) {
            outcome.verdict = HoldVerdict::NotFinite;
            findings_.addDefect(describe(setting) + ": a value is not finite");
        }
        return outcome;
    }

    HoldBench bench_;
    const CancelCheck& check_;
    Scene scene_;
    Scene quiet_;  ///< the same with a detector without noise
    ExtremesFindings findings_;
};

/// The settings of one bench.
std::vector<HoldSetting> settingsOf(const CouplingGrid& grid) {
    std::vector<HoldSetting> settings;
    for (const double delay : grid.delays) {
        for (const double positionGain : grid.positionGains) {
            for (const double forceGain : grid.forceGains) {
                for (const Grip grip : kValues<Grip>) {
                    settings.push_back(
                        {.delay = delay, .scale = {positionGain, forceGain}, .grip = grip});
                }
            }
        }
    }
    return settings;
}

}  // namespace

std::vector<SampleMaterial> tickMaterials() {
    return {{.name = "silicone rubber",
             .elastic = {.youngsModulus = 1.0_MPa, .poissonRatio = 0.5},
             .workOfAdhesion = 0.022},
            {.name = "polystyrene",
             .elastic = {.youngsModulus = 2.0_GPa, .poissonRatio = 0.4},
             .workOfAdhesion = 0.066,
             .hardness = 0.3_GPa},
            {.name = "silicon oxide",
             .elastic = {.youngsModulus = 70.0_GPa, .poissonRatio = 0.27},
             .workOfAdhesion = 0.2,
             .hardness = 9.0_GPa},
            {.name = "silicone rubber, two works of adhesion",
             .elastic = {.youngsModulus = 1.0_MPa, .poissonRatio = 0.5},
             .workOfAdhesion = 0.022,
             .retractWork = 0.066},
            {.name = "gel in water",
             .elastic = {.youngsModulus = 10e3, .poissonRatio = 0.5},
             .workOfAdhesion = 0.0,
             .relaxingModulus = 20e3,
             .relaxationTime = 0.05}};
}

ExtremesFindings tickExtremes(const TickGrid& grid, const RoughSample& sample,
                              const CancelCheck& check) {
    RoughSampleStudy study(grid, sample, check);
    const HeightMap map = roughMap(sample);
    for (const SampleMaterial& material : tickMaterials()) {
        for (const double stiffness : grid.leverStiffnesses) {
            for (const double depth : grid.depths) {
                const TickSetting setting{material, stiffness, depth};
                study.meet(buildScene(sceneOf(sample, setting), map), setting);
            }
        }
    }
    return study.take();
}

std::vector<SampleMaterial> holdMaterials() {
    std::vector<SampleMaterial> materials;
    for (SampleMaterial& material : tickMaterials()) {
        if (material.hasTwoWorks() || material.dependsOnTime()) {
            continue;  // no stiffer than the others
        }
        materials.push_back(material);
        material.workOfAdhesion = 0.0;
        materials.push_back(material);
    }
    return materials;
}

std::vector<HoldBench> benchesOf(const CouplingGrid& grid) {
    std::vector<HoldBench> benches;
    const auto each = static_cast<long>(settingsOf(grid).size());
    for (const SampleMaterial& material : holdMaterials()) {
        for (const double lever : grid.leverStiffnesses) {
            for (const double rate : grid.tickRates) {
                const auto before = static_cast<long>(benches.size());
                benches.push_back({material, lever, rate, before * each});
            }
        }
    }
    std::stable_sort(
        benches.begin(), benches.end(),
        [](const HoldBench& one, const HoldBench& other) { return one.tickRate > other.tickRate; });
    return benches;
}

ExtremesFindings couplingExtremes(const CouplingGrid& grid, const HoldBench& bench,
                                  const CancelCheck& check) {
    BenchStudy study(bench, check);
    long index = bench.first;
    for (const HoldSetting& setting : settingsOf(grid)) {
        if (index++ % grid.stride == 0) {
            study.meet(setting);
        }
    }
    return study.take();
}

}  // namespace asperity
