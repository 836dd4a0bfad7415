#include "app/program/UserLibrary.h"

#include "app/program/DataFolder.h"
#include "core/Error.h"
#include "core/TemporaryFile.h"

#include <algorithm>
#include <cctype>
#include <system_error>

namespace asperity {

namespace {

constexpr const char* kExtension = ".toml";
constexpr std::size_t kLongestName = 80;  ///< [byte]

/// Letters of other scripts stay as they are, byte by byte.
bool isPlain(unsigned char letter) {
    return letter >= 0x80U || std::isalnum(letter) != 0 || letter == '-' || letter == '.';
}

}  // namespace

std::string fileNameFor(const std::string& name) {
    std::string file;
    bool isNamed = false;
    for (const char letter : name.substr(0, kLongestName)) {
        const auto byte = static_cast<unsigned char>(letter);
        isNamed = isNamed || byte >= 0x80U || std::isalnum(byte) != 0;
        file += isPlain(byte) ? static_cast<char>(std::tolower(byte)) : '_';
    }
    return isNamed ? file : std::string();
}

std::vector<UserLibrary::Entry> UserLibrary::entries() const {
    std::vector<Entry> entries;
    for (const std::filesystem::path& file : dataFiles(kind_)) {
        entries.push_back({.file = file, .own = false});
    }
    const auto shipped = static_cast<std::ptrdiff_t>(entries.size());
    std::error_code ignored;
    if (!folder_.empty()) {
        for (const auto& entry : std::filesystem::directory_iterator(folder_, ignored)) {
            if (entry.path().extension() == kExtension) {
                entries.push_back({.file = entry.path(), .own = true});
            }
        }
    }
    std::ranges::sort(entries.begin() + shipped, entries.end(), {}, &Entry::file);
    return entries;
}

std::filesystem::path UserLibrary::replacedBy(const std::string& name) const {
    const std::filesystem::path file = folder_ / (fileNameFor(name) + kExtension);
    return !folder_.empty() && std::filesystem::exists(file) ? file : std::filesystem::path();
}

std::filesystem::path UserLibrary::save(const std::string& name, const std::string& text) const {
    const std::string stem = fileNameFor(name);
    if (stem.empty()) {
        throw Error("“" + name + "” is no name: it needs a letter or a digit");
    }
    const bool isShipped = std::ranges::any_of(
        entries(), [&](const Entry& entry) { return !entry.own && entry.file.stem() == stem; });
    if (isShipped) {
        throw Error("“" + name +
                    "” comes with the program and stays as it is: choose another name");
    }
    if (folder_.empty()) {
        throw Error("There is no folder for files of your own on this system");
    }
    std::error_code failure;
    std::filesystem::create_directories(folder_, failure);
    if (failure) {
        throw FileError(folder_.string(), "the folder cannot be made: " + failure.message());
    }
    const std::filesystem::path file = folder_ / (stem + kExtension);
    OutputFile output(file);
    output.stream() << text;
    output.commit();
    return file;
}

void UserLibrary::remove(const Entry& entry) const {
    if (!entry.own) {
        throw Error(entry.file.stem().string() + " comes with the program and stays");
    }
    std::error_code failure;
    std::filesystem::remove(entry.file, failure);
    if (failure) {
        throw FileError(entry.file.string(), "cannot be deleted: " + failure.message());
    }
}

}  // namespace asperity
