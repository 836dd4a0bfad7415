#pragma once

#include <string>

namespace asperity {

/// For people, to the second, the minute or a tenth of an hour: "45 s", "12 min", "3.4 h".
[[nodiscard]] std::string durationText(double seconds);

}  // namespace asperity
