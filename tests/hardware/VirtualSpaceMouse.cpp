#include "tests/hardware/VirtualSpaceMouse.h"

#include "core/Error.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <linux/hidraw.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace asperity::test {

namespace {

constexpr int kFirstNumber = 7;  // of the hidraw node
constexpr const char* kHidDevice = "/devices/pci0000:00/usb1/1-1/1-1:1.0/0003:256F:C635.0001";

// Report 1 in: six axes of 16 bits from -350 to 350; 3 in: two buttons; 4 out: the light.
constexpr auto kSpaceMouseReports = std::to_array<std::uint8_t>(
    {0x05, 0x01, 0x09, 0x08, 0xA1, 0x01,                          // multi-axis controller
     0x09, 0x01, 0xA1, 0x00, 0x85, 0x01, 0x16, 0xA2, 0xFE,        // report 1, from -350
     0x26, 0x5E, 0x01, 0x09, 0x30, 0x09, 0x31, 0x09, 0x32,        // to 350: X, Y, Z,
     0x09, 0x33, 0x09, 0x34, 0x09, 0x35, 0x75, 0x10, 0x95, 0x06,  // Rx, Ry, Rz
     0x81, 0x02, 0xC0, 0x09, 0x3A, 0xA1, 0x02, 0x85, 0x03,        // report 3
     0x05, 0x09, 0x19, 0x01, 0x29, 0x02, 0x15, 0x00, 0x25, 0x01,  // buttons 1 and 2
     0x75, 0x01, 0x95, 0x10, 0x81, 0x02, 0xC0,                    // in 16 bits
     0xA1, 0x02, 0x85, 0x04, 0x05, 0x08, 0x09, 0x4B, 0x75, 0x08,  // report 4: indicator
     0x95, 0x01, 0x91, 0x02, 0xC0, 0xC0});

constexpr const char* kSpaceMouseFiles = R"(P: /devices/pci0000:00/usb1/1-1
E: DEVTYPE=usb_device
E: DRIVER=usb
E: SUBSYSTEM=usb
A: bcdDevice=0437\n
A: idVendor=256f\n
A: idProduct=c635\n
A: manufacturer=3Dconnexion\n
A: product=SpaceMouse Compact\n

P: /devices/pci0000:00/usb1/1-1/1-1:1.0
E: DEVTYPE=usb_interface
E: DRIVER=usbhid
E: SUBSYSTEM=usb
A: bInterfaceNumber=00\n
A: bInterfaceClass=03\n

P: /devices/pci0000:00/usb1/1-1/1-1:1.0/0003:256F:C635.0001
E: DRIVER=hid-generic
E: HID_ID=0003:0000256F:0000C635
E: HID_NAME=3Dconnexion SpaceMouse Compact
E: HID_PHYS=usb-0000:00-1/input0
E: HID_UNIQ=
E: SUBSYSTEM=hid
H: report_descriptor=)";

constexpr const char* kOtherDevice = R"(P: /devices/virtual/0005:1234:0001.0002
E: DRIVER=hid-generic
E: HID_ID=0005:00001234:00000001
E: HID_NAME=Acme Maus
E: HID_PHYS=
E: HID_UNIQ=7
E: SUBSYSTEM=hid
H: report_descriptor=05010902A101C0

P: /devices/virtual/0005:1234:0001.0002/hidraw/hidraw3
N: hidraw3
E: DEVNAME=/dev/hidraw3
E: MAJOR=245
E: MINOR=3
E: SUBSYSTEM=hidraw
A: dev=245:3\n
L: device=../../../0005:1234:0001.0002

)";

template <std::size_t N>
std::string inHex(const std::array<std::uint8_t, N>& bytes) {
    constexpr const char* kDigits = "0123456789ABCDEF";
    std::string text;
    for (const std::uint8_t byte : bytes) {
        text += kDigits[byte >> 4U];
        text += kDigits[byte & 0xFU];
    }
    return text;
}

std::string nodeDescription(int number) {
    const std::string digits = std::to_string(number);
    return std::string("P: ") + kHidDevice + "/hidraw/hidraw" + digits + "\nN: hidraw" + digits +
           "\nE: DEVNAME=/dev/hidraw" + digits + "\nE: MAJOR=245\nE: MINOR=" + digits +
           "\nE: SUBSYSTEM=hidraw\nA: dev=245:" + digits +
           "\\n\nL: device=../../../0003:256F:C635.0001\n\n";
}

void require(bool held, const std::string& what) {
    if (!held) {
        throw Error("the virtual SpaceMouse: " + what);
    }
}

/// The near end, "/dev/pts/1" or so.
std::string terminalOf(int farEnd) {
    std::array<char, 64> name{};
    require(ptsname_r(farEnd, name.data(), name.size()) == 0, "its node is no terminal");
    return name.data();
}

}  // namespace

VirtualSpaceMouse::VirtualSpaceMouse()
    : testbed_(umockdev_testbed_new())
    , node_(umockdev_ioctl_base_new())
    , number_(kFirstNumber - 1) {
    require(umockdev_in_mock_environment() != 0, "libumockdev-preload is not loaded");
    g_signal_connect(node_.get(), "handle-ioctl", G_CALLBACK(&onIoctl), this);
    g_signal_connect(node_.get(), "handle-read", G_CALLBACK(&onRead), this);
    g_signal_connect(node_.get(), "handle-write", G_CALLBACK(&onWrite), this);
    addToSystem(kOtherDevice);
    addToSystem(kSpaceMouseFiles + inHex(kSpaceMouseReports) + "\n\n");
    plug();
}

VirtualSpaceMouse::~VirtualSpaceMouse() { closeTokens(); }

