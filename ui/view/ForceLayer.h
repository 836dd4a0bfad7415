#pragma once

#include "core/Vector.h"
#include "core/probe/ForceDecoupling.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <string>

class vtkActor;
class vtkAspForceGlyphSource;
class vtkRenderer;

namespace asperity {

/// Decides whether a force is known to be there: not while it is not larger than three of its
/// standard deviations, and not shortly after.
class ForceEvidence {
public:
    /// Takes the next estimate, and returns whether its force is known. @param time of the run [s]
    bool take(const ForceEstimate& estimate, double time);
    void forget() { lastNoise_.reset(); }

private:
    std::optional<double> lastNoise_;  ///< when the force was within its noise [s]
};

/// The force on the tip as an arrow from the contact, once it is known to be there.
class ForceLayer {
public:
    explicit ForceLayer(vtkRenderer* renderer);
    ~ForceLayer();
    ForceLayer(const ForceLayer&) = delete;
    ForceLayer& operator=(const ForceLayer&) = delete;

    /// @param start where the arrow begins, as drawn [m]
    /// @param time  of the run [s]
    /// @param usual force whose arrow fills half of the room [N]
    /// @param room  length that the arrow may have [m]
    void show(const ForceEstimate& estimate, const Vector3& start, double time, double usual,
              double room);
    void hide();

    /// End of the arrow; empty: the force is too small to show.
    [[nodiscard]] const std::optional<Vector3>& end() const { return end_; }

private:
    vtkNew<vtkAspForceGlyphSource> source_;
    vtkSmartPointer<vtkActor> arrow_;
    ForceEvidence evidence_;
    std::optional<Vector3> end_;
};

/// Length of a force's arrow: a larger force always has a longer one, and none is longer than its
/// room; far below `usual` the length is proportional to the force [m].
/// @param magnitude of the force, >= 0 [N]
/// @param usual     force whose arrow fills half of the room, > 0 [N]
/// @param room      [m]
[[nodiscard]] double arrowLength(double magnitude, double usual, double room);

/// Magnitude of a force for its arrow: "5.10 nN". @param force [N]
[[nodiscard]] std::string magnitudeText(const Vector3& force);

}  // namespace asperity
