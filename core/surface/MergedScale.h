#pragma once

#include "core/surface/GivenScale.h"

namespace asperity {

/// What is given later goes before what was given first.
[[nodiscard]] inline GivenScale merged(const GivenScale& first, const GivenScale& later) {
    const GivenScale& size = later.hasSize() ? later : first;
    const GivenScale& height = later.hasHeight() ? later : first;
    return {size.sizeX, size.sizeY, height.heightPerValue};
}

}  // namespace asperity
