#include "core/Error.h"
#include "core/io/TextValue.h"
#include "core/io/curves/CurveFormat.h"
#include "core/io/curves/CurveSegments.h"
#include "core/io/curves/jpk/JpkChannel.h"
#include "core/io/curves/jpk/JpkProperties.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "core/io/zip/ZipArchive.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

// JPK's archives of force curves: single ones, maps and quantitative imaging. Source:
// docs/formats.md 21.

namespace asperity {

namespace {

constexpr std::string_view kSharedHeader = "shared-data/header.properties";
constexpr std::string_view kMainHeader = "header.properties";
constexpr std::string_view kSegmentHeader = "segment-header.properties";
constexpr std::string_view kIndexes = "index/";
constexpr std::string_view kSegments = "segments/";
constexpr std::uint64_t kMostHeader = std::uint64_t{1} << 24U;  // [bytes]; real ones have 130 kB

/// Sensors before the piezo's voltage, which shows its hysteresis.
constexpr std::array<std::string_view, 4> kJpkHeights{"measuredHeight", "capacitiveSensorHeight",
                                                      "strainGaugeHeight", "height"};
constexpr std::string_view kLeverChannel = "vDeflection";

/// Members of one curve in the archive.
struct JpkCurveEntries {
    long long number = 0;                ///< in the map
    std::string folder;                  ///< "", "index/12/"
    std::map<long long, bool> segments;  ///< by their number; whether it has a header
};

/// What the segments before leave to the next one.
struct SegmentStart {
    double time = 0.0;        ///< at its begin [s]
    std::uint64_t bytes = 0;  ///< that its members may have
};

/// A segment in the archive.
struct JpkSegment {
    std::string folder;                     ///< "index/12/segments/0/"
    std::string location;                   ///< for messages
    std::unique_ptr<JpkProperties> header;  ///< not null
    std::vector<std::string> channels;      ///< by name
};

/// Takes "12/" off the front; empty: there is no number.
std::optional<long long> takeFolderNumber(std::string_view& path) {
    const std::size_t slash = path.find('/');
    if (slash == std::string_view::npos || slash > 9) {
        return std::nullopt;
    }
    const std::optional<long long> number = parseInteger(path.substr(0, slash));
    path.remove_prefix(slash + 1);
    return number && *number >= 0 ? number : std::nullopt;
}

/// The words of a list, parted by blanks.
std::vector<std::string> wordsOf(std::string_view text) {
    std::vector<std::string> words;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        if (end > 0) {
            words.emplace_back(text.substr(0, end));
        }
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return words;
}

class JpkCurves final : public StoredCurves {
public:
    JpkCurves(const ByteSource& bytes, const CurveReadOptions& options)
        : archive_(bytes), file_(bytes.name()), wanted_(options.height), most_(mostBytesOf(bytes)) {
        sortEntries();
        shared_ = propertiesAt(std::string(kSharedHeader), nullptr);
        main_ = propertiesAt(std::string(kMainHeader), nullptr);
        readGrid();
    }

    [[nodiscard]] std::size_t count() const override { return curves_.size(); }
    [[nodiscard]] CurveGrid grid() const override { return grid_; }
    [[nodiscard]] bool hasImage() const override { return hasImage_; }

    [[nodiscard]] std::optional<CurveCell> cell(std::size_t index) const override {
        const long long number = curves_[index].number;
        if (number >= static_cast<long long>(grid_.columns) * grid_.rows) {
            return std::nullopt;
        }
        const auto row = static_cast<int>(number / grid_.columns);
        const auto column = static_cast<int>(number % grid_.columns);
        return CurveCell{turnsBack_ && row % 2 == 1 ? grid_.columns - 1 - column : column, row};
    }

    [[nodiscard]] std::optional<CurvePosition> position(std::size_t index) const override {
        const auto header = propertiesAt(curves_[index].folder + std::string(kMainHeader), nullptr);
        if (header == nullptr) {
            return std::nullopt;
        }
        const std::string start = std::string(header->text("type")) + ".header.position.";
        const std::optional<double> x = header->number(start + "x");
        const std::optional<double> y = header->number(start + "y");
        return x && y ? std::optional(CurvePosition{*x, *y}) : std::nullopt;
    }

