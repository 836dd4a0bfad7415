#pragma once

#include "app/program/LoadedScene.h"
#include "app/window/SteadyForce.h"
#include "core/deformation/HalfSpaceModel.h"
#include "core/haptics/VirtualRun.h"

#include <deque>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

namespace asperity {

/// A recording that the window shows instead of the run: its scene, and its ticks up to the moment
/// that is shown.
class ShownRecording {
public:
    /// @param input its folder or bundle; empty: it is on no disk
    ShownRecording(std::shared_ptr<const LoadedScene> loaded, std::filesystem::path input,
                   const TickSample& first);

    [[nodiscard]] const std::shared_ptr<const LoadedScene>& loaded() const { return loaded_; }
    [[nodiscard]] const std::filesystem::path& input() const { return input_; }
    /// Returns the solver of its half-space; null: its scene does not ask for one.
    [[nodiscard]] HalfSpaceWorker* halfSpace() const { return halfSpace_.get(); }

    /// Shows the last one of these ticks. @param goesOn they follow those before
    void take(std::span<const TickSample> ticks, bool goesOn);
    /// Sets how fast it plays: then the force is the steady one, a mean of a tenth of a second of
    /// the viewer's time. @param speed recorded seconds a second; 0: it rests
    void setPlaying(double speed);
    /// Returns the tick that is shown, with the timing of the live loop.
    [[nodiscard]] const Snapshot& snapshot(const LoopStatistics& live);
    /// Returns the last seconds up to that tick, in order.
    [[nodiscard]] std::vector<TickSample> ticks() const { return {ticks_.begin(), ticks_.end()}; }

private:
    std::shared_ptr<const LoadedScene> loaded_;
    std::filesystem::path input_;
    std::unique_ptr<HalfSpaceWorker> halfSpace_;
    std::deque<TickSample> ticks_;
    SteadyForce steady_;
    bool isPlaying_ = false;
    Snapshot snapshot_;
};

}  // namespace asperity
