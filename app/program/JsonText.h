#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace asperity {

/// JSON as text with two blanks a level. Whatever the strings hold, it is valid UTF-8 without a
/// character that a terminal obeys: those stand as \u001b, bytes that are no UTF-8 as U+FFFD.
[[nodiscard]] std::string jsonText(const nlohmann::json& json);
[[nodiscard]] std::string jsonText(const nlohmann::ordered_json& json);

}  // namespace asperity