    [[nodiscard]] CurveContents read(std::size_t index) const override {
        const JpkCurveEntries& entries = curves_[index];
        CurveContents contents;
        SegmentStart start{0.0, most_};
        const std::vector<JpkSegment> segments = segmentsOf(entries, contents);
        contents.heights = commonHeights(segments);
        contents.heightChannel = chosenHeight(contents.heights, wanted_, file_);
        for (const JpkSegment& segment : segments) {
            addSegment(contents, segment, start);
        }
        finishCurve(contents, file_ + (entries.folder.empty() ? "" : ": " + entries.folder));
        return contents;
    }

private:
    /// Members of one curve may have so many bytes together: real ones are packed to between all
    /// and a tenth of them, and a small archive can hold zeros that take a thousand times its size.
    static std::uint64_t mostBytesOf(const ByteSource& bytes) {
        constexpr std::uint64_t kAlwaysAllowed = std::uint64_t{1} << 20U;
        constexpr std::uint64_t kUsualPacking = 16;
        return std::max(kAlwaysAllowed, kUsualPacking * bytes.size());
    }

    /// The directory is in no order, and folders may be missing in it.
    void sortEntries() {
        std::map<long long, JpkCurveEntries> curves;
        for (const ZipEntry& entry : archive_.entries()) {
            entries_.emplace(entry.name, &entry);
            hasImage_ = hasImage_ || entry.baseName().starts_with("data-image.");
            std::string_view path = entry.name;
            long long number = 0;
            std::string folder;
            if (path.starts_with(kIndexes)) {
                path.remove_prefix(kIndexes.size());
                const std::optional<long long> found = takeFolderNumber(path);
                if (!found) {
                    continue;
                }
                number = *found;
                folder = entry.name.substr(0, entry.name.size() - path.size());
            }
            if (!path.starts_with(kSegments)) {
                continue;
            }
            path.remove_prefix(kSegments.size());
            if (const std::optional<long long> segment = takeFolderNumber(path)) {
                JpkCurveEntries& curve = curves[number];
                curve.number = number;
                curve.folder = folder;
                bool& hasHeader = curve.segments[*segment];
                hasHeader = hasHeader || path == kSegmentHeader;
            }
        }
        for (auto& [number, curve] : curves) {
            curves_.push_back(std::move(curve));
        }
        if (curves_.empty()) {
            throw InputError(file_, "", "this JPK archive holds no force curve");
        }
    }

    void readGrid() {
        if (main_ == nullptr || curves_.front().folder.empty()) {
            return;
        }
        constexpr double kMaxSide = 65'536.0;
        const std::string start = std::string(main_->text("type")) + ".position-pattern.";
        const double columns = main_->number(start + "grid.ilength").value_or(0.0);
        const double rows = main_->number(start + "grid.jlength").value_or(0.0);
        if (columns >= 1.0 && rows >= 1.0 && columns <= kMaxSide && rows <= kMaxSide) {
            grid_ = {static_cast<int>(columns), static_cast<int>(rows)};
        }
        turnsBack_ = main_->text(start + "back-and-forth") == "true";
    }

    /// Null: there is no such entry.
    [[nodiscard]] const ZipEntry* entryAt(const std::string& name) const {
        const auto found = entries_.find(name);
        return found == entries_.end() ? nullptr : found->second;
    }

    [[nodiscard]] std::unique_ptr<JpkProperties> propertiesAt(const std::string& name,
                                                              const JpkProperties* shared) const {
        const ZipEntry* const entry = entryAt(name);
        if (entry == nullptr) {
            return nullptr;
        }
        return std::make_unique<JpkProperties>(
            archive_.decoded(*entry, std::min(kMostHeader, most_)), shared);
    }

    /// Those that have a header and channels.
    [[nodiscard]] std::vector<JpkSegment> segmentsOf(const JpkCurveEntries& entries,
                                                     CurveContents& contents) const {
        std::vector<JpkSegment> segments;
        for (const auto& [number, hasHeader] : entries.segments) {
            const std::string folder =
                entries.folder + std::string(kSegments) + std::to_string(number) + "/";
            auto header = hasHeader
                              ? propertiesAt(folder + std::string(kSegmentHeader), shared_.get())
                              : nullptr;
            std::vector<std::string> channels;
            if (header != nullptr) {
                channels = wordsOf(header->text("channels.list"));
            }
            if (channels.empty()) {
                contents.notes.push_back(folder + " names no channels and was left out");
                continue;
            }
            segments.push_back({folder, file_ + ": " + folder.substr(0, folder.size() - 1),
                                std::move(header), std::move(channels)});
        }
        return segments;
    }

