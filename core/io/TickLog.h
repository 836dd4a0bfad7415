#pragma once

#include "core/haptics/VirtualRun.h"
#include "core/io/CsvWriter.h"

#include <filesystem>
#include <vector>

namespace asperity {

/// Writes force_log.csv: what a run did, one row a tick; `state` and `flags` are words.
class ForceLogWriter {
public:
    /// @throw Error when the file's folder cannot be written
    explicit ForceLogWriter(const std::filesystem::path& path);
    void take(const TickSample& sample);
    /// Puts the whole log in place. @throw Error
    void close() { csv_.close(); }

private:
    CsvWriter csv_;
};

/// Writes tick_input.csv: all that a run depended on besides its scene, one row a tick.
class TickInputWriter {
public:
    /// @throw Error when the file's folder cannot be written
    explicit TickInputWriter(const std::filesystem::path& path);
    void take(const TickSample& sample);
    /// Puts the whole log in place. @throw Error
    void close() { csv_.close(); }

private:
    CsvWriter csv_;
};

/// The samples of a recorded run, bit for bit, with empty outputs. @throw InputError
[[nodiscard]] std::vector<TickSample> readTickInputs(const std::filesystem::path& path);

}  // namespace asperity
