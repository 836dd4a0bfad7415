#include "core/Error.h"
#include "core/io/NestedText.h"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>
#include <toml++/toml.h>

// A text of TOML or JSON (ASPERITY_FUZZED): values, a mistake, or an InputError, on little stack.

namespace {

void parse(std::string_view text) {
    using asperity::NestedSyntax;
    constexpr NestedSyntax kSyntax = NestedSyntax::ASPERITY_FUZZED;
    asperity::requireParsable(text, kSyntax, "fuzz");
    if constexpr (kSyntax == NestedSyntax::Toml) {
        try {
            (void)toml::parse(text);
        } catch (const toml::parse_error&) {
            return;
        }
    } else {
        const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
        const nlohmann::json copy = json;  // reaches the deepest value
    }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        parse({reinterpret_cast<const char*>(data), size});
    } catch (const asperity::InputError&) {
        return 0;
    }
    return 0;
}
