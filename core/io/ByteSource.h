#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace asperity {

/// Bytes that are copied out when they are asked for: no look into a file that others change can
/// end the program. Any threads.
class ByteSource {
public:
    /// @param name for messages: the file's path as the user gave it
    explicit ByteSource(std::string name) : name_(std::move(name)) {}
    ByteSource(const ByteSource&) = delete;
    ByteSource& operator=(const ByteSource&) = delete;
    virtual ~ByteSource() = default;

    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] virtual std::uint64_t size() const = 0;  ///< [bytes]
    /// Fills `bytes` with those from `place` on.
    /// @throw InputError when they are not there, or not there any more
    virtual void read(std::uint64_t place, std::span<char> bytes) const = 0;
    /// @throw InputError when the content has changed since the beginning: what was read until now
    ///        may be of two contents
    virtual void requireUnchanged() const = 0;

    /// The bytes at the front, fewer where there are fewer.
    [[nodiscard]] std::string start(std::uint64_t most) const;
    /// The bytes at the front, read on until they are enough; at most `most` of them.
    [[nodiscard]] std::string startUntil(const std::function<bool(std::string_view)>& areEnough,
                                         std::uint64_t most) const;
    [[nodiscard]] bool startsWith(std::string_view mark) const {
        return start(mark.size()) == mark;
    }

private:
    std::string name_;
};

/// Bytes in memory, which must outlive this.
class MemoryBytes final : public ByteSource {
public:
    MemoryBytes(std::string_view bytes, std::string name)
        : ByteSource(std::move(name)), bytes_(bytes) {}

    [[nodiscard]] std::uint64_t size() const override { return bytes_.size(); }
    void read(std::uint64_t place, std::span<char> bytes) const override;
    void requireUnchanged() const override {}

private:
    std::string_view bytes_;
};

/// Bytes in memory that belong to it, as what was decoded.
class OwnedBytes final : public ByteSource {
public:
    OwnedBytes(std::string bytes, std::string name)
        : ByteSource(std::move(name)), bytes_(std::move(bytes)) {}

    [[nodiscard]] std::uint64_t size() const override { return bytes_.size(); }
    void read(std::uint64_t place, std::span<char> bytes) const override {
        MemoryBytes(bytes_, name()).read(place, bytes);
    }
    void requireUnchanged() const override {}

private:
    std::string bytes_;
};

}  // namespace asperity
