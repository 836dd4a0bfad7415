#include "core/experiment/Study.h"

#include "core/FormattedText.h"
#include "core/contact/Within.h"
#include "core/haptics/coupling/CouplingKeeper.h"
#include "core/scene/Scene.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace asperity {

namespace {

constexpr double kLongestTrial = 3600.0;  // [s]
constexpr double kFarthest = 1e-6;        // of a target, from the surface or from the middle [m]
constexpr int kMaxRepeats = 100;

/// A lever that bends by more than this for each way into the sample presses nothing in.
constexpr double kMaxBend = 10.0;

void require(bool holds, const std::string& key, const std::string& expected) {
    if (!holds) {
        throw StudyRefused(key, expected);
    }
}

std::string keyOfTask(std::size_t task) { return "task " + std::to_string(task + 1); }

void checkTask(const Study& study, std::size_t index) {
    const StudyTask& task = study.tasks[index];
    const std::string name = keyOfTask(index);
    require(!task.materials.empty(), name + ": materials", "at least one material");
    for (const std::size_t material : task.materials) {
        require(material < study.materials.size(), name + ": materials", "materials of the study");
    }
    const bool isOn = task.kind == TaskKind::On;
    require(isWithin(task.nearest, 0.0, kFarthest) && (task.nearest > 0.0) != isOn,
            name + ": nearest_m",
            isOn ? "none: task B is on the surface" : "a distance above 0 and up to 1e-6 m");
    require(isWithin(task.farthest, task.nearest, kFarthest), name + ": farthest_m",
            "at least nearest_m, up to 1e-6 m");
}

/// Force that presses the tip so deep into a material, without adhesion [N].
/// Source: Hertz (1882); docs/theory.md 2.1.
double forceForDepth(const ContactPair& pair, double depth) {
    return 4.0 / 3.0 * pair.reducedModulus * std::sqrt(pair.tipRadius * depth) * depth;
}

/// A material under a lever.
struct Sample {
    std::size_t material;
    std::size_t lever;
    const Scene& scene;
};

void checkPressing(const Study& study, const Sample& sample) {
    const SceneDescription& scene = sample.scene.description;
    const ContactPair pair = contactPair(scene, scene.sample.material);
    for (std::size_t i = 0; i < study.tasks.size(); ++i) {
        const StudyTask& task = study.tasks[i];
        if (task.kind != TaskKind::Below || !std::ranges::count(task.materials, sample.material)) {
            continue;
        }
        const double bend =
            forceForDepth(pair, task.farthest) / Cantilever(scene.probe).stiffness();
        require(bend <= kMaxBend * task.farthest, keyOfTask(i) + ": materials",
                formatted("no %s: to press the tip %.3g nm deep the lever %s would bend by %.3g nm",
                          scene.sample.material.name.c_str(), 1e9 * task.farthest,
                          study.levers[sample.lever].name.c_str(), 1e9 * bend));
    }
}

void checkTargets(const Study& study, const Scene& scene, const BenchSetup& bench) {
    const double x = scene.surface.sizeX();
    const double y = scene.surface.sizeY();
    const double reach = 0.9 * bench.handle.workspaceRadius * study.scale.positionGain;
    for (std::size_t i = 0; i < study.targets.size(); ++i) {
        const Vector2& target = study.targets[i];
        const std::string key = "targets_m: target " + std::to_string(i + 1);
        require(std::abs(target.x()) < 0.5 * x && std::abs(target.y()) < 0.5 * y, key,
                formatted("a point in the scan, which is %.4g x %.4g nm", 1e9 * x, 1e9 * y));
        const double way = std::hypot(target.norm(), study.startHeight);
        require(
            way <= reach, key,
            formatted("a point within the device's reach: %.3g nm from where a trial begins, of "
                      "%.3g nm at this position_gain",
                      1e9 * way, 1e9 * reach));
    }
}

/// The scale at which the device holds a tip; none where it holds it at none.
std::optional<DeviceScale> heldScale(const Scene& scene, const BenchSetup& bench) {
    CouplingKeeper keeper(scene);
    const DeviceSpecification device = VirtualBench(bench, Vector3::Zero()).specification();
    try {
        const Settings held = keeper.takeOver(device, bench.delay, scene.settings);
        return DeviceScale{.positionGain = held.positionGain, .forceGain = held.forceGain};
    } catch (const CouplingRefused&) {
        return std::nullopt;
    }
}

void checkHolding(const Study& study, const Scene& scene, const BenchSetup& bench) {
    const std::optional<DeviceScale> held = heldScale(scene, bench);
    const char* const material = scene.description.sample.material.name.c_str();
    require(held.has_value(), "scale: position_gain",
            formatted("a scale at which the device holds the tip on %s", material));
    require(
        *held == study.scale, "scale: force_gain",
        formatted("at most %.3g with position_gain %.3g, so that the device holds the tip on %s",
                  held->forceGain, held->positionGain, material));
}

}  // namespace

SceneDescription sceneOf(const Study& study, std::size_t material, std::size_t lever) {
    SceneDescription scene = withMaterial(study.scene, study.materials.at(material));
    const bool isTrueLever = scene.truth.stiffness == Cantilever(scene.probe).stiffness();
    scene.probe = study.levers.at(lever).probe.lever;
    scene.detector = study.levers.at(lever).probe.detector;
    if (isTrueLever) {
        scene.truth.stiffness = Cantilever(scene.probe).stiffness();
    }
    scene.settings.positionGain = study.scale.positionGain;
    scene.settings.forceGain = study.scale.forceGain;
    scene.settings.forcesOn = study.aids.forces;
    checkScene(scene);
    return scene;
}

void checkStudy(const Study& study) {
    require(!study.materials.empty(), "material", "at least one [[material]]");
    require(!study.levers.empty(), "lever", "at least one [[lever]]");
    require(!study.tasks.empty(), "task", "at least one [[task]]");
    require(!study.targets.empty(), "targets_m", "at least one target");
    require(study.repeats >= 1 && study.repeats <= kMaxRepeats, "repeats", "1 to 100");
    require(isWithin(study.timeLimit, 1.0, kLongestTrial), "time_limit_s", "1 to 3600 s");
    require(isWithin(study.training, 0.0, kLongestTrial), "training_s", "0 to 3600 s");
    require(isWithin(study.startHeight, 1e-9, kFarthest), "start_height_m", "1e-9 to 1e-6 m");
    for (std::size_t i = 0; i < study.tasks.size(); ++i) {
        checkTask(study, i);
    }
}

void checkStudyOn(
    const Study& study, const BenchSetup& bench,
    const std::function<const Scene&(std::size_t material, std::size_t lever)>& scene) {
    checkTargets(study, scene(0, 0), bench);
    for (std::size_t material = 0; material < study.materials.size(); ++material) {
        for (std::size_t lever = 0; lever < study.levers.size(); ++lever) {
            const Scene& sample = scene(material, lever);
            checkPressing(study, {material, lever, sample});
            if (study.aids.coupling) {
                checkHolding(study, sample, bench);
            }
        }
    }
}

}  // namespace asperity
