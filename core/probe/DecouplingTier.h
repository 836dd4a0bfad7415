#pragma once

#include <cstdint>

namespace asperity {

/// How the signals become a force.
enum class DecouplingTier : std::uint8_t {
    Planar,    ///< nothing assumed but that the force lies in the plane of normal and motion
    Estimator  ///< weighted least squares of all that is known
};

}  // namespace asperity
