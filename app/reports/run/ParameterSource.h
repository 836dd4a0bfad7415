#pragma once

#include "core/scene/SceneFields.h"

#include <string>

namespace asperity {

/// Where the values of a scene may come from, as far as a run knows: it keeps every value, not
/// where it was written.
class ParameterSources {
public:
    /// Reads the library that comes with the program. @throw InputError
    explicit ParameterSources(const SceneDescription& scene);

    /// For people: "library: silicon_14_n_m", "default", "scene".
    [[nodiscard]] std::string sourceOf(const SceneField& field) const;

private:
    const SceneDescription& scene_;
    SceneDescription defaults_;
    std::string material_;  ///< of the library, with all of the scene's values; empty: none
    std::string probe_;     ///< likewise
};

}  // namespace asperity
