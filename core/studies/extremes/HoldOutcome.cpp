#include "core/studies/extremes/HoldOutcome.h"

#include <regex>

namespace asperity {

std::string kindOf(const std::string& sentence) {
    static const std::regex quantity(R"([0-9][0-9.e+-]* \S{0,2}(N/m|N|s)\b)");
    return std::regex_replace(sentence, quantity, "X $1");
}

}  // namespace asperity
