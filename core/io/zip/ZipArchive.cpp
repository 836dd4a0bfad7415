#include "core/io/zip/ZipArchive.h"

#include "core/Error.h"
#include "core/io/ByteReader.h"
#include "core/io/MemoryLimit.h"

#include <algorithm>
#include <array>
#include <exception>
#include <mutex>
#include <utility>
#include <zip.h>

namespace asperity {

namespace {

constexpr std::size_t kStep = std::size_t{1} << 18U;
/// No byte of a compressed entry makes more; a damaged directory may promise more.
constexpr std::uint64_t kMaxExpansion = 1032;

/// A damaged directory lists stored entries of no bytes; libzip 1.7 crashes when it seeks in one.
bool isStored(const zip_stat_t& status) {
    return status.comp_method == ZIP_CM_STORE && status.encryption_method == ZIP_EM_NONE &&
           status.comp_size == status.size && status.size > 0;
}

/// Each needs some 350 bytes of memory. An archive of curves has more of them only where it is
/// large: the entries of a map hold hundreds of bytes each.
constexpr std::uint64_t kAlwaysAllowedEntries = 600'000;
constexpr std::uint64_t kMinBytesOfEntry = 160;

/// Refuses an archive whose list of entries needs far more memory than the file.
const ByteSource& withFewEntries(const ByteSource& bytes) {
    const std::uint64_t most = std::max(kAlwaysAllowedEntries, bytes.size() / kMinBytesOfEntry);
    if (zipListsMoreThan(most, bytes)) {
        throw InputError(bytes.name(), "directory of the zip archive",
                         "it lists more than " + std::to_string(most) +
                             " files; no archive of this size has so many");
    }
    return bytes;
}

std::string entryName(const std::string& file, const std::string& entry) {
    return file + ": " + entry;
}

/// The source of libzip. It knows no exceptions: one waits here until libzip has returned.
struct Input {
    const ByteSource* bytes = nullptr;
    std::uint64_t offset = 0;
    std::exception_ptr failure;
    zip_error_t error{};

    zip_int64_t read(void* data, zip_uint64_t length) {
        const std::uint64_t left = bytes->size() - std::min(offset, bytes->size());
        const std::uint64_t count = std::min<std::uint64_t>(length, left);
        bytes->read(offset, {static_cast<char*>(data), static_cast<std::size_t>(count)});
        offset += count;
        return static_cast<zip_int64_t>(count);
    }

    zip_int64_t seek(void* data, zip_uint64_t length) {
        const zip_int64_t to =
            zip_source_seek_compute_offset(offset, bytes->size(), data, length, &error);
        if (to < 0) {
            return -1;
        }
        offset = static_cast<std::uint64_t>(to);
        return 0;
    }

    zip_int64_t describe(void* data) const {
        auto* const status = static_cast<zip_stat_t*>(data);
        zip_stat_init(status);
        status->size = bytes->size();
        status->valid = ZIP_STAT_SIZE;
        return sizeof(zip_stat_t);
    }

