#include "core/io/heightmap/ZlibStream.h"

#include "core/Error.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>
#include <zlib.h>

namespace asperity {

namespace {

/// From zlib's own description of its worst and best cases.
constexpr std::uint64_t kBestRatio = 1032;
constexpr std::uint64_t kSmallest = 64;  // [bytes]; below, a stream's ends count

/// A stream of zlib that is freed in any case.
class Inflation {
public:
    Inflation() : isOpen_(inflateInit(&stream_) == Z_OK) {}
    Inflation(const Inflation&) = delete;
    Inflation& operator=(const Inflation&) = delete;
    ~Inflation() {
        if (isOpen_) {
            (void)inflateEnd(&stream_);
        }
    }

    [[nodiscard]] bool isOpen() const { return isOpen_; }
    /// Takes packed bytes and fills `free`. @return zlib's code
    int step(std::span<char> packed, std::span<char>& free) {
        stream_.next_in = reinterpret_cast<Bytef*>(packed.data());
        stream_.avail_in = static_cast<uInt>(packed.size());
        const auto room = std::min<std::size_t>(free.size(), std::numeric_limits<uInt>::max());
        stream_.next_out = reinterpret_cast<Bytef*>(free.data());
        stream_.avail_out = static_cast<uInt>(room);
        const int code = inflate(&stream_, Z_NO_FLUSH);
        free = free.subspan(room - stream_.avail_out);
        return code;
    }
    [[nodiscard]] std::size_t unused() const { return stream_.avail_in; }

private:
    z_stream stream_{};
    bool isOpen_;
};

}  // namespace

bool mayUnpackTo(std::uint64_t packedBytes, std::uint64_t bytes) {
    return bytes / kBestRatio <= packedBytes + kSmallest;
}

void appendUnpacked(std::string& text, const ByteSource& source, const ByteSpan& packed,
                    std::uint64_t size, const std::string& owner) {
    constexpr std::uint64_t kBlock = std::uint64_t{1} << 16U;
    const auto fail = [&](const std::string& what) {
        throw InputError(source.name(), owner, what + "; the file is damaged");
    };
    if (!mayUnpackTo(packed.count, size)) {
        fail("a zlib stream of " + std::to_string(packed.count) + " bytes cannot hold " +
             std::to_string(size));
    }
    const std::size_t before = text.size();
    text.resize(before + size);
    std::span<char> free = std::span(text).subspan(before);
    Inflation inflation;
    if (!inflation.isOpen()) {
        throw Error("zlib cannot be started: is there no memory left?");
    }
    std::string block;
    int code = Z_OK;
    for (std::uint64_t done = 0; code == Z_OK && done < packed.count;) {
        block.resize(static_cast<std::size_t>(std::min(kBlock, packed.count - done)));
        source.read(packed.offset + done, block);
        code = inflation.step(block, free);
        done += block.size() - inflation.unused();
        if (code == Z_OK && free.empty() && inflation.unused() == block.size()) {
            break;  // it holds more than it should
        }
    }
    if (code == Z_BUF_ERROR || code == Z_OK) {
        fail(free.empty() ? "its zlib stream holds more than " + std::to_string(size) + " bytes"
                          : "its zlib stream ends early");
    }
    if (code != Z_STREAM_END || !free.empty()) {
        fail(code == Z_STREAM_END ? "its zlib stream holds " + std::to_string(size - free.size()) +
                                        " bytes of " + std::to_string(size)
                                  : std::string("its zlib stream cannot be unpacked"));
    }
}

}  // namespace asperity
