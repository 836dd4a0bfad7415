#include "tests/hardware/FakeHid.h"

#include "core/Error.h"

#include <algorithm>
#include <thread>

namespace asperity::test {

class FakeHid::Connection final : public HidConnection {
public:
    explicit Connection(FakeHid& hid) : hid_(hid), plugging_(hid.plugging_) { ++hid_.opened_; }
    ~Connection() override {
        const std::lock_guard lock(hid_.mutex_);
        --hid_.opened_;
    }
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    std::optional<std::size_t> read(std::span<std::uint8_t> report,
                                    std::chrono::milliseconds patience) override {
        std::unique_lock lock(hid_.mutex_);
        hid_.changed_.wait_for(lock, patience, [this] { return lost() || !hid_.reports_.empty(); });
        if (lost()) {
            return std::nullopt;
        }
        if (hid_.reports_.empty()) {
            return 0;
        }
        const Report oldest = hid_.reports_.front();
        hid_.reports_.pop_front();
        const std::size_t size = std::min(oldest.size(), report.size());
        std::copy_n(oldest.begin(), size, report.begin());
        return size;
    }

    bool write(std::span<const std::uint8_t> report) override {
        std::this_thread::sleep_for(hid_.timeOfAWrite());
        const std::lock_guard lock(hid_.mutex_);
        if (lost() || hid_.refusesWrites_) {
            return false;
        }
        hid_.written_.emplace_back(report.begin(), report.end());
        return true;
    }

private:
    [[nodiscard]] bool lost() const { return plugging_ != hid_.plugging_; }

    FakeHid& hid_;
    int plugging_;
};

void FakeHid::plug(const HidDeviceInfo& device) {
    const std::lock_guard lock(mutex_);
    devices_.push_back(device);
}

void FakeHid::unplug() {
    const std::lock_guard lock(mutex_);
    devices_.clear();
    reports_.clear();
    ++plugging_;
    changed_.notify_all();
}

void FakeHid::send(const std::vector<Report>& reports) {
    const std::lock_guard lock(mutex_);
    reports_.insert(reports_.end(), reports.begin(), reports.end());
    changed_.notify_all();
}

void FakeHid::refuseToOpen(const std::string& why) {
    const std::lock_guard lock(mutex_);
    refusal_ = why;
}

void FakeHid::refuseToWrite(bool refuse) {
    const std::lock_guard lock(mutex_);
    refusesWrites_ = refuse;
}

void FakeHid::holdWrites(std::chrono::milliseconds time) {
    const std::lock_guard lock(mutex_);
    writing_ = time;
}

std::chrono::milliseconds FakeHid::timeOfAWrite() const {
    const std::lock_guard lock(mutex_);
    return writing_;
}

std::vector<Report> FakeHid::written() const {
    const std::lock_guard lock(mutex_);
    return written_;
}

int FakeHid::opened() const {
    const std::lock_guard lock(mutex_);
    return opened_;
}

std::vector<HidDeviceInfo> FakeHid::enumerate() {
    const std::lock_guard lock(mutex_);
    return devices_;
}

std::unique_ptr<HidConnection> FakeHid::open(const std::string& /*path*/) {
    const std::lock_guard lock(mutex_);
    if (!refusal_.empty()) {
        throw Error(refusal_);
    }
    return std::make_unique<Connection>(*this);
}

HidDeviceInfo spaceMouseInfo() {
    return {.path = "/dev/hidraw7",
            .vendorId = 0x256f,
            .productId = 0xc635,
            .manufacturer = "3Dconnexion",
            .product = "SpaceMouse Compact",
            .usages = {{.page = 1, .id = 8}}};
}

Report motionReport(int x, int y, int z) {
    Report report(13, 0);
    report[0] = 1;
    std::size_t index = 1;
    for (const int counts : {x, y, z}) {
        report[index++] = static_cast<std::uint8_t>(static_cast<unsigned>(counts) & 0xFFU);
        report[index++] = static_cast<std::uint8_t>((static_cast<unsigned>(counts) >> 8U) & 0xFFU);
    }
    return report;
}

}  // namespace asperity::test
