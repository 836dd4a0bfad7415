#pragma once

#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace asperity {

/// A file that holds the latest of many texts. A thread of its own writes it: who hands over a text
/// waits for no disk, and texts that come faster than the disk writes are left out. The file is
/// whole at any moment, after a power cut, too.
class LatestFile {
public:
    explicit LatestFile(std::filesystem::path path);
    /// The last text is written.
    ~LatestFile() = default;
    LatestFile(const LatestFile&) = delete;
    LatestFile& operator=(const LatestFile&) = delete;

    void write(std::string text);
    /// Why the last text could not be written, once; empty: it could.
    [[nodiscard]] std::string takeFailure();

private:
    void work(const std::stop_token& stop);

    std::filesystem::path path_;
    std::mutex mutex_;  ///< guards the rest
    std::condition_variable_any waiting_;
    std::optional<std::string> next_;  ///< to be written
    std::string failure_;
    std::jthread thread_;  ///< last: it uses all of the above
};

}  // namespace asperity
