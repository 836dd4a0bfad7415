#pragma once

#include "app/program/LoadedScene.h"

#include <string>
#include <vector>

namespace asperity {

/// What a run was made with.
struct RunConditions {
    SceneDescription scene;
    std::string sha256;  ///< of the scan's file; empty: a shape
};

[[nodiscard]] RunConditions conditionsOf(const LoadedScene& loaded);

/// In what the conditions of two runs differ that their forces may follow from, for people, one
/// piece of text each: "scan: a.gsf, channel Height; b.gsf, channel Height",
/// "tip radius_m: 15 nm; 20 nm". Empty: in nothing.
[[nodiscard]] std::vector<std::string> differencesOf(const RunConditions& first,
                                                     const RunConditions& second);

}  // namespace asperity
