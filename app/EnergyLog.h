#pragma once

#include "core/haptics/EnergyWatch.h"
#include "core/io/CsvWriter.h"

#include <filesystem>

namespace asperity {

/// Writes energy_log.csv: the trace of the passivity observer, one row a tick that a hand with
/// motors led. Without such a tick there is no file.
class EnergyLog {
public:
    /// @param timeStep from tick to tick [s]
    /// @param delay    of the hand's device [s]
    /// @throw Error when the file's folder cannot be written
    EnergyLog(const std::filesystem::path& path, double timeStep, double delay);

    void take(const TickSample& sample);
    /// Puts the whole log in place. @throw Error
    void close();

private:
    EnergyWatch watch_;
    CsvWriter csv_;
    bool empty_ = true;
};

}  // namespace asperity
