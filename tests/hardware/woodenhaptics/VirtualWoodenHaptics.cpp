#include "tests/hardware/woodenhaptics/VirtualWoodenHaptics.h"

#include "core/realtime/PacedThread.h"
#include "tests/hardware/woodenhaptics/ArmPose.h"

#include <algorithm>
#include <cmath>

namespace asperity::test {

namespace {

using std::chrono::milliseconds;

constexpr double kTimeOut = 0.5;           // of the firmware without a message [s]
constexpr double kDeviceStep = 0.1e-3;     // of the handle in a millisecond [m]
constexpr std::size_t kReportSize = 64;    // [byte]
constexpr std::size_t kCurrentsBegin = 1;  // in a message: after the report id
constexpr std::size_t kCurrentsEnd = 7;

// 64 bytes in, 64 bytes out, for what the vendor likes.
const std::vector<std::uint8_t> kReportDescriptor = {
    0x06, 0xAB, 0xFF, 0x0A, 0x00, 0x02, 0xA1, 0x01, 0x75, 0x08, 0x15, 0x00, 0x26, 0xFF,
    0x00, 0x95, 0x40, 0x09, 0x01, 0x81, 0x02, 0x95, 0x40, 0x09, 0x02, 0x91, 0x02, 0xC0};

}  // namespace

VirtualWoodenHaptics::VirtualWoodenHaptics(const Vector3& handle)
    : hid_({.vendorId = 0x16c0,
            .productId = 0x0486,
            .manufacturer = "Teensyduino",
            .product = "WoodenHaptics",
            .reportDescriptor = kReportDescriptor})
    , handle_(handle) {
    hold(handle);
    firmware_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

void VirtualWoodenHaptics::hold(const Vector3& handle) {
    const EncoderCounts counts = countsAt(handle);
    const std::lock_guard lock(mutex_);
    counts_ = counts;
}

void VirtualWoodenHaptics::moveTo(const Vector3& handle) {
    const Vector3 from = handle_;
    const double steps = std::ceil((handle - from).norm() / kDeviceStep);
    for (double step = 1.0; step <= steps; ++step) {
        hold(from + (step / steps) * (handle - from));
        std::this_thread::sleep_for(milliseconds(1));
    }
    handle_ = handle;
}

std::vector<MotorEvent> VirtualWoodenHaptics::events() const {
    const std::lock_guard lock(mutex_);
    return events_;
}

void VirtualWoodenHaptics::run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        for (const VirtualHid::Report& message : hid_.takeWritten()) {
            obey(message);
            hid_.send({reading()});
        }
        if (enabled_ && monotonicSeconds() - lastMessage_ > kTimeOut) {
            enabled_ = false;
            const std::lock_guard lock(mutex_);
            events_.push_back(MotorEvent::Cut);
        }
        std::this_thread::sleep_for(milliseconds(1));
    }
}

void VirtualWoodenHaptics::obey(const VirtualHid::Report& message) {
    enabled_ = true;
    lastMessage_ = monotonicSeconds();
    const bool drives =
        std::any_of(message.begin() + kCurrentsBegin, message.begin() + kCurrentsEnd,
                    [](std::uint8_t byte) { return byte != 0; });
    const std::lock_guard lock(mutex_);
    events_.push_back(drives ? MotorEvent::Drive : MotorEvent::Zero);
}

VirtualHid::Report VirtualWoodenHaptics::reading() const {
    VirtualHid::Report report;
    const std::lock_guard lock(mutex_);
    for (const std::int16_t count : counts_) {
        const auto bits = static_cast<unsigned>(static_cast<std::uint16_t>(count));
        report.push_back(static_cast<std::uint8_t>(bits & 0xFFU));
        report.push_back(static_cast<std::uint8_t>(bits >> 8U));
    }
    report.resize(kReportSize, 0);
    return report;
}

}  // namespace asperity::test
