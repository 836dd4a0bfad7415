#include "core/Error.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/ForceCurveFiles.h"
#include "core/io/heightmap/HeaderFields.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "core/io/heightmap/SampleRows.h"
#include "core/io/heightmap/ScanImage.h"
#include "core/io/heightmap/WholeImages.h"
#include "core/io/heightmap/nanosurf/NanosurfHeader.h"

#include <algorithm>
#include <array>
#include <utility>

// Nanosurf .nid and .ezd: text sections of `key=value`, then the samples of all listed channels,
// one after the other: images, and curves as images of their points. Source: docs/formats.md 10.

namespace asperity {

namespace {

class NanosurfReader {
public:
    explicit NanosurfReader(const ByteSource& bytes) : bytes_(bytes), file_(bytes.name()) {}

    StoredScan read() {
        NanosurfHeader header = readNanosurfHeader(bytes_);
        sections_ = std::move(header.sections);
        offset_ = header.end;
        takeSharedTexts();
        const std::vector<const HeaderFields*> channels = nanosurfChannels(sections_, file_);
        quota_ = TextQuota::ofEach(channels.size());
        for (const HeaderFields* const channel : channels) {
            addChannel(*channel);
        }
        images_.finish(result_);
        if (result_.channels.empty()) {
            throw InputError(file_, "[DataSet]",
                             curves_.empty()
                                 ? "it lists no image"
                                 : "this Nanosurf file holds force curves or spectra, no image (" +
                                       curveList() + ")" + std::string(kCurvePointer));
        }
        if (!curves_.empty()) {
            result_.notes.push_back(
                "the file also holds force curves or spectra, which 'asperity info' lists: " +
                curveList());
        }
        if (const std::string* const version = sections_.at("DataSet").find("Version")) {
            result_.provenance.push_back({"format version", *version, "[DataSet] Version"});
        }
        return std::move(result_);
    }

private:
    void addChannel(const HeaderFields& section) {
        const std::string frame = section.text("Frame");
        const bool scans = lowerCase(frame).find("scan") != std::string::npos;
        if (!scans || section.integer("Lines") < 2) {
            skipCurves(section, frame);
            return;
        }
        const SampleLayout samples{.size = checkedImageSize(section.integer("Points"),
                                                            section.integer("Lines"), file_,
                                                            section.location() + " Points, Lines"),
                                   .type = nanosurfSampleType(section),
                                   .offset = offset_,
                                   .bottomFirst = true};
        offset_ += samples.bytes();
        StoredChannel image = imageOf(section, samples);
        if (images_.holds(bytes_, samples, section.location(), image.channel.name)) {
            result_.channels.push_back(std::move(image));
        }
    }

    /// Curves have a line each.
    void skipCurves(const HeaderFields& section, const std::string& frame) {
        constexpr long long kMax = 1LL << 24;
        const long long points = section.integer("Points");
        const long long lines = section.integer("Lines");
        if (!(points >= 0 && points <= kMax && lines >= 0 && lines <= kMax)) {
            section.fail("Points, Lines",
                         "found " + std::to_string(points) + " x " + std::to_string(lines));
        }
        const auto count = static_cast<std::uint64_t>(points * lines);
        const std::uint64_t length = count * sizeOf(nanosurfSampleType(section));
        offset_ += length;
        long long& curves = curves_[frame.empty() ? "no frame" : frame];
        curves = std::max(curves, lines);
    }

    /// "'Spec forward' (25), 'Spec backward' (25)"
    [[nodiscard]] std::string curveList() const {
        std::string list;
        for (const auto& [frame, count] : curves_) {
            list += (list.empty() ? "'" : ", '") + frame + "' (" + std::to_string(count) + ")";
        }
        return list;
    }

    [[nodiscard]] StoredChannel imageOf(const HeaderFields& section, const SampleLayout& samples) {
        ScanChannel channel;
        channel.direction = directionFromName(section.text("Frame"));
        channel.name = section.text("Dim2Name");
        channel.name += (channel.name.empty() ? "" : " ") + channel.direction;
        const PhysicalUnit x = parseUnit(section.text("Dim0Unit"));
        const PhysicalUnit y = parseUnit(section.text("Dim1Unit"));
        channel.lateralUnit = x.base == y.base ? x.base : std::string();
        channel.map = emptyMap(samples.size, section.number("Dim0Range").value_or(0.0) * x.factor,
                               section.number("Dim1Range").value_or(0.0) * y.factor);
        setOrigin(channel, section.number("Dim0Min").value_or(0.0) * x.factor,
                  section.number("Dim1Min").value_or(0.0) * y.factor, GivenPoint::Corner);
        const BoundedTexts texts = textsOf(section);
        channel.metadata = texts.all();
        result_.hasCutTexts = result_.hasCutTexts || texts.isCut();
        channel.provenance.push_back(
            {"orientation", "the bottom row is stored first", "the same in every Nanosurf file"});
        const PhysicalUnit unit = parseUnit(section.text("Dim2Unit"));
        channel.unit = unit.base;
        settleSize(channel, section.location() + " Dim0Range and Dim1Range");
        const NanosurfScale scale = nanosurfScale(section, samples.type);
        channel.provenance.push_back(scaleProvenance(
            scale.perCount * unit.factor, unit.base,
            section.location() + " Dim2Range over the counts of SaveBits, from Dim2Min on"));
        return {.channel = std::move(channel),
                .factor = unit.factor,
                .readRow = replaced(rowsOf(bytes_, samples), samples.size.columns, scale)};
    }

    /// Takes the texts on the whole scan.
    void takeSharedTexts() {
        if (const auto scan = sections_.find("DataSet-Info"); scan != sections_.end()) {
            result_.texts = textsOf(scan->second);
        }
    }

    /// The fields of a section without the titles among them; several images may have the same one.
    [[nodiscard]] BoundedTexts textsOf(const HeaderFields& section) const {
        BoundedTexts texts(quota_);
        for (const auto& [key, value] : section.all()) {
            if (!key.starts_with("--")) {
                texts.add(key, value);
            }
        }
        return texts;
    }

    const ByteSource& bytes_;
    const std::string& file_;
    HeaderSections sections_;
    TextQuota quota_;                          ///< of each image
    std::uint64_t offset_ = 0;                 ///< of the next samples
    std::map<std::string, long long> curves_;  ///< number for each frame
    WholeImages images_;
    StoredScan result_;
};

constexpr std::array<std::string_view, 2> kNanosurfExtensions{".nid", ".ezd"};

}  // namespace

const HeightMapFormat kNanosurfFormat = {
    .name = "Nanosurf .nid",
    .extensions = kNanosurfExtensions,
    .recognizes = [](const ByteSource& bytes) { return bytes.startsWith(kNanosurfMagic); },
    .read = [](const ByteSource& bytes) { return NanosurfReader(bytes).read(); }};

}  // namespace asperity
