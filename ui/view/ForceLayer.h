#pragma once

#include "core/probe/ForceDecoupling.h"

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <optional>

class vtkActor;
class vtkAspForceGlyphSource;
class vtkRenderer;

namespace asperity {

/// The force on the tip as an arrow from the contact, once it is known to be there: while it is not
/// larger than three of its standard deviations, and shortly after, there is none.
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

    /// Where the arrow ends; empty: the force is too small to show.
    [[nodiscard]] const std::optional<Vector3>& end() const { return end_; }

private:
    vtkNew<vtkAspForceGlyphSource> source_;
    vtkSmartPointer<vtkActor> arrow_;
    std::optional<double> lastNoise_;  ///< when the force was within its noise [s]
    std::optional<Vector3> end_;
};

}  // namespace asperity
