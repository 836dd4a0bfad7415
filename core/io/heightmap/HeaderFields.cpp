#include "core/io/heightmap/HeaderFields.h"

#include "core/Error.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/PhysicalUnit.h"

#include <algorithm>
#include <utility>

namespace asperity {

namespace {

constexpr std::uint64_t kMaxHeader = std::uint64_t{1} << 18U;

}  // namespace

TextQuota TextQuota::ofEach(std::size_t images) {
    constexpr TextQuota kOne;
    const std::size_t shares = std::max(images, kFullShares);
    return {.count = kOne.count * kFullShares / shares, .bytes = kOne.bytes * kFullShares / shares};
}

void BoundedTexts::add(std::string name, std::string text) {
    if (texts_.contains(name)) {
        return;
    }
    const std::size_t bytes = name.size() + text.size();
    if (texts_.size() == quota_.count || bytes > quota_.bytes - bytes_) {
        isCut_ = true;
        return;
    }
    bytes_ += bytes;
    texts_.emplace(std::move(name), std::move(text));
}

void BoundedTexts::set(std::string name, std::string text) {
    const auto old = texts_.find(name);
    if (old == texts_.end()) {
        add(std::move(name), std::move(text));
        return;
    }
    const std::size_t others = bytes_ - old->second.size();
    if (text.size() > quota_.bytes - others) {
        isCut_ = true;
        return;
    }
    bytes_ = others + text.size();
    old->second = std::move(text);
}

void BoundedTexts::remove(const std::string& name) {
    if (const auto text = texts_.find(name); text != texts_.end()) {
        bytes_ -= text->first.size() + text->second.size();
        texts_.erase(text);
    }
}

void BoundedTexts::add(const std::map<std::string, std::string>& texts) {
    for (const auto& [name, text] : texts) {
        add(name, text);
    }
}

void BoundedTexts::add(const BoundedTexts& texts) {
    add(texts.all());
    isCut_ = isCut_ || texts.isCut_;
}

HeaderText headerText(const ByteSource& bytes, std::string_view mark) {
    std::string start = bytes.startUntil(
        [mark](std::string_view text) { return text.find(mark) != std::string_view::npos; },
        kMaxHeader);
    const std::size_t found = start.find(mark);
    if (found == std::string::npos) {
        throw InputError(bytes.name(), "header",
                         "no '" + std::string(trimmed(mark)) +
                             "' ends it; the file is truncated or damaged");
    }
    start.resize(found);
    return {.text = std::move(start), .end = found + mark.size()};
}

std::vector<std::string_view> linesOf(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        lines.push_back(text.substr(0, end));
        text.remove_prefix(end);
        text.remove_prefix(text.starts_with("\r\n") ? 2 : std::min<std::size_t>(1, text.size()));
    }
    return lines;
}

HeaderFields::HeaderFields(std::string file, std::string location)
    : file_(std::move(file)), location_(std::move(location)) {}

void HeaderFields::add(std::string_view key, std::string_view value) {
    fields_.add(toUtf8(trimmed(key)), toUtf8(trimmed(value)));
}

const std::string* HeaderFields::find(const std::string& key) const& {
    const auto field = all().find(key);
    return field == all().end() ? nullptr : &field->second;
}

std::string HeaderFields::text(const std::string& key) const {
    const std::string* const value = find(key);
    return value == nullptr ? std::string() : *value;
}

const std::string& HeaderFields::required(const std::string& key) const& {
    const std::string* const value = find(key);
    if (value == nullptr) {
        throw InputError(file_, location_.empty() ? "header" : location_,
                         "it has no '" + key + "'");
    }
    return *value;
}

long long HeaderFields::integer(const std::string& key) const {
    const std::string& value = required(key);
    const std::optional<long long> number = parseInteger(value);
    if (!number) {
        fail(key, "expected a whole number, found '" + value + "'");
    }
    return *number;
}

std::optional<double> HeaderFields::number(const std::string& key) const {
    return text(key).empty() ? std::nullopt : std::optional(requiredNumber(key));
}

double HeaderFields::requiredNumber(const std::string& key) const {
    const std::string& value = required(key);
    const std::optional<double> number = parseNumber(value);
    if (!number) {
        fail(key, "expected a number, found '" + value + "'");
    }
    return *number;
}

void HeaderFields::fail(const std::string& key, const std::string& what) const {
    throw InputError(file_, location_.empty() ? key : location_ + " " + key, what);
}

HeaderSections sectionsOf(std::string_view text, char separator, const std::string& file) {
    HeaderSections sections;
    HeaderFields* current = nullptr;
    for (const std::string_view whole : linesOf(text)) {
        const std::string_view line = trimmed(whole);
        if (line.size() > 2 && line.starts_with('[') && line.ends_with(']')) {
            const std::string name = toUtf8(line.substr(1, line.size() - 2));
            current = &sections.try_emplace(name, file, "[" + name + "]").first->second;
            continue;
        }
        const std::size_t end = line.find(separator);
        if (current != nullptr && end != std::string_view::npos) {
            current->add(line.substr(0, end), line.substr(end + 1));
        }
    }
    return sections;
}

std::optional<double> parseLength(std::string_view text) {
    const std::optional<LeadingNumber> number = parseLeadingNumber(text);
    if (!number) {
        return std::nullopt;
    }
    const PhysicalUnit unit = parseLengthUnit(number->rest);
    return unit.base == "m" ? std::optional(number->value * unit.factor) : std::nullopt;
}

}  // namespace asperity
