#pragma once

#include "core/scene/SceneFields.h"

#include <string_view>

namespace asperity::test {

/// Another text than the usual one that a field of a scan takes.
inline const char* textOf(const SceneField& field) {
    return std::string_view(field.key) == "smoothing_px" ? "2.5" : "2, 3, 20, 10";
}

}  // namespace asperity::test
