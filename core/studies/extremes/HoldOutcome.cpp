#include "core/studies/extremes/HoldOutcome.h"

#include <regex>

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

std::string kindOf(const std::string& sentence) {
    static const std::regex quantity(R"([0-9][0-9.e+-]* \S{0,2}(N/m|N|s)\b)");
    return std::regex_replace(sentence, quantity, "X $1");
}

}  // namespace asperity
