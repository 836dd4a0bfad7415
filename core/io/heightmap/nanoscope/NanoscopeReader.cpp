#include "core/Error.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/SampleRows.h"
#include "core/io/heightmap/ScanImage.h"
#include "core/io/heightmap/nanoscope/NanoscopeHeader.h"
#include "core/io/heightmap/nanoscope/NanoscopeImage.h"

#include <algorithm>
#include <utility>
#include <vector>

// Bruker (Veeco, Digital Instruments) NanoScope: a text header of sections, then the samples.
// Source: docs/formats.md 3.

namespace asperity {

namespace {

constexpr std::string_view kNanoscopeMagic = "\\*File list";
constexpr std::string_view kTextMagic = "?*File list";
/// Force curves and force volumes; these list the image that was recorded with them, too.
constexpr std::string_view kForceMagic = "\\*Force file list";
constexpr std::string_view kImageList = "\\*Ciao image list";

class NanoscopeReader {
public:
    explicit NanoscopeReader(const ByteSource& bytes)
        : bytes_(bytes)
        , file_(bytes.name())
        , start_(bytes.startUntil(
              [](std::string_view start) {
                  return nanoscopeHeaderSize(start) != std::string_view::npos;
              },
              kMaxNanoscopeHeader)) {}

    StoredScan read() {
        refuseRelatives();
        sections_ = readNanoscopeHeader(start_, file_);
        headerEnd_ = nanoscopeHeaderSize(start_);
        for (const NanoscopeSection& section : sections_) {
            if (lowerCase(section.name) == "ciao image list") {
                addChannel(section);
            }
        }
        if (result_.channels.empty()) {
            throw InputError(file_, "header", "it lists no image ('Ciao image list')");
        }
        if (holdsForceCurves()) {
            result_.notes.emplace_back("the file holds force curves, too, which are not read");
        }
        return std::move(result_);
    }

private:
    void refuseRelatives() const {
        if (start_.starts_with(kForceMagic) && start_.find(kImageList) == std::string::npos) {
            throw InputError(file_, "", "this NanoScope file holds force curves, no image");
        }
        if (start_.starts_with(kTextMagic)) {
            throw InputError(file_, "",
                             "this NanoScope file was exported as text; save it in binary form");
        }
    }

    [[nodiscard]] bool holdsForceCurves() const {
        return start_.starts_with(kForceMagic) ||
               std::ranges::any_of(sections_, [](const NanoscopeSection& section) {
                   return lowerCase(section.name) == "ciao force image list";
               });
    }

    void addChannel(const NanoscopeSection& section) {
        const std::string place = "image list " + std::to_string(result_.channels.size() + 1);
        requireImages(result_.channels.size() + 1, file_, place);
        const NanoscopeImage image(sections_, section, file_, place);
        const NanoscopeLayout layout = image.layout();
        const NanoscopeScale scale = image.scale();
        ScanChannel channel;
        channel.name = image.name();
        channel.unit = scale.unit;
        channel.lateralUnit = "m";
        channel.direction = image.direction();
        channel.originX = image.scanLength("X Offset");
        channel.originY = image.scanLength("Y Offset");
        channel.map = emptyMap(layout.size, layout.sizeX, layout.sizeY);
        channel.metadata = metadata(section);
        // Whatever the scan's direction was, the first stored row is the bottom of the image.
        const SampleLayout samples{.size = layout.size,
                                   .type = layout.sampleBytes == sizeof(std::int32_t)
                                               ? SampleType::Int32
                                               : SampleType::Int16,
                                   .place = layout.offset,
                                   .bottomFirst = true};
        takeSamples(samples, place);
        addNotes(image, channel, layout.sampleBytes);
        addProvenance(image, channel, scale, place);
        result_.channels.push_back({.channel = std::move(channel),
                                    .factor = scale.factor,
                                    .readRow = rowsOf(bytes_, samples)});
    }

    void takeSamples(const SampleLayout& samples, const std::string& place) {
        requireSamples(bytes_, samples, place);
        if (samples.place < headerEnd_) {
            throw InputError(file_, place,
                             "its data start at byte " + std::to_string(samples.place) +
                                 ", but the header ends at " + std::to_string(headerEnd_));
        }
        const std::uint64_t pastLast = samples.place + samples.bytes();
        for (const auto& [start, end] : taken_) {
            if (samples.place < end && start < pastLast) {
                throw InputError(file_, place, "its data overlap those of another image");
            }
        }
        taken_.emplace_back(samples.place, pastLast);
    }

    static void addNotes(const NanoscopeImage& image, ScanChannel& channel, int sampleBytes) {
        channel.notes = image.notes();
        if (image.bytesPerPixel() != sampleBytes) {
            channel.notes.push_back("the header names " + std::to_string(image.bytesPerPixel()) +
                                    " bytes a sample, but this version stores " +
                                    std::to_string(sampleBytes));
        }
    }

    void addProvenance(const NanoscopeImage& image, ScanChannel& channel,
                       const NanoscopeScale& scale, const std::string& place) {
        result_.provenance = {{"format version", image.version(), "File list, Version"}};
        settleSize(channel, place + ", Scan size");
        channel.provenance.push_back(scaleProvenance(scale.factor, scale.unit, scale.source));
        channel.provenance.push_back(
            {"orientation", "the bottom row is stored first", "the same in every NanoScope file"});
    }

    /// Everything but the other images; the image's own entries win.
    [[nodiscard]] std::map<std::string, std::string> metadata(const NanoscopeSection& image) const {
        std::map<std::string, std::string> metadata;
        for (const NanoscopeSection& section : sections_) {
            const bool other = lowerCase(section.name).ends_with("image list");
            if (!other) {
                insert(metadata, section);
            }
        }
        insert(metadata, image);
        return metadata;
    }

    static void insert(std::map<std::string, std::string>& metadata,
                       const NanoscopeSection& section) {
        for (const auto& [key, entry] : section.entries) {
            metadata.insert_or_assign(entry.key, entry.value);
        }
    }

    const ByteSource& bytes_;
    const std::string& file_;
    std::string start_;  ///< with the whole header
    std::vector<NanoscopeSection> sections_;
    /// First and past-the-last byte of each image so far.
    std::size_t headerEnd_ = 0;
    std::vector<std::pair<std::uint64_t, std::uint64_t>> taken_;
    StoredScan result_;
};

constexpr std::array<std::string_view, 6> kNanoscopeExtensions{".spm", ".di", ".0*",
                                                               ".1*",  ".2*", ".3*"};

}  // namespace

const HeightMapFormat kNanoscopeFormat = {
    .name = "Bruker NanoScope",
    .extensions = kNanoscopeExtensions,
    .recognizes =
        [](const ByteSource& bytes) {
            return bytes.startsWith(kNanoscopeMagic) || bytes.startsWith(kTextMagic) ||
                   bytes.startsWith(kForceMagic);
        },
    .read = [](const ByteSource& bytes) { return NanoscopeReader(bytes).read(); }};

}  // namespace asperity
