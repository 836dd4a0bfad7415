#pragma once

#include "core/haptics/Snapshot.h"
#include "core/scene/Validity.h"

#include <array>
#include <optional>

namespace asperity {

/// Which validity flags a user shall see. One of a single tick stays long enough to be read, but
/// one of a contact goes with it; one that noisy signals raise counts where most ticks have it.
class ShownFlags {
public:
    ShownFlags() { clear(); }

    void clear() noexcept;
    /// Every tick, in order.
    void take(const TickSample& sample) noexcept;
    /// @param index into kValidityTraits @param latest the newest tick, taken or not
    [[nodiscard]] bool isShown(std::size_t index, const TickSample& latest) const;

private:
    struct Seen {
        double last = 0.0;    ///< time of the last tick that had it [s]
        double share = 0.0;   ///< of the last ticks
        bool inMost = false;  ///< of them, with hysteresis
    };

    std::array<Seen, kValidityFlagCount> seen_;
    std::optional<double> time_;  ///< of the newest tick taken [s]
};

}  // namespace asperity
