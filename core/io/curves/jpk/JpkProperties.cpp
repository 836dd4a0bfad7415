#include "core/io/curves/jpk/JpkProperties.h"

#include "core/io/TextValue.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr std::string_view kReferenceEnd = ".*";

void appendUtf8(std::string& text, unsigned code) {
    if (code < 0x80U) {
        text += static_cast<char>(code);
    } else if (code < 0x800U) {
        text += static_cast<char>(0xC0U | (code >> 6U));
        text += static_cast<char>(0x80U | (code & 0x3FU));
    } else {
        text += static_cast<char>(0xE0U | (code >> 12U));
        text += static_cast<char>(0x80U | ((code >> 6U) & 0x3FU));
        text += static_cast<char>(0x80U | (code & 0x3FU));
    }
}

/// The four digits of "\u00B5"; empty: they are none.
std::optional<unsigned> hexCode(std::string_view digits) {
    unsigned code = 0;
    for (const char digit : digits) {
        const std::size_t value =
            std::string_view("0123456789abcdef").find(static_cast<char>(lowerCase({&digit, 1})[0]));
        if (value == std::string_view::npos) {
            return std::nullopt;
        }
        code = 16U * code + static_cast<unsigned>(value);
    }
    return digits.size() == 4 ? std::optional(code) : std::nullopt;
}

}  // namespace

JpkProperties::JpkProperties(std::string text, const JpkProperties* shared)
    : text_(std::move(text)), shared_(shared) {
    std::string_view rest = text_;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        add(trimmed(rest.substr(0, end)));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    std::ranges::stable_sort(entries_, {}, [](const auto& entry) { return entry.first; });
}

void JpkProperties::add(std::string_view line) {
    const std::size_t equals = line.find('=');
    if (line.starts_with('#') || equals == std::string_view::npos) {
        return;
    }
    const std::string_view key = unescaped(trimmed(line.substr(0, equals)));
    const std::string_view value = unescaped(trimmed(line.substr(equals + 1)));
    entries_.emplace_back(key, value);
    if (key.ends_with(kReferenceEnd)) {
        const std::string_view path = key.substr(0, key.size() - kReferenceEnd.size());
        const std::size_t dot = path.rfind('.');
        const std::size_t begin = dot == std::string_view::npos ? 0 : dot + 1;
        references_.push_back({path.substr(0, begin), path.substr(begin), value});
    }
}

std::string_view JpkProperties::unescaped(std::string_view text) {
    if (text.find('\\') == std::string_view::npos) {
        return text;
    }
    std::string& result = unescaped_.emplace_back();
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '\\' || i + 1 == text.size()) {
            result += text[i];
            continue;
        }
        ++i;
        const std::optional<unsigned> code =
            text[i] == 'u' ? hexCode(text.substr(i + 1, 4)) : std::nullopt;
        if (code) {
            appendUtf8(result, *code);
            i += 4;
        } else {
            result += text[i];
        }
    }
    return result;
}

const std::string_view* JpkProperties::own(std::string_view key) const {
    const auto found =
        std::ranges::lower_bound(entries_, key, {}, [](const auto& entry) { return entry.first; });
    return found == entries_.end() || found->first != key ? nullptr : &found->second;
}

std::optional<std::string_view> JpkProperties::find(std::string_view key, int references) const {
    if (const std::string_view* const value = own(key)) {
        return *value;
    }
    if (references == 0) {
        return std::nullopt;
    }
    const JpkProperties& shared = shared_ == nullptr ? *this : *shared_;
    for (const Reference& reference : references_) {
        if (!key.starts_with(reference.base)) {
            continue;
        }
        std::string inserted(reference.word);
        inserted.append(".").append(reference.index).append(".");
        inserted.append(key.substr(reference.base.size()));
        if (const auto value = shared.find(inserted, references - 1)) {
            return value;
        }
    }
    return std::nullopt;
}

std::optional<double> JpkProperties::number(std::string_view key) const {
    const std::optional<double> value = parseNumber(text(key));
    return value && std::isfinite(*value) ? value : std::nullopt;
}

}  // namespace asperity
