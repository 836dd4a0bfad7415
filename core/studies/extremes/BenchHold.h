#pragma once

#include "core/EnumTable.h"
#include "core/ShareOut.h"
#include "core/haptics/bench/VirtualBench.h"
#include "core/haptics/coupling/CouplingKeeper.h"

#include <cstdint>
#include <optional>
#include <string>

namespace asperity {

struct Scene;

/// Grip on the handle once the tip has been tapped on the sample.
enum class Grip : std::uint8_t { None, Light, Normal };

template <>
inline constexpr auto kEnumTable<Grip> = std::to_array<EnumRow<Grip>>({{Grip::None, "none"},
                                                                       {Grip::Light, "light"},
                                                                       {Grip::Normal, "normal"}});

/// Verdict on a device that holds a tip on a sample, best first.
enum class HoldVerdict : std::uint8_t {
    Still,         ///< the handle comes to rest
    Noisy,         ///< at rest but for the detector's noise, which the force gain makes felt
    NoCoupling,    ///< refused: the device holds no coupling as stiff as is needed
    ScaleTooHigh,  ///< refused by the guard of the scale
    Oscillates,    ///< the handle does not come to rest, nor without the detector's noise
    NotFinite,     ///< a defect
};

template <>
inline constexpr auto kEnumTable<HoldVerdict> =
    std::to_array<EnumRow<HoldVerdict>>({{HoldVerdict::Still, "still"},
                                         {HoldVerdict::Noisy, "noisy"},
                                         {HoldVerdict::NoCoupling, "no coupling"},
                                         {HoldVerdict::ScaleTooHigh, "scale too high"},
                                         {HoldVerdict::Oscillates, "oscillates"},
                                         {HoldVerdict::NotFinite, "not finite"}});

/// One operator at one device on one sample.
struct HoldSetting {
    std::string material;
    double workOfAdhesion = 0.0;  ///< [J/m^2]
    double leverStiffness = 0.0;  ///< [N/m]
    double tickRate = 0.0;        ///< [Hz]
    double delay = 0.0;           ///< from a motion to its force, without the hold [s]
    DeviceScale scale;
    Grip grip = Grip::Light;
    bool coupled = false;  ///< with the gains of designCoupling(); else the device moves the base
};

struct HoldOutcome {
    HoldSetting setting;
    HoldVerdict verdict = HoldVerdict::Still;
    CoupledDevice device;  ///< what designCoupling() offers, and judgeScale() says of the scale
    double swing = 0.0;    ///< of the handle in the end, to and fro [m]; 0 where refused
};

inline constexpr double kStillWithin = 0.05e-3;  ///< [m] to and fro: less is not felt

/// The stretch of the handle's way that is looked at for rest, as long as a light arm takes to
/// swing once to and fro [s].
inline constexpr double kRestWindow = 0.2;

/// Time within which each hold must come to rest [s].
inline constexpr double kPatience = 2.0;

/// Setup of a device on the bench.
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