void VirtualSpaceMouse::addToSystem(const std::string& description) {
    GError* error = nullptr;
    umockdev_testbed_add_from_string(testbed_.get(), description.c_str(), &error);
    require(error == nullptr, "umockdev does not take its description");
}

std::string VirtualSpaceMouse::path() const { return "/dev/hidraw" + std::to_string(number_); }

/// umockdev takes each number once. Who opens the node before umockdev answers for it is refused,
/// and tries again.
void VirtualSpaceMouse::plug() {
    ++number_;
    addToSystem(nodeDescription(number_));
    openTokens();
    GError* error = nullptr;
    umockdev_testbed_attach_ioctl(testbed_.get(), path().c_str(), node_.get(), &error);
    require(error == nullptr, "umockdev does not answer for its node");
}

/// The node is a terminal. Its far end takes the tokens in; the near end is opened past umockdev.
void VirtualSpaceMouse::openTokens() {
    const std::lock_guard lock(mutex_);
    tokensIn_ = umockdev_testbed_get_dev_fd(testbed_.get(), path().c_str());
    require(tokensIn_ >= 0, "it has no node");
    tokensOut_ = ::open(terminalOf(tokensIn_).c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    require(tokensOut_ >= 0, "the near end of its node cannot be opened");
}

/// umockdev 0.17 keeps a link for the terminal, and fails when the system gives that out again.
void VirtualSpaceMouse::forgetTerminal() const {
    std::string link = terminalOf(tokensIn_);
    std::replace(link.begin(), link.end(), '/', '_');
    const std::unique_ptr<gchar, decltype(&g_free)> root(
        umockdev_testbed_get_root_dir(testbed_.get()), &g_free);
    std::filesystem::remove(std::filesystem::path(root.get()) / "dev/.ptymap" / link);
}

void VirtualSpaceMouse::unplug() {
    umockdev_testbed_detach_ioctl(testbed_.get(), path().c_str(), nullptr);
    const std::string files =
        std::string("/sys") + kHidDevice + "/hidraw/hidraw" + std::to_string(number_);
    umockdev_testbed_remove_device(testbed_.get(), files.c_str());
    forgetTerminal();
    closeTokens();
}

/// Wakes up who waits for a report.
void VirtualSpaceMouse::closeTokens() {
    const std::lock_guard lock(mutex_);
    for (int* end : {&tokensOut_, &tokensIn_}) {
        if (*end >= 0) {
            ::close(*end);
        }
        *end = -1;
    }
    reports_.clear();
}

void VirtualSpaceMouse::send(const std::vector<Report>& reports) {
    const std::lock_guard lock(mutex_);
    reports_.insert(reports_.end(), reports.begin(), reports.end());
    const std::string tokens(reports.size(), '!');
    require(::write(tokensIn_, tokens.data(), tokens.size()) == static_cast<ssize_t>(tokens.size()),
            "it cannot tell that it has reports");
}

std::vector<VirtualSpaceMouse::Report> VirtualSpaceMouse::written() const {
    const std::lock_guard lock(mutex_);
    return written_;
}

gboolean VirtualSpaceMouse::onIoctl(UMockdevIoctlBase* /*node*/, UMockdevIoctlClient* client,
                                    gpointer self) {
    auto& mouse = *static_cast<VirtualSpaceMouse*>(self);
    const std::lock_guard lock(mouse.mutex_);
    if (umockdev_ioctl_client_get_request(client) != HIDIOCGRDESCSIZE) {
        umockdev_ioctl_client_complete(client, -1, EINVAL);
        return TRUE;
    }
    if (mouse.tokensOut_ < 0) {
        umockdev_ioctl_client_complete(client, -1, ENODEV);
        return TRUE;
    }
    int size = kSpaceMouseReports.size();
    UMockdevIoctlData* argument = umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client),
                                                              0, sizeof(size), nullptr);
    umockdev_ioctl_data_update(argument, 0, reinterpret_cast<guint8*>(&size), sizeof(size));
    g_object_unref(argument);
    umockdev_ioctl_client_complete(client, 0, 0);
    return TRUE;
}

gboolean VirtualSpaceMouse::onRead(UMockdevIoctlBase* /*node*/, UMockdevIoctlClient* client,
                                   gpointer self) {
    auto& mouse = *static_cast<VirtualSpaceMouse*>(self);
    const std::lock_guard lock(mouse.mutex_);
    char token = 0;
    if (mouse.tokensOut_ < 0 || ::read(mouse.tokensOut_, &token, 1) != 1) {
        umockdev_ioctl_client_complete(client, -1, mouse.tokensOut_ < 0 ? EIO : EAGAIN);
        return TRUE;
    }
    Report report = mouse.reports_.front();
    mouse.reports_.pop_front();
    UMockdevIoctlData* buffer = umockdev_ioctl_client_get_arg(client);
    const int size = std::min(buffer->data_len, static_cast<int>(report.size()));
    umockdev_ioctl_data_update(buffer, 0, report.data(), size);
    umockdev_ioctl_client_complete(client, size, 0);
    return TRUE;
}

gboolean VirtualSpaceMouse::onWrite(UMockdevIoctlBase* /*node*/, UMockdevIoctlClient* client,
                                    gpointer self) {
    auto& mouse = *static_cast<VirtualSpaceMouse*>(self);
    const std::lock_guard lock(mouse.mutex_);
    if (mouse.tokensOut_ < 0) {
        umockdev_ioctl_client_complete(client, -1, ENODEV);
        return TRUE;
    }
    const UMockdevIoctlData* data = umockdev_ioctl_client_get_arg(client);
    mouse.written_.emplace_back(data->data, data->data + data->data_len);
    umockdev_ioctl_client_complete(client, data->data_len, 0);
    return TRUE;
}

}  // namespace asperity::test
