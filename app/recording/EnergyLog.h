#pragma once

#include "core/haptics/EnergyWatch.h"
#include "core/io/tables/CsvWriter.h"

#include <filesystem>
#include <optional>

namespace asperity {

/// Writes energy_log.csv: the trace of the passivity observer, one row a tick that a device with
/// motors drove the tip. Without such a tick there is no file.
class EnergyLog {
public:
    /// @param timeStep from tick to tick [s]
    /// @param delay    of the device [s]
    EnergyLog(std::filesystem::path path, double timeStep, double delay);

    /// @throw Error when the file is there or cannot be made
    void take(const TickSample& sample);
    /// Hands all rows so far to the system. @throw Error
    void flush();
    /// Waits until the disk holds what was flushed. @throw Error
    void sync() const;

private:
    std::filesystem::path path_;
    EnergyWatch watch_;
    std::optional<CsvWriter> csv_;  ///< of a GrowingFile; none before the first row
};

}  // namespace asperity
