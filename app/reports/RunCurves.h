#pragma once

#include "core/Vector.h"
#include "core/haptics/VirtualRun.h"
#include "vtkplugins/pictures/Charts.h"

#include <filesystem>
#include <vector>

namespace asperity {

/// Collects what the plots of a run show; SI units.
class RunCurves {
public:
    void take(const TickSample& sample);

    /// Forces, approach and retract, contact, and signals.
    [[nodiscard]] std::vector<Chart> charts() const;
    /// Draws them as forces.png. @throw Error
    void write(const std::filesystem::path& path) const;

    /// Where the tip's apex went [m].
    [[nodiscard]] const std::vector<Vector3>& tipPath() const noexcept { return tip_; }

private:
    /// One leg of a force-distance curve.
    struct Leg {
        std::vector<double> height;  ///< of the base above first touch [m]
        std::vector<double> force;   ///< along z [N]
    };

    void takeLegs(const TickSample& sample);

    std::vector<double> time_;           ///< [s]
    std::vector<Vector3> tip_;           ///< apex [m]
    std::vector<Vector3> estimate_;      ///< force from the signals [N]
    std::vector<Vector3> model_;         ///< model force [N]
    std::vector<double> indentation_;    ///< [m]
    std::vector<double> contactRadius_;  ///< [m]
    std::vector<double> bending_;        ///< [rad]
    std::vector<double> torsion_;        ///< [rad]
    Leg approach_;
    Leg retract_;
};

}  // namespace asperity