    zip_int64_t answer(void* data, zip_uint64_t length, zip_source_cmd_t command) {
        switch (command) {
        case ZIP_SOURCE_OPEN:
            offset = 0;
            return 0;
        case ZIP_SOURCE_READ:
            return read(data, length);
        case ZIP_SOURCE_SEEK:
            return seek(data, length);
        case ZIP_SOURCE_TELL:
            return static_cast<zip_int64_t>(offset);
        case ZIP_SOURCE_STAT:
            return describe(data);
        case ZIP_SOURCE_ERROR:
            return zip_error_to_data(&error, data, length);
        case ZIP_SOURCE_SUPPORTS:
            return ZIP_SOURCE_SUPPORTS_SEEKABLE |
                   ZIP_SOURCE_MAKE_COMMAND_BITMASK(ZIP_SOURCE_ACCEPT_EMPTY);
        case ZIP_SOURCE_ACCEPT_EMPTY:
        case ZIP_SOURCE_CLOSE:
        case ZIP_SOURCE_FREE:
            return 0;
        default:
            zip_error_set(&error, ZIP_ER_OPNOTSUPP, 0);
            return -1;
        }
    }
};

zip_int64_t answerOf(void* state, void* data, zip_uint64_t length, zip_source_cmd_t command) {
    auto& input = *static_cast<Input*>(state);
    try {
        return input.answer(data, length, command);
    } catch (...) {
        input.failure = std::current_exception();
        zip_error_set(&input.error, ZIP_ER_READ, 0);
        return -1;
    }
}

struct CloseEntry {
    void operator()(zip_file_t* file) const { zip_fclose(file); }
};
using OpenEntry = std::unique_ptr<zip_file_t, CloseEntry>;

/// Ends an error of libzip's, which must be initialized.
std::string textOf(zip_error_t& error) {
    std::string text = zip_error_strerror(&error);
    zip_error_fini(&error);
    return text;
}

constexpr std::string_view kLocalMark = "PK\3\4";
constexpr std::string_view kEntryMark = "PK\1\2";
constexpr std::string_view kEndMark = "PK\5\6";
constexpr std::string_view kLocatorMark = "PK\6\7";
constexpr std::string_view kEnd64Mark = "PK\6\6";
constexpr std::uint64_t kEndBytes = 22;
constexpr std::uint64_t kLocatorBytes = 20;
constexpr std::uint64_t kEnd64Bytes = 56;
constexpr std::uint64_t kMaxComment = 65536;  // of which libzip takes one byte more than can be
/// A million entries.
constexpr std::uint64_t kMaxDirectory = std::uint64_t{1} << 27U;

bool lies(const ByteSpan& span, const ByteSource& bytes) {
    return span.offset <= bytes.size() && span.count <= bytes.size() - span.offset;
}

/// The record of `count` bytes with this mark; empty when it is not there.
std::string recordAt(const ByteSource& bytes, const ByteSpan& span, std::string_view mark) {
    std::string record = lies(span, bytes) ? bytesOf(bytes, span) : std::string();
    return record.starts_with(mark) ? record : std::string();
}

/// Returns the directory's span by the end record at `end`. Where a locator is before it,
/// the 64-bit record alone counts, whatever the 32-bit fields say: that is how libzip reads them.
std::optional<ByteSpan> spanOf(const ByteSource& bytes, std::uint64_t end,
                               std::string_view endRecord) {
    const std::string locator =
        end < kLocatorBytes ? std::string()
                            : recordAt(bytes, {end - kLocatorBytes, kLocatorBytes}, kLocatorMark);
    if (locator.empty()) {
        return ByteSpan{littleEndian<std::uint32_t>(endRecord.data() + 16),
                        littleEndian<std::uint32_t>(endRecord.data() + 12)};
    }
    const std::string record =
        recordAt(bytes, {littleEndian<std::uint64_t>(locator.data() + 8), kEnd64Bytes}, kEnd64Mark);
    if (record.empty()) {
        return std::nullopt;
    }
    return ByteSpan{littleEndian<std::uint64_t>(record.data() + 48),
                    littleEndian<std::uint64_t>(record.data() + 40)};
}

bool isDirectory(const ByteSource& bytes, const ByteSpan& span) {
    return lies(span, bytes) &&
           (span.count == 0 ||
            !recordAt(bytes, {span.offset, kEntryMark.size()}, kEntryMark).empty());
}

/// The directories that the file may have, from its front on: a comment or a stored entry can hold
/// another end record, and libzip reads what each of them lists.
std::vector<ByteSpan> directorySpans(const ByteSource& bytes) {
    const std::uint64_t searched = std::min(bytes.size(), kEndBytes + kMaxComment);
    const std::uint64_t start = bytes.size() - searched;
    const std::string tail = bytesOf(bytes, {start, searched});
    std::vector<ByteSpan> spans;
    for (std::size_t mark = tail.find(kEndMark);
         mark != std::string::npos && tail.size() - mark >= kEndBytes;
         mark = tail.find(kEndMark, mark + 1)) {
        const std::optional<ByteSpan> span =
            spanOf(bytes, start + mark, std::string_view(tail).substr(mark, kEndBytes));
        if (span && isDirectory(bytes, *span)) {
            spans.push_back(*span);
        }
    }
    return spans;
}

/// Counts the entries of a directory up to the first that is damaged; more than `most` are not
/// counted.
std::uint64_t entriesIn(const ByteSource& bytes, const ByteSpan& span, std::uint64_t most) {
    constexpr std::size_t kNameLength = 28;
    constexpr std::size_t kExtraLength = 30;
    constexpr std::size_t kCommentLength = 32;
    ByteReader reader(bytes, span);
    std::array<char, 46> entry{};
    for (std::uint64_t count = 0;; ++count) {
        if (count > most || reader.remaining() < entry.size()) {
            return count;
        }
        reader.copy(entry, "an entry");
        std::uint64_t rest = 0;
        for (const std::size_t length : {kNameLength, kExtraLength, kCommentLength}) {
            rest += littleEndian<std::uint16_t>(entry.data() + length);
        }
        if (std::string_view(entry.data(), kEntryMark.size()) != kEntryMark ||
            rest > reader.remaining()) {
            return count;
        }
        (void)reader.take(rest, "an entry");
    }
}

}  // namespace

/// The open archive; one thread at a time is in libzip.
class ZipArchive::Opened {
public:
    explicit Opened(const ByteSource& bytes) : input_{.bytes = &bytes} {
        zip_error_t error;
        zip_error_init(&error);
        zip_source_t* const source = zip_source_function_create(answerOf, &input_, &error);
        zip_ = source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, &error);
        if (zip_ != nullptr) {
            zip_error_fini(&error);
            return;
        }
        zip_source_free(source);
        const std::string reason = textOf(error);
        if (input_.failure) {
            std::rethrow_exception(input_.failure);
        }
        throw InputError(bytes.name(), "", "the zip archive is damaged or truncated: " + reason);
    }
    Opened(const Opened&) = delete;
    Opened& operator=(const Opened&) = delete;
    ~Opened() { zip_discard(zip_); }

