#pragma once

#include "app/experiment/ExperimentFolder.h"
#include "app/loading/SceneLoader.h"
#include "core/Progress.h"

#include <cstdint>
#include <vector>

namespace asperity {

/// The scenes of a study, each material with each lever.
class StudyScenes {
public:
    /// @throw as loadScene(); StudyRefused where the study contradicts one of them
    StudyScenes(const Study& study, Progress* progress);

    [[nodiscard]] const LoadedScene& of(std::size_t material, std::size_t lever) const {
        return scenes_.at(material * levers_ + lever);
    }

private:
    std::size_t levers_;
    std::vector<LoadedScene> scenes_;
};

/// How operators of the model do a study.
struct OperatorRun {
    int operators = 6;
    std::uint64_t seed = 1;
    bool record = false;  ///< every tick of each trial, as `asperity replay` takes it
};

/// Has all trials done that do not count yet, on all cores: the results do not depend on their
/// number. A trial that a fault ends is done again, five times at most.
/// @throw Canceled, Error; what was done is kept
void runOperators(const StudyScenes& scenes, const OperatorRun& run, ExperimentFolder& folder,
                  Progress* progress);

}  // namespace asperity
