#include "core/scene/MaterialMapFields.h"

namespace asperity {

namespace {

constexpr const char* kBetween = " # ";

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(' ');
    return first == std::string::npos ? std::string()
                                      : text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

}  // namespace

std::string mapText(const std::optional<MapSource>& source) {
    if (!source) {
        return {};
    }
    return source->file + (source->channel.empty() ? "" : kBetween + source->channel);
}

std::optional<MapSource> mapOf(const std::string& text, const std::optional<MapSource>& present) {
    const std::string wanted = trimmed(text);
    if (wanted.empty()) {
        return std::nullopt;
    }
    if (present && wanted == trimmed(mapText(present))) {
        return present;
    }
    const std::size_t mark = wanted.find(kBetween);
    const bool hasChannel = mark != std::string::npos;
    return MapSource{.file = trimmed(wanted.substr(0, mark)),
                     .channel = hasChannel ? trimmed(wanted.substr(mark + 3)) : "",
                     .sha256 = ""};
}

}  // namespace asperity
