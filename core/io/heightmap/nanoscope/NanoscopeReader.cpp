#include "core/Error.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/ForceCurveFiles.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/SampleRows.h"
#include "core/io/heightmap/ScanImage.h"
#include "core/io/heightmap/WholeImages.h"
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
/// Written with electrochemistry.
constexpr std::string_view kEcMagic = "\\*EC File list";
constexpr std::string_view kTextMagic = "?*File list";
/// Force curves and force volumes; these list the image that was recorded with them, too.
constexpr std::string_view kForceMagic = "\\*Force file list";
constexpr char kHeaderPadding = '\x1A';

class NanoscopeReader {
public:
    explicit NanoscopeReader(const ByteSource& bytes)
        : bytes_(bytes), file_(bytes.name()), start_(nanoscopeStart(bytes)) {}

    StoredScan read() {
        if (start_.starts_with(kTextMagic)) {
            throw InputError(file_, "",
                             "this NanoScope file was exported as text; save it in binary form");
        }
        sections_ = readNanoscopeHeader(start_, file_);
        headerEnd_ = nanoscopeHeaderSize(start_);
        refuseProfiles();
        takeSharedTexts();
        for (const NanoscopeSection& section : sections_) {
            if (isNanoscopeImageList(section)) {
                addChannel(section);
            }
        }
        if (!images_.areAll() && !isHeaderWhole()) {
            images_.requireAll();
        }
        images_.finish(result_);
        requireAnyImage();
        return std::move(result_);
    }

private:
    /// Returns a value of the whole header, whatever list it is in; empty: there is none.
    [[nodiscard]] std::string anywhere(const std::string& key) const {
        const std::string* const text = nanoscopeEntry(sections_, key);
        return text == nullptr ? std::string() : *text;
    }

    /// Refuses profiles of trenches: lines of different lengths.
    void refuseProfiles() const {
        if (anywhere("Start context").ends_with("VAR")) {
            throw InputError(file_, "header",
                             "this NanoScope file holds profiles of different lengths (start "
                             "context '" +
                                 anywhere("Start context") + "'), no image");
        }
    }

    void requireAnyImage() {
        if (result_.channels.empty()) {
            throw InputError(file_, holdsForceCurves() ? "" : "header",
                             holdsForceCurves()
                                 ? "this NanoScope file holds force curves, no image" +
                                       std::string(kCurvePointer)
                                 : "it lists no image ('Ciao image list')");
        }
        if (holdsForceCurves()) {
            result_.notes.emplace_back("the file holds force curves, too: 'asperity info' lists "
                                       "them, 'asperity fit' evaluates them");
        }
    }

    [[nodiscard]] bool holdsForceCurves() const {
        const std::string mode = anywhere("Operating mode");
        return start_.starts_with(kForceMagic) || mode == "Force" || mode == "Force Volume" ||
               std::ranges::any_of(sections_, [](const NanoscopeSection& section) {
                   return lowerCase(section.name) == "ciao force image list";
               });
    }

    /// Returns whether nothing is missing before the first samples: the header says how long it is,
    /// and is filled up to there. Where bytes are missing, samples are not where it says.
    [[nodiscard]] bool isHeaderWhole() const {
        const std::optional<long long> length =
            parseInteger(sections_.empty() || sections_[0].find("Data length") == nullptr
                             ? ""
                             : *sections_[0].find("Data length"));
        const std::size_t textEnd = start_.find('\n', headerEnd_);
        if (!length || *length <= 0 || textEnd == std::string::npos) {
            return false;
        }
        const std::uint64_t end = std::min(static_cast<std::uint64_t>(*length), bytes_.size());
        if (end <= textEnd || end > kMaxNanoscopeHeader) {
            return false;
        }
        std::string filling(end - textEnd, '\0');
        bytes_.read(textEnd, filling);
        return filling.find_first_not_of(std::string("\r\n\0", 3) + kHeaderPadding) ==
               std::string::npos;
    }

    void addChannel(const NanoscopeSection& section) {
        const std::string location = "image list " + std::to_string(++listed_);
        requireImages(listed_, file_, location);
        const NanoscopeImage image(sections_, section, file_, location);
        const NanoscopeLayout layout = image.layout();
        const NanoscopeScale scale = image.scale();
        ScanChannel channel;
        channel.name = image.name();
        channel.unit = scale.unit;
        channel.lateralUnit = "m";
        channel.direction = image.direction();
        channel.map = emptyMap(layout.size, layout.sizeX, layout.sizeY);
        if (const std::optional<NanoscopePosition> center = image.center(layout)) {
            setOrigin(channel, center->x, center->y, GivenPoint::Center);
        }
        for (const auto& [key, entry] : section.entries) {
            channel.metadata.insert_or_assign(entry.key, entry.value);
        }
        // Whatever the scan's direction was, the first stored row is the bottom of the image.
        const SampleLayout samples{.size = layout.size,
                                   .type = layout.sampleBytes == sizeof(std::int32_t)
                                               ? SampleType::Int32
                                               : SampleType::Int16,
                                   .offset = layout.offset,
                                   .bottomFirst = true};
        if (!images_.holds(bytes_, samples, location, channel.name)) {
            return;
        }
        takeSamples(samples, location);
        addNotes(image, channel, layout.sampleBytes);
        noteRotation(result_.notes, image.rotation());
        addProvenance(image, channel, scale, location);
        result_.channels.push_back({.channel = std::move(channel),
                                    .factor = scale.factor,
                                    .readRow = rowsOf(bytes_, samples)});
    }

    void takeSamples(const SampleLayout& samples, const std::string& location) {
        if (samples.offset < headerEnd_) {
            throw InputError(file_, location,
                             "its data start at byte " + std::to_string(samples.offset) +
                                 ", but the header ends at " + std::to_string(headerEnd_));
        }
        const std::uint64_t pastLast = samples.offset + samples.bytes();
        for (const auto& [start, end] : taken_) {
            if (samples.offset < end && start < pastLast) {
                throw InputError(file_, location, "its data overlap those of another image");
            }
        }
        taken_.emplace_back(samples.offset, pastLast);
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
                       const NanoscopeScale& scale, const std::string& location) {
        const std::string version = image.ofFile("Version");
        result_.provenance.clear();
        if (!version.empty()) {
            result_.provenance = {{"format version", version, "File list, Version"}};
        }
        settleSize(channel, location + ", Scan size");
        channel.provenance.push_back(scaleProvenance(scale.factor, scale.unit, scale.source));
        channel.provenance.push_back(
            {"orientation", "the bottom row is stored first", "the same in every NanoScope file"});
    }

    /// Takes the texts of everything but the images.
    void takeSharedTexts() {
        for (const NanoscopeSection& section : sections_) {
            if (lowerCase(section.name).ends_with("image list")) {
                continue;
            }
            for (const auto& [key, entry] : section.entries) {
                result_.texts.set(entry.key, entry.value);
            }
        }
    }

    const ByteSource& bytes_;
    const std::string& file_;
    std::string start_;  ///< with the whole header
    std::vector<NanoscopeSection> sections_;
    std::size_t listed_ = 0;  ///< images until now
    WholeImages images_;
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
            return bytes.startsWith(kNanoscopeMagic) || bytes.startsWith(kEcMagic) ||
                   bytes.startsWith(kTextMagic) || bytes.startsWith(kForceMagic);
        },
    .read = [](const ByteSource& bytes) { return NanoscopeReader(bytes).read(); }};

}  // namespace asperity
