#include "core/io/heightmap/UnreadFormats.h"

#include "core/io/ByteReader.h"

#include <algorithm>
#include <array>
#include <cstdint>

// Formats for which we have no real file to prove a reader, docs/formats.md 20, and pictures.

namespace asperity {

namespace {

using namespace std::string_view_literals;

constexpr std::array kUnread{
    UnreadFormat{"Asperity, HDF5 behind this block"sv, "a recording of Asperity, of no scan"sv},
    UnreadFormat{"MATLAB 7.3 MAT-file"sv, "an HDF5 file of MATLAB (.mat)"sv},
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

/// By a name that only files of this kind hold; the last one is in all.
constexpr std::array kUnreadHdf5{
    UnreadFormat{"position-pattern.grid"sv, "an HDF5 file of JPK (.h5-jpk)"sv},
    UnreadFormat{"nsf_file_version"sv, "an HDF5 file of Nanosurf (.nhf)"sv},
    UnreadFormat{"topostats"sv, "an HDF5 file of TopoStats (.topostats)"sv},
    UnreadFormat{"_NCProperties"sv, "a netCDF 4 file (.nc)"sv},
    UnreadFormat{"NX_class"sv, "a NeXus file of no NXafm, NXstm or NXspm"sv},
    UnreadFormat{""sv, "an HDF5 file of no known kind"sv}};

}  // namespace

std::optional<UnreadFormat> unreadFormat(const ByteSource& bytes) {
    if (isHdf5(bytes)) {
        return *std::ranges::find_if(
            kUnreadHdf5, [&](const UnreadFormat& each) { return holdsName(bytes, each.mark); });
    }
    const auto* const found = std::ranges::find_if(
        kUnread, [&](const UnreadFormat& each) { return bytes.startsWith(each.mark); });
    return found == kUnread.end() ? std::nullopt : std::optional(*found);
}

std::string pictureRefusal(std::string_view name) {
    return "this is a picture (" + std::string(name) +
           "), whose values are no heights; save the scan as data, not as an image";
}

using namespace std::string_view_literals;

bool isHdf5(const ByteSource& bytes) { return bytes.startsWith("\x89HDF\r\n\x1A\n"sv); }

bool holdsName(const ByteSource& bytes, std::string_view name) {
    constexpr std::uint64_t kChunk = std::uint64_t{1} << 20U;
    constexpr std::uint64_t kOverlap = 64;
    for (std::uint64_t offset = 0; offset < bytes.size(); offset += kChunk - kOverlap) {
        const std::string chunk = bytesOf(bytes, {offset, std::min(kChunk, bytes.size() - offset)});
        if (chunk.find(name) != std::string::npos) {
            return true;
        }
    }
    return false;
}

}  // namespace asperity
