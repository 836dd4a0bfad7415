#pragma once

#include "core/EnumTable.h"

#include <cstddef>
#include <cstdint>
#include <numbers>

namespace asperity {

/// Input of model and calibration that leaves a result uncertain; see docs/uncertainty.md.
enum class UncertaintyInput : std::uint8_t {
    Stiffness,           ///< of the lever
    InvOls,              ///< deflection per volt
    TipRadius,           ///< of the tip
    ImagingTip,          ///< radius of the tip that recorded the scan, where it is known
    Modulus,             ///< Young's modulus of the sample
    WorkOfAdhesion,      ///< of tip and sample
    CohesiveRange,       ///< h0 of the Maugis-Dugdale laws
    HeightCalibration,   ///< of the scanner along z
    LateralCalibration,  ///< of the scanner along x and y
    HeightNoise,         ///< white noise of the scan's heights
    SurfaceNormal,       ///< beyond what heights and calibration say
    Smoothing,           ///< what the low-pass took from slopes and curvatures
    Pixels,              ///< what the area of a pixel took from them
};

/// Standard deviations of the inputs of a scene, those of a share being relative.
struct Uncertainty {
    bool enabled = true;               ///< false: results carry the detector's noise alone
    double stiffness = 0.10;           ///< relative
    double invOls = 0.03;              ///< relative
    double tipRadius = 0.10;           ///< relative
    double imagingTip = 0.10;          ///< relative
    double modulus = 0.10;             ///< relative
    double workOfAdhesion = 0.10;      ///< relative
    double cohesiveRange = 0.10;       ///< relative
    double heightCalibration = 0.03;   ///< relative
    double lateralCalibration = 0.01;  ///< relative
    double heightNoise = 0.0;          ///< [m]; 0: estimated from the scan
    double surfaceNormal = 0.02;       ///< about each axis across it [rad]
    /// The stiffness comes from a thermal spectrum that was read with the same InvOLS: it goes as
    /// 1 / InvOLS^2, and forces as 1 / InvOLS.
    bool thermalStiffness = false;

    /// Standard deviation of the surface normal as the force estimate takes it [rad]; 0: exact.
    [[nodiscard]] double normalDeviation() const noexcept { return enabled ? surfaceNormal : 0.0; }

    bool operator==(const Uncertainty&) const = default;
};

/// Names, unit and limits of an input.
struct UncertaintyRow {
    UncertaintyInput value;
    const char* key;   ///< in scenes, "stiffness", and summaries
    const char* name;  ///< in results: "k"
    const char* caption = "";
    const char* source = "";                   ///< of the default
    double Uncertainty::*deviation = nullptr;  ///< null: follows from the scan, no key
    const char* unit = "%";                    ///< in which it is shown
    double scale = 0.01;                       ///< that unit [SI]
    double max = 1.0;                          ///< [SI]; the least is 0
    const char* limits = "lie between 0 and 1";
};

template <>
inline constexpr auto kEnumTable<UncertaintyInput> = std::to_array<UncertaintyRow>(
    {{UncertaintyInput::Stiffness, "stiffness", "k", "Stiffness",
      "Of the lever; a thermal or Sader calibration leaves 5 to 15 %", &Uncertainty::stiffness},
     {UncertaintyInput::InvOls, "inv_ols", "InvOLS", "InvOLS",
      "Deflection per volt; ramps on a hard wall repeat to some 3 %", &Uncertainty::invOls},
     {UncertaintyInput::TipRadius, "tip_radius", "tip radius", "Tip radius",
      "Of a tip that was characterized; a maker's value leaves more", &Uncertainty::tipRadius},
     {UncertaintyInput::ImagingTip, "imaging_tip_radius", "imaging tip", "Imaging tip radius",
      "Of the tip that recorded the scan; what a scan that is not eroded holds of it is a shift",
      &Uncertainty::imagingTip},
     {UncertaintyInput::Modulus, "youngs_modulus", "modulus", "Young's modulus",
      "Of the sample; values of one material in the literature differ by this and more",
      &Uncertainty::modulus},
     {UncertaintyInput::WorkOfAdhesion, "work_of_adhesion", "adhesion", "Work of adhesion",
      "Of tip and sample; values of one pair in the literature differ by this and more",
      &Uncertainty::workOfAdhesion},
     {UncertaintyInput::CohesiveRange, "cohesive_range", "range of adhesion", "Cohesive range",
      "h0 of the Maugis-Dugdale laws, which no measurement of the pull-off tells apart from w",
      &Uncertainty::cohesiveRange},
     {UncertaintyInput::HeightCalibration, "z_calibration", "z calibration", "z calibration",
      "Of the scan's heights; step gratings leave some 3 %", &Uncertainty::heightCalibration},
     {UncertaintyInput::LateralCalibration, "xy_calibration", "xy calibration", "xy calibration",
      "Of the scan's size; pitch gratings leave some 1 %", &Uncertainty::lateralCalibration},
     {UncertaintyInput::HeightNoise, "height_noise_m", "heights", "Height noise",
      "White noise of the scan's heights; 0: estimated from its highest frequencies",
      &Uncertainty::heightNoise, "pm", 1e-12, 1e-6, "lie between 0 and 1e-6"},
     {UncertaintyInput::SurfaceNormal, "surface_normal_rad", "surface normal", "Surface normal",
      "About each axis: tilt of sample and lever that leveling took out, a degree; the force "
      "estimate assumes it",
      &Uncertainty::surfaceNormal, "°", std::numbers::pi / 180.0, 0.5, "lie between 0 and 0.5"},
     {UncertaintyInput::Smoothing, "smoothing", "smoothing"},
     {UncertaintyInput::Pixels, "pixels", "pixels"}});
static_assert(isComplete<UncertaintyInput>());

inline constexpr std::size_t kUncertaintyInputCount = kEnumTable<UncertaintyInput>.size();

}  // namespace asperity
