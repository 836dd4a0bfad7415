#include "core/io/MemoryLimit.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "core/io/heightmap/ScanImage.h"
#include "core/io/heightmap/vti/VtiHead.h"
#include "core/io/heightmap/vti/VtiWriter.h"

#include <algorithm>

// Images of VTK: each array at the points is a channel, or at the cells where there is none. y is
// up, and a point is a pixel's center. Names and units are those of Asperity's own files; VTK knows
// none. Source: docs/formats.md 16.

namespace asperity {

namespace {

class VtiReader {
public:
    explicit VtiReader(const ByteSource& bytes) : bytes_(bytes), head_(readVtiHead(bytes)) {}

    StoredScan read() {
        requireUsualArrays();
        const auto mask = std::ranges::find_if(head_.arrays, [](const VtiArray& array) {
            return array.name == kVtiValid && array.type == SampleType::UInt8;
        });
        const bool hasMask = mask != head_.arrays.end() && head_.arrays.size() > 1;
        StoredScan scan;
        for (auto array = head_.arrays.begin(); array != head_.arrays.end(); ++array) {
            if (!hasMask || array != mask) {
                scan.channels.push_back(channel(*array, hasMask ? &*mask : nullptr));
            }
        }
        scan.markedChannel = head_.scalars;
        scan.notes = head_.notes;
        scan.texts.add(head_.texts);
        scan.texts.remove(kVtiTitle);
        scan.texts.remove(kVtiUnit);
        scan.provenance = {{"orientation", "first stored row at the bottom", "VTK: y is up"}};
        if (!head_.version.empty()) {
            scan.provenance.push_back({"format version", head_.version, "VTKFile"});
        }
        return scan;
    }

private:
    /// All arrays together: several may lie at the same offset of the file.
    void requireUsualArrays() const {
        std::uint64_t decoded = 0;
        for (const VtiArray& array : head_.arrays) {
            if (std::ranges::any_of(array.pieces, [](const VtiPiece& piece) {
                    return static_cast<bool>(piece.decode);
                })) {
                decoded += head_.size.pixels() * sizeOf(array.type);
            }
        }
        requireUsualPacking(decoded, bytes_.size(), bytes_.name(), "arrays");
    }

    StoredChannel channel(const VtiArray& array, const VtiArray* mask) {
        const std::string unitOf = kVtiUnitOf + array.name;
        const bool isOurs =
            head_.texts.all().contains(kVtiUnit) || head_.texts.all().contains(unitOf);
        // Title and unit are those of the one image of a height map that Asperity writes.
        const bool isAlone = head_.arrays.size() == (mask == nullptr ? 1U : 2U);
        const std::string given =
            text(isAlone && head_.texts.all().contains(kVtiUnit) ? kVtiUnit : unitOf);
        const PhysicalUnit unit = parseUnit(given);
        ScanChannel channel;
        channel.name = isAlone && !text(kVtiTitle).empty() ? text(kVtiTitle) : array.name;
        channel.unit = unit.base;
        channel.lateralUnit = isOurs ? "m" : "";
        channel.direction = directionFromName(channel.name);
        channel.map =
            emptyMap(head_.size, head_.pitchX * head_.size.columns, head_.pitchY * head_.size.rows);
        if (const auto origin = head_.numbers.find(kVtiOrigin);
            origin != head_.numbers.end() && origin->second.size() == 2) {
            setOrigin(channel, origin->second[0], origin->second[1], GivenPoint::Corner);
        }
        if (!isOurs) {
            channel.notes.emplace_back("VTK images give no units; sizes and values are numbers");
        }
        settleSize(channel, "ImageData, Spacing");
        if (!channel.unit.empty()) {
            channel.provenance.push_back(
                scaleProvenance(unit.factor, channel.unit, "FieldData, unit"));
        }
        ReadRow rows = rowsOf(bytes_, array, head_.size.rows);
        if (mask != nullptr) {
            rows = masked(std::move(rows), head_.size.columns, marks(*mask));
        }
        return {.channel = std::move(channel), .factor = unit.factor, .readRow = std::move(rows)};
    }

    /// Above 0 where the array is 0: there are no data.
    [[nodiscard]] ReadRow marks(const VtiArray& valid) const {
        return replaced(rowsOf(bytes_, valid, head_.size.rows), head_.size.columns,
                        [](double value) { return value == 0.0 ? 1.0 : 0.0; });
    }

    [[nodiscard]] std::string text(const std::string& name) const {
        const auto found = head_.texts.all().find(name);
        return found == head_.texts.all().end() ? std::string() : found->second;
    }

    const ByteSource& bytes_;
    VtiHead head_;
};

constexpr std::array<std::string_view, 1> kVtiExtensions{".vti"};

}  // namespace

const HeightMapFormat kVtiFormat = {
    .name = "VTK image .vti",
    .extensions = kVtiExtensions,
    .recognizes = isVtkXml,
    .read = [](const ByteSource& bytes) { return VtiReader(bytes).read(); },
    .write = writeVti};

}  // namespace asperity
