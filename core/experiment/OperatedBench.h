#pragma once

#include "core/experiment/Operator.h"
#include "core/haptics/bench/VirtualBench.h"
#include "core/haptics/device/HapticDevice.h"

namespace asperity {

/// The virtual bench in an operator's hand: a haptic device that moves by itself.
class OperatedBench final : public HapticDevice {
public:
    /// @param start where handle and hand rest at first, in the device's frame [m]
    OperatedBench(const BenchSetup& setup, const Vector3& start, const Operator& person)
        : bench_(setup, start), operator_(person) {}

    [[nodiscard]] DeviceSpecification specification() const noexcept override {
        return bench_.specification();
    }
    [[nodiscard]] double delay() const noexcept override { return bench_.delay(); }
    DeviceState advance(double timeStep) noexcept override;
    void setForce(const Vector3& force) noexcept override;
    void observe(const TickOutput& output) noexcept override;

    [[nodiscard]] Operator& person() noexcept { return operator_; }
    /// Where the handle really is [m].
    [[nodiscard]] const Vector3& position() const noexcept { return bench_.position(); }
    /// Whether the deformed surface is drawn; without it a tip in the sample is hidden.
    void showDeformation(bool shown) noexcept { deformationShown_ = shown; }

private:
    VirtualBench bench_;
    Operator operator_;
    Vector3 force_ = Vector3::Zero();  ///< that acts at the handle [N]
    double timeStep_ = 1e-3;           ///< [s]
    bool deformationShown_ = true;
};

}  // namespace asperity
