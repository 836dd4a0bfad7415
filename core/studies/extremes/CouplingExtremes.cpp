#include "core/studies/extremes/CouplingExtremes.h"

#include "core/FormattedText.h"
#include "core/Units.h"
#include "core/scene/Scene.h"
#include "core/studies/extremes/BenchHold.h"
#include "core/studies/extremes/TickExtremes.h"
#include "core/surface/synthetic/SyntheticSurface.h"

#include <algorithm>

namespace asperity {

namespace {

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

std::vector<SampleMaterial> holdMaterials() {
    std::vector<SampleMaterial> materials;
    for (SampleMaterial& material : tickMaterials()) {
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
