#include "core/Error.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/ForceCurveFiles.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "core/io/heightmap/ScanImage.h"
#include "core/io/heightmap/WholeImages.h"
#include "core/io/heightmap/igor/IgorWave.h"

#include <algorithm>
#include <array>

// Igor binary waves as images: those of Asylum Research instruments, and plain ones of two or three
// dimensions. Source: docs/formats.md 6.

namespace asperity {

namespace {

constexpr std::string_view kImageFooter = "MFP3D";

class IgorReader {
public:
    explicit IgorReader(const ByteSource& bytes) : bytes_(bytes), wave_(readIgorWave(bytes)) {}

    StoredScan read() {
        refuseCurves();
        refuseCut();
        note_ = parseAsylumNote(wave_.note);
        SampleLayout samples{
            .size = checkedImageSize(wave_.counts[0], wave_.counts[1], bytes_.name(), "dimensions"),
            .type = wave_.type,
            .order = wave_.order,
            .offset = wave_.offset,
            .bottomFirst = true};
        StoredScan result;
        result.texts.add(note_);
        result.usualDirection = isAsylum() ? "backward" : "";
        WholeImages whole;
        for (int layer = 0; layer < layers(); ++layer) {
            StoredChannel image = channelOf(layer, samples);
            if (whole.holds(bytes_, samples, "layer " + std::to_string(layer),
                            image.channel.name)) {
                result.channels.push_back(std::move(image));
            }
            samples.offset += samples.bytes();
        }
        whole.finish(result);
        if (const auto angle = note_.find("ScanAngle"); angle != note_.end()) {
            noteRotation(result.notes, parseNumber(angle->second).value_or(0.0));
        }
        noteCut(result);
        addProvenance(result);
        return result;
    }

private:
    /// Asylum's force curves have a column for each signal: Raw, Defl, ZSnsr.
    void refuseCurves() const {
        if (isAsylumCurve(wave_)) {
            std::string list;
            for (const std::string& column : wave_.labels[1]) {
                list += column.empty() ? "" : (list.empty() ? " (" : ", ") + column;
            }
            throw InputError(bytes_.name(), "",
                             "this Asylum file holds force curves" +
                                 (list.empty() ? list : list + ")") + ", no image" +
                                 std::string(kCurvePointer));
        }
        if (wave_.counts[1] == 0) {
            throw InputError(bytes_.name(), "dimensions",
                             "this Igor wave has one dimension: a curve, no image" +
                                 std::string(kCurvePointer));
        }
    }

    [[nodiscard]] bool isAsylum() const {
        return wave_.footer.ends_with(kImageFooter) ||
               std::ranges::any_of(wave_.labels[2], isAsylumLabel);
    }

    /// Without labels nobody can discern a single image from force curves; several are no curves.
    void refuseCut() const {
        if (wave_.cut && wave_.counts[2] == 0) {
            throw InputError(*wave_.cut);
        }
    }

    /// Asylum's program ends a file with previews and their list.
    void noteCut(StoredScan& scan) const {
        const bool lostFooter =
            isAsylum() && !wave_.footer.empty() && !wave_.footer.ends_with(kImageFooter);
        if (wave_.cut) {
            scan.notes.emplace_back(
                "the file is truncated: it lost names and units of its channels");
        } else if (lostFooter) {
            scan.notes.emplace_back("the file is truncated: it does not end with 'MFP3D'");
        }
    }

    [[nodiscard]] int layers() const {
        const std::int32_t layers = std::max(wave_.counts[2], 1);
        if (wave_.counts[3] > 1 || layers > static_cast<int>(kMaxImages)) {
            throw InputError(bytes_.name(), "dimensions",
                             "an image of at most " + std::to_string(kMaxImages) +
                                 " layers is expected, found " + std::to_string(layers) + " x " +
                                 std::to_string(std::max(wave_.counts[3], 1)));
        }
        return layers;
    }

    [[nodiscard]] StoredChannel channelOf(int layer, const SampleLayout& samples) const {
        const auto index = static_cast<std::size_t>(layer) + 1;
        const std::vector<std::string>& labels = wave_.labels[2];
        const std::string label = index < labels.size() ? labels[index] : std::string();
        ScanChannel channel;
        channel.name = label.empty() ? nameOf(layer) : label;
        channel.direction = directionFromName(label);
        setSize(channel, samples.size);
        const PhysicalUnit unit = parseUnit(isAsylum() ? asylumUnit(label, note_) : wave_.unit);
        channel.unit = unit.base;
        settleSize(channel, "steps of the wave's dimensions, byte 148");
        return {.channel = std::move(channel),
                .factor = unit.factor,
                .readRow = rowsOf(bytes_, samples)};
    }

    /// A layer without a label is called as the wave.
    [[nodiscard]] std::string nameOf(int layer) const {
        const std::string name = wave_.name.empty() ? "Untitled" : wave_.name;
        return layers() == 1 ? name : name + " " + std::to_string(layer);
    }

    void setSize(ScanChannel& channel, ImageSize size) const {
        const PhysicalUnit x = parseUnit(wave_.dimensionUnits[0]);
        const PhysicalUnit y = parseUnit(wave_.dimensionUnits[1]);
        channel.lateralUnit = x.base == y.base ? x.base : std::string();
        channel.map = emptyMap(size, wave_.steps[0] * x.factor * size.columns,
                               wave_.steps[1] * y.factor * size.rows);
        setOrigin(channel, wave_.starts[0] * x.factor, wave_.starts[1] * y.factor,
                  GivenPoint::Corner);
    }

    void addProvenance(StoredScan& scan) const {
        const bool little = wave_.order == ByteOrder::Little;
        scan.provenance.push_back({"format version", "5", "byte 0"});
        scan.provenance.push_back({"byte order",
                                   little ? "lowest byte first" : "highest byte first",
                                   "the version number"});
        scan.provenance.push_back(
            {"scale", "1",
             isAsylum() ? "an Asylum file stores SI units; which ones say note and channel names"
                        : "the numbers are in the unit of the wave"});
        scan.provenance.push_back(
            {"orientation", "the bottom row is stored first", "as Asylum's program shows it"});
    }

    const ByteSource& bytes_;
    IgorWave wave_;
    std::map<std::string, std::string> note_;
};

constexpr std::array<std::string_view, 1> kIgorExtensions{".ibw"};

}  // namespace

const HeightMapFormat kIgorFormat = {
    .name = "Igor .ibw (Asylum Research)",
    .extensions = kIgorExtensions,
    .recognizes = startsAsIgorWave,
    .read = [](const ByteSource& bytes) { return IgorReader(bytes).read(); }};

}  // namespace asperity
