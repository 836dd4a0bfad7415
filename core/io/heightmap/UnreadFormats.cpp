#include "core/io/heightmap/UnreadFormats.h"

#include <algorithm>
#include <array>

// Formats that no real file at hand proves a reader of, docs/formats.md 20, and pictures.

namespace asperity {

namespace {

using namespace std::string_view_literals;

constexpr std::array kUnread{
    UnreadFormat{"\x89HDF\r\n\x1A\n"sv, "an HDF5 file (as .h5-jpk or .nhf)"sv},
    UnreadFormat{"\x1F\x8B"sv, "a gzip file (unpack it first)"sv},
    UnreadFormat{"PK\3\4"sv, "a zip archive of neither JPK nor X3P data"sv},
    UnreadFormat{
        .mark = "\x01\xB0\x93\xFF"sv, .name = "an NT-MDT file (.mdt)"sv, .byGwyddion = true},
    UnreadFormat{.mark = "ISO/TC 201 SPM data transfer format"sv,
                 .name = "an ISO 28600 file (.spm)"sv,
                 .byGwyddion = true},
    UnreadFormat{"\xFF\xD8\xFF"sv, "JPEG"sv, true},
    UnreadFormat{"GIF8"sv, "GIF"sv, true},
    UnreadFormat{"%PDF-"sv, "PDF"sv, true}};

}  // namespace

std::optional<UnreadFormat> unreadFormat(const ByteSource& bytes) {
    const auto* const found = std::ranges::find_if(
        kUnread, [&](const UnreadFormat& each) { return bytes.startsWith(each.mark); });
    return found == kUnread.end() ? std::nullopt : std::optional(*found);
}

std::string pictureRefusal(std::string_view name) {
    return "this is a picture (" + std::string(name) +
           "), whose values are no heights; save the scan as data, not as an image";
}

}  // namespace asperity
