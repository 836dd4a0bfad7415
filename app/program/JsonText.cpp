#include "app/program/JsonText.h"

#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/PrintableText.h"
#include "core/io/FileBytes.h"
#include "core/io/NestedText.h"

#include <string_view>

namespace asperity {

namespace {

/// The library leaves some of them as they are. Beside line ends, they occur in strings only.
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

nlohmann::json parsedJson(std::string_view text, const std::string& file) {
    requireParsable(text, NestedSyntax::Json, file);
    return nlohmann::json::parse(text, nullptr, false);
}

nlohmann::json readJson(const std::filesystem::path& file) {
    std::error_code unknown;
    const std::uintmax_t size = std::filesystem::file_size(file, unknown);
    return unknown || size == 0 ? nlohmann::json(nlohmann::json::value_t::discarded)
                                : parsedJson(readFileBytes(file), file.string());
}

nlohmann::json requiredJson(const std::filesystem::path& file) {
    const std::string text = readFileBytes(file);
    requireParsable(text, NestedSyntax::Json, file.string());
    try {
        return nlohmann::json::parse(text);
    } catch (const nlohmann::json::parse_error& error) {
        // The library counts from 1.
        throw InputError(file.string(), "byte " + std::to_string(error.byte - 1),
                         "this is no JSON; the file is truncated or damaged");
    } catch (const nlohmann::json::out_of_range&) {  // it does not say where
        throw InputError(file.string(), "",
                         "a number in it is larger than any can be; the file is damaged");
    }
}

nlohmann::ordered_json provenanceJson(const std::vector<Provenance>& entries) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Provenance& entry : entries) {
        list.push_back({{"what", entry.what}, {"value", entry.value}, {"source", entry.source}});
    }
    return list;
}

}  // namespace asperity
