#pragma once

#include "core/Error.h"
#include "core/experiment/Study.h"
#include "core/haptics/bench/VirtualBench.h"

#include <functional>
#include <string>

namespace asperity {

struct Scene;

/// A key of a study that contradicts the rest of it.
struct StudyRefused : Error {
    /// @param where key of the study, with the section before it
    StudyRefused(const std::string& where, const std::string& expected)
        : Error(where + ": " + expected), key(where), reason(expected) {}

    std::string key;
    std::string reason;
};

/// What a study says by itself: counts, ranges, tasks that name their materials.
/// @throw StudyRefused naming the first key that cannot be
void checkStudy(const Study& study);

/// Whether the study can be done on a sample: its targets lie in the scan and in the device's
/// reach; what is pressed yields before the lever does; and each material with each lever can be
/// held by the device at the study's scale.
/// @param scene of a material and a lever
/// @throw StudyRefused
void checkStudyOn(
    const Study& study, const BenchSetup& bench,
    const std::function<const Scene&(std::size_t material, std::size_t lever)>& scene);

}  // namespace asperity
