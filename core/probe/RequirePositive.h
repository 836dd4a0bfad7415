#pragma once

#include "core/Error.h"

#include <cmath>
#include <string>

namespace asperity {

/// @throw Error saying that `what` must be finite and positive
inline void requirePositive(double value, const char* what) {
    if (!(std::isfinite(value) && value > 0.0)) {
        throw Error(std::string(what) + " must be finite and positive");
    }
}

}  // namespace asperity
