#include "core/io/heightmap/UnreadFormats.h"

#include <algorithm>
#include <array>

// Formats that no real file at hand proves a reader of; docs/formats.md 20.

namespace asperity {

namespace {

using namespace std::string_view_literals;

struct UnreadFormat {
    std::string_view mark;  ///< at the front
    std::string_view name;
};

constexpr std::array kUnread{
    UnreadFormat{"\x89HDF\r\n\x1A\n"sv, "an HDF5 file (as .h5-jpk or .nhf)"sv},
    UnreadFormat{"\x1F\x8B"sv, "a gzip file (unpack it first)"sv},
    UnreadFormat{"\x01\xB0\x93\xFF"sv, "an NT-MDT file (.mdt)"sv},
    UnreadFormat{"ISO/TC 201 SPM data transfer format"sv, "an ISO 28600 file (.spm)"sv}};

}  // namespace

std::string_view unreadFormat(const ByteSource& bytes) {
    const auto* const found = std::ranges::find_if(
        kUnread, [&](const UnreadFormat& each) { return bytes.startsWith(each.mark); });
    return found == kUnread.end() ? std::string_view() : found->name;
}

}  // namespace asperity
