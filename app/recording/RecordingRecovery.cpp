#include "app/recording/RecordingRecovery.h"

#include "app/program/JsonText.h"
#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "core/GrowingFile.h"
#include "core/TemporaryFile.h"
#include "core/Version.h"
#include "core/io/TextValue.h"
#include "core/io/tables/CsvTable.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <system_error>

namespace asperity {

namespace {

/// More than what tables may differ in when they are cut off.
constexpr off_t kTailBytes = off_t{64} << 20U;
constexpr double kNever = -std::numeric_limits<double>::infinity();

/// A row of a table that begins with its time.
struct Row {
    double time = kNever;  ///< [s]
    off_t end = 0;         ///< of its line in the file [byte]
};

/// The end of a table whose writing was cut off.
class TableEnd {
public:
    explicit TableEnd(const std::filesystem::path& path)
        : path_(path), file_(open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC)) {
        struct stat status {};
        if (!file_.isOpen() || fstat(file_.get(), &status) != 0) {
            fail();
        }
        begin_ = std::max<off_t>(status.st_size - kTailBytes, 0);
        tail_.resize(static_cast<std::size_t>(status.st_size - begin_));
        if (pread(file_.get(), tail_.data(), tail_.size(), begin_) !=
            static_cast<ssize_t>(tail_.size())) {
            fail();
        }
        tail_.resize(wholeLines(tail_).size());
    }

    /// @return false: a process still writes it
    [[nodiscard]] bool lock() const { return file_.lock() || errno != EWOULDBLOCK; }

    /// The last row that is not later; where there is none, the line of the columns' names. Lines
    /// that are neither are no rows. @throw Error where neither is near the end
    [[nodiscard]] Row lastUntil(double time) const {
        std::size_t end = tail_.size();
        while (end > 0) {
            const std::size_t start = end < 2 ? 0 : tail_.rfind('\n', end - 2) + 1;
            const std::string_view line = std::string_view(tail_).substr(start, end - start);
            const std::optional<double> found = parseNumber(line.substr(0, line.find(',')));
            const Row row{found.value_or(kNever), begin_ + static_cast<off_t>(end)};
            if ((found && *found <= time) || line.starts_with("time_s,")) {
                return row;
            }
            end = start;
        }
        throw Error(path_.string() + ": holds no row near its end");
    }

    void cutAfter(const Row& row) const {
        if (ftruncate(file_.get(), row.end) != 0 || fsync(file_.get()) != 0) {
            fail();
        }
    }

private:
    [[noreturn]] void fail() const {
        throw Error(path_.string() + ": " + std::generic_category().message(errno));
    }

