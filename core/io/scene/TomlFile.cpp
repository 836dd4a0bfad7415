#include "core/io/scene/TomlFile.h"

#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/io/FileBytes.h"
#include "core/io/FormerKeys.h"
#include "core/io/NestedText.h"

#include <fstream>
#include <optional>
#include <sstream>
#include <utility>

namespace asperity {

namespace {

std::string lineOf(const toml::source_region& source) {
    return "line " + std::to_string(source.begin.line);
}

/// A file without a byte is a text, too.
std::string textOf(const std::filesystem::path& path) {
    std::error_code unknown;
    return std::filesystem::is_empty(path, unknown) ? std::string() : readFileBytes(path);
}

/// Gives renamed keys their current names, in the sections too; the lines of the file stay with the
/// values. A key that has both names is left as it is, to be refused as an unknown one.
void renameFormerKeys(toml::table& table) {
    for (const FormerKey& key : kFormerKeys) {
        toml::node* const node = table.get(key.former);
        if (node != nullptr && table.insert(key.current, std::move(*node)).second) {
            table.erase(key.former);
        }
    }
    for (auto&& [key, node] : table) {
        if (toml::table* const section = node.as_table()) {
            renameFormerKeys(*section);
        }
    }
}

}  // namespace

toml::table readToml(const std::filesystem::path& path) {
    if (!std::filesystem::is_regular_file(path)) {
        throw InputError(path.string(), "", "no such file");
    }
    const std::string text = textOf(path);
    requireParsable(text, NestedSyntax::Toml, path.string());
    try {
        toml::table table = toml::parse(text, path.string());
        renameFormerKeys(table);
        return table;
    } catch (const toml::parse_error& error) {
        throw InputError(path.string(), lineOf(error.source()), std::string(error.description()));
    }
}

std::string commented(const toml::table& table, const std::string& notes) {
    std::ostringstream text;
    std::istringstream lines(notes);
    for (std::string line; std::getline(lines, line);) {
        text << "# " << line << '\n';
    }
    text << table << '\n';
    return text.str();
}

std::string notesOf(const std::filesystem::path& file) {
    std::ifstream stream(file);
    if (!stream) {
        throw FileError(file.string(), "cannot be read");
    }
    std::string notes;
    for (std::string line; std::getline(stream, line) && line.starts_with('#');) {
        line.erase(0, line.starts_with("# ") ? 2 : 1);
        notes += (notes.empty() ? "" : "\n") + line;
    }
    return notes;
}

TomlSection::TomlSection(const toml::table& root, std::filesystem::path file, std::string name)
    : file_(std::move(file)), name_(std::move(name)) {
    if (name_.empty()) {
        table_ = &root;
    } else if (const toml::node* node = root.get(name_)) {
        table_ = node->as_table();
        if (table_ == nullptr) {
            throw InputError(file_.string(), lineOf(node->source()),
                             "'" + name_ + "' must be a section, written [" + name_ + "]");
        }
    }
}

bool TomlSection::has(const std::string& key) const {
    return table_ != nullptr && table_->contains(key);
}

bool TomlSection::isText(const std::string& key) const {
    return has(key) && table_->get(key)->is_string();
}

double TomlSection::number(const std::string& key, double otherwise) {
    const toml::node* node = find(key);
    if (node == nullptr) {
        return otherwise;
    }
    if (!node->is_number()) {
        refuse(key, "a number");
    }
    return *node->value<double>();
}

std::uint64_t TomlSection::count(const std::string& key, std::uint64_t otherwise) {
    const toml::node* node = find(key);
    if (node == nullptr) {
        return otherwise;
    }
    if (!node->is_integer() || *node->value<std::int64_t>() < 0) {
        refuse(key, "a whole number, zero or more");
    }
    return static_cast<std::uint64_t>(*node->value<std::int64_t>());
}

bool TomlSection::flag(const std::string& key, bool otherwise) {
    const toml::node* node = find(key);
    if (node == nullptr) {
        return otherwise;
    }
    if (!node->is_boolean()) {
        refuse(key, "true or false");
    }
    return *node->value<bool>();
}

std::string TomlSection::text(const std::string& key, const std::string& otherwise) {
    const toml::node* node = find(key);
    if (node == nullptr) {
        return otherwise;
    }
    if (!node->is_string()) {
        refuse(key, "a text in quotes");
    }
    return *node->value<std::string>();
}

std::optional<std::vector<std::string>> TomlSection::texts(const std::string& key) {
    const toml::node* node = find(key);
    if (node == nullptr) {
        return std::nullopt;
    }
    const toml::array* const list = node->as_array();
    if (list == nullptr) {
        if (!node->is_string()) {
            refuse(key, "a text in quotes, or a list of such texts");
        }
        return std::vector<std::string>{*node->value<std::string>()};
    }
    std::vector<std::string> texts;
    for (const toml::node& one : *list) {
        if (!one.is_string()) {
            refuse(key, "a text in quotes, or a list of such texts");
        }
        texts.push_back(*one.value<std::string>());
    }
    return texts;
}

std::vector<Vector2> TomlSection::positions(const std::string& key) {
    const toml::node* node = find(key);
    if (node == nullptr) {
        return {};
    }
    const std::string expected = "a list of points, each written [x, y]";
    if (!node->is_array()) {
        refuse(key, expected);
    }
    std::vector<Vector2> positions;
    for (const toml::node& one : *node->as_array()) {
        const toml::array* const pair = one.as_array();
        if (pair == nullptr || pair->size() != 2 || !pair->get(0)->is_number() ||
            !pair->get(1)->is_number()) {
            refuse(key, expected);
        }
        positions.emplace_back(*pair->get(0)->value<double>(), *pair->get(1)->value<double>());
    }
    return positions;
}

std::vector<std::int64_t> TomlSection::integers(const std::string& key) {
    const toml::node* node = find(key);
    std::vector<std::int64_t> numbers;
    if (node == nullptr) {
        return numbers;
    }
    if (!node->is_array()) {
        refuse(key, "whole numbers in brackets");
    }
    for (const toml::node& entry : *node->as_array()) {
        if (!entry.is_integer()) {
            refuse(key, "whole numbers in brackets");
        }
        numbers.push_back(*entry.value<std::int64_t>());
    }
    return numbers;
}

std::optional<TomlSection> TomlSection::table(const std::string& key) {
    const toml::node* node = find(key);
    if (node == nullptr) {
        return std::nullopt;
    }
    if (!node->is_table()) {
        refuse(key, "a table in braces");
    }
    TomlSection inner(*table_, file_, key);
    if (!name_.empty()) {
        inner.name_ = name_ + "." + key;
    }
    return inner;
}

std::filesystem::path TomlSection::path(const std::string& key) {
    const std::optional<std::filesystem::path> given = pathFromText(text(key, ""));
    if (!given) {
        refuse(key, "a path, or a file URI with two digits after each '%'");
    }
    return given->empty() ? *given : (file_.parent_path() / *given).lexically_normal();
}

void TomlSection::refuseUnknownKeys() const {
    if (table_ == nullptr) {
        return;
    }
    for (const auto& [key, node] : *table_) {
        if (!known_.contains(std::string(key.str()))) {
            throw InputError(file_.string(), lineOf(node.source()),
                             "unknown key '" + std::string(key.str()) + "'" +
                                 (name_.empty() ? "" : " in [" + name_ + "]"));
        }
    }
}

void TomlSection::refuse(const std::string& key, const std::string& expected) const {
    complain(key, "expected " + expected);
}

void TomlSection::complain(const std::string& key, const std::string& wrong) const {
    throw InputError(file_.string(), location(key), wrong);
}

const toml::node* TomlSection::find(const std::string& key) {
    known_.insert(key);
    return table_ == nullptr ? nullptr : table_->get(key);
}

std::string TomlSection::location(const std::string& key) const {
    const std::string name = (name_.empty() ? "" : "[" + name_ + "] ") + key;
    const toml::node* node = table_ == nullptr ? nullptr : table_->get(key);
    return node == nullptr ? name : lineOf(node->source()) + ", " + name;
}

}  // namespace asperity