    [[nodiscard]] const std::string& file() const { return input_.bytes->name(); }
    [[nodiscard]] const ByteSource& bytes() const { return *input_.bytes; }
    [[nodiscard]] std::mutex& mutex() { return mutex_; }

    [[nodiscard]] std::vector<ZipEntry> list() {
        const auto count = static_cast<std::uint64_t>(zip_get_num_entries(zip_, 0));
        std::vector<ZipEntry> entries;
        entries.reserve(count);
        for (std::uint64_t i = 0; i < count; ++i) {
            zip_stat_t status;
            zip_stat_init(&status);
            if (zip_stat_index(zip_, i, ZIP_FL_ENC_GUESS, &status) != 0 || status.name == nullptr) {
                fail("entry " + std::to_string(i + 1), zip_strerror(zip_));
            }
            std::string name = status.name;
            std::ranges::replace(name, '\\', '/');
            entries.push_back({.name = std::move(name),
                               .size = status.size,
                               .packed = status.comp_size,
                               .index = i,
                               .isStored = isStored(status)});
        }
        return entries;
    }

    [[nodiscard]] OpenEntry open(const ZipEntry& entry) {
        OpenEntry file(zip_fopen_index(zip_, entry.index, 0));
        if (file == nullptr) {
            fail(entry.name, zip_strerror(zip_));
        }
        return file;
    }

    /// Reads as many of the next bytes as there are. @throw InputError when they cannot be decoded
    [[nodiscard]] std::size_t read(zip_file_t& from, std::span<char> bytes,
                                   const ZipEntry& entry) const {
        std::size_t done = 0;
        while (done < bytes.size()) {
            const zip_int64_t count = zip_fread(&from, bytes.data() + done, bytes.size() - done);
            if (count < 0) {
                fail(entry.name, zip_file_strerror(&from));
            }
            if (count == 0) {
                break;
            }
            done += static_cast<std::size_t>(count);
        }
        return done;
    }

    [[noreturn]] void fail(const std::string& entry, const std::string& reason) const {
        if (input_.failure) {
            std::rethrow_exception(input_.failure);
        }
        throw InputError(file(), entry, "it cannot be taken from the zip archive: " + reason);
    }

private:
    Input input_;
    zip_t* zip_ = nullptr;
    std::mutex mutex_;
};

std::string_view ZipEntry::baseName() const {
    return std::string_view(name).substr(name.find_last_of('/') + 1);
}

ZipArchive::ZipArchive(const ByteSource& bytes)
    : opened_(std::make_shared<Opened>(withFewEntries(bytes))), entries_(opened_->list()) {}

const ZipEntry* ZipArchive::find(std::string_view name) const {
    const auto found = std::ranges::find(entries_, name, &ZipEntry::name);
    return found == entries_.end() ? nullptr : &*found;
}

