#pragma once

#include "core/EnumTable.h"
#include "core/Vector.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <toml++/toml.h>
#include <vector>

namespace asperity {

/// Parses a TOML file; renamed keys get their current names, see kFormerKeys.
/// @throw InputError with the line of the first mistake
[[nodiscard]] toml::table readToml(const std::filesystem::path& path);

/// A table as text, below notes as comments, a line each.
[[nodiscard]] std::string commented(const toml::table& table, const std::string& notes);

/// The comments that a file begins with, a line each. @throw FileError
[[nodiscard]] std::string notesOf(const std::filesystem::path& file);

/// One section of a TOML file, read key by key; what is left unread at the end was not known.
class TomlSection {
public:
    /// The named section of `root` (which may be missing), or the root itself when `name` is empty.
    TomlSection(const toml::table& root, std::filesystem::path file, std::string name);

    [[nodiscard]] bool has(const std::string& key) const;
    [[nodiscard]] bool isText(const std::string& key) const;
    [[nodiscard]] double number(const std::string& key, double otherwise);
    [[nodiscard]] std::uint64_t count(const std::string& key, std::uint64_t otherwise);
    [[nodiscard]] bool flag(const std::string& key, bool otherwise);
    [[nodiscard]] std::string text(const std::string& key, const std::string& otherwise);
    /// A text or a list of texts; none where the key is absent.
    [[nodiscard]] std::optional<std::vector<std::string>> texts(const std::string& key);
    /// Positions [[x, y], ...]; empty where the key is absent.
    [[nodiscard]] std::vector<Vector2> positions(const std::string& key);
    /// Whole numbers, written [1, 2, 3]; empty where there are none.
    [[nodiscard]] std::vector<std::int64_t> integers(const std::string& key);
    /// A table within the section, read as a section of its own, named [section.key] in messages;
    /// none where there is no such key.
    [[nodiscard]] std::optional<TomlSection> table(const std::string& key);
    /// A path as pathText() writes it, resolved against the folder of the file.
    [[nodiscard]] std::filesystem::path path(const std::string& key);

    /// Leaves a key that somebody else reads.
    void allow(const std::string& key) { known_.insert(key); }
    /// @throw InputError naming the first key that nobody asked for
    void refuseUnknownKeys() const;
    /// @throw InputError about the value of `key`: what was expected there
    [[noreturn]] void refuse(const std::string& key, const std::string& expected) const;
    /// @throw InputError about the value of `key`: what is wrong, in words of the caller
    [[noreturn]] void complain(const std::string& key, const std::string& wrong) const;

private:
    const toml::node* find(const std::string& key);
    [[nodiscard]] std::string location(const std::string& key) const;

    const toml::table* table_ = nullptr;
    std::filesystem::path file_;
    std::string name_;
    std::set<std::string> known_;
};

/// @throw InputError naming what is known
[[noreturn]] inline void refuseChoice(TomlSection& section, const std::string& key,
                                      const std::string& known) {
    section.refuse(key, "one of " + known + ", not '" + section.text(key, "") + "'");
}

/// @throw InputError when the section names another value than those of its table
template <class Value>
Value choice(TomlSection& section, const std::string& key, Value otherwise) {
    const auto value = fromKey<Value>(section.text(key, keyOf(otherwise)));
    if (!value) {
        refuseChoice(section, key, keyList<Value>());
    }
    return *value;
}

}  // namespace asperity
