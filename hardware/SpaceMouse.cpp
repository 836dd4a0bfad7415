#include "hardware/SpaceMouse.h"

#include "hardware/DeviceRegistry.h"

#include <array>
#include <cmath>
#include <csignal>
#include <utility>

namespace asperity {

namespace {

using std::chrono::milliseconds;

constexpr milliseconds kReadPatience{20};   // how long a stop may have to wait
constexpr milliseconds kSearchPeriod{500};  // between two looks for the device
constexpr std::size_t kLongestReport = 64;  // of a full-speed USB device [byte]
constexpr int kKernelQueue = 63;            // reports that the kernel keeps; it drops later ones

constexpr double kDeadZone = 0.05;    // a knob let go does not always rest at zero
constexpr double kGentleSlope = 0.2;  // speed per deflection where it begins

/// Speed, as a share of the full one, for the deflection of one axis. It grows with the cube, so
/// that a light touch places the tip to the nanometre; axis by axis, so that a push straight down
/// stays one.
double speedShare(double deflection) noexcept {
    const double magnitude = std::abs(deflection);
    if (!(magnitude > kDeadZone)) {
        return 0.0;
    }
    const double push = (magnitude - kDeadZone) / (1.0 - kDeadZone);
    const double share = push * (kGentleSlope + (1.0 - kGentleSlope) * push * push);
    return std::copysign(share, deflection);
}

/// The light of the device, on while it is followed. Models without one refuse the report.
class Light {
public:
    explicit Light(HidConnection& device) : device_(device) { set(true); }
    ~Light() { set(false); }
    Light(const Light&) = delete;
    Light& operator=(const Light&) = delete;

private:
    void set(bool on) {
        const std::array<std::uint8_t, 2> report = {0x04, static_cast<std::uint8_t>(on ? 1 : 0)};
        device_.write(report);
    }

    HidConnection& device_;
};

/// The state after all reports that wait, or nothing when the device is lost.
std::optional<SpaceMouseState> drain(HidConnection& device, SpaceMouseState state) {
    std::array<std::uint8_t, kLongestReport> report{};
    milliseconds patience = kReadPatience;
    for (int count = 0; count < kKernelQueue; ++count) {
        const std::optional<std::size_t> size = device.read(report, patience);
        if (!size) {
            return std::nullopt;
        }
        if (*size == 0) {
            return state;
        }
        state = afterReport(state, std::span(report).first(*size));
        patience = milliseconds(0);
    }
    // The queue was full, so the newest reports are gone, perhaps the one that the knob was let go.
    return SpaceMouseState{.buttons = state.buttons};
}

/// A signal would interrupt the wait for a report and look like a lost device.
void leaveSignalsToOtherThreads() {
    sigset_t all{};
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
}

}  // namespace

SpaceMouse::SpaceMouse(HidTransport& transport, Vector3 start, double fullSpeed)
    : transport_(transport)
    , position_(std::move(start))
    , fullSpeed_(fullSpeed)
    , device_(find())
    , reading_(Reading{.connected = device_ != nullptr})
    , thread_([this](const std::stop_token& stop) { run(stop); }) {}

SpaceMouse::~SpaceMouse() = default;

HandState SpaceMouse::advance(double timeStep) noexcept {
    const Reading& reading = reading_.read();
    const double step = fullSpeed_.load(std::memory_order_relaxed) * timeStep;
    position_ += step * reading.state.translation.unaryExpr(&speedShare);
    return {
        .position = position_, .buttons = reading.state.buttons, .connected = reading.connected};
}

std::string SpaceMouse::status() const {
    const std::lock_guard lock(mutex_);
    return status_;
}

void SpaceMouse::setStatus(std::string status) {
    const std::lock_guard lock(mutex_);
    status_ = std::move(status);
}

/// The first SpaceMouse that can be opened, or none.
std::unique_ptr<HidConnection> SpaceMouse::find() {
    std::string problem = "no SpaceMouse is plugged in";
    try {
        for (const DeviceDescription& found : listDevices(transport_)) {
            if (found.driver == kSpaceMouseDriver && found.usable()) {
                std::unique_ptr<HidConnection> device = transport_.open(found.path);
                setStatus(found.name + " at " + found.path);
                return device;
            }
            if (found.driver == kSpaceMouseDriver) {
                problem = found.path + ": " + found.obstacle;
            }
        }
    } catch (const std::exception& error) {
        problem = error.what();
    }
    setStatus(problem);
    return nullptr;
}

void SpaceMouse::run(const std::stop_token& stop) {
    leaveSignalsToOtherThreads();
    while (!stop.stop_requested()) {
        if (device_) {
            follow(*device_, stop);
            device_.reset();
        }
        if (pauseUnlessStopped(stop)) {
            device_ = find();
        }
    }
}

/// Publishes what the device says until it is lost or the hand is done with it.
void SpaceMouse::follow(HidConnection& device, const std::stop_token& stop) {
    const Light light(device);
    Reading reading = {.connected = true};
    while (!stop.stop_requested()) {
        const std::optional<SpaceMouseState> state = drain(device, reading.state);
        if (!state) {
            reading_.write({});
            setStatus("the SpaceMouse was unplugged");
            return;
        }
        reading.state = *state;
        reading_.write(reading);
    }
}

/// @return false when the hand is done with
bool SpaceMouse::pauseUnlessStopped(const std::stop_token& stop) {
    std::unique_lock lock(mutex_);
    wakeUp_.wait_for(lock, stop, kSearchPeriod, [] { return false; });
    return !stop.stop_requested();
}

}  // namespace asperity
