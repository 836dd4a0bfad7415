#include "core/io/heightmap/vti/VtiValues.h"

#include "core/Error.h"
#include "core/io/Base64.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/ZlibStream.h"

#include <algorithm>
#include <limits>
#include <lz4.h>
#include <lzma.h>
#include <string_view>
#include <zlib.h>

// The values of VTK's XML files: the number of their bytes and the bytes; compressed, the number of
// blocks, the size of a block, that of the last one where it is smaller, the size of each
// compressed block, and the blocks. Base64 may stop and begin again after any of these. Source: VTK
// File Formats (4.2), "XML File Formats"; IO/XMLParser/vtkXMLDataParser.h.

namespace asperity {

namespace {

constexpr std::uint64_t kChunk = std::uint64_t{1} << 16U;

bool isBlank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

/// Bytes in a row, of base64 or as they are.
class VtiStream {
public:
    VtiStream(const ByteSource& bytes, const VtiValues& values)
        : bytes_(bytes), values_(values), offset_(values.span.offset) {}

    std::string take(std::uint64_t count) {
        if (values_.form == VtiForm::Raw) {
            require(count <= values_.span.end() - offset_);
            offset_ += count;
            return bytesOf(bytes_, {offset_ - count, count});
        }
        while (decoded_.size() < count) {
            require(offset_ < values_.span.end());
            decodeMore(count - decoded_.size());
        }
        std::string taken = decoded_.substr(0, count);
        decoded_.erase(0, count);
        return taken;
    }

private:
    void require(bool holds) const {
        if (!holds) {
            throw InputError(bytes_.name(), values_.location,
                             "its values end too early; the file is truncated or damaged");
        }
    }

    /// Groups of four letters, as many as there are of a chunk.
    void decodeMore(std::uint64_t wanted) {
        const std::uint64_t left = values_.span.end() - offset_;
        const std::uint64_t count = std::min({left, kChunk, 4 * (wanted / 3) + 64});
        const std::string text = bytesOf(bytes_, {offset_, count});
        offset_ += count;
        for (const char c : text) {
            if (c == '<') {  // the values are those before the next tag
                offset_ = values_.span.end();
                break;
            }
            if (!isBlank(c)) {
                letters_ += c;
            }
        }
        const std::size_t whole = letters_.size() - letters_.size() % 4;
        if (!appendBase64(decoded_, std::string_view(letters_).substr(0, whole))) {
            throw InputError(bytes_.name(), values_.location, "its values are no base64");
        }
        letters_.erase(0, whole);
    }

    const ByteSource& bytes_;
    const VtiValues& values_;
    std::uint64_t offset_;
    std::string letters_;  ///< read, not decoded
    std::string decoded_;  ///< not taken
};

std::uint64_t wordsIn(std::string_view text) {
    std::uint64_t words = 0;
    bool isBetween = true;
    for (const char c : text) {
        words += isBetween && !isBlank(c) ? 1 : 0;
        isBetween = isBlank(c);
    }
    return words;
}

/// Returns whether a packed block of this many bytes can hold that many: none packs better than the
/// best case of its method.
bool mayHold(VtiCompressor compressor, std::uint64_t packed, std::uint64_t bytes) {
    if (compressor == VtiCompressor::Zlib) {
        return mayUnpackTo(packed, bytes);
    }
    // LZ4: a byte of length counts at most 255. LZMA: the longest repetition, 273 bytes, takes
    // 14 decisions of at least log2(2048 / 2017) bits.
    const std::uint64_t best = compressor == VtiCompressor::Lz4 ? 255 : 7200;
    constexpr std::uint64_t kEnds = 64;  // [bytes]; below, a block's ends count
    return bytes / best <= packed + kEnds;
}

/// Returns whether the block had exactly this length.
bool decompress(VtiCompressor compressor, const std::string& block, char* target,
                std::uint64_t size) {
    auto* const bytes = reinterpret_cast<unsigned char*>(target);
    const auto* const packed = reinterpret_cast<const unsigned char*>(block.data());
    if (compressor == VtiCompressor::Zlib) {
        uLongf count = size;
        return uncompress(bytes, &count, packed, block.size()) == Z_OK && count == size;
    }
    if (compressor == VtiCompressor::Lz4) {
        constexpr std::uint64_t kMax = std::numeric_limits<int>::max();
        return size <= kMax && block.size() <= kMax &&
               LZ4_decompress_safe(block.data(), target, static_cast<int>(block.size()),
                                   static_cast<int>(size)) == static_cast<int>(size);
    }
    std::uint64_t memory = std::uint64_t{1} << 28U;
    std::size_t in = 0;
    std::size_t out = 0;
    return lzma_stream_buffer_decode(&memory, 0, nullptr, packed, &in, block.size(), bytes, &out,
                                     size) == LZMA_OK &&
           out == size;
}

class VtiDecoder {
public:
    VtiDecoder(const ByteSource& bytes, const VtiCoding& coding, const VtiValues& values,
               std::uint64_t most)
        : bytes_(bytes), coding_(coding), values_(values), most_(most), stream_(bytes, values) {}