    void addSegment(CurveContents& contents, const JpkSegment& source, SegmentStart& start) const {
        CurveSegment segment;
        segment.kind = kindOf(*source.header);
        addLever(contents.curve, segment, source, start);
        addHeight(contents.heightChannel, segment, source, start);
        trim(segment, *source.header, contents, source.folder);
        const std::size_t points = segment.base.size();
        const double duration =
            source.header->number("force-segment-header.duration").value_or(0.0);
        if (duration > 0.0 && points > 0) {
            setUniformTimes(segment, start.time, duration, points);
        }
        start.time += std::max(duration, 0.0);
        contents.curve.segments.push_back(std::move(segment));
    }

    [[nodiscard]] static CurveSegmentKind kindOf(const JpkProperties& header) {
        bool known = false;
        for (const char* const key : {"settings.segment-settings.style", "settings.style",
                                      "segment-settings.style", "style", "name.name"}) {
            const CurveSegmentKind kind =
                segmentKind(header.text("force-segment-header." + std::string(key)), known);
            if (known) {
                return kind;
            }
        }
        return CurveSegmentKind::Pause;
    }

    /// Arrays of one segment get the same length: channels may differ by a sample, or by what the
    /// header says.
    static void trim(CurveSegment& segment, const JpkProperties& header, CurveContents& contents,
                     const std::string& folder) {
        const double stated = header.number("force-segment-header.num-points").value_or(1e300);
        std::size_t points = std::min(segment.base.size(), loadOf(segment).size());
        bool differs = segment.base.size() != loadOf(segment).size();
        if (stated < static_cast<double>(points)) {
            points = static_cast<std::size_t>(std::max(stated, 0.0));
            differs = true;
        } else if (stated < 1e300 && stated > static_cast<double>(points)) {
            differs = true;
        }
        for (const auto array : kCurveArrays) {
            (segment.*array).resize(std::min((segment.*array).size(), points));
        }
        if (differs) {
            contents.notes.push_back(folder +
                                     ": header and channels differ in their number of "
                                     "points; " +
                                     std::to_string(points) + " are taken");
        }
    }

    [[nodiscard]] std::vector<double> samplesOf(const JpkChannel& channel, const JpkSegment& source,
                                                SegmentStart& start) const {
        const std::string& location = source.location;
        const std::string name = source.folder + std::string(channel.dataFile());
        const ZipEntry* const entry = channel.dataFile().empty() ? nullptr : entryAt(name);
        if (entry == nullptr) {
            throw InputError(location, "channel " + channel.name(),
                             "the archive has no member '" + name + "'");
        }
        const SampleType type = channel.sampleType();
        const std::string content = archive_.decoded(*entry, start.bytes);
        start.bytes -= std::min<std::uint64_t>(start.bytes, content.size());
        if (content.size() % sizeOf(type) != 0) {
            throw InputError(location, "channel " + channel.name(),
                             std::to_string(content.size()) + " bytes are no whole samples of " +
                                 std::to_string(sizeOf(type)));
        }
        std::vector<double> samples(content.size() / sizeOf(type));
        convertSamples(type, ByteOrder::Big, content.data(), samples);
        return samples;
    }

    static std::vector<double> scaled(const std::vector<double>& samples, const JpkScaling& scaling,
                                      double sign = 1.0) {
        std::vector<double> values(samples.size());
        std::ranges::transform(samples, values.begin(),
                               [&](double sample) { return sign * scaling(sample); });
        return values;
    }

