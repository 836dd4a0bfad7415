#pragma once

#include "core/EnumTable.h"
#include "core/scene/Validity.h"

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace asperity {

/// Verdict on a state, best first.
enum class Verdict : std::uint8_t {
    Exact,     ///< solved, not flagged, within kExactWithin of the reference
    Valid,     ///< solved, not flagged, within kValidWithin of it
    Off,       ///< solved, not flagged, farther off
    Flagged,   ///< solved, and a validity flag says that it does not hold
    Unproven,  ///< solved, not flagged, but the reference itself is not known to hold there
    Refused,   ///< no answer, but a reason
};

template <>
inline constexpr auto
    kEnumTable<Verdict> = std::to_array<EnumRow<Verdict>>({{Verdict::Exact, "exact"},
                                                           {Verdict::Valid, "valid"},
                                                           {Verdict::Off, "off"},
                                                           {Verdict::Flagged, "flagged"},
                                                           {Verdict::Unproven, "unproven"},
                                                           {Verdict::Refused, "refused"}});

/// Less than any force calibration resolves [relative].
inline constexpr double kExactWithin = 1e-3;
/// As far as two adhesion laws of the same work and range differ [relative]: nothing finer has a
/// physical meaning. Source: docs/theory.md 2.9.
inline constexpr double kValidWithin = 0.05;

/// The verdict on a solved state without flags whose reference holds. @param error relative to the
/// reference
[[nodiscard]] Verdict verdictOnError(double error) noexcept;

/// Difference of two quantities relative to the largest of both and `unit` >= 0; 0 where all are 0.
[[nodiscard]] double relativeError(double value, double reference, double unit) noexcept;

/// Position of a region in the map.
struct RegionKey {
    std::string model;  ///< key of a contact law; "tick"
    std::string
        setting;  ///< of its solver, "-" where all are the same; effort of the closest point search
    std::string sample;      ///< "adhesive", "no adhesion", "film", "rough", "out of range"
    double tipRadius = 0.0;  ///< [m]
    double modulus = 0.0;    ///< E* [Pa]; 0 for the tick
    double roughness = 0.0;  ///< rms height over tip radius; of the tick only

    [[nodiscard]] auto operator<=>(const RegionKey&) const = default;
};

/// Relative errors of one state.
struct StateErrors {
    double force = 0.0;          ///< against the reference
    double contactRadius = 0.0;  ///< same
    double jump = 0.0;    ///< of the position of a jump that lies between state and reference
    double solver = 0.0;  ///< the largest one against the same law solved afresh

    [[nodiscard]] double largest() const noexcept { return std::max({force, contactRadius, jump}); }
};

/// One solved state, compared.
struct ComparedState {
    ValidityFlags flags;
    bool referenceHolds = true;  ///< whether the reference itself is known to hold there
    StateErrors errors;

    [[nodiscard]] Verdict verdict() const noexcept {
        if (flags.bits() != 0) {
            return Verdict::Flagged;
        }
        return referenceHolds ? verdictOnError(errors.largest()) : Verdict::Unproven;
    }
};

/// The largest error so far, and the state that has it.
struct WorstError {
    double error = 0.0;
    std::string where;

    /// @param describe says what state it is; asked only where the error is larger
    template <class Describe>
    void meet(double candidate, const Describe& describe) {
        if (candidate > error) {
            error = candidate;
            where = describe();
        }
    }
    void add(const WorstError& other) {
        meet(other.error, [&] { return other.where; });
    }
};

/// The states of one verdict in a region.
struct VerdictTally {
    long states = 0;
    WorstError force;
    WorstError contactRadius;
    WorstError jump;

    void add(const VerdictTally& other);
};

/// Results of all states of one model and setting in one part of the parameter space, added up
/// while they are evaluated.
class ExtremesRegion {
public:
    explicit ExtremesRegion(RegionKey key) : key_(std::move(key)) {}

    /// A solved state.
    template <class Describe>
    void add(const ComparedState& state, const Describe& describe) {
        countFlags(state.flags);
        solver_.meet(state.errors.solver, describe);
        VerdictTally& tally = tallies_[static_cast<std::size_t>(state.verdict())];
        ++tally.states;
        if (state.referenceHolds) {
            tally.force.meet(state.errors.force, describe);
            tally.contactRadius.meet(state.errors.contactRadius, describe);
            tally.jump.meet(state.errors.jump, describe);
        }
    }
    /// States without an answer. @param reason one sentence for people
    void refuse(const std::string& reason, long states = 1);
    /// All states of another region.
    void add(const ExtremesRegion& other);

    [[nodiscard]] const RegionKey& key() const noexcept { return key_; }
    [[nodiscard]] const VerdictTally& tally(Verdict verdict) const noexcept {
        return tallies_[static_cast<std::size_t>(verdict)];
    }
    [[nodiscard]] long states() const noexcept;
    /// Largest errors of the states that are not flagged and have a reference.
    [[nodiscard]] VerdictTally unflagged() const;
    /// Largest error of the solver's setting alone, flagged states included.
    [[nodiscard]] const WorstError& solver() const noexcept { return solver_; }
    [[nodiscard]] const std::map<std::string, long>& refusals() const noexcept { return refusals_; }
    /// The most frequent flag, lack of a reference or reason of a refusal; empty without any.
    [[nodiscard]] std::string mainReason() const;

private:
    void countFlags(ValidityFlags flags);

    RegionKey key_;
    std::array<VerdictTally, kValues<Verdict>.size()> tallies_;
    std::array<long, kValidityFlagCount> flags_{};
    std::map<std::string, long> refusals_;
    WorstError solver_;
};

/// One region for each position, in the order of positions.
[[nodiscard]] std::vector<ExtremesRegion> merged(std::vector<ExtremesRegion> regions);

/// One region for each model, setting and sample, over all tips, moduli and roughnesses.
[[nodiscard]] std::vector<ExtremesRegion>
summedBySample(const std::vector<ExtremesRegion>& regions);

}  // namespace asperity
