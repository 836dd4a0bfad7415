#include "core/Error.h"
#include "core/io/heightmap/ForceCurveFiles.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/SampleRows.h"
#include "core/io/heightmap/jpk/JpkSlot.h"
#include "core/io/zip/ZipArchive.h"

#include <algorithm>
#include <memory>

// JPK's archives of force curves: zip files with a folder a curve and, of a map, the image of its
// heights beside them. Source: docs/formats.md 5.

namespace asperity {

namespace {

constexpr std::string_view kImage = "data-image.";
constexpr std::string_view kCurves = "segments/";
constexpr std::string_view kProperties = "header.properties";
/// Ten channels of 4096 x 4096 pixels; a map of curves has a few hundred a side.
constexpr std::uint64_t kMaxImage = std::uint64_t{1} << 30U;
/// Ten channels of 1,600 x 1,600 pixels.
constexpr std::uint64_t kAlwaysAllowedImage = std::uint64_t{1} << 27U;

bool isImage(const ZipEntry& entry) { return entry.baseName().starts_with(kImage); }

bool belongsToCurves(const ZipEntry& entry) {
    return entry.name.find(kCurves) != std::string::npos;
}

/// Returns the most bytes that an image may have: behind its pixels a small archive can hold zeros
/// that take a thousand times its size of memory. The curves of a map are larger than its image.
std::uint64_t mostBytesOf(const ByteSource& archive) {
    return std::clamp(archive.size() + archive.size() / 2, kAlwaysAllowedImage, kMaxImage);
}

StoredScan readJpkArchive(const ByteSource& bytes) {
    const ZipArchive archive(bytes);
    const auto image = std::ranges::find_if(archive.entries(), isImage);
    if (image == archive.entries().end()) {
        throw InputError(bytes.name(), "",
                         "this JPK archive holds force curves alone and no image" +
                             std::string(kCurvePointer));
    }
    const std::shared_ptr<const ByteSource> content = archive.source(*image, mostBytesOf(bytes));
    if (!isJpkImage(*content)) {
        throw InputError(content->name(), "", "expected a JPK image; the archive is damaged");
    }
    StoredScan scan = readJpkImage(*content);
    for (StoredChannel& channel : scan.channels) {
        channel.readRow = keeping(std::move(channel.readRow), content);
    }
    if (std::ranges::any_of(archive.entries(), belongsToCurves)) {
        scan.notes.emplace_back("the archive also holds force curves: 'asperity info' lists "
                                "them, 'asperity fit' evaluates them");
    }
    scan.provenance.push_back({"image", image->name, "the zip archive's directory"});
    return scan;
}

constexpr std::array<std::string_view, 2> kJpkArchiveExtensions{".jpk-qi-data", ".jpk-force-map"};

bool recognizesJpkArchive(const ByteSource& bytes) {
    if (!isZip(bytes)) {
        return false;
    }
    const std::optional<std::string> directory = zipDirectory(bytes);
    const auto lists = [&](std::string_view name) {
        return directory->find(name) != std::string::npos;
    };
    return directory && lists(kProperties) &&
           (lists(kImage) || lists(kCurves) || lists("shared-data/") || lists("index/"));
}

}  // namespace

const HeightMapFormat kJpkArchiveFormat = {.name = "JPK archive",
                                           .extensions = kJpkArchiveExtensions,
                                           .recognizes = recognizesJpkArchive,
                                           .read = readJpkArchive};

}  // namespace asperity