    /// The deflection in every slot that the file defines, each to the array of its unit.
    void addLever(MeasuredForceCurve& curve, CurveSegment& segment, const JpkSegment& source,
                  SegmentStart& start) const {
        if (std::ranges::count(source.channels, kLeverChannel) == 0) {
            throw InputError(source.location, "", "it has no channel vDeflection");
        }
        const JpkChannel channel(*source.header, std::string(kLeverChannel), source.location);
        const std::vector<double> samples = samplesOf(channel, source, start);
        for (const std::string_view slot :
             {channel.baseSlot(), std::string_view("distance"), std::string_view("force")}) {
            const std::optional<JpkScaling> scaling = channel.scalingTo(slot);
            if (!scaling) {
                continue;
            }
            const PhysicalUnit unit = parseUnit(channel.unitOf(slot));
            std::vector<double>& array = unit.base == "N"   ? segment.force
                                         : unit.base == "m" ? segment.deflection
                                                            : segment.signal;
            array =
                scaled(samples, {unit.factor * scaling->multiplier, unit.factor * scaling->offset});
        }
        takeCalibration(curve, channel);
    }

    static void takeCalibration(MeasuredForceCurve& curve, const JpkChannel& channel) {
        const auto factor = [&](std::string_view slot, std::string_view parent) {
            const std::optional<JpkScaling> own = channel.ownScaling(slot);
            const bool counts = own && own->multiplier > 0.0 && channel.parentOf(slot) == parent;
            return counts ? own->multiplier : 0.0;
        };
        curve.invols = factor("distance", channel.baseSlot());
        curve.stiffness = factor("force", "distance");
    }

    /// A height grows away from the sample.
    void addHeight(const std::string& name, CurveSegment& segment, const JpkSegment& source,
                   SegmentStart& start) const {
        const JpkChannel channel(*source.header, name, source.location);
        const std::string slot = channel.shownSlot();
        const std::optional<JpkScaling> scaling = channel.scalingTo(slot);
        const PhysicalUnit unit = parseUnit(channel.unitOf(slot));
        if (!scaling || unit.base != "m") {
            throw InputError(source.location, "channel " + channel.name(),
                             "the file gives no conversion of it to a length");
        }
        segment.base =
            scaled(samplesOf(channel, source, start),
                   {unit.factor * scaling->multiplier, unit.factor * scaling->offset}, -1.0);
    }

    /// The heights that all segments have: a base that changes its channel would jump.
    static std::vector<std::string> commonHeights(const std::vector<JpkSegment>& segments) {
        std::vector<std::string> heights;
        if (!segments.empty()) {
            heights = heightsAmong(segments.front().channels);
        }
        std::erase_if(heights, [&](const std::string& height) {
            return std::ranges::any_of(segments, [&](const JpkSegment& segment) {
                return std::ranges::count(segment.channels, height) == 0;
            });
        });
        return heights;
    }

    /// The known ones in their order, then all others that are called a height.
    static std::vector<std::string> heightsAmong(const std::vector<std::string>& channels) {
        std::vector<std::string> heights;
        for (const std::string_view known : kJpkHeights) {
            if (std::ranges::count(channels, known) > 0) {
                heights.emplace_back(known);
            }
        }
        for (const std::string& channel : channels) {
            const bool isHeight = lowerCase(channel).find("height") != std::string::npos;
            if (isHeight && std::ranges::count(heights, channel) == 0) {
                heights.push_back(channel);
            }
        }
        return heights;
    }

    ZipArchive archive_;
    std::string file_;
    std::string wanted_;
    std::uint64_t most_;  ///< of a member, decoded [bytes]
    std::unordered_map<std::string, const ZipEntry*> entries_;
    std::vector<JpkCurveEntries> curves_;  ///< by their number
    std::unique_ptr<JpkProperties> shared_;
    std::unique_ptr<JpkProperties> main_;
    CurveGrid grid_;
    bool turnsBack_ = false;  ///< every second row of the map runs back
    bool hasImage_ = false;
};

bool recognizesJpkCurves(const ByteSource& bytes) {
    if (!isZip(bytes)) {
        return false;
    }
    const std::optional<std::string> directory = zipDirectory(bytes);
    return directory && directory->find(kSegmentHeader) != std::string::npos;
}

}  // namespace

const CurveFormat kJpkCurveFormat = {
    .name = "JPK force curves",
    .recognizes = recognizesJpkCurves,
    .open = [](const ByteSource& bytes, const CurveReadOptions& options)
        -> std::unique_ptr<StoredCurves> { return std::make_unique<JpkCurves>(bytes, options); }};

}  // namespace asperity
