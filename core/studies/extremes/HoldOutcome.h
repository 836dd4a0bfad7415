#pragma once

#include "core/EnumTable.h"
#include "core/haptics/coupling/CoupledDevice.h"

#include <cstdint>
#include <string>

namespace asperity {

/// How the handle is held once the tip has been tapped on the sample.
enum class Grip : std::uint8_t { None, Light, Normal };

template <>
inline constexpr auto kEnumTable<Grip> = std::to_array<EnumRow<Grip>>({{Grip::None, "none"},
                                                                       {Grip::Light, "light"},
                                                                       {Grip::Normal, "normal"}});

/// What becomes of a device that holds a tip on a sample, best first.
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

/// What became of it.
struct HoldOutcome {
    HoldSetting setting;
    HoldVerdict verdict = HoldVerdict::Still;
    CoupledDevice device;  ///< what designCoupling() offers, and judgeScale() says of the scale
    double swing = 0.0;    ///< of the handle in the end, to and fro [m]; 0 where refused
};

}  // namespace asperity
