#include "app/program/DataFolder.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>

namespace asperity {

namespace {

bool isDataFolder(const std::filesystem::path& folder) {
    std::error_code ignored;
    return std::filesystem::is_directory(folder / "materials", ignored);
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
        for (const char* place : {"data", "share/asperity/data"}) {
            if (isDataFolder(folder / place)) {
                return folder / place;
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

std::filesystem::path defaultSceneFile() {
    const std::filesystem::path file = dataFolder() / "scenes" / "granular_film.toml";
    std::error_code ignored;
    return std::filesystem::exists(file, ignored) ? file : std::filesystem::path();
}

}  // namespace asperity
