#pragma once

#include "app/recording/RecordedRun.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace asperity {

/// The inputs of a recorded run, closely packed: an hour at 1 kHz takes about 0.5 GB.
class RunInputs {
public:
    /// @param memory what the first tick starts from
    explicit RunInputs(TickMemory memory) : memory_(std::move(memory)) {}

    void add(const TickSample& sample);
    /// Only the first ones stay.
    void shorten(std::size_t size);

    [[nodiscard]] std::size_t size() const noexcept { return inputs_.size(); }
    [[nodiscard]] const TickMemory& memory() const noexcept { return memory_; }
    [[nodiscard]] double time(std::size_t tick) const { return inputs_.at(tick).time; }  ///< [s]
    [[nodiscard]] TickInput input(std::size_t tick) const;
    /// The first tick that begins after this time [s]; size(): none does.
    [[nodiscard]] std::size_t firstAfter(double time) const;
    [[nodiscard]] double shortestStep() const noexcept { return shortestStep_; }  ///< [s]

private:
    /// Of one tick; the settings, which seldom change, are kept once.
    struct Input {
        double time = 0.0;
        DeviceState device;
        AfmMeasurement measurement;
        double timeStep = 0.0;
        std::uint32_t starts = 0;
        std::uint32_t settings = 0;  ///< which of settings_
    };

    TickMemory memory_;
    std::vector<Input> inputs_;
    std::vector<Settings> settings_;
    double shortestStep_ = 0.0;
};

/// The folder of a run without what it did: that can be computed again.
struct RunOnDisk {
    RunState state = RunState::Complete;
    std::string sha256;  ///< of the scan that it was made on
    RunInputs inputs;
};

/// Reads the inputs a piece at a time; of a run that is not complete, as many ticks as readRun().
/// @throw InputError as readRun()
[[nodiscard]] RunOnDisk readRunInputs(const std::filesystem::path& folder);

}  // namespace asperity
