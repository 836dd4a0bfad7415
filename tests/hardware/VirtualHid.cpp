#include "tests/hardware/VirtualHid.h"

#include "core/Error.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <iomanip>
#include <linux/hidraw.h>
#include <sstream>
#include <sys/ioctl.h>
#include <unistd.h>
#include <utility>

namespace asperity::test {

namespace {

constexpr int kFirstNumber = 7;  // of the hidraw node
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

/// Returns a number of this many digits, in lower case.
std::string inHex(unsigned value, int digits) {
    std::ostringstream text;
    text << std::hex << std::setw(digits) << std::setfill('0') << value;
    return text.str();
}

std::string inHex(const std::vector<std::uint8_t>& bytes) {
    std::string text;
    for (const std::uint8_t byte : bytes) {
        text += inHex(byte, 2);
    }
    return text;
}

/// Below /sys.
std::string hidDeviceOf(const VirtualHidDescription& device) {
    return "/devices/pci0000:00/usb1/1-1/1-1:1.0/0003:" + inHex(device.vendorId, 4) + ":" +
           inHex(device.productId, 4) + ".0001";
}

/// The USB device, its interface and the HID device, as umockdev expects them.
std::string filesOf(const VirtualHidDescription& device) {
    std::ostringstream text;
    text << "P: /devices/pci0000:00/usb1/1-1\nE: DEVTYPE=usb_device\nE: DRIVER=usb\n"
         << "E: SUBSYSTEM=usb\nA: bcdDevice=0437\\n\n"
         << "A: idVendor=" << inHex(device.vendorId, 4) << "\\n\n"
         << "A: idProduct=" << inHex(device.productId, 4) << "\\n\n"
         << "A: manufacturer=" << device.manufacturer << "\\n\n"
         << "A: product=" << device.product << "\\n\n\n"
         << "P: /devices/pci0000:00/usb1/1-1/1-1:1.0\nE: DEVTYPE=usb_interface\n"
         << "E: DRIVER=usbhid\nE: SUBSYSTEM=usb\nA: bInterfaceNumber=00\\n\n"
         << "A: bInterfaceClass=03\\n\n\n"
         << "P: " << hidDeviceOf(device) << "\nE: DRIVER=hid-generic\n"
         << "E: HID_ID=0003:" << inHex(device.vendorId, 8) << ":" << inHex(device.productId, 8)
         << "\nE: HID_NAME=" << device.manufacturer << " " << device.product
         << "\nE: HID_PHYS=usb-0000:00-1/input0\nE: HID_UNIQ=\nE: SUBSYSTEM=hid\n"
         << "H: report_descriptor=" << inHex(device.reportDescriptor) << "\n\n";
    return text.str();
}

/// The node of the HID device below `files`.
std::string nodeDescription(const std::string& files, int number) {
    const std::string digits = std::to_string(number);
    return "P: " + files + "/hidraw/hidraw" + digits + "\nN: hidraw" + digits +
           "\nE: DEVNAME=/dev/hidraw" + digits + "\nE: MAJOR=245\nE: MINOR=" + digits +
           "\nE: SUBSYSTEM=hidraw\nA: dev=245:" + digits + "\\n\nL: device=../../../" +
           files.substr(files.rfind('/') + 1) + "\n\n";
}

void require(bool held, const std::string& what) {
    if (!held) {
        throw Error("the virtual HID device: " + what);
    }
}

/// The near end, "/dev/pts/1" or so.
std::string terminalOf(int farEnd) {
    std::array<char, 64> name{};
    require(ptsname_r(farEnd, name.data(), name.size()) == 0, "its node is no terminal");
    return name.data();
}

}  // namespace

VirtualHid::VirtualHid(const VirtualHidDescription& description)
    : testbed_(umockdev_testbed_new())
    , node_(umockdev_ioctl_base_new())
    , files_(hidDeviceOf(description))
    , descriptorSize_(static_cast<int>(description.reportDescriptor.size()))
    , number_(kFirstNumber - 1) {
    require(umockdev_in_mock_environment() != 0, "libumockdev-preload is not loaded");
    g_signal_connect(node_.get(), "handle-ioctl", G_CALLBACK(&onIoctl), this);
    g_signal_connect(node_.get(), "handle-read", G_CALLBACK(&onRead), this);
    g_signal_connect(node_.get(), "handle-write", G_CALLBACK(&onWrite), this);
    addToSystem(kOtherDevice);
    addToSystem(filesOf(description));
    plug();
}

VirtualHid::~VirtualHid() { closeTokens(); }

void VirtualHid::addToSystem(const std::string& description) {
    GError* error = nullptr;
    umockdev_testbed_add_from_string(testbed_.get(), description.c_str(), &error);
    require(error == nullptr, "umockdev does not take its description");
}

std::string VirtualHid::path() const { return "/dev/hidraw" + std::to_string(number_); }

/// umockdev accepts each number once. Who opens the node before umockdev answers for it is refused,
/// and tries again.
void VirtualHid::plug() {
    ++number_;
    addToSystem(nodeDescription(files_, number_));
    openTokens();
    GError* error = nullptr;
    umockdev_testbed_attach_ioctl(testbed_.get(), path().c_str(), node_.get(), &error);
    require(error == nullptr, "umockdev does not answer for its node");
}

/// The node is a terminal. Its far end takes the tokens in; the near end is opened past umockdev.
void VirtualHid::openTokens() {
    const std::lock_guard lock(mutex_);
    tokensIn_ = umockdev_testbed_get_dev_fd(testbed_.get(), path().c_str());
    require(tokensIn_ >= 0, "it has no node");
    tokensOut_ = ::open(terminalOf(tokensIn_).c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
    require(tokensOut_ >= 0, "the near end of its node cannot be opened");
}

/// umockdev 0.17 keeps a link for the terminal, and fails when the system gives that out again.
void VirtualHid::forgetTerminal() const {
    std::string link = terminalOf(tokensIn_);
    std::replace(link.begin(), link.end(), '/', '_');
    const std::unique_ptr<gchar, decltype(&g_free)> root(
        umockdev_testbed_get_root_dir(testbed_.get()), &g_free);
    std::filesystem::remove(std::filesystem::path(root.get()) / "dev/.ptymap" / link);
}

void VirtualHid::unplug() {
    umockdev_testbed_detach_ioctl(testbed_.get(), path().c_str(), nullptr);
    const std::string files = "/sys" + files_ + "/hidraw/hidraw" + std::to_string(number_);
    umockdev_testbed_remove_device(testbed_.get(), files.c_str());
    forgetTerminal();
    closeTokens();
}

/// Wakes up who waits for a report.
void VirtualHid::closeTokens() {
    const std::lock_guard lock(mutex_);
    for (int* end : {&tokensOut_, &tokensIn_}) {
        if (*end >= 0) {
            ::close(*end);
        }
        *end = -1;
    }
    reports_.clear();
}

void VirtualHid::send(const std::vector<Report>& reports) {
    const std::lock_guard lock(mutex_);
    if (tokensIn_ < 0) {
        return;
    }
    reports_.insert(reports_.end(), reports.begin(), reports.end());
    const std::string tokens(reports.size(), '!');
    require(::write(tokensIn_, tokens.data(), tokens.size()) == static_cast<ssize_t>(tokens.size()),
            "it cannot tell that it has reports");
}

std::vector<VirtualHid::Report> VirtualHid::written() const {
    const std::lock_guard lock(mutex_);
    return written_;
}

std::vector<VirtualHid::Report> VirtualHid::takeWritten() {
    const std::lock_guard lock(mutex_);
    return std::exchange(written_, {});
}

gboolean VirtualHid::onIoctl(UMockdevIoctlBase* /*node*/, UMockdevIoctlClient* client,
                             gpointer self) {
    auto& hid = *static_cast<VirtualHid*>(self);
    const std::lock_guard lock(hid.mutex_);
    if (umockdev_ioctl_client_get_request(client) != HIDIOCGRDESCSIZE) {
        umockdev_ioctl_client_complete(client, -1, EINVAL);
        return TRUE;
    }
    if (hid.tokensOut_ < 0) {
        umockdev_ioctl_client_complete(client, -1, ENODEV);
        return TRUE;
    }
    int size = hid.descriptorSize_;
    UMockdevIoctlData* argument = umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client),
                                                              0, sizeof(size), nullptr);
    umockdev_ioctl_data_update(argument, 0, reinterpret_cast<guint8*>(&size), sizeof(size));
    g_object_unref(argument);
    umockdev_ioctl_client_complete(client, 0, 0);
    return TRUE;
}

