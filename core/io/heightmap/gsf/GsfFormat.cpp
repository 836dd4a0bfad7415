#include "core/Error.h"
#include "core/io/ByteReader.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/HeightMapWriter.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "core/io/heightmap/SampleRows.h"
#include "core/io/heightmap/ScanImage.h"

#include <array>
#include <cstddef>
#include <fstream>

// Gwyddion Simple Field: a text header, 1 to 4 NUL bytes, then float32 with the lowest byte first.
// Source: Gwyddion user guide, "Gwyddion Simple Field files"; docs/formats.md 2.

namespace asperity {

namespace {

/// The heights begin at a multiple of it, behind a header that ends with at least one zero [byte].
constexpr std::size_t kGsfAlignment = 4;

/// Fields of the format itself.
constexpr std::array<std::string_view, 9> kFields = {
    "XRes", "YRes", "XReal", "YReal", "XOffset", "YOffset", "XYUnits", "ZUnits", "Title"};

std::string header(const HeightRows& map, const HeightMapMeta& meta) {
    return "Gwyddion Simple Field 1.0\nXRes = " + std::to_string(map.columns) +
           "\nYRes = " + std::to_string(map.rows) + "\nXReal = " + exactText(map.sizeX()) +
           "\nYReal = " + exactText(map.sizeY()) + "\nXOffset = " + exactText(meta.originX) +
           "\nYOffset = " + exactText(meta.originY) + "\nXYUnits = m" +
           (meta.unit.empty() ? "" : "\nZUnits = " + oneLine(meta.unit)) +
           "\nTitle = " + oneLine(meta.title) + "\n" + metadataLines(meta, " = ", kFields);
}

/// See HeightMapFormat::write.
void writeGsf(const std::filesystem::path& target, const HeightRows& map, const HeightMapMeta& meta,
              Progress* progress) {
    std::string bytes = header(map, meta);
    bytes.append(kGsfAlignment - bytes.size() % kGsfAlignment, '\0');
    std::ofstream stream(target, std::ios::binary);
    stream << bytes;
    forEachRow(map, progress, [&](int, const std::vector<double>& heights) {
        bytes.clear();
        for (const double height : heights) {
            appendLittleEndian(bytes, static_cast<float>(height));
        }
        stream << bytes;
    });
    finish(stream);
}

constexpr std::string_view kFamily = "Gwyddion Simple Field ";
constexpr std::string_view kGsfMagic = "Gwyddion Simple Field 1.0\n";
/// Gwyddion's own headers have some 200 bytes.
constexpr std::size_t kGsfMaxHeader = std::size_t{1} << 20U;

using Fields = std::map<std::string, std::string>;

class GsfReader {
public:
    explicit GsfReader(const ByteSource& bytes)
        : bytes_(bytes)
        , start_(bytes.startUntil(
              [](std::string_view start) {
                  return std::min(start.find('\0'), start.size()) + kGsfAlignment < start.size();
              },
              kGsfMaxHeader + kGsfAlignment)) {}

    StoredScan read() {
        checkMagic();
        const std::size_t headerEnd = start_.find('\0');
        if (headerEnd >= kGsfMaxHeader) {
            fail("header", "no NUL byte ends it; the file is truncated or damaged");
        }
        parseHeader(
            std::string_view(start_).substr(kGsfMagic.size(), headerEnd - kGsfMagic.size()));
        StoredScan result;
        result.channels.push_back(channel(dataAfter(headerEnd)));
        addProvenance(result.channels.back());
        result.provenance = {{"format version", "1.0", "line 1"}};
        return result;
    }

private:
    void checkMagic() const {
        if (start_.starts_with(kGsfMagic)) {
            return;
        }
        if (start_.starts_with("Gwyddion Simple Field 1.0\r")) {
            fail("line 1", "it ends with CR LF: a transfer in text mode has damaged the file");
        }
        fail("line 1", "expected 'Gwyddion Simple Field 1.0'");
    }

    void parseHeader(std::string_view header) {
        for (int line = 2; !header.empty(); ++line) {
            const std::size_t end = std::min(header.find('\n'), header.size());
            const std::string_view text = header.substr(0, end);
            header.remove_prefix(std::min(end + 1, header.size()));
            const std::size_t equals = text.find('=');
            if (equals == std::string_view::npos) {
                if (trimmed(text).empty()) {
                    continue;
                }
                fail("line " + std::to_string(line), "expected 'name = value'");
            }
            fields_[toUtf8(trimmed(text.substr(0, equals)))] =
                toUtf8(trimmed(text.substr(equals + 1)));
        }
    }

