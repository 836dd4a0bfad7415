#pragma once

#include "core/SiFormat.h"
#include "core/haptics/cycle/ContactCycle.h"

#include <string>

namespace asperity {

/// A value to four digits in a given prefix, without unit: "12.34".
[[nodiscard]] std::string numberText(double value, const SiScale& scale);

/// A value with its standard deviation, which has two digits, without unit: "3.395 ± 0.086". Where
/// none is known (0) as numberText().
[[nodiscard]] std::string measuredText(const Reading& reading, const SiScale& scale);

/// The same of a value of which no more is known than the noise: "3.395 ± 0.086 (noise)".
[[nodiscard]] std::string noisyText(const Reading& reading, const SiScale& scale);

/// As measuredText() in a prefix of its own, with unit: "(3.395 ± 0.086) nN".
[[nodiscard]] std::string measuredText(const Reading& reading, const std::string& unit);

/// A sentence that begins with a capital.
[[nodiscard]] std::string capitalized(std::string sentence);

/// A share for people: "12 %"; what is not zero is not shown as zero: "< 0.1 %".
[[nodiscard]] std::string shareText(long part, long whole);

}  // namespace asperity
