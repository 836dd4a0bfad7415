#include "app/program/DataFolder.h"

#include "core/Error.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <system_error>

namespace asperity {

namespace {

bool isDataFolder(const std::filesystem::path& folder) {
    std::error_code ignored;
    return std::filesystem::is_directory(folder / "materials", ignored);
}

std::filesystem::path shippedScene(const char* name) {
    const std::filesystem::path file = dataFolder() / "scenes" / name;
    std::error_code ignored;
    return std::filesystem::exists(file, ignored) ? file : std::filesystem::path();
}

constexpr const char* kVariable = "XDG_RUNTIME_DIR";

constexpr const char* kExtension = ".toml";
constexpr std::size_t kLongestName = 80;  ///< [byte]

/// Letters of other scripts stay as they are, byte by byte.
bool isPlain(unsigned char letter) {
    return letter >= 0x80U || std::isalnum(letter) != 0 || letter == '-' || letter == '.';
}

}  // namespace

std::filesystem::path dataFolder() {
    // NOLINTNEXTLINE(concurrency-mt-unsafe): nothing changes the environment after the start
    if (const char* named = std::getenv("ASPERITY_DATA"); named != nullptr && *named != '\0') {
        return named;
    }
    std::error_code failure;
    std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", failure);
    while (folder.has_relative_path()) {
        folder = folder.parent_path();
        for (const char* name : {"data", "share/asperity/data"}) {
            if (isDataFolder(folder / name)) {
                return folder / name;
            }
        }
    }
    return {};
}

std::vector<std::filesystem::path> dataFiles(const std::filesystem::path& kind) {
    std::vector<std::filesystem::path> files;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(dataFolder() / kind, ignored)) {
        if (entry.path().extension() == ".toml") {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

std::filesystem::path defaultSceneFile() { return shippedScene("granular_film.toml"); }

std::filesystem::path firstSceneFile() { return shippedScene("polystyrene.toml"); }

// NOLINTBEGIN(concurrency-mt-unsafe): the header says when

RuntimeFolder::RuntimeFolder() {
    const char* const given = std::getenv(kVariable);
    if (given != nullptr && *given != '\0') {
        return;
    }
    try {
        own_.emplace();
        setenv(kVariable, own_->path().c_str(), 1);
    } catch (const FileError&) {  // Qt can make none there either, and goes on without
    }
}

RuntimeFolder::~RuntimeFolder() {
    if (own_) {
        unsetenv(kVariable);
    }
}

// NOLINTEND(concurrency-mt-unsafe)

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