    /// Returns the offset of the samples: they are all that follows the padding, in exactly the
    /// number that the header promises.
    std::uint64_t dataAfter(std::size_t headerEnd) {
        size_ = checkedImageSize(integer("XRes"), integer("YRes"), bytes_.name(), "XRes, YRes");
        const std::size_t start = (headerEnd / kGsfAlignment + 1) * kGsfAlignment;
        const std::string padding = start_.substr(headerEnd, start - headerEnd);
        if (padding.find_first_not_of('\0') != std::string::npos) {
            fail("byte " + std::to_string(headerEnd), "expected NUL bytes up to a multiple of 4");
        }
        const std::uint64_t held = bytes_.size() - std::min<std::uint64_t>(start, bytes_.size());
        const std::uint64_t expected = size_.pixels() * sizeof(float);
        if (held != expected) {
            fail("byte " + std::to_string(start),
                 "expected " + std::to_string(expected) + " bytes of data for " +
                     std::to_string(size_.columns) + " x " + std::to_string(size_.rows) +
                     " pixels, found " + std::to_string(held));
        }
        return start;
    }

    StoredChannel channel(std::uint64_t data) {
        const PhysicalUnit lateral = parseUnit(takeText("XYUnits"));
        const PhysicalUnit vertical = parseUnit(takeText("ZUnits"));
        ScanChannel channel;
        channel.name = takeText("Title");
        if (channel.name.empty()) {
            channel.name = "Untitled";
        }
        channel.unit = vertical.base;
        channel.lateralUnit = lateral.base;
        channel.direction = directionFromName(channel.name);
        channel.map =
            emptyMap(size_, number("XReal") * lateral.factor, number("YReal") * lateral.factor);
        setOrigin(channel, number("XOffset") * lateral.factor, number("YOffset") * lateral.factor,
                  GivenPoint::Corner);
        channel.metadata = fields_;
        return {.channel = std::move(channel),
                .factor = vertical.factor,
                .readRow = rowsOf(bytes_, {.size = size_, .offset = data})};
    }

    static void addProvenance(StoredChannel& stored) {
        ScanChannel& channel = stored.channel;
        assumeMeters(channel);
        settleSize(channel, "header, XReal and YReal");
        channel.provenance.push_back(
            scaleProvenance(stored.factor, channel.unit, "header, ZUnits"));
        channel.provenance.push_back(
            {"orientation", "the top row is stored first", "the same in every .gsf file"});
    }

    /// Removes the field, so that what is left is metadata.
    std::string takeText(const std::string& name) {
        const auto field = fields_.find(name);
        if (field == fields_.end()) {
            return {};
        }
        std::string text = field->second;
        fields_.erase(field);
        return text;
    }

    long long integer(const std::string& name) {
        const std::string text = takeText(name);
        const std::optional<long long> value = parseInteger(text);
        if (!value) {
            fail(name, "expected a whole number, found '" + text + "'");
        }
        return *value;
    }

    /// 0 when the field is missing.
    double number(const std::string& name) {
        const std::string text = takeText(name);
        if (text.empty()) {
            return 0.0;
        }
        const std::optional<double> value = parseNumber(text);
        if (!value) {
            fail(name, "expected a number, found '" + text + "'");
        }
        return *value;
    }

    [[noreturn]] void fail(const std::string& location, const std::string& what) const {
        throw InputError(bytes_.name(), location, what);
    }

    const ByteSource& bytes_;
    std::string start_;
    Fields fields_;
    ImageSize size_;
};

constexpr std::array<std::string_view, 1> kGsfExtensions{".gsf"};

}  // namespace

const HeightMapFormat kGsfFormat = {
    .name = "Gwyddion Simple Field .gsf",
    .extensions = kGsfExtensions,
    .recognizes = [](const ByteSource& bytes) { return bytes.startsWith(kFamily); },
    .read = [](const ByteSource& bytes) { return GsfReader(bytes).read(); },
    .write = writeGsf};

}  // namespace asperity
