#include "core/studies/extremes/HoldOutcome.h"

namespace asperity {

const char* nameOf(Grip grip) noexcept {
    static constexpr std::array kNames{"none", "light", "normal"};
    return kNames.at(static_cast<std::size_t>(grip));
}

const char* nameOf(HoldVerdict verdict) noexcept {
    static constexpr std::array kNames{"still",          "noisy",  "no coupling",
                                       "scale too high", "shakes", "not finite"};
    return kNames.at(static_cast<std::size_t>(verdict));
}

}  // namespace asperity
