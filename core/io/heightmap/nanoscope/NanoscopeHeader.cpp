#include "core/io/heightmap/nanoscope/NanoscopeHeader.h"

#include "core/Error.h"

#include <charconv>
#include <cmath>

namespace asperity {

namespace {

constexpr std::string_view kLineEnd = "\r\n";
/// Behind "\*", or "\*EC " of electrochemistry.
constexpr std::string_view kNanoscopeHeaderEnd = "File list end";
constexpr char kPadding = '\x1A';

/// The header's text, without its end mark and padding.
std::string_view headerText(std::string_view bytes, const std::string& file) {
    bytes = bytes.substr(0, kMaxNanoscopeHeader);
    const std::size_t firstEnd = bytes.find('\n');
    if (firstEnd != std::string_view::npos && firstEnd > 0 && bytes[firstEnd - 1] != '\r') {
        throw InputError(file, "line 1",
                         "it ends with a bare line feed: a transfer in text mode has damaged the "
                         "file; copy it again in binary mode");
    }
    const std::size_t end = nanoscopeHeaderSize(bytes);
    if (end == std::string_view::npos) {
        throw InputError(file, "header",
                         "it has no '\\*File list end'; the file is truncated or damaged");
    }
    return bytes.substr(0, end);
}

/// Splits "@2:Z scale: V ..." after the colon that ends the key, which is not that of the group.
std::optional<NanoscopeEntry> parseEntry(std::string_view line) {
    const bool grouped =
        line.size() > 2 && line[0] == '@' && line[1] >= '0' && line[1] <= '9' && line[2] == ':';
    const std::size_t start = grouped ? 3 : 0;
    std::size_t colon = line.find(": ", start);
    if (colon == std::string_view::npos && line.ends_with(':') && line.size() > start) {
        colon = line.size() - 1;
    }
    if (colon == std::string_view::npos) {
        return std::nullopt;
    }
    return NanoscopeEntry{toUtf8(line.substr(0, colon)), toUtf8(trimmed(line.substr(colon + 1)))};
}

/// Takes a balanced "(...)" or "[...]" off the front; empty when it is not closed.
std::optional<std::string_view> takeBracket(std::string_view& text, char open, char close) {
    int depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == open) {
            ++depth;
        }
        if (text[i] == close && --depth == 0) {
            const std::string_view inside = text.substr(1, i - 1);
            text = trimmed(text.substr(i + 1));
            return inside;
        }
    }
    return std::nullopt;
}

}  // namespace

const std::string* NanoscopeSection::find(std::string_view key) const {
    const auto entry = entries.find(lowerCase(key));
    return entry == entries.end() ? nullptr : &entry->second.value;
}

std::optional<CiaoValue> parseCiaoValue(std::string_view value) {
    const bool typed = value.size() > 1 && value[1] == ' ' &&
                       (value[0] == 'V' || value[0] == 'C' || value[0] == 'S');
    if (!typed) {
        return std::nullopt;
    }
    std::string_view text = trimmed(value.substr(1));
    CiaoValue result;
    if (text.starts_with('[')) {
        const std::optional<std::string_view> inside = takeBracket(text, '[', ']');
        if (!inside) {
            return std::nullopt;
        }
        result.bracket = trimmed(*inside);
    }
    if (text.starts_with('(')) {
        const std::optional<std::string_view> inside = takeBracket(text, '(', ')');
        if (!inside) {
            return std::nullopt;
        }
        result.hardScale = trimmed(*inside);
    }
    if (text.size() > 1 && text.starts_with('"') && text.ends_with('"')) {
        text = text.substr(1, text.size() - 2);
    }
    result.text = text;
    const std::optional<LeadingNumber> number = parseLeadingNumber(text);
    if (number && std::isfinite(number->value)) {
        result.number = number->value;
        result.unit = number->rest;
    }
    return result;
}

std::string nanoscopeStart(const ByteSource& bytes) {
    return bytes.startUntil(
        [](std::string_view start) { return nanoscopeHeaderSize(start) != std::string_view::npos; },
        kMaxNanoscopeHeader);
}

const std::string* nanoscopeEntry(const std::vector<NanoscopeSection>& sections,
                                  std::string_view key) {
    for (const NanoscopeSection& section : sections) {
        if (const std::string* const text = section.find(key)) {
            return text;
        }
    }
    return nullptr;
}

int nanoscopeSampleBytes(std::string_view version) {
    constexpr unsigned kFirstWideVersion = 0x09200000;
    const bool hasPrefix = version.starts_with("0x") || version.starts_with("0X");
    unsigned number = 0;
    (void)std::from_chars(version.data() + (hasPrefix ? 2 : 0), version.data() + version.size(),
                          number, 16);
    return number >= kFirstWideVersion ? 4 : 2;
}

std::size_t nanoscopeHeaderSize(std::string_view bytes) {
    const std::size_t mark = bytes.find(kNanoscopeHeaderEnd);
    const std::size_t line = mark == std::string_view::npos ? mark : bytes.rfind('\\', mark);
    return std::min(line, bytes.find(kPadding));
}

void takeNanoscopeLine(std::string_view line, std::vector<NanoscopeSection>& sections) {
    if (line.starts_with('*')) {
        sections.push_back({toUtf8(trimmed(line.substr(1))), {}});
    } else if (const auto entry = parseEntry(line); entry && !sections.empty()) {
        sections.back().entries.insert_or_assign(lowerCase(entry->key), *entry);
    }
}

std::vector<NanoscopeSection> readNanoscopeHeader(std::string_view bytes, const std::string& file) {
    std::string_view text = headerText(bytes, file);
    std::vector<NanoscopeSection> sections;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(kLineEnd), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + kLineEnd.size(), text.size()));
        if (!line.starts_with('\\')) {
            continue;
        }
        takeNanoscopeLine(line.substr(1), sections);
    }
    return sections;
}

}  // namespace asperity
