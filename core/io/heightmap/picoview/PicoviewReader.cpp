#include "core/Error.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/HeaderFields.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "core/io/heightmap/SampleRows.h"
#include "core/io/heightmap/ScanImage.h"
#include "core/io/heightmap/WholeImages.h"

#include <array>
#include <cmath>

// PicoView (Molecular Imaging, Agilent, Keysight): lines of a key of 14 columns and a value, then
// the samples of one image after the other. Source: docs/formats.md 13.

namespace asperity {

namespace {

constexpr std::string_view kImageMagic = "fileType      Image";
constexpr std::string_view kCurveMagic = "fileType      Spectroscopy";
constexpr std::string_view kDataKey = "\ndata          ";
constexpr std::size_t kKeyColumns = 14;

class PicoviewReader {
public:
    explicit PicoviewReader(const ByteSource& bytes)
        : bytes_(bytes), file_(bytes.name()), scan_(bytes.name(), "") {}

    StoredScan read() {
        refuseRelatives();
        const HeaderText header = headerText(bytes_, kDataKey);
        parse(header.text);
        readSampleKind(header.end);
        samples_.size = checkedImageSize(scan_.integer("xPixels"), scan_.integer("yPixels"), file_,
                                         "xPixels, yPixels");
        if (images_.empty()) {
            throw InputError(file_, "header", "it lists no image ('bufferLabel')");
        }
        StoredScan result;
        result.texts.add(scan_.texts());
        if (const std::string* const version = scan_.find("version")) {
            result.provenance.push_back({"format version", *version, "version"});
        }
        noteRotation(result.notes, scan_.number("scanAngle").value_or(0.0));
        WholeImages whole;
        for (const HeaderFields& image : images_) {
            StoredChannel stored = channelOf(image);
            const std::string& name = stored.channel.name;
            if (whole.holds(bytes_, samples_, "image '" + name + "'", name)) {
                result.channels.push_back(std::move(stored));
            }
            samples_.offset += samples_.bytes();
        }
        whole.finish(result);
        return result;
    }

private:
    void refuseRelatives() const {
        if (bytes_.startsWith(kCurveMagic)) {
            throw InputError(file_, "",
                             "this PicoView file holds force curves or spectra, no image");
        }
        if (bytes_.startsWith(std::string(kImageMagic) + "\r")) {
            throw InputError(file_, "line 1",
                             "it ends with CR LF: a transfer in text mode has damaged the file");
        }
    }

    void parse(std::string_view header) {
        HeaderFields* part = &scan_;
        for (const std::string_view line : linesOf(header)) {
            const std::string_view key = trimmed(line.substr(0, kKeyColumns));
            const std::string_view value = line.substr(std::min(kKeyColumns, line.size()));
            if (key == "bufferLabel") {
                requireImages(images_.size() + 1, file_, "header");
                images_.emplace_back(file_, "image " + std::to_string(images_.size() + 1));
                part = &images_.back();
            }
            if (!key.empty()) {
                part->add(key, value);
            }
        }
    }

    /// The rest of the line `data`, which says how the samples are stored that follow it.
    void readSampleKind(std::uint64_t offset) {
        constexpr std::uint64_t kLongest = 32;
        std::string text(std::min(kLongest, bytes_.size() - offset), '\0');
        bytes_.read(offset, text);
        const std::size_t end = text.find('\n');
        const std::string_view kind = trimmed(std::string_view(text).substr(0, end));
        if (kind == "ASCII") {
            throw InputError(file_, "data",
                             "its samples are stored as text (ASCII); save it with binary data");
        }
        const bool wide = kind == "BINARY_32";
        if (end == std::string::npos || !(wide || kind == "BINARY" || kind.empty())) {
            throw InputError(file_, "data",
                             "expected BINARY, BINARY_32 or ASCII, found '" + std::string(kind) +
                                 "'");
        }
        samples_.type = wide ? SampleType::Int32 : SampleType::Int16;
        samples_.offset = offset + end + 1;
        // Whatever the scan's direction was, the first stored row is the bottom of the image.
        samples_.bottomFirst = true;
    }

    [[nodiscard]] StoredChannel channelOf(const HeaderFields& image) const {
        ScanChannel channel;
        channel.name = image.text("bufferLabel");
        channel.direction = directionFromName(image.text("trace"));
        channel.lateralUnit = "m";
        channel.map = emptyMap(samples_.size, scan_.number("xLength").value_or(0.0),
                               scan_.number("yLength").value_or(0.0));
        if (scan_.number("xOffset") || scan_.number("yOffset")) {
            setOrigin(channel, scan_.number("xOffset").value_or(0.0),
                      scan_.number("yOffset").value_or(0.0), GivenPoint::Center);
        }
        channel.metadata = image.all();
        settleSize(channel, "xLength and yLength");
        channel.provenance.push_back(
            {"orientation", "the bottom row is stored first", "the same in every PicoView file"});
        const double factor = setUnit(channel, image);
        return {
            .channel = std::move(channel), .factor = factor, .readRow = rowsOf(bytes_, samples_)};
    }

    /// @return value in the channel's unit per count
    [[nodiscard]] double setUnit(ScanChannel& channel, const HeaderFields& image) const {
        const std::optional<double> range = image.number("bufferRange");
        if (!range) {
            channel.notes.emplace_back("the file gives no range of its values; they are numbers");
            return 1.0;
        }
        const PhysicalUnit unit = parseUnit(image.text("bufferUnit"));
        channel.unit = unit.base;
        const int bits = samples_.type == SampleType::Int32 ? 31 : 15;
        const double factor = std::ldexp(*range * unit.factor, -bits);
        channel.provenance.push_back(
            scaleProvenance(factor, unit.base,
                            "bufferRange and bufferUnit, 2^" + std::to_string(bits) + " counts"));
        return factor;
    }

    const ByteSource& bytes_;
    const std::string& file_;
    HeaderFields scan_;
    std::vector<HeaderFields> images_;
    SampleLayout samples_;  ///< of the next image
};

constexpr std::array<std::string_view, 1> kPicoviewExtensions{".mi"};

}  // namespace

const HeightMapFormat kPicoviewFormat = {
    .name = "PicoView .mi",
    .extensions = kPicoviewExtensions,
    .recognizes =
        [](const ByteSource& bytes) {
            return bytes.startsWith(kImageMagic) || bytes.startsWith(kCurveMagic);
        },
    .read = [](const ByteSource& bytes) { return PicoviewReader(bytes).read(); }};

}  // namespace asperity