void ZipArchive::decode(const ZipEntry& entry, std::uint64_t most, const ByteSink& sink) const {
    if (entry.size > most) {
        throw InputError(opened_->file(), entry.name,
                         "it holds " + std::to_string(entry.size) + " bytes; at most " +
                             std::to_string(most) + " are expected");
    }
    const std::scoped_lock lock(opened_->mutex());
    const OpenEntry file = opened_->open(entry);
    std::vector<char> piece(
        static_cast<std::size_t>(std::min<std::uint64_t>(kStep, entry.size + 1)));
    std::uint64_t done = 0;
    // One byte more than are listed: at the end, libzip compares the CRC.
    for (bool more = true; more && done <= entry.size;) {
        const std::size_t wanted =
            static_cast<std::size_t>(std::min<std::uint64_t>(piece.size(), entry.size + 1 - done));
        const std::size_t count = opened_->read(*file, std::span(piece).first(wanted), entry);
        sink(std::span(piece).first(count));
        done += count;
        more = count == wanted;
    }
    if (done != entry.size) {
        opened_->fail(entry.name, "it does not hold the " + std::to_string(entry.size) +
                                      " bytes that the directory lists");
    }
}

std::string ZipArchive::decoded(const ZipEntry& entry, std::uint64_t most) const {
    requireMemory(std::min(entry.size, most), opened_->file(), entry.name);
    std::string bytes;
    const std::uint64_t packed = std::min(entry.packed, opened_->bytes().size());
    bytes.reserve(static_cast<std::size_t>(std::min({entry.size, packed * kMaxExpansion, most})));
    decode(entry, most,
           [&bytes](std::span<const char> piece) { bytes.append(piece.begin(), piece.end()); });
    return bytes;
}

/// A stored entry, whose bytes are copied out of the archive when they are asked for.
class ZipArchive::StoredEntry final : public ByteSource {
public:
    StoredEntry(std::shared_ptr<Opened> archive, const ZipEntry& entry)
        : ByteSource(entryName(archive->file(), entry.name))
        , archive_(std::move(archive))
        , entry_(entry)
        , file_(archive_->open(entry)) {}
    StoredEntry(const StoredEntry&) = delete;
    StoredEntry& operator=(const StoredEntry&) = delete;
    ~StoredEntry() override {
        const std::scoped_lock lock(archive_->mutex());
        file_.reset();
    }

    [[nodiscard]] std::uint64_t size() const override { return entry_.size; }
    void read(std::uint64_t offset, std::span<char> bytes) const override {
        const std::scoped_lock lock(archive_->mutex());
        const bool there = offset <= entry_.size && bytes.size() <= entry_.size - offset &&
                           zip_fseek(file_.get(), static_cast<zip_int64_t>(offset), SEEK_SET) == 0;
        if (!there || archive_->read(*file_, bytes, entry_) != bytes.size()) {
            archive_->fail(entry_.name,
                           "it ends before byte " + std::to_string(offset + bytes.size()));
        }
    }
    void requireUnchanged() const override { archive_->bytes().requireUnchanged(); }

private:
    std::shared_ptr<Opened> archive_;
    ZipEntry entry_;
    OpenEntry file_;
};

std::shared_ptr<const ByteSource> ZipArchive::source(const ZipEntry& entry,
                                                     std::uint64_t most) const {
    if (entry.isStored && entry.size <= most) {
        const std::scoped_lock lock(opened_->mutex());
        return std::make_shared<StoredEntry>(opened_, entry);
    }
    return std::make_shared<OwnedBytes>(decoded(entry, most),
                                        entryName(opened_->file(), entry.name));
}

bool isZip(const ByteSource& bytes) {
    return bytes.startsWith(kLocalMark) || bytes.startsWith(kEndMark);
}

std::optional<std::string> zipDirectory(const ByteSource& bytes) {
    const std::vector<ByteSpan> spans = directorySpans(bytes);
    if (spans.empty() || spans.back().count > kMaxDirectory) {
        return std::nullopt;
    }
    return bytesOf(bytes, spans.back());
}

bool zipListsMoreThan(std::uint64_t most, const ByteSource& bytes) {
    std::uint64_t count = 0;
    for (const ByteSpan& span : directorySpans(bytes)) {
        count += entriesIn(bytes, span, most - count);
        if (count > most) {
            return true;
        }
    }
    return false;
}

}  // namespace asperity
