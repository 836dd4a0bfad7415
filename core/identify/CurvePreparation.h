#pragma once

#include "core/EnumTable.h"
#include "core/Error.h"
#include "core/curves/MeasuredForceCurve.h"
#include "core/identify/IdentifiedValue.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// A curve from which nothing can be identified, with the reason.
class CurveRefusal : public Error {
public:
    using Error::Error;
};

/// Rule by which the stiffness of the lever follows a correction of the InvOLS. Source:
/// docs/measured.md.
enum class LeverRule : std::uint8_t {
    AsInFile,  ///< the InvOLS is not corrected
    Thermal,  ///< stiffness from a thermal spectrum with the same InvOLS: it goes as its -2nd power
    Fixed,    ///< stiffness from elsewhere
};

template <>
inline constexpr auto kEnumTable<LeverRule> = std::to_array<EnumRow<LeverRule>>(
    {{LeverRule::AsInFile, "file"}, {LeverRule::Thermal, "thermal"}, {LeverRule::Fixed, "fixed"}});

/// Steps before a fit, and what is given for them.
struct PreparationOptions {
    double stiffness = 0.0;  ///< of the lever instead of the file's [N/m]; 0: the file's
    ValueSource stiffnessSource = ValueSource::Assumed;  ///< of that stiffness
    double invols = 0.0;  ///< instead of the file's [m/V]; 0: the file's
    LeverRule lever = LeverRule::AsInFile;
    bool sign = true;      ///< turn a force over that is negative at the deepest base
    bool baseline = true;  ///< take the force before contact off
    bool tilt = true;      ///< of it a line, not a constant
    bool drag = true;      ///< take the retract's own offset off it, too
};

/// One branch of a curve, in the order of time. Arrays of one length, `time` may be empty.
struct BranchSamples {
    std::vector<double> time;   ///< [s]
    std::vector<double> base;   ///< of the lever, growing towards the sample [m]
    std::vector<double> force;  ///< stiffness times deflection, as in the file, > 0 repulsive [N]

    [[nodiscard]] std::size_t size() const noexcept { return base.size(); }
    [[nodiscard]] double forceRange() const;  ///< largest less smallest [N]
};

/// The force before contact: offset + slope * base.
struct CurveBaseline {
    double offset = 0.0;         ///< [N]
    double slope = 0.0;          ///< [N/m]
    double noise = 0.0;          ///< standard deviation about the line [N]
    double pointNoise = 0.0;     ///< of one sample from the next, by their differences [N]
    double retractOffset = 0.0;  ///< of the retract's far end above the line [N]
    double nearEnd = 0.0;        ///< base up to which the line was fitted [m]

    [[nodiscard]] double at(double base) const noexcept { return offset + (slope * base); }
    /// Drag of lever and tip on the approach [N]: half of what the retract lies lower.
    [[nodiscard]] double drag() const noexcept { return -0.5 * retractOffset; }
    /// Returns whether the residual of the line exceeds three times what one sample scatters: light
    /// that interferes, slow drift, or a force of long range.
    [[nodiscard]] bool isWavy() const noexcept { return noise > 3.0 * pointNoise; }
};

/// Deflection by base in contact, d(deflection)/d(base), over the upper 80 % of the force.
struct ContactSlope {
    double approach = 0.0;
    double retract = 0.0;     ///< 0: no retract
    double unevenness = 0.0;  ///< rms about the line of the approach, over its range

    /// Returns whether the contact looks like one with a rigid sample: straight within 1 %, the
    /// same on both branches.
    [[nodiscard]] bool isRigid() const noexcept;
};

/// A step of the preparation and its result, as reports list them.
struct PreparationStep {
    std::string key;  ///< "baseline"
    bool on = true;
    std::vector<IdentifiedValue> values = {};
    std::string note = {};  ///< in words; empty: nothing to say
};

/// The branches of a curve that identification works on, and what the steps before it found.
struct PreparedCurve {
    BranchSamples approach;
    BranchSamples dwell;      ///< pauses between both; often empty
    BranchSamples retract;    ///< empty: the curve has none
    double stiffness = 0.0;   ///< of the lever, corrected [N/m]
    double gain = 1.0;        ///< true over stored InvOLS as it was applied
    bool turnedOver = false;  ///< force and deflection had the wrong sign
    CurveBaseline baseline;
    ContactSlope slope;
    std::vector<PreparationStep> steps;

    /// Force without baseline [N].
    [[nodiscard]] std::vector<double> correctedForce(const BranchSamples& branch) const;
    /// Largest less smallest force of the cycle [N].
    [[nodiscard]] double forceRange() const;
};

/// Takes the approach with the largest force and the retract after it, calibrates them and takes
/// the steps of `options`.
/// @throw CurveRefusal without an approach of at least 20 samples, stiffness or InvOLS
[[nodiscard]] PreparedCurve prepareCurve(const MeasuredForceCurve& curve,
                                         const PreparationOptions& options);

/// Fits the part of the approach before contact; the retract's offset is 0.
/// @param tilt false: a constant
[[nodiscard]] CurveBaseline baselineOf(const BranchSamples& approach, bool tilt);
/// Mean of the retract above the line at its far end, as far as it is level there [N]; 0: it is
/// not.
[[nodiscard]] double retractOffset(const BranchSamples& retract, const CurveBaseline& baseline);
[[nodiscard]] ContactSlope contactSlope(const PreparedCurve& curve);

}  // namespace asperity
