#include "core/Error.h"
#include "core/io/heightmap/WholeImages.h"
#include "core/io/heightmap/tiff/TiffDirectory.h"

#include <set>
#include <utility>

// From one directory of a TIFF to the next.

namespace asperity {

namespace {

/// Stacks have some hundred.
constexpr std::size_t kMaxDirectories = 1024;
constexpr std::uint64_t kMaxFields = 65535;
/// A thousand images have some ten each, the images of instruments some hundred.
constexpr std::uint64_t kMaxFieldsInAll = std::uint64_t{1} << 18U;

/// Layout of a TIFF file's offsets.
struct ChainHeader {
    ByteOrder order = ByteOrder::Little;
    bool big = false;  ///< with offsets of 8 bytes instead of 4

    [[nodiscard]] std::uint64_t offsetBytes() const { return big ? 8 : 4; }
    /// Returns the size of the number of a directory's fields.
    [[nodiscard]] std::uint64_t countBytes() const { return big ? 8 : 2; }
    [[nodiscard]] std::uint64_t fieldBytes() const { return big ? 20 : 12; }
    [[nodiscard]] std::uint64_t offset(const char* stored) const {
        return big ? orderedNumber<std::uint64_t>(stored, order)
                   : orderedNumber<std::uint32_t>(stored, order);
    }
};

std::optional<ChainHeader> headerOf(const ByteSource& bytes) {
    using std::string_view_literals::operator""sv;
    constexpr std::uint64_t kMagicBytes = 4;
    const std::string magic = bytes.start(kMagicBytes);
    if (magic == "II*\0"sv) {
        return ChainHeader{ByteOrder::Little, false};
    }
    if (magic == "MM\0*"sv) {
        return ChainHeader{ByteOrder::Big, false};
    }
    if (magic == "II+\0"sv) {
        return ChainHeader{ByteOrder::Little, true};
    }
    if (magic == "MM\0+"sv) {
        return ChainHeader{ByteOrder::Big, true};
    }
    return std::nullopt;
}

/// Refuses a directory that is not all within the file.
class CutDirectory : public InputError {
    using InputError::InputError;
};

/// Walks from directory to directory.
class Chain {
public:
    Chain(const ByteSource& bytes, const ChainHeader& header)
        : bytes_(bytes)
        , header_(header)
        , next_(offsetAt(header.big ? kFirstOfBig : kFirst, "header"))
        , left_(bytes.size()) {}

    [[nodiscard]] bool atEnd() const { return next_ == 0; }

    TiffDirectory take() {
        const std::string name = "directory " + std::to_string(visited_.size() + 1);
        if (visited_.size() == kMaxDirectories || !visited_.insert(next_).second) {
            fail(name, "expected at most " + std::to_string(kMaxDirectories) + ", each once");
        }
        const std::uint64_t offset = next_;
        const std::uint64_t count = fieldCount(name);
        const std::string table =
            tableAt(offset + header_.countBytes(), count * header_.fieldBytes(), name);
        std::vector<TiffField> fields;
        for (std::uint64_t i = 0; i < count; ++i) {
            const std::uint64_t start = i * header_.fieldBytes();
            const TiffField field =
                fieldOf(table.data() + start, offset + header_.countBytes() + start, name);
            if (sizeOfTiffType(field.type) != 0) {
                fields.push_back(field);
            }
        }
        next_ = offsetAt(offset + header_.countBytes() + table.size(), name);
        return {bytes_, header_.order, offset, visited_.size(), std::move(fields)};
    }

private:
    static constexpr std::uint64_t kFirst = 4;
    static constexpr std::uint64_t kFirstOfBig = 8;

    std::uint64_t offsetAt(std::uint64_t offset, const std::string& name) {
        return header_.offset(read({offset, header_.offsetBytes()}, name).data());
    }

    std::uint64_t fieldCount(const std::string& name) {
        const std::string stored = read({next_, header_.countBytes()}, name);
        const std::uint64_t count =
            header_.big ? orderedNumber<std::uint64_t>(stored.data(), header_.order)
                        : orderedNumber<std::uint16_t>(stored.data(), header_.order);
        if (count == 0 || count > kMaxFields) {
            fail(name, "it has " + std::to_string(count) + " fields; expected 1 to " +
                           std::to_string(kMaxFields));
        }
        fields_ += count;
        if (fields_ > kMaxFieldsInAll) {
            fail(name, "expected at most " + std::to_string(kMaxFieldsInAll) +
                           " fields in all directories; the file is damaged");
        }
        return count;
    }

