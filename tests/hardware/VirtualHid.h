#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <umockdev.h>
#include <vector>

namespace asperity::test {

/// Description of a USB HID device.
struct VirtualHidDescription {
    std::uint16_t vendorId = 0;
    std::uint16_t productId = 0;
    std::string manufacturer;
    std::string product;
    std::vector<std::uint8_t> reportDescriptor;
};

/// A HID device that exists for this process and its children alone: umockdev shows its files and
/// answers for its node, so that the real hidapi can be tested. One at a time; the program must be
/// linked with libumockdev-preload before everything else.
class VirtualHid {
public:
    using Report = std::vector<std::uint8_t>;

    /// Plugged in at /dev/hidraw7, beside a HID mouse at /dev/hidraw3 that answers nothing.
    explicit VirtualHid(const VirtualHidDescription& description);
    ~VirtualHid();
    VirtualHid(const VirtualHid&) = delete;
    VirtualHid& operator=(const VirtualHid&) = delete;

    /// Where it is plugged in, or was last.
    [[nodiscard]] std::string path() const;
    /// Under another number than before.
    void plug();
    void unplug();
    /// All reports at once: no reader sees some of them only. Unplugged, it says nothing.
    void send(const std::vector<Report>& reports);
    [[nodiscard]] std::vector<Report> written() const;
    /// Returns the bytes written since the last call.
    [[nodiscard]] std::vector<Report> takeWritten();

private:
    struct Unref {
        void operator()(void* object) const { g_object_unref(object); }
    };

    static gboolean onIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self);
    static gboolean onRead(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self);
    static gboolean onWrite(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self);
    void addToSystem(const std::string& description);
    void openTokens();
    void closeTokens();
    void forgetTerminal() const;

    std::unique_ptr<UMockdevTestbed, Unref> testbed_;
    std::unique_ptr<UMockdevIoctlBase, Unref> node_;

    std::string files_;   ///< of the HID device, below /sys
    int descriptorSize_;  ///< of its reports [byte]
    int number_;          ///< of the node

    mutable std::mutex mutex_;
    int tokensIn_ = -1;   ///< takes a byte for each report: what poll() on the node sees
    int tokensOut_ = -1;  ///< gives it back when the report is read; -1: unplugged
    std::deque<Report> reports_;
    std::vector<Report> written_;
};

}  // namespace asperity::test
