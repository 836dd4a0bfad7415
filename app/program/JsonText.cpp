#include "app/program/JsonText.h"

#include "core/FormattedText.h"
#include "core/PrintableText.h"
#include "core/Utf8.h"

#include <string_view>

namespace asperity {

namespace {

/// The library leaves some of them as they are. Beside line ends, they stand in strings only.
std::string withoutCommands(std::string_view text) {
    std::string safe;
    while (!text.empty()) {
        const Utf8Character character = firstCharacter(text);
        if (character.codePoint != '\n' && isCommand(character.codePoint)) {
            safe += formatted("\\u%04x", static_cast<unsigned>(character.codePoint));
        } else {
            safe += text.substr(0, character.length);
        }
        text.remove_prefix(character.length);
    }
    return safe;
}

template <class Json>
std::string textOf(const Json& json) {
    constexpr int kIndent = 2;
    return withoutCommands(json.dump(kIndent, ' ', false, Json::error_handler_t::replace));
}

}  // namespace

std::string jsonText(const nlohmann::json& json) { return textOf(json); }
std::string jsonText(const nlohmann::ordered_json& json) { return textOf(json); }

}  // namespace asperity
