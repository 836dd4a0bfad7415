#include "core/io/GovernorKeys.h"

#include <cmath>

namespace asperity {

namespace {

constexpr const char* kButtonKey = "dead_man_button";

/// Here and not with the other ranges: a description holds whole numbers only.
int readButton(TomlSection& section, int otherwise) {
    const double button = section.number(kButtonKey, otherwise);
    const bool exists =
        button >= GovernorLimits::kNoButton && button <= GovernorLimits::kLastButton;
    if (!exists || button != std::floor(button)) {
        section.refuse(kButtonKey, "a whole number from 0 to 31, or -1 for none");
    }
    return static_cast<int>(button);
}

}  // namespace

GovernorLimits readGovernorKeys(TomlSection& section, const GovernorLimits& otherwise) {
    return {.maxForce = section.number("max_force_n", otherwise.maxForce),
            .engageTime = section.number("engage_s", otherwise.engageTime),
            .maxHandSpeed = section.number("max_hand_speed_m_s", otherwise.maxHandSpeed),
            .deadManButton = readButton(section, otherwise.deadManButton)};
}

toml::table governorTable(const GovernorLimits& governor) {
    return toml::table{{"max_force_n", governor.maxForce},
                       {"engage_s", governor.engageTime},
                       {"max_hand_speed_m_s", governor.maxHandSpeed},
                       {kButtonKey, governor.deadManButton}};
}

}  // namespace asperity
