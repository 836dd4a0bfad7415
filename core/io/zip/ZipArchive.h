#pragma once

#include "core/io/ByteReader.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// A file in a zip archive, as the archive's directory lists it.
struct ZipEntry {
    std::string name;          ///< '/' between folders, UTF-8
    std::uint64_t size = 0;    ///< decoded [bytes]
    std::uint64_t packed = 0;  ///< in the archive [bytes]
    std::uint64_t index = 0;   ///< in the directory
    bool isStored = false;     ///< as it is, not compressed, not empty

    /// Behind the last '/'; empty for a folder.
    [[nodiscard]] std::string_view baseName() const;
};

/// Takes the next bytes.
using ByteSink = std::function<void(std::span<const char>)>;

/// A zip archive, read through libzip.
class ZipArchive {
public:
    /// @param bytes must outlive the archive and the sources that it gives
    /// @throw InputError when it is no archive, its directory is damaged, or lists far more entries
    ///        than an archive of this size has
    explicit ZipArchive(const ByteSource& bytes);

    [[nodiscard]] const std::vector<ZipEntry>& entries() const { return entries_; }
    /// Null: there is none of this name.
    [[nodiscard]] const ZipEntry* find(std::string_view name) const;

    /// Decodes a whole entry, piece by piece, and checks its CRC at the end.
    /// @param most bytes that the entry may hold: a small archive can list a huge one
    /// @throw InputError that names file and entry, when it is larger, damaged or encrypted
    void decode(const ZipEntry& entry, std::uint64_t most, const ByteSink& sink) const;
    /// The same into memory.
    [[nodiscard]] std::string decoded(const ZipEntry& entry, std::uint64_t most) const;
    /// The bytes of an entry, named by file and entry. A stored one stays in the archive, any other
    /// is decoded here. @throw as decoded()
    [[nodiscard]] std::shared_ptr<const ByteSource> source(const ZipEntry& entry,
                                                           std::uint64_t most) const;

private:
    class Opened;
    class StoredEntry;

    std::shared_ptr<Opened> opened_;
    std::vector<ZipEntry> entries_;
};

/// Returns whether a content begins as a zip archive does.
[[nodiscard]] bool isZip(const ByteSource& bytes);

/// The raw directory of a zip archive, which holds the names of its entries: enough to recognize
/// what the archive is, and a hundred times faster than to open one of many entries. Empty when it
/// is damaged. Source: PKWARE, APPNOTE.TXT 6.3.9, sections 4.3.12 to 4.3.16.
[[nodiscard]] std::optional<std::string> zipDirectory(const ByteSource& bytes);

/// Returns whether the directories that a zip archive may have, by any of its end records, list
/// more entries than that, each directory up to its first entry that is damaged.
[[nodiscard]] bool zipListsMoreThan(std::uint64_t most, const ByteSource& bytes);

}  // namespace asperity
