#pragma once

#include "core/experiment/Operator.h"
#include "core/experiment/TrialPlaces.h"
#include "core/experiment/TrialRecord.h"
#include "core/haptics/VirtualRun.h"

#include <functional>

namespace asperity {

struct Scene;

/// What a trial is done with, beside its plan.
struct TrialSetup {
    const Study& study;
    const Scene& scene;  ///< sceneOf() the trial's material and lever
    OperatorTraits person;
    BenchSetup bench;
};

/// The knobs of a trial: as a device with motors gets them, or without a coupling as the study
/// has them. @throw CouplingRefused where none hold
[[nodiscard]] Settings trialSettings(const Study& study, const Scene& scene,
                                     const BenchSetup& bench, const Vector3& target);

/// What sees a trial as a recording does; either may be empty.
struct TrialWatch {
    std::function<void(const TickMemory&)> begin = {};  ///< what its first tick starts from
    TickSink tick = {};                                 ///< every tick
};

/// One trial by the operator model, on a virtual clock: the whole tick with bench, instrument and
/// governor. The same trial gives the same bits.
/// @throw CouplingRefused
[[nodiscard]] DoneTrial runTrial(const TrialSetup& setup, const PlannedTrial& trial,
                                 const TrialWatch& watch = {});

}  // namespace asperity
