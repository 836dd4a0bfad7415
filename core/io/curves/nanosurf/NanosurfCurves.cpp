#include "core/Error.h"
#include "core/io/TextValue.h"
#include "core/io/curves/CurveFormat.h"
#include "core/io/curves/CurveSegments.h"
#include "core/io/curves/nanosurf/NanosurfLines.h"
#include "core/io/heightmap/PhysicalUnit.h"

#include <algorithm>
#include <cmath>

// Spectroscopy of Nanosurf .nid files: a line of each channel is a curve's segment, which its frame
// names. Source: docs/formats.md 21.

namespace asperity {

namespace {

struct NanosurfFrame {
    std::string_view name;
    CurveSegmentKind kind;
};

/// In the order of time.
constexpr std::array<NanosurfFrame, 4> kNanosurfFrames{
    {{"Spec forward", CurveSegmentKind::Approach},
     {"Spec fwd pause", CurveSegmentKind::Pause},
     {"Spec backward", CurveSegmentKind::Retract},
     {"Spec bwd pause", CurveSegmentKind::Pause}}};

class NanosurfCurves final : public StoredCurves {
public:
    NanosurfCurves(const ByteSource& bytes, const CurveReadOptions& options)
        : bytes_(bytes), wanted_(options.height), header_(readNanosurfHeader(bytes)) {
        for (NanosurfLines& channel : nanosurfLines(header_, bytes)) {
            if (std::ranges::count(kNanosurfFrames, channel.frame, &NanosurfFrame::name) > 0) {
                curves_ = std::max(curves_, channel.lines);
                channels_.push_back(std::move(channel));
            }
        }
        if (curves_ == 0) {
            throw InputError(bytes.name(), "[DataSet]", "it lists no force curve (Spec forward)");
        }
        const auto sections = nanosurfChannels(header_.sections, bytes.name());
        hasImage_ = std::ranges::any_of(
            sections, [](const HeaderFields* section) { return isNanosurfScan(*section); });
        readStiffness();
    }

    [[nodiscard]] std::size_t count() const override { return curves_; }
    [[nodiscard]] bool hasImage() const override { return hasImage_; }

    [[nodiscard]] CurveContents read(std::size_t index) const override {
        CurveContents contents;
        contents.curve.stiffness = stiffness_;
        for (const NanosurfFrame& frame : kNanosurfFrames) {
            addSegment(contents, frame, index);
        }
        turnBase(contents.curve.segments);
        finishCurve(contents, bytes_.name());
        contents.notes.emplace_back("the samples have no times in this file");
        return contents;
    }

private:
    /// A property of the cantilever with the unit N/m: "D[0.2]*[N/m]".
    void readStiffness() {
        const auto cantilever = header_.sections.find("DataSet\\Calibration\\Cantilever");
        if (cantilever == header_.sections.end()) {
            return;
        }
        for (const auto& [key, value] : cantilever->second.all()) {
            const std::size_t open = value.find('[');
            const std::size_t close = value.find("]*[N/m]");
            if (!key.starts_with("Prop") || open == std::string::npos || close <= open ||
                close == std::string::npos) {
                continue;
            }
            const double stiffness =
                parseNumber(value.substr(open + 1, close - open - 1)).value_or(0.0);
            stiffness_ = stiffness > 0.0 && std::isfinite(stiffness) ? stiffness : 0.0;
        }
    }

    void addSegment(CurveContents& contents, const NanosurfFrame& frame, std::size_t index) const {
        const NanosurfLines* lever = nullptr;
        std::vector<const NanosurfLines*> heights;
        for (const NanosurfLines& channel : channels_) {
            if (channel.frame != frame.name || index >= channel.lines) {
                continue;
            }
            const std::string name = lowerCase(channel.name);
            if (name.find("deflection") != std::string::npos && lever == nullptr) {
                lever = &channel;
            } else if (name.starts_with("z")) {
                heights.push_back(&channel);
            }
        }
        if (lever == nullptr) {
            return;
        }
        CurveSegment segment;
        segment.kind = frame.kind;
        takeLever(segment, *lever, index);
        takeBase(contents, segment, *lever, heights, index);
        const std::size_t points = std::min(segment.base.size(), loadOf(segment).size());
        for (const auto array : kCurveArrays) {
            (segment.*array).resize(std::min((segment.*array).size(), points));
        }
        contents.curve.segments.push_back(std::move(segment));
    }

    void takeLever(CurveSegment& segment, const NanosurfLines& lever, std::size_t index) const {
        const PhysicalUnit unit = parseUnit(lever.section->text("Dim2Unit"));
        std::vector<double>& array = unit.base == "N"   ? segment.force
                                     : unit.base == "m" ? segment.deflection
                                                        : segment.signal;
        array = nanosurfLine(bytes_, lever, index);
    }

    /// A sensor of the height before the piezo's; without any, the ramp that the axis names.
    void takeBase(CurveContents& contents, CurveSegment& segment, const NanosurfLines& lever,
                  std::vector<const NanosurfLines*>& heights, std::size_t index) const {
        std::ranges::stable_sort(heights, {}, [](const NanosurfLines* channel) {
            return lowerCase(channel->name).find("sensor") == std::string::npos;
        });
        if (heights.empty() && wanted_.empty()) {
            segment.base = nanosurfAxis(lever, loadOf(segment).size());
            if (segment.kind == CurveSegmentKind::Retract) {
                std::ranges::reverse(segment.base);
            }
            return;
        }
        std::vector<std::string> names;
        for (const NanosurfLines* const channel : heights) {
            names.push_back(channel->name);
        }
        contents.heights = names;
        contents.heightChannel = chosenHeight(names, wanted_, bytes_.name());
        const auto found = std::ranges::find(names, contents.heightChannel);
        segment.base =
            nanosurfLine(bytes_, *heights[static_cast<std::size_t>(found - names.begin())], index);
    }

    const ByteSource& bytes_;
    std::string wanted_;
    NanosurfHeader header_;
    std::vector<NanosurfLines> channels_;
    std::size_t curves_ = 0;
    double stiffness_ = 0.0;  ///< [N/m]
    bool hasImage_ = false;
};

bool recognizesNanosurfCurves(const ByteSource& bytes) {
    constexpr std::uint64_t kLooked = std::uint64_t{1} << 18U;
    return bytes.startsWith(kNanosurfMagic) &&
           bytes.start(kLooked).find("Frame=Spec ") != std::string::npos;
}

}  // namespace

const CurveFormat kNanosurfCurveFormat = {
    .name = "Nanosurf .nid spectroscopy",
    .recognizes = recognizesNanosurfCurves,
    .open = [](const ByteSource& bytes,
               const CurveReadOptions& options) -> std::unique_ptr<StoredCurves> {
        return std::make_unique<NanosurfCurves>(bytes, options);
    }};

}  // namespace asperity
