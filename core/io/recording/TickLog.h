#pragma once

#include "core/haptics/HapticTick.h"
#include "core/haptics/VirtualRun.h"
#include "core/haptics/cycle/CurveBranch.h"
#include "core/io/tables/CsvTable.h"
#include "core/io/tables/CsvWriter.h"
#include "core/probe/MaterialMaps.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace asperity {

/// A table with one row a tick. The file grows in its place, so that a run which is cut off is
/// there up to its last flush.
class TickTable {
public:
    /// Hands all ticks so far to the system. @throw Error
    void flush() { csv_.flush(); }
    /// Waits until the disk holds what was flushed. @throw Error
    void sync() const { csv_.sync(); }
    /// Writes what is left. @throw Error
    void close() { csv_.close(); }

protected:
    TickTable(const std::filesystem::path& path, const char* what,
              const std::vector<std::string>& columns);

    CsvWriter csv_;
};

/// Writes force_log.csv: what a run did; `state`, `flags` and `branch` are words. A log begins on
/// the approach branch, wherever in a run it begins, so that its replay says the same.
class ForceLogWriter : public TickTable {
public:
    /// @param field of a sample that is not the same everywhere: columns of what it is made of at
    ///        the contact point are added; null: there are none
    /// @throw Error when the file is there or cannot be made
    explicit ForceLogWriter(const std::filesystem::path& path,
                            std::shared_ptr<const MaterialField> field = nullptr);
    void take(const TickSample& sample);

private:
    std::shared_ptr<const MaterialField> field_;
    BranchTracker branch_;
};

/// Writes tick_input.csv: all that a run depended on besides its scene.
class TickInputWriter : public TickTable {
public:
    /// @throw Error when the file is there or cannot be made
    explicit TickInputWriter(const std::filesystem::path& path);
    void take(const TickSample& sample);
};

/// The samples of a recorded run, bit for bit, with empty outputs. @throw InputError
[[nodiscard]] std::vector<TickSample> readTickInputs(const std::filesystem::path& path);
/// The same of a table that is read already. @throw InputError
[[nodiscard]] std::vector<TickSample> readTickInputs(const CsvTable& table);

/// Writes what the first tick of a recording starts from, so that it replays to the same bits.
/// @throw Error when it cannot be written
void writeTickMemory(const std::filesystem::path& path, const TickMemory& memory);

/// @throw InputError
[[nodiscard]] TickMemory readTickMemory(const std::filesystem::path& path);

}  // namespace asperity
