#pragma once

#include "core/Random.h"
#include "core/Vector.h"
#include "core/experiment/OperatorTraits.h"

#include <cstddef>
#include <vector>

namespace asperity {

/// What the window shows of a moment: pictures, numbers, not the truth.
struct ShownMoment {
    Vector3 tip = Vector3::Zero();  ///< apex, as the window shows it, world [m]
    bool hidden = false;            ///< it is below the surface that is drawn
};

/// The picture as an operator sees it: frame by frame, late, and not exactly.
class OperatorSight {
public:
    /// @param scale meters on the screen per meter of the sample
    /// @param lineOfSight unit
    OperatorSight(const OperatorTraits& person, double scale, const Vector3& lineOfSight);

    /// One more tick of the loop. @param timeStep since the last one [s]
    void show(const ShownMoment& moment, double timeStep);
    /// Whether there is anything to be seen yet.
    [[nodiscard]] bool isOpen() const noexcept { return !frames_.empty(); }
    /// Where the operator takes the tip to be, looking at it anew [m].
    [[nodiscard]] Vector3 look(Random& random) const;

private:
    [[nodiscard]] const ShownMoment& seen() const;

    OperatorTraits person_;
    double scale_;
    Vector3 lineOfSight_;
    std::size_t length_;               ///< of the ring: for so many frames sight is late
    std::vector<ShownMoment> frames_;  ///< a ring
    std::size_t newest_ = 0;
    double sinceFrame_ = 0.0;  ///< [s]
};

/// The force as a hand feels it: a change is noticed where it is large enough beside what acts
/// already, and answered late.
class OperatorTouch {
public:
    explicit OperatorTouch(const OperatorTraits& person) : person_(person) {}

    void feel(const Vector3& force, double timeStep);
    /// Whether a change of the force was noticed that can be answered now; tells it once.
    [[nodiscard]] bool takeNotice();

private:
    OperatorTraits person_;
    Vector3 usual_ = Vector3::Zero();  ///< what the hand is used to [N]
    double since_ = -1.0;              ///< the change that is not answered yet; < 0: there is none
    bool noticed_ = false;
};

}  // namespace asperity
