#pragma once

#include "core/haptics/VirtualRun.h"
#include "core/io/tables/CsvTable.h"
#include "core/io/tables/CsvWriter.h"

#include <filesystem>
#include <vector>

namespace asperity {

/// Writes force_log.csv: what a run did, one row a tick; `state` and `flags` are words. The file
/// grows in its place, so that a run which is cut off is there up to its last flush.
class ForceLogWriter {
public:
    /// @throw Error when the file is there or cannot be made
    explicit ForceLogWriter(const std::filesystem::path& path);
    void take(const TickSample& sample);
    /// Hands all ticks so far to the system. @throw Error
    void flush() { csv_.flush(); }
    /// Waits until the disk holds what was flushed. @throw Error
    void sync() const { csv_.sync(); }
    /// Writes what is left. @throw Error
    void close() { csv_.close(); }

private:
    CsvWriter csv_;
};

/// Writes tick_input.csv: all that a run depended on besides its scene, one row a tick. It grows as
/// force_log.csv does.
class TickInputWriter {
public:
    /// @throw Error when the file is there or cannot be made
    explicit TickInputWriter(const std::filesystem::path& path);
    void take(const TickSample& sample);
    /// Hands all ticks so far to the system. @throw Error
    void flush() { csv_.flush(); }
    /// Waits until the disk holds what was flushed. @throw Error
    void sync() const { csv_.sync(); }
    /// Writes what is left. @throw Error
    void close() { csv_.close(); }

private:
    CsvWriter csv_;
};

/// The samples of a recorded run, bit for bit, with empty outputs. @throw InputError
[[nodiscard]] std::vector<TickSample> readTickInputs(const std::filesystem::path& path);
/// The same of a table that is read already. @throw InputError
[[nodiscard]] std::vector<TickSample> readTickInputs(const CsvTable& table);

}  // namespace asperity
