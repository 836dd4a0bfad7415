#pragma once

#include "core/Vector.h"

#include <optional>

namespace asperity {

/// An instrument that knows where its tip really is, as a simulated one does. This goes to the
/// pictures alone, beside the tick: neither tick nor estimator sees it.
class TrueTip {
public:
    virtual ~TrueTip() = default;
    /// Apex behind the last measurement, lab frame [m]; none before there is one.
    [[nodiscard]] virtual std::optional<Vector3> trueTip() const noexcept = 0;
};

}  // namespace asperity
