#pragma once

#include "app/program/LoadedScene.h"
#include "core/deformation/HalfSpaceModel.h"
#include "core/haptics/EnergyWatch.h"
#include "core/haptics/HapticLoop.h"
#include "core/haptics/blackbox/BlackBox.h"
#include "core/haptics/coupling/CouplingKeeper.h"

#include <functional>
#include <memory>

namespace asperity {

/// Processor time to fetch ticks from the loop into the black box and to the caller.
struct FetchCost {
    double time = 0.0;  ///< of all [s]
    long ticks = 0;

    [[nodiscard]] double perTick() const noexcept {
        return ticks == 0 ? 0.0 : time / static_cast<double>(ticks);
    }
};

/// A scene with its instrument, its device and its loop: everything that lives and ends together.
class LiveRun {
public:
    /// The instrument of a run; the scene outlives it.
    using MakeInstrument = std::function<std::unique_ptr<AfmController>(const Scene& scene)>;

    /// @param start position of the base at first [m]
    LiveRun(LoadedScene loaded, const Vector3& start,
            const MakeInstrument& makeInstrument = instrumentOf);

    [[nodiscard]] const LoadedScene& loaded() const noexcept { return *loaded_; }
    /// The same, for who works with it beside the run, and after its end.
    [[nodiscard]] std::shared_ptr<const LoadedScene> shared() const noexcept { return loaded_; }
    [[nodiscard]] const Scene& scene() const noexcept { return loaded_->scene; }
    [[nodiscard]] HapticLoop& loop() noexcept { return loop_; }
    /// Passes all ticks since the last call to `sink`, in order, and to the black box and the
    /// energy monitor.
    void fetch(const TickSink& sink);
    /// Returns the cost of all calls of fetch() so far.
    [[nodiscard]] const FetchCost& fetchCost() const noexcept { return fetchCost_; }
    /// The last seconds, for when a fault comes.
    [[nodiscard]] BlackBox& blackBox() noexcept { return blackBox_; }
    /// Supervises a force-feedback device.
    [[nodiscard]] const EnergyWatch& energy() const noexcept { return energy_; }
    /// Returns the solver of the half-space beside the loop; null: the scene does not ask for it.
    [[nodiscard]] HalfSpaceWorker* halfSpace() noexcept { return halfSpace_.get(); }

    /// The knobs as they are now; they begin as the scene says.
    [[nodiscard]] const Settings& settings() const noexcept { return settings_; }
    /// @throw Error where the device has motors and could not be held so; nothing has changed then
    void setSettings(const Settings& settings);
    /// The knobs with the gains of devices that only sense.
    [[nodiscard]] Settings sensingSettings() const;

    using MakeDevice = std::function<std::unique_ptr<HapticDevice>()>;
    /// Another device takes over; one with motors gets a coupling and a scale that hold, and when
    /// it ends the earlier gains return. `make` is called while the loop rests, with the gains of
    /// devices that only sense: what it reads of the present device and base is exact.
    /// @throw what `make` throws, or Error where no scale holds; the present device stays then
    void takeDevice(const MakeDevice& make);
    [[nodiscard]] HapticDevice& device() noexcept { return *device_; }
    /// Returns whether the device was chosen before it was there: its absence is no accident.
    [[nodiscard]] bool awaitsDevice() const noexcept { return awaited_; }
    /// Returns the supervisor of a force-feedback device's coupling.
    [[nodiscard]] const CouplingKeeper& coupling() const noexcept { return coupling_; }
    /// Makes sure that a force-feedback device could hold the tip of this scene. @throw Error why
    /// not
    void requireHolding(const SceneDescription& scene) const;
    /// Once a frame: has the gains follow the device's delay. @return whether knobs changed
    bool followDelay();
    /// Returns the position of the device in its own frame [m].
    [[nodiscard]] Vector3 devicePosition() noexcept;
    /// Returns the position of the base [m].
    [[nodiscard]] Vector3 basePosition() noexcept;

    /// Gives the scene what can change while it is in use, see SceneChange::Shown.
    void adopt(const SceneDescription& description);
    /// Returns whether the model can be replaced unnoticed: the tip is out of the sample's reach,
    /// the black box is not frozen, and nothing else uses the scene.
    [[nodiscard]] bool mayAdoptModel() noexcept;
    /// Gives the scene the model that was found for it beside the run. The tip may adopt one, the
    /// loop is stopped and all its ticks are fetched.
    void adoptModel(const LoadedScene& fitted);

private:
    void apply(const Settings& settings) noexcept;
    void seat(std::unique_ptr<HapticDevice> device);
    void keep(const TickSample& sample);
    [[nodiscard]] EnergyWatch newEnergyWatch() const;

    std::shared_ptr<LoadedScene> loaded_;
    CouplingKeeper coupling_;
    Vector3 start_;  ///< of the base [m]
    Settings settings_;
    std::unique_ptr<AfmController> instrument_;
    std::unique_ptr<HapticDevice> device_;
    std::unique_ptr<HalfSpaceWorker> halfSpace_;
    HapticLoop loop_;
    BlackBox blackBox_;
    bool awaited_ = false;            ///< see awaitsDevice()
    std::uint32_t startsBefore_ = 0;  ///< of the loop, before the device got it
    FetchCost fetchCost_;
    EnergyWatch energy_;
};

/// Returns a solver of the half-space beside the loop; null: the scene does not ask for it.
/// @param scene outlives it
[[nodiscard]] std::unique_ptr<HalfSpaceWorker> newHalfSpace(const Scene& scene);

/// Above the sample, where it holds data, as near to the middle of the scan as can be [m].
[[nodiscard]] Vector3 startPosition(const Scene& scene);

}  // namespace asperity
