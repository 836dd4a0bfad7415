#include "core/Error.h"
#include "core/io/FileBytes.h"
#include "core/io/TextValue.h"
#include "core/io/curves/CurveFormat.h"
#include "core/io/curves/CurveSegments.h"
#include "core/io/heightmap/igor/IgorWave.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <system_error>

// Force curves of Asylum Research in Igor waves: one wave with a column for each channel, or a file
// for each channel side by side. Source: docs/formats.md 21.

namespace asperity {

namespace {

constexpr std::string_view kIgorDeflection = "Defl";
/// The sensor before the drive of the piezo.
constexpr std::array<std::string_view, 3> kIgorHeights{"ZSnsr", "LVDT", "Raw"};

/// Numbers of a wave, all of them or those of one column.
std::vector<double> numbersIn(const ByteSource& bytes, const IgorWave& wave, std::size_t column) {
    const auto rows = static_cast<std::size_t>(std::max(wave.counts[0], 0));
    const std::uint64_t length = rows * sizeOf(wave.type);
    const ByteSpan span{wave.offset + static_cast<std::uint64_t>(column) * length, length};
    if (span.end() > bytes.size()) {
        throw wave.cut.value_or(InputError(bytes.name(), "", "the file is truncated"));
    }
    const std::string stored = bytesOf(bytes, span);
    std::vector<double> numbers(rows);
    convertSamples(wave.type, wave.order, stored.data(), numbers);
    return numbers;
}

/// One curve: its channels by their names.
struct IgorChannels {
    std::vector<std::pair<std::string, std::vector<double>>> channels;

    [[nodiscard]] const std::vector<double>* find(std::string_view name) const {
        const auto found =
            std::ranges::find(channels, name, [](const auto& channel) { return channel.first; });
        return found == channels.end() ? nullptr : &found->second;
    }
};

/// Entries of a list "0,1008,2015", also with blanks and a comma at the end.
std::vector<double> listOf(const std::string& text) {
    std::vector<double> numbers;
    std::string_view rest = text;
    while (!trimmed(rest).empty()) {
        const std::size_t comma = std::min(rest.find(','), rest.size());
        numbers.push_back(parseNumber(trimmed(rest.substr(0, comma))).value_or(NAN));
        rest.remove_prefix(std::min(comma + 1, rest.size()));
    }
    return numbers;
}

/// Where a file lies whose name ends with a channel: "Line0000Point0001Defl.ibw".
struct ChannelFile {
    std::filesystem::path folder;
    std::string stem;       ///< "Line0000Point0001"
    std::string extension;  ///< ".ibw"

    [[nodiscard]] std::filesystem::path of(std::string_view channel) const {
        return folder / (stem + std::string(channel) + extension);
    }
};

/// Empty: the name ends with no known channel.
std::optional<ChannelFile> channelFileOf(const std::filesystem::path& path) {
    const std::string stem = path.stem().string();
    std::vector<std::string_view> names(kIgorHeights.begin(), kIgorHeights.end());
    names.push_back(kIgorDeflection);
    for (const std::string_view name : names) {
        if (stem.ends_with(name)) {
            return ChannelFile{path.parent_path(), stem.substr(0, stem.size() - name.size()),
                               path.extension().string()};
        }
    }
    return std::nullopt;
}

class IgorCurve final : public StoredCurves {
public:
    IgorCurve(const ByteSource& bytes, const CurveReadOptions& options)
        : bytes_(bytes), wanted_(options.height), wave_(readIgorWave(bytes)) {
        note_ = parseAsylumNote(wave_.note);
        if (wave_.counts[2] > 1) {
            throw InputError(bytes.name(), "dimensions",
                             "this Igor wave holds images, no force curve");
        }
    }

    [[nodiscard]] std::size_t count() const override { return 1; }

    [[nodiscard]] std::optional<CurvePosition> position(std::size_t /*index*/) const override {
        const double x = number("XLVDT");
        const double y = number("YLVDT");
        return std::isfinite(x) && std::isfinite(y) ? std::optional(CurvePosition{x, y})
                                                    : std::nullopt;
    }

    [[nodiscard]] CurveContents read(std::size_t /*index*/) const override {
        CurveContents contents;
        const IgorChannels channels =
            wave_.counts[1] > 0 ? columnsOfWave() : channelsBeside(contents.notes);
        for (const std::string_view height : kIgorHeights) {
            if (channels.find(height) != nullptr) {
                contents.heights.emplace_back(height);
            }
        }
        contents.heightChannel = chosenHeight(contents.heights, wanted_, bytes_.name());
        const std::vector<double>* const deflection = channels.find(kIgorDeflection);
        if (deflection == nullptr) {
            throw InputError(bytes_.name(), "", "it has no channel Defl");
        }
        const double stiffness = number("SpringConstant");
        const double invols = number("InvOLS");
        contents.curve.stiffness = stiffness > 0.0 ? stiffness : 0.0;
        contents.curve.invols = invols > 0.0 ? invols : 0.0;
        split(contents, *channels.find(contents.heightChannel), *deflection);
        finishCurve(contents, bytes_.name());
        return contents;
    }

private:
    /// NaN: the note does not say it.
    [[nodiscard]] double number(const std::string& key) const {
        const auto entry = note_.find(key);
        return entry == note_.end() ? NAN : parseNumber(entry->second).value_or(NAN);
    }

    [[nodiscard]] std::string text(const std::string& key) const {
        const auto entry = note_.find(key);
        return entry == note_.end() ? std::string() : entry->second;
    }

