#include "hardware/hid/HidapiTransport.h"

#include "core/Error.h"
#include "core/words/DeviceWords.h"
#include "hardware/DeviceRegistry.h"
#include "hardware/spacemouse/SpaceMouse.h"
#include "tests/hardware/Eventually.h"
#include "tests/hardware/VirtualSpaceMouse.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <sys/stat.h>
#include <unistd.h>

namespace asperity::test {
namespace {

using std::chrono::milliseconds;
using Report = VirtualSpaceMouse::Report;

const Report kFullRight = {1, 0x5E, 0x01, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
const Report kFullLeft = {1, 0xA2, 0xFE, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0};
constexpr milliseconds kNone{0};
constexpr milliseconds kLong{30000};

/// The real hidapi and a device that umockdev makes up.
class HidapiWithVirtualDevice : public ::testing::Test {
protected:
    /// The next report, or one byte 0xEE when the device is lost.
    static Report read(HidConnection& connection, milliseconds patience) {
        std::array<std::uint8_t, 64> buffer{};
        const std::optional<std::size_t> size = connection.read(buffer, patience);
        return size ? Report(buffer.begin(), buffer.begin() + static_cast<std::ptrdiff_t>(*size))
                    : Report{0xEE};
    }

    VirtualSpaceMouse device;
    HidapiTransport transport;
};

TEST_F(HidapiWithVirtualDevice, EnumeratesEachDeviceOnceWithAllItsCollections) {
    std::vector<HidDeviceInfo> list = transport.enumerate();
    ASSERT_EQ(list.size(), 2U);
    std::sort(list.begin(), list.end(),
              [](const auto& one, const auto& other) { return one.path < other.path; });
    EXPECT_EQ(list[0].path, "/dev/hidraw3");
    EXPECT_EQ(list[0].vendorId, 0x1234);
    EXPECT_EQ(list[0].serial, "7");
    EXPECT_FALSE(isSpaceMouse(list[0]));

    EXPECT_EQ(list[1].path, "/dev/hidraw7");
    EXPECT_EQ(list[1].vendorId, 0x256f);
    EXPECT_EQ(list[1].productId, 0xc635);
    EXPECT_EQ(list[1].manufacturer, "3Dconnexion");
    EXPECT_EQ(list[1].product, "SpaceMouse Compact");
    EXPECT_GT(list[1].usages.size(), 1U);
    EXPECT_EQ(list[1].usages.front(), (HidUsage{.page = 1, .id = 8}));
    EXPECT_TRUE(list[1].permitted);
    EXPECT_TRUE(isSpaceMouse(list[1]));
}

TEST_F(HidapiWithVirtualDevice, ReadsReportAfterReport) {
    const auto connection = transport.open("/dev/hidraw7");
    EXPECT_EQ(read(*connection, kNone), Report{});
    device.send({kFullRight, {3, 1, 0}});
    EXPECT_EQ(read(*connection, kLong), kFullRight);
    EXPECT_EQ(read(*connection, kNone), (Report{3, 1, 0}));
    EXPECT_EQ(read(*connection, milliseconds(1)), Report{});
}

TEST_F(HidapiWithVirtualDevice, WritesReports) {
    const auto connection = transport.open("/dev/hidraw7");
    const std::vector<Report> light = {{4, 1}};
    EXPECT_TRUE(connection->write(light.front()));
    EXPECT_EQ(device.written(), light);
}

TEST_F(HidapiWithVirtualDevice, ReadingAndWritingFailAfterAnUnplug) {
    const auto connection = transport.open("/dev/hidraw7");
    device.unplug();
    EXPECT_EQ(read(*connection, kLong), Report{0xEE});
    EXPECT_FALSE(connection->write(Report{4, 0}));
    EXPECT_EQ(transport.enumerate().size(), 1U);
    device.plug();
    EXPECT_EQ(transport.enumerate().size(), 2U);
    EXPECT_EQ(read(*transport.open(device.path()), kNone), Report{});
}

TEST_F(HidapiWithVirtualDevice, AConnectionOutlivesTheTransport) {
    auto other = std::make_unique<HidapiTransport>();
    const auto connection = other->open("/dev/hidraw7");
    other.reset();
    device.send({kFullRight});
    EXPECT_EQ(read(*connection, kLong), kFullRight);
}

std::string whyNotOpened(HidTransport& transport, const std::string& path) {
    try {
        (void)transport.open(path);
    } catch (const Error& error) {
        return error.what();
    }
    return "opened";
}

TEST_F(HidapiWithVirtualDevice, RefusesWhatIsNoHidrawNode) {
    EXPECT_EQ(whyNotOpened(transport, "/dev/null"),
              "/dev/null: not a hidraw device, or it has just been unplugged");
    EXPECT_EQ(whyNotOpened(transport, "/dev/hidraw9"),
              "/dev/hidraw9: the device cannot be opened: No such file or directory");
}

/// Makes the process somebody who may not open a file, also where it runs as root.
class Outsider {
public:
    explicit Outsider(const std::string& path) : self_(geteuid()) {
        EXPECT_EQ(chmod(path.c_str(), 0), 0);
        EXPECT_TRUE(self_ != 0 || seteuid(kNobody) == 0);
    }
    ~Outsider() { EXPECT_EQ(seteuid(self_), 0); }
    Outsider(const Outsider&) = delete;
    Outsider& operator=(const Outsider&) = delete;

private:
    static constexpr uid_t kNobody = 65534;
    uid_t self_;
};

// umockdev gives its nodes to everybody; a file replaces one that the system gives to root alone.
TEST_F(HidapiWithVirtualDevice, NamesTheRulesFileWhenPermissionIsMissing) {
    const ScratchFolder folder;
    const std::string path = folder.write("hidraw0", "");
    const Outsider outsider(path);
    EXPECT_EQ(whyNotOpened(transport, path), path + ": " + kNoPermission);
}

TEST_F(HidapiWithVirtualDevice, TheDeviceFollowsTheDevice) {
    SpaceMouse mouse(transport, Vector3::Zero(), 1e-6);
    EXPECT_TRUE(mouse.advance(1.0).connected);
    device.send({kFullLeft, kFullLeft, kFullRight, {3, 2, 0}});
    ASSERT_TRUE(eventually([&mouse] { return mouse.advance(0.0).buttons == 2; }));
    EXPECT_TRUE(mouse.advance(1.0).position.isApprox(Vector3(1e-6, 0.0, 0.0), 1e-9));
}

TEST_F(HidapiWithVirtualDevice, TheDeviceSurvivesUnplugAndReplugAgainAndAgain) {
    SpaceMouse mouse(transport, Vector3::Zero(), 1e-6);
    for (int i = 0; i < 3; ++i) {
        ASSERT_TRUE(eventually([&mouse] { return mouse.advance(0.0).connected; }));
        device.send({kFullRight, {3, 1, 0}});
        ASSERT_TRUE(eventually([&mouse] { return mouse.advance(0.0).buttons == 1; }));
        const Vector3 reached = mouse.advance(1.0).position;
        device.unplug();
        ASSERT_TRUE(eventually([&mouse] { return !mouse.advance(0.0).connected; }));
        EXPECT_EQ(mouse.advance(1.0).position, reached);
        device.plug();
    }
    EXPECT_TRUE(eventually([&mouse] { return mouse.advance(0.0).connected; }));
}

TEST_F(HidapiWithVirtualDevice, TheDevicePutsTheLightOut) {
    const std::vector<Report> on = {{4, 1}};
    const std::vector<Report> onAndOff = {{4, 1}, {4, 0}};
    {
        const SpaceMouse mouse(transport, Vector3::Zero());
        ASSERT_TRUE(eventually([&] { return device.written() == on; }));
    }
    EXPECT_EQ(device.written(), onAndOff);
}

TEST_F(HidapiWithVirtualDevice, ListingGoesOnWhileTheDeviceSearches) {
    SpaceMouse mouse(transport, Vector3::Zero());
    for (int i = 0; i < 20; ++i) {
        const bool plugged = i % 2 == 1;
        plugged ? device.plug() : device.unplug();
        HidapiTransport other;
        const auto listed = listDevices({.hid = [&other]() -> HidTransport& { return other; }});
        const auto hid = std::ranges::count_if(
            listed, [](const DeviceDescription& one) { return !one.path.empty(); });
        EXPECT_EQ(hid, plugged ? 2 : 1);
    }
    EXPECT_TRUE(eventually([&mouse] { return mouse.advance(0.0).connected; }));
}

}  // namespace
}  // namespace asperity::test
