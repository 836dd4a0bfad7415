#pragma once

#include <filesystem>
#include <string>
#include <unistd.h>

namespace asperity {

/// A temporary folder, removed with all that is in it.
class BenchFolder {
public:
    BenchFolder() { std::filesystem::create_directory(path_); }
    BenchFolder(const BenchFolder&) = delete;
    BenchFolder& operator=(const BenchFolder&) = delete;
    ~BenchFolder() { std::filesystem::remove_all(path_); }

    [[nodiscard]] std::filesystem::path file(const char* name) const { return path_ / name; }

private:
    std::filesystem::path path_ =
        std::filesystem::temp_directory_path() / ("asperity_bench_" + std::to_string(getpid()));
};

/// For a shell.
inline std::string quoted(const std::filesystem::path& path) { return "'" + path.string() + "'"; }

}  // namespace asperity
