#pragma once

#include "core/ShareOut.h"
#include "core/haptics/bench/VirtualBench.h"
#include "core/studies/extremes/HoldOutcome.h"

#include <optional>

namespace asperity {

struct Scene;

inline constexpr double kStillWithin = 0.05e-3;  ///< [m] to and fro: less is not felt

/// The stretch of the handle's way that is looked at for rest, as long as a light arm takes to
/// swing once to and fro [s].
inline constexpr double kRestWindow = 0.2;

/// How long each hold may take to come to rest [s].
inline constexpr double kPatience = 2.0;

/// How a device is put on the bench.
struct BenchHold {
    DeviceScale scale;
    CouplingGains coupling;  ///< without stiffness: the device moves the base itself
    double delay = 0.0;      ///< [s]
    Grip grip = Grip::Light;
};

/// A device taps the tip on the middle of the scene's flat sample, then holds it pressed, just off
/// the surface, and pressed hard; with `Grip::None` it lets go when it has pressed hard. Each time
/// the handle is watched until it rests or kPatience has passed. On the virtual clock, with
/// the real tick and a simulated instrument: reproducible.
///
/// @return how far the handle goes to and fro over the last kRestWindow of any hold, along the axis
/// where that is most [m]; a creep one way is none; no value where a tick was not finite
/// @throw Canceled
[[nodiscard]] std::optional<double> swingOnBench(const Scene& scene, const BenchHold& hold,
                                                 const CancelCheck& check);

}  // namespace asperity
