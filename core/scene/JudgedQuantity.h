#pragma once

#include "core/EnumTable.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace asperity {

/// The quantities by which a model is judged: those that a user reads from an approach and retract,
/// and the force of a run.
enum class JudgedQuantity : std::uint8_t {
    PullOffForce,     ///< the strongest pull of the retract
    PullOffPosition,  ///< of the base where the tip pulls off
    SnapInForce,      ///< the pull just after snap-in
    SnapInPosition,   ///< of the base where the tip snaps in
    Indentation,      ///< at the setpoint
    Stiffness,        ///< at the setpoint, of the main contact
    SeparationWork,   ///< area between the retract and zero force, where it pulls
    RunForce,         ///< root mean square along a run, its jumps included
};

template <>
inline constexpr auto kEnumTable<JudgedQuantity> = std::to_array<EnumRow<JudgedQuantity>>(
    {{JudgedQuantity::PullOffForce, "pull_off_force", "pull-off force"},
     {JudgedQuantity::PullOffPosition, "pull_off_position", "pull-off position"},
     {JudgedQuantity::SnapInForce, "snap_in_force", "snap-in force"},
     {JudgedQuantity::SnapInPosition, "snap_in_position", "snap-in position"},
     {JudgedQuantity::Indentation, "indentation", "indentation"},
     {JudgedQuantity::Stiffness, "stiffness", "contact stiffness"},
     {JudgedQuantity::SeparationWork, "separation_work", "work of separation"},
     {JudgedQuantity::RunForce, "rms_force", "rms force of a run"}});

/// The relative error of each quantity, >= 0. A position's error is relative to the base's travel
/// from the setpoint to the pull-off: on the plotted curve that is the part in contact, so the
/// error says how far the curve looks shifted, and it scales with the scene.
class QuantityErrors {
public:
    double& operator[](JudgedQuantity quantity) noexcept {
        return errors_[static_cast<std::size_t>(quantity)];
    }
    double operator[](JudgedQuantity quantity) const noexcept {
        return errors_[static_cast<std::size_t>(quantity)];
    }

    [[nodiscard]] JudgedQuantity worstQuantity() const noexcept {
        const auto* const worst = std::max_element(errors_.begin(), errors_.end());
        return static_cast<JudgedQuantity>(worst - errors_.begin());
    }
    [[nodiscard]] double worst() const noexcept { return (*this)[worstQuantity()]; }

    /// Keeps the larger error of each quantity.
    void raiseTo(const QuantityErrors& other) noexcept {
        combine(other, [](double a, double b) { return std::max(a, b); });
    }
    /// Adds errors that are independent: the root of the sum of squares.
    void addSquares(const QuantityErrors& other) noexcept {
        combine(other, [](double a, double b) { return std::hypot(a, b); });
    }
    void add(const QuantityErrors& other) noexcept {
        combine(other, [](double a, double b) { return a + b; });
    }

    bool operator==(const QuantityErrors&) const = default;

private:
    template <class Combine>
    void combine(const QuantityErrors& other, const Combine& combined) noexcept {
        for (std::size_t i = 0; i < errors_.size(); ++i) {
            errors_[i] = combined(errors_[i], other.errors_[i]);
        }
    }

    std::array<double, kEnumTable<JudgedQuantity>.size()> errors_{};
};

}  // namespace asperity
