#pragma once

#include "core/EnumTable.h"
#include "core/Error.h"
#include "core/haptics/bench/VirtualBench.h"
#include "core/haptics/coupling/CouplingDesign.h"
#include "core/probe/ProbeSystem.h"
#include "core/scene/SceneDescription.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace asperity {

struct Scene;

/// Task of a participant with the tip at a target. Source: Vogl, Ma, Sitti (2005), VI.
enum class TaskKind : std::uint8_t {
    Above,  ///< hold it a small distance above the surface
    On,     ///< right on the surface
    Below,  ///< press it a small distance into the surface
};

template <>
inline constexpr auto kEnumTable<TaskKind> =
    std::to_array<EnumRow<TaskKind>>({{TaskKind::Above, "A", "hold the tip above the surface"},
                                      {TaskKind::On, "B", "bring the tip onto the surface"},
                                      {TaskKind::Below, "C", "press the tip into the surface"}});

/// A task with the materials that it is done on.
struct StudyTask {
    TaskKind kind = TaskKind::On;
    /// Distance from the undeformed surface to the target, above or below it [m]; each trial draws
    /// from the range. Both are 0 on the surface.
    double nearest = 0.0;
    double farthest = 0.0;
    std::vector<std::size_t> materials;  ///< of Study::materials

    bool operator==(const StudyTask&) const = default;
};

/// A cantilever of a study.
struct StudyLever {
    std::string name;
    ProbeDescription probe;

    bool operator==(const StudyLever&) const = default;
};

/// Aids for a participant, each of which may be taken away.
struct StudyAids {
    bool coupling = true;     ///< between device and tip; false: by an operator model only
    bool forces = true;       ///< are felt
    bool deformation = true;  ///< is drawn
    FixtureKind guide = FixtureKind::None;  ///< through the target

    bool operator==(const StudyAids&) const = default;
};

/// A study of positioning: tasks at targets on several materials, each a few times by each
/// participant. What a study file says; units SI. Source: Vogl, Ma, Sitti (2005), VI;
/// docs/study.md.
struct Study {
    std::string name;
    SceneDescription scene;  ///< of every trial but for its material and lever
    std::vector<StudyTask> tasks;
    std::vector<SampleMaterial> materials;
    std::vector<StudyLever> levers;
    std::vector<Vector2> targets;  ///< on the sample, from the middle of the scan [m]
    double startHeight = 60e-9;    ///< of the tip above the surface when a trial begins [m]
    int repeats = 3;               ///< of each task on each material with each lever
    double training = 60.0;        ///< for which a participant tries the program first [s]
    double timeLimit = 60.0;       ///< after which a trial ends where it is [s]
    DeviceScale scale{.positionGain = 1e-6, .forceGain = 1e8};  ///< 1 mm : 1 nm, 1 N : 10 nN
    StudyAids aids;

    bool operator==(const Study&) const = default;
};

/// The scene of a trial. @throw Error as checkScene()
[[nodiscard]] SceneDescription sceneOf(const Study& study, std::size_t material, std::size_t lever);

/// A key of a study that contradicts the rest of it.
struct StudyRefused : Error {
    /// @param where key of the study, with the section before it
    StudyRefused(const std::string& where, const std::string& expected)
        : Error(where + ": " + expected), key(where), reason(expected) {}

    std::string key;
    std::string reason;
};

/// Checks a study without its sample: counts, ranges, tasks that name their materials.
/// @throw StudyRefused naming the first key that cannot be
void checkStudy(const Study& study);

/// Checks that the study can be done on a sample: its targets lie in the scan and in the device's
/// reach; what is pressed yields before the lever does; and each material with each lever can be
/// held by the device at the study's scale.
/// @param scene of a material and a lever
/// @throw StudyRefused
void checkStudyOn(
    const Study& study, const BenchSetup& bench,
    const std::function<const Scene&(std::size_t material, std::size_t lever)>& scene);

}  // namespace asperity