    std::string decode() {
        if (values_.form == VtiForm::Text) {
            return numbersOfText();
        }
        return coding_.compressor == VtiCompressor::None ? stream_.take(checked(count()))
                                                         : blocks();
    }

private:
    std::uint64_t count() { return vtiCount(stream_.take(coding_.countBytes).data(), coding_); }

    [[nodiscard]] std::uint64_t checked(std::uint64_t size) const {
        if (size > most_) {
            fail("expected " + std::to_string(most_) + " bytes of values, found " +
                 std::to_string(size));
        }
        return size;
    }

    std::string blocks() {
        const std::uint64_t blocks = count();
        const std::uint64_t block = count();
        const std::uint64_t last = count();
        if (blocks == 0) {
            return {};
        }
        // Each block but the last is full; the first checks keep products small.
        if (blocks > most_ || last > block || (blocks > 1 && block > most_ / (blocks - 1))) {
            fail("the sizes of its compressed blocks do not fit the image");
        }
        const std::uint64_t end = last == 0 ? block : last;
        const std::uint64_t size = checked((blocks - 1) * block + end);
        const std::string sizes = stream_.take(blocks * coding_.countBytes);
        const auto packedSize = [&](std::uint64_t i) {
            return vtiCount(sizes.data() + i * coding_.countBytes, coding_);
        };
        const auto wanted = [&](std::uint64_t i) { return i + 1 == blocks ? end : block; };
        // All blocks are checked before there is memory for any of them.
        std::uint64_t left = values_.span.count;
        for (std::uint64_t i = 0; i < blocks; ++i) {
            if (packedSize(i) > left || !mayHold(coding_.compressor, packedSize(i), wanted(i))) {
                failBlock(i);
            }
            left -= packedSize(i);
        }
        std::string result(size, '\0');
        for (std::uint64_t i = 0; i < blocks; ++i) {
            const std::string packed = stream_.take(packedSize(i));
            if (!decompress(coding_.compressor, packed, result.data() + i * block, wanted(i))) {
                failBlock(i);
            }
        }
        return result;
    }

    [[noreturn]] void failBlock(std::uint64_t index) const {
        fail("compressed block " + std::to_string(index + 1) + " is damaged");
    }

    [[nodiscard]] std::string numbersOfText() const {
        const std::string text = bytesOf(bytes_, values_.span);
        std::string result;
        result.reserve(std::min(wordsIn(text) * sizeof(double), most_));
        for (std::size_t begin = 0; begin < text.size();) {
            const auto end = static_cast<std::size_t>(
                std::find_if(text.begin() + static_cast<std::ptrdiff_t>(begin), text.end(),
                             isBlank) -
                text.begin());
            if (end > begin) {
                const std::string_view word = std::string_view(text).substr(begin, end - begin);
                const std::optional<double> number = parseNumber(word);
                if (!number) {
                    fail("expected a number, found '" + toUtf8(word.substr(0, 20)) + "'");
                }
                (void)checked(result.size() + sizeof(double));
                appendLittleEndian(result, *number);
            }
            begin = end + 1;
        }
        return result;
    }

    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(bytes_.name(), values_.location, what);
    }

    const ByteSource& bytes_;
    const VtiCoding& coding_;
    const VtiValues& values_;
    std::uint64_t most_;
    VtiStream stream_;
};

}  // namespace

std::string decodedVti(const ByteSource& bytes, const VtiCoding& coding, const VtiValues& values,
                       std::uint64_t most) {
    return VtiDecoder(bytes, coding, values, most).decode();
}

std::uint64_t vtiCount(const char* bytes, const VtiCoding& coding) {
    const bool little = coding.order == ByteOrder::Little;
    if (coding.countBytes == sizeof(std::uint64_t)) {
        return little ? littleEndian<std::uint64_t>(bytes) : bigEndian<std::uint64_t>(bytes);
    }
    return little ? littleEndian<std::uint32_t>(bytes) : bigEndian<std::uint32_t>(bytes);
}

}  // namespace asperity