gboolean VirtualHid::onRead(UMockdevIoctlBase* /*node*/, UMockdevIoctlClient* client,
                            gpointer self) {
    auto& hid = *static_cast<VirtualHid*>(self);
    const std::lock_guard lock(hid.mutex_);
    char token = 0;
    if (hid.tokensOut_ < 0 || ::read(hid.tokensOut_, &token, 1) != 1) {
        umockdev_ioctl_client_complete(client, -1, hid.tokensOut_ < 0 ? EIO : EAGAIN);
        return TRUE;
    }
    Report report = hid.reports_.front();
    hid.reports_.pop_front();
    UMockdevIoctlData* buffer = umockdev_ioctl_client_get_arg(client);
    const int size = std::min(buffer->data_len, static_cast<int>(report.size()));
    umockdev_ioctl_data_update(buffer, 0, report.data(), size);
    umockdev_ioctl_client_complete(client, size, 0);
    return TRUE;
}

gboolean VirtualHid::onWrite(UMockdevIoctlBase* /*node*/, UMockdevIoctlClient* client,
                             gpointer self) {
    auto& hid = *static_cast<VirtualHid*>(self);
    const std::lock_guard lock(hid.mutex_);
    if (hid.tokensOut_ < 0) {
        umockdev_ioctl_client_complete(client, -1, ENODEV);
        return TRUE;
    }
    const UMockdevIoctlData* data = umockdev_ioctl_client_get_arg(client);
    hid.written_.emplace_back(data->data, data->data + data->data_len);
    umockdev_ioctl_client_complete(client, data->data_len, 0);
    return TRUE;
}

}  // namespace asperity::test
