#pragma once

#include "core/io/ByteSource.h"

#include <cstdint>
#include <optional>
#include <string>

namespace asperity {

/// Whether a content begins as a zip archive does.
[[nodiscard]] bool isZip(const ByteSource& bytes);

/// The raw directory of a zip archive, in which the names of its entries stand: enough to recognize
/// what the archive is, and a hundred times faster than to open one of many entries. Empty when it
/// is damaged. Source: PKWARE, APPNOTE.TXT 6.3.9, sections 4.3.12 to 4.3.16.
[[nodiscard]] std::optional<std::string> zipDirectory(const ByteSource& bytes);

/// Returns whether the directories that a zip archive may have, by any of its end records, list
/// more entries than that, each directory up to its first entry that is damaged.
[[nodiscard]] bool zipListsMoreThan(std::uint64_t most, const ByteSource& bytes);

}  // namespace asperity