    std::filesystem::path path_;
    FileDescriptor file_;
    off_t begin_ = 0;   ///< of the tail in the file [byte]
    std::string tail_;  ///< up to the last whole line
};

/// The time of the first row [s].
double firstTimeOf(const std::filesystem::path& table) {
    std::ifstream file(table);
    for (std::string line; std::getline(file, line);) {
        if (const auto time = parseNumber(std::string_view(line).substr(0, line.find(',')))) {
            return *time;
        }
    }
    return kNever;
}

/// Cuts all tables after the last tick that all of them hold.
/// @return its time; no number where there is none [s]
double cutTables(const std::filesystem::path& folder, const TableEnd& input) {
    const TableEnd log(folder / run_files::kLog);
    Row ofInput = input.lastUntil(std::numeric_limits<double>::infinity());
    const Row ofLog = log.lastUntil(ofInput.time);
    ofInput = input.lastUntil(ofLog.time);
    if (ofInput.time != ofLog.time) {
        throw Error(folder.string() + ": its tables have no tick in common at their ends");
    }
    input.cutAfter(ofInput);
    log.cutAfter(ofLog);
    const std::filesystem::path energy = folder / run_files::kEnergy;
    std::error_code unknown;
    if (std::filesystem::exists(energy, unknown)) {
        const TableEnd table(energy);
        table.cutAfter(table.lastUntil(ofInput.time));
    }
    return ofInput.time;
}

/// @return nothing where it was not cut off, or is still written
std::optional<RecoveredRecording> recovered(const std::filesystem::path& folder) {
    RecoveredRecording recording{.folder = folder};
    try {
        std::optional<RecordingManifest> manifest = readManifest(folder);
        if (!manifest || manifest->complete) {
            return std::nullopt;
        }
        const TableEnd input(folder / run_files::kInput);
        if (!input.lock()) {
            return std::nullopt;
        }
        manifest = readManifest(folder);  // it may have been finished before the lock
        if (!manifest || manifest->complete) {
            return std::nullopt;
        }
        const double last = cutTables(folder, input);
        recording.duration = last == kNever ? 0.0 : last - firstTimeOf(folder / run_files::kInput);
        manifest->complete = true;
        manifest->recovered = true;
        writeManifest(folder, *manifest);
    } catch (const std::exception& error) {
        recording.problem = error.what();
    }
    return recording;
}

constexpr const char* kRecordingFormat = "asperity recording";
constexpr int kRecordingVersion = 1;

double lengthIn(const nlohmann::json& input, const char* key, const std::filesystem::path& file) {
    const auto length = input.at(key).get<double>();
    if (!(length > 0.0)) {
        throw InputError(file.string(), std::string("input.") + key,
                         "expected the size of a scan in meters, above 0; the file is damaged");
    }
    return length;
}

std::optional<Vector2> sizeIn(const nlohmann::json& input, const std::filesystem::path& file) {
    if (!input.contains("size_x_m")) {
        return std::nullopt;
    }
    return Vector2(lengthIn(input, "size_x_m", file), lengthIn(input, "size_y_m", file));
}

}  // namespace

std::vector<RecoveredRecording> recoverRecordings(const std::filesystem::path& recordings) {
    std::vector<RecoveredRecording> found;
    std::error_code failure;
    std::filesystem::directory_iterator entry(recordings, failure);
    for (; !failure && entry != std::filesystem::directory_iterator(); entry.increment(failure)) {
        std::error_code unknown;
        if (entry->is_directory(unknown) && !entry->is_symlink(unknown)) {
            if (std::optional<RecoveredRecording> recording = recovered(entry->path())) {
                found.push_back(std::move(*recording));
            }
        }
    }
    return found;
}

void writeManifest(const std::filesystem::path& folder, const RecordingManifest& manifest) {
    nlohmann::ordered_json input{{"sha256", manifest.sha256}};
    if (manifest.size) {
        input["size_x_m"] = manifest.size->x();
        input["size_y_m"] = manifest.size->y();
    }
    const nlohmann::ordered_json json{
        {"format", kRecordingFormat},
        {"format_version", kRecordingVersion},
        {"versions", {{"asperity", kVersion}, {"compiler", __VERSION__}}},
        {"input", input},
        {"complete", manifest.complete},
        {"recovered", manifest.recovered}};
    constexpr int kIndent = 2;
    OutputFile file(folder / run_files::kManifest);
    file.stream() << json.dump(kIndent) << '\n';
    manifest.complete ? file.commitToDisk() : file.commit();
}

std::optional<RecordingManifest> readManifest(const std::filesystem::path& folder) {
    const std::filesystem::path path = folder / run_files::kManifest;
    std::error_code unknown;
    if (!std::filesystem::exists(path, unknown)) {
        return std::nullopt;
    }
    const nlohmann::json json = requiredJson(path);
    try {
        if (json.at("format") == kRecordingFormat &&
            json.at("format_version") == kRecordingVersion) {
            return RecordingManifest{.sha256 = json.at("input").at("sha256").get<std::string>(),
                                     .size = sizeIn(json.at("input"), path),
                                     .complete = json.at("complete").get<bool>(),
                                     .recovered = json.at("recovered").get<bool>()};
        }
    } catch (const nlohmann::json::exception&) {  // as of another version
    }
    throw InputError(path.string(), "", "expected the manifest of a recording, format version 1");
}

}  // namespace asperity