    std::string tableAt(std::uint64_t offset, std::uint64_t count, const std::string& name) {
        spend(count, name);
        return read({offset, count}, name);
    }

    TiffField fieldOf(const char* stored, std::uint64_t offset, const std::string& name) {
        constexpr std::uint64_t kTypeOffset = 2;
        constexpr std::uint64_t kCountOffset = 4;
        TiffField field{.tag = orderedNumber<std::uint16_t>(stored, header_.order),
                        .type = orderedNumber<std::uint16_t>(stored + kTypeOffset, header_.order),
                        .count = header_.offset(stored + kCountOffset)};
        const std::uint64_t valueOffset = kCountOffset + header_.offsetBytes();
        const std::uint64_t valueBytes = sizeOfTiffType(field.type);
        if (valueBytes != 0 && field.count > bytes_.size() / valueBytes) {
            failBeyond(field.tag, name);
        }
        const std::uint64_t size = field.count * valueBytes;
        if (size <= header_.offsetBytes()) {
            field.offset = offset + valueOffset;
            return field;
        }
        field.offset = header_.offset(stored + valueOffset);
        if (field.offset > bytes_.size() || size > bytes_.size() - field.offset) {
            failBeyond(field.tag, name);
        }
        spend(size, name);
        return field;
    }

    /// Counts bytes that belong to directories.
    void spend(std::uint64_t count, const std::string& name) {
        if (count > left_) {
            fail(name, "its fields overlap those of other directories; the file is damaged");
        }
        left_ -= count;
    }

    [[nodiscard]] std::string read(const ByteSpan& span, const std::string& name) const {
        if (span.offset > bytes_.size() || span.count > bytes_.size() - span.offset) {
            throw CutDirectory(bytes_.name(), name,
                               "it is at byte " + std::to_string(span.offset) +
                                   ", but the file has " + std::to_string(bytes_.size()) +
                                   "; it is truncated or damaged");
        }
        return bytesOf(bytes_, span);
    }

    [[noreturn]] void failBeyond(std::uint16_t tag, const std::string& name) const {
        throw CutDirectory(bytes_.name(), name,
                           "the values of tag " + std::to_string(tag) +
                               " are beyond the end of the file; it is truncated or damaged");
    }
    [[noreturn]] void fail(const std::string& location, const std::string& what) const {
        throw InputError(bytes_.name(), location, what);
    }

    const ByteSource& bytes_;
    ChainHeader header_;
    std::uint64_t next_;
    std::uint64_t left_;        ///< bytes of the file that no directory has spent yet
    std::uint64_t fields_ = 0;  ///< of the directories until now
    std::set<std::uint64_t> visited_;
};

}  // namespace

bool isTiff(const ByteSource& bytes) { return headerOf(bytes).has_value(); }

bool isTiffWithTag(const ByteSource& bytes, std::uint16_t tag) {
    const std::optional<ChainHeader> header = headerOf(bytes);
    if (!header) {
        return false;
    }
    try {
        Chain chain(bytes, *header);
        return !chain.atEnd() && chain.take().has(tag);
    } catch (const InputError&) {
        return false;  // a TIFF all the same, which the reader of any TIFF refuses
    }
}

std::vector<TiffDirectory> readTiffDirectories(const ByteSource& bytes, WholeImages* images) {
    const std::optional<ChainHeader> header = headerOf(bytes);
    if (!header) {
        throw InputError(bytes.name(), "", "this is no TIFF");
    }
    Chain chain(bytes, *header);
    std::vector<TiffDirectory> directories;
    while (!chain.atEnd()) {
        try {
            directories.push_back(chain.take());
        } catch (const CutDirectory& error) {
            if (images == nullptr || directories.empty()) {
                throw;
            }
            images->leaveOut("directory " + std::to_string(directories.size() + 1), error);
            break;
        }
    }
    if (directories.empty()) {
        throw InputError(bytes.name(), "header", "expected the offset of a first directory");
    }
    return directories;
}

}  // namespace asperity