    /// The first label is that of the dimension.
    [[nodiscard]] IgorChannels columnsOfWave() const {
        IgorChannels channels;
        const auto columns = static_cast<std::size_t>(wave_.counts[1]);
        for (std::size_t i = 0; i < columns && i + 1 < wave_.labels[1].size(); ++i) {
            const std::string& name = wave_.labels[1][i + 1];
            if (name == kIgorDeflection || std::ranges::count(kIgorHeights, name) > 0) {
                channels.channels.emplace_back(name, numbersIn(bytes_, wave_, i));
            }
        }
        return channels;
    }

    [[nodiscard]] IgorChannels channelsBeside(std::vector<std::string>& notes) const {
        const std::filesystem::path path = bytes_.name();
        const std::optional<ChannelFile> file = channelFileOf(path);
        if (!file) {
            throw InputError(bytes_.name(), "",
                             "this Igor wave has one dimension, and its name ends with none of the "
                             "channels Defl, ZSnsr, LVDT and Raw");
        }
        IgorChannels channels;
        std::vector<std::string_view> names(kIgorHeights.begin(), kIgorHeights.end());
        names.push_back(kIgorDeflection);
        for (const std::string_view name : names) {
            const std::filesystem::path beside = file->of(name);
            std::error_code missing;
            if (std::filesystem::is_regular_file(beside, missing)) {
                const BufferedFile bytes(beside);
                channels.channels.emplace_back(name, wholeWave(bytes));
            }
        }
        if (channels.find(kIgorDeflection) == nullptr || channels.channels.size() < 2) {
            throw InputError(bytes_.name(), "",
                             "this Igor wave holds one channel; those of the same curve, '" +
                                 file->stem + "Defl" + file->extension + "' and '" + file->stem +
                                 "ZSnsr" + file->extension + "' or Raw, must lie beside it");
        }
        notes.emplace_back("a file for each channel: the others lie beside this one");
        return channels;
    }

    [[nodiscard]] static std::vector<double> wholeWave(const ByteSource& bytes) {
        const IgorWave wave = readIgorWave(bytes);
        if (wave.counts[1] > 0) {
            throw InputError(bytes.name(), "dimensions", "expected one channel");
        }
        return numbersIn(bytes, wave, 0);
    }

    /// Where each segment of the note ends, and its kind; empty: the note does not say it.
    [[nodiscard]] std::vector<std::pair<std::size_t, CurveSegmentKind>>
    statedSegments(std::size_t points) const {
        const std::vector<double> indexes = listOf(text("Indexes"));
        const std::vector<double> directions = listOf(text("Direction"));
        std::vector<std::pair<std::size_t, CurveSegmentKind>> segments;
        std::size_t begin = 0;
        for (std::size_t i = 1; i < indexes.size() && i < directions.size(); ++i) {
            const double last = indexes[i];
            if (!(last >= static_cast<double>(begin)) || !(last < 1e9)) {
                return {};
            }
            const std::size_t end = std::min(static_cast<std::size_t>(last) + 1, points);
            segments.emplace_back(end, directions[i] > 0.0   ? CurveSegmentKind::Approach
                                       : directions[i] < 0.0 ? CurveSegmentKind::Retract
                                                             : CurveSegmentKind::Pause);
            begin = end;
        }
        return segments;
    }

    /// ZSnsr and Raw grow towards the sample. Entry j of the indexes is the last sample of segment
    /// j.
    void split(CurveContents& contents, const std::vector<double>& base,
               const std::vector<double>& deflection) const {
        const std::size_t points = std::min(base.size(), deflection.size());
        if (base.size() != deflection.size()) {
            contents.notes.push_back("the channels differ in their number of points; " +
                                     std::to_string(points) + " are taken");
        }
        std::vector<CurveSegment>& segments = contents.curve.segments;
        std::size_t begin = 0;
        for (const auto& [end, kind] : statedSegments(points)) {
            segments.push_back(segmentOf(base, deflection, begin, end));
            segments.back().kind = kind;
            begin = end;
        }
        if (segments.empty()) {
            contents.notes.emplace_back("the note does not say where the curve turns: it is split "
                                        "at its largest deflection");
            segments.push_back(segmentOf(base, deflection, 0, points));
            splitAtTurn(segments);
        }
    }

    [[nodiscard]] CurveSegment segmentOf(const std::vector<double>& base,
                                         const std::vector<double>& deflection, std::size_t begin,
                                         std::size_t end) const {
        const auto part = [&](const std::vector<double>& all) {
            return std::vector<double>(all.begin() + static_cast<std::ptrdiff_t>(begin),
                                       all.begin() + static_cast<std::ptrdiff_t>(end));
        };
        CurveSegment segment;
        segment.base = part(base);
        segment.deflection = part(deflection);
        const double step = wave_.steps[0];
        if (step > 0.0 && std::isfinite(step) && end > begin) {
            const auto points = static_cast<double>(end - begin);
            setUniformTimes(segment, static_cast<double>(begin) * step, points * step, end - begin);
        }
        return segment;
    }

    const ByteSource& bytes_;
    std::string wanted_;
    IgorWave wave_;
    std::map<std::string, std::string> note_;
};

/// One dimension, or columns of Asylum's signals.
bool recognizesIgorCurve(const ByteSource& bytes) {
    if (!startsAsIgorWave(bytes)) {
        return false;
    }
    try {
        const IgorWave wave = readIgorWave(bytes);
        return wave.counts[1] == 0 || isAsylumCurve(wave);
    } catch (const InputError&) {
        return false;
    }
}

}  // namespace

const CurveFormat kIgorCurveFormat = {
    .name = "Igor .ibw (Asylum Research) force curve",
    .recognizes = recognizesIgorCurve,
    .open = [](const ByteSource& bytes, const CurveReadOptions& options)
        -> std::unique_ptr<StoredCurves> { return std::make_unique<IgorCurve>(bytes, options); }};

}  // namespace asperity
