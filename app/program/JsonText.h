#pragma once

#include "core/surface/Provenance.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// JSON as text with two blanks a level. Whatever the strings hold, it is valid UTF-8 without a
/// character that a terminal obeys: those become \u001b, bytes that are no UTF-8 as U+FFFD.
[[nodiscard]] std::string jsonText(const nlohmann::json& json);
[[nodiscard]] std::string jsonText(const nlohmann::ordered_json& json);

/// The values of a text; discarded where it is no JSON.
/// @param file for messages
/// @throw InputError where there is far more in it than in any of Asperity's own
[[nodiscard]] nlohmann::json parsedJson(std::string_view text, const std::string& file);
/// The same of a file; discarded where there is none, too. @throw InputError
[[nodiscard]] nlohmann::json readJson(const std::filesystem::path& file);
/// The values of a file that must be there. @throw InputError as parsedJson(), and with the byte
/// where it is no JSON any more
[[nodiscard]] nlohmann::json requiredJson(const std::filesystem::path& file);

/// A list of objects with `what`, `value` and `source`.
[[nodiscard]] nlohmann::ordered_json provenanceJson(const std::vector<Provenance>& entries);

}  // namespace asperity
