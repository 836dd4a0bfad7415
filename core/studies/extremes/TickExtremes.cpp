#include "core/studies/extremes/TickExtremes.h"

#include "core/FormattedText.h"
#include "core/Units.h"
#include "core/contact/maugis/MaugisUnits.h"
#include "core/haptics/HapticTick.h"
#include "core/haptics/VirtualRun.h"
#include "core/scene/Scene.h"
#include "core/scene/SceneTruth.h"
#include "core/surface/synthetic/SyntheticSurface.h"

#include <algorithm>
#include <array>

namespace asperity {

namespace {

constexpr std::array kEfforts{SearchEffort::Certified, SearchEffort::Global, SearchEffort::Local};

/// A scan some tips wide, whose waves are as long as the tip is wide and shorter.
HeightMap roughMap(const RoughPlace& place) {
    constexpr int kPixels = 96;
    constexpr double kSize = 8.0;  // in tip radii
    const double size = kSize * place.tipRadius;
    const ScanSize scan{.columns = kPixels, .rows = kPixels, .sizeX = size, .sizeY = size};
    if (place.roughness == 0.0) {
        return flatMap(scan);
    }
    return selfAffineMap(scan, {.rms = place.roughness * place.tipRadius,
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

SceneDescription sceneOf(const RoughPlace& place, const TickSetting& setting) {
    SceneDescription scene = defaultScene();
    scene.sample.material = setting.material;
    scene.sample.smoothingPixels = 0.0;
    scene.sample.leveling = {};
    scene.truth.material = setting.material;
    scene.truth.stiffness = setting.leverStiffness;
    scene.probe.thickness = thicknessForStiffness(scene.probe, setting.leverStiffness);
    scene.tip.radius = place.tipRadius;
    return scene;
}

std::string describe(const RoughPlace& place, const TickSetting& setting, const char* effort,
                     std::size_t tick) {
    return formatted(
        "tick %zu (%s), tip radius %.17g m, roughness %.17g of it, %s, lever %.17g N/m, "
        "depth of the base %.17g tip radii",
        tick, effort, place.tipRadius, place.roughness, setting.material.name.c_str(),
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

/// What a state does not hold for. A jump that is announced takes nothing back of what is; that the
/// reference has no proof either is the reference's doubt.
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

class RoughPlaceStudy {
public:
    RoughPlaceStudy(const TickGrid& grid, const RoughPlace& place, const CancelCheck& check)
        : grid_(grid), place_(place), check_(check) {
        for (const SearchEffort effort : kEfforts) {
            findings_.regions.emplace_back(RegionPlace{.model = "tick",
                                                       .setting = keyOf(effort),
                                                       .sample = "rough",
                                                       .tipRadius = place.tipRadius,
                                                       .roughness = place.roughness});
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
                    return describe(place_, setting, keyOf(kEfforts[i]), tick);
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
    RoughPlace place_;
    const CancelCheck& check_;
    ExtremesFindings findings_;
};

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
             .hardness = 9.0_GPa}};
}

ExtremesFindings tickExtremes(const TickGrid& grid, const RoughPlace& place,
                              const CancelCheck& check) {
    RoughPlaceStudy study(grid, place, check);
    const HeightMap map = roughMap(place);
    for (const SampleMaterial& material : tickMaterials()) {
        for (const double stiffness : grid.leverStiffnesses) {
            for (const double depth : grid.depths) {
                const TickSetting setting{material, stiffness, depth};
                study.meet(buildScene(sceneOf(place, setting), map), setting);
            }
        }
    }
    return study.take();
}

}  // namespace asperity
