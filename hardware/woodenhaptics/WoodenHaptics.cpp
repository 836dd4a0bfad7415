#include "hardware/woodenhaptics/WoodenHaptics.h"

#include "core/io/scene/DeviceFiles.h"
#include "core/realtime/PacedThread.h"
#include "hardware/hid/HidapiTransport.h"

#include <utility>

namespace asperity {

namespace {

using std::chrono::milliseconds;

constexpr milliseconds kAnswerPatience{10};  // the board speaks when spoken to: then ask it again
constexpr int kOldReadings = 3;        // may be in transfer when it is calibrated, and one more
constexpr double kFirstReading = 0.2;  // how long the beginning waits for it [s]
constexpr double kNever = 0.0;         // no reading: longer ago than any force lasts [s]
constexpr double kForceLasts = 40e-3;  // after the reading that it answers [s]

/// Switches the force off in the end, however that comes about.
class MotorsOff {
public:
    MotorsOff(HidConnection& device, WoodenHapticsBoard board) : device_(device), board_(board) {}
    ~MotorsOff() { device_.write(currentsMessage(board_, Vector3::Zero()).report()); }
    MotorsOff(const MotorsOff&) = delete;
    MotorsOff& operator=(const MotorsOff&) = delete;

private:
    HidConnection& device_;
    WoodenHapticsBoard board_;
};

constexpr HidUsage kTeensySerialPort = {.page = 0xFFC9, .id = 0x04};

}  // namespace

WoodenHaptics::WoodenHaptics(HidTransport& transport, WoodenHapticsDescription description)
    : description_(std::move(description))
    , latest_{.time = monotonicSeconds()}
    , reading_(latest_)
    , follower_(transport, isWoodenHaptics, woodenHapticsDriver().label) {
    const bool expected = follower_.hasDevice();
    follower_.start(
        [this](const FoundDevice& found, const std::stop_token& stop) { follow(found, stop); });
    if (expected) {
        awaitFirstReading();
    }
}

WoodenHaptics::~WoodenHaptics() = default;

void WoodenHaptics::awaitFirstReading() const {
    const double end = monotonicSeconds() + kFirstReading;
    while (!awaitsCalibration_ && monotonicSeconds() < end) {
        std::this_thread::sleep_for(milliseconds(1));
    }
}

DeviceStatus WoodenHaptics::status() const {
    DeviceStatus status = follower_.status();
    status.calibrated = !awaitsCalibration_;
    return status;
}

DeviceState WoodenHaptics::advance(double /*timeStep*/) noexcept {
    const Reading& reading = reading_.read();
    taken_ = reading.connected ? reading.time : kNever;
    return {.position = reading.position,
            .buttons = reading.button ? 1U : 0U,
            .connected = reading.connected,
            .age = monotonicSeconds() - reading.time};
}

void WoodenHaptics::setForce(const Vector3& force) noexcept {
    order_.write({.force = force, .answers = taken_});
}

/// Exchanges reports with the device until it is lost or no longer wanted.
void WoodenHaptics::follow(const FoundDevice& found, const std::stop_token& stop) {
    const auto& [description, connection] = found;
    Link link = {.device = *connection,
                 .board = *woodenHapticsBoard(description.vendorId, description.productId)};
    const MotorsOff atTheEnd(link.device, link.board);
    calibrationWanted_.store(false, std::memory_order_relaxed);  // of a device that was lost
    while (!stop.stop_requested() && listen(link) && answer(link)) {
    }
    awaitsCalibration_ = false;
    latest_.connected = false;
    latest_.button = false;
    reading_.write(latest_);
}

/// Publishes the newest reading, if there is a new one. @return false when the device is lost
bool WoodenHaptics::listen(Link& link) {
    std::optional<WoodenHapticsReading> newest;
    const Drained drained =
        drainReports(link.device, kAnswerPatience, [&](std::span<const std::uint8_t> report) {
            if (const auto reading = readingOf(link.board, report)) {
                newest = reading;
            }
        });
    if (drained == Drained::All && newest) {
        link.angles = jointAngles(description_, newest->counts);
        if (link.uncounted) {
            link.uncounted = std::max(0, *link.uncounted - 1);
        }
        awaitsCalibration_ = !link.uncounted;
        latest_ = {.position = inLabFrame(handlePosition(description_, *link.angles)),
                   .button = newest->button,
                   .connected = link.calibrated(),
                   .time = monotonicSeconds()};
        reading_.write(latest_);
    }
    return drained != Drained::Lost;
}

/// Returns whether the order may move the motors: it answers a young reading. One from before the
/// device was lost is too old, for it is looked for half a second later.
bool WoodenHaptics::isLive(const Link& link, const Order& order) {
    return link.calibrated() && monotonicSeconds() - order.answers <= kForceLasts;
}

/// @return false when the device is lost
bool WoodenHaptics::answer(Link& link) {
    const Order order = order_.read();
    const bool live = isLive(link, order);
    const Vector3 force = live ? order.force : Vector3(Vector3::Zero());
    if (!link.device.write(nextMessage(link, force).report())) {
        return false;
    }
    if (live) {
        noteDelay(order);
    }
    return true;
}

WoodenHapticsMessage WoodenHaptics::nextMessage(Link& link, const Vector3& force) {
    if (!link.angles) {
        return currentsMessage(link.board, Vector3::Zero());
    }
    if (calibrationWanted_.exchange(false, std::memory_order_relaxed)) {
        link.uncounted = kOldReadings;
        const auto& [a, b, c] = description_.joints;
        return encodersMessage(link.board, {a.restCounts, b.restCounts, c.restCounts});
    }
    const Vector3 torques = jointTorques(description_, *link.angles, inDeviceFrame(force));
    return currentsMessage(link.board, motorCurrents(description_, torques));
}

/// A force that is written again adds nothing.
void WoodenHaptics::noteDelay(const Order& order) {
    if (order.answers <= answered_) {
        return;
    }
    answered_ = order.answers;
    const double now = monotonicSeconds();
    delays_.add(now - order.answers, now);
    delay_.store(delays_.value(), std::memory_order_relaxed);
}

bool isWoodenHaptics(const HidDeviceInfo& device) {
    return woodenHapticsBoard(device.vendorId, device.productId) &&
           !device.hasCollection(kTeensySerialPort);
}

const DeviceDriver& woodenHapticsDriver() {
    static const DeviceDriver driver{
        .key = "WoodenHaptics",
        .label = "WoodenHaptics",
        .senses = {"x", "y", "z", "buttons"},
        .rendersForce = true,
        .list = [](const DeviceSite& site) { return listHid(site, isWoodenHaptics); },
        .open = [](const DeviceSite& site) -> std::unique_ptr<HapticDevice> {
            return std::make_unique<WoodenHaptics>(
                site.hid(), readWoodenHaptics(site.data / "devices" / "woodenhaptics_2015.toml"));
        }};
    return driver;
}

}  // namespace asperity
