#include "core/Error.h"
#include "core/io/TextValue.h"
#include "core/io/curves/CurveFormat.h"
#include "core/io/curves/CurveSegments.h"
#include "core/io/heightmap/HeaderFields.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "core/io/heightmap/SampleRows.h"
#include "core/io/heightmap/nanoscope/NanoscopeHeader.h"

#include <algorithm>
#include <cmath>

// Force curves and force volumes of Bruker NanoScope: approach, stored backwards, then retract,
// curve after curve; the base is the ramp of the piezo. Source: docs/formats.md 21.

namespace asperity {

namespace {

constexpr std::array<std::string_view, 1> kForceImageLists{"ciao force image list"};
constexpr double kVolumeUnit = 256.0;  ///< counts of a volume have 8 bits behind the point

/// A line of the header that has a bracket and a number, "V [Sens. Zsens] (...) 227.2 V".
struct ForceScale {
    double hardScale = 0.0;    ///< per count; 0: the parenthesis has no number
    double value = 0.0;        ///< behind it, in SI
    double sensitivity = 0.0;  ///< [SI unit / V]; 0: the header does not give it
};

class NanoscopeCurves final : public StoredCurves {
public:
    NanoscopeCurves(const ByteSource& bytes, const CurveReadOptions& options)
        : bytes_(bytes)
        , sections_(readNanoscopeHeader(nanoscopeStart(bytes), bytes.name()))
        , heights_{"ramp"}
        , height_(chosenHeight(heights_, options.height, bytes.name())) {
        const NanoscopeSection& list = deflectionList();
        readCounts(list);
        readScales(list);
        readData(list);
        readGrid();
        hasImage_ = std::ranges::any_of(sections_, isNanoscopeImageList);
    }

    [[nodiscard]] std::size_t count() const override { return curves_; }
    [[nodiscard]] CurveGrid grid() const override { return grid_; }
    [[nodiscard]] bool hasImage() const override { return hasImage_; }

    [[nodiscard]] std::optional<CurveCell> cell(std::size_t index) const override {
        if (grid_.columns == 0) {
            return std::nullopt;
        }
        const auto columns = static_cast<std::size_t>(grid_.columns);
        return CurveCell{static_cast<int>(index % columns), static_cast<int>(index / columns)};
    }

    [[nodiscard]] std::optional<CurvePosition> position(std::size_t index) const override {
        const std::optional<CurveCell> place = cell(index);
        const std::optional<double> size = parseLength(text("Scan size"));
        if (!place || !size) {
            return std::nullopt;
        }
        const auto along = [&](int step, int steps, const std::string& offset) {
            return parseLength(text(offset)).value_or(0.0) + ((step + 0.5) / steps - 0.5) * *size;
        };
        return CurvePosition{along(place->column, grid_.columns, "X Offset"),
                             along(place->row, grid_.rows, "Y Offset")};
    }

    [[nodiscard]] CurveContents read(std::size_t index) const override {
        CurveContents contents;
        contents.heights = heights_;
        contents.heightChannel = height_;
        contents.curve.stiffness = stiffness_;
        contents.curve.invols = invols_;
        const std::vector<double> samples = samplesOf(index);
        addApproach(contents.curve, samples);
        addRetract(contents.curve, samples);
        finishCurve(contents, bytes_.name());
        return contents;
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(bytes_.name(), "Ciao force image list", what);
    }

    [[nodiscard]] std::string text(std::string_view key) const {
        const std::string* const value = nanoscopeEntry(sections_, key);
        return value == nullptr ? std::string() : *value;
    }

    /// 0: the header does not say it.
    [[nodiscard]] double number(std::string_view key) const {
        const std::optional<LeadingNumber> value = parseLeadingNumber(text(key));
        return value && std::isfinite(value->value) ? value->value : 0.0;
    }

    [[nodiscard]] const NanoscopeSection& deflectionList() const {
        const NanoscopeSection* found = nullptr;
        for (const NanoscopeSection& section : sections_) {
            const std::string* const data = section.find("@4:Image Data");
            const bool isDeflection =
                data == nullptr || lowerCase(*data).find("deflection") != std::string::npos;
            if (found == nullptr && isNamed(section, kForceImageLists) && isDeflection) {
                found = &section;
            }
        }
        if (found == nullptr) {
            throw InputError(bytes_.name(), "header",
                             "it lists no deflection of force curves ('Ciao force image list')");
        }
        return *found;
    }

    /// "Samps/line: 1024 1024": those of the retract, then those of the approach.
    void readCounts(const NanoscopeSection& list) {
        constexpr double kMaxSamples = 1 << 24;
        const std::string* const given = list.find("Samps/line");
        const std::optional<LeadingNumber> retract =
            given == nullptr ? std::nullopt : parseLeadingNumber(*given);
        const std::optional<LeadingNumber> approach =
            retract ? parseLeadingNumber(retract->rest) : std::nullopt;
        const double second = approach ? approach->value : retract ? retract->value : 0.0;
        const auto isCount = [](double value) { return value >= 0.0 && value <= kMaxSamples; };
        if (!retract || !isCount(retract->value) || !isCount(second) ||
            !(retract->value + second >= 1.0)) {
            fail("expected the numbers of samples at 'Samps/line'");
        }
        retractPoints_ = static_cast<std::size_t>(retract->value);
        approachPoints_ = static_cast<std::size_t>(second);
    }

    /// The entry of a list whose key ends so, "@4:Ramp Size". A damaged parenthesis is left out.
    [[nodiscard]] ForceScale scaleAt(const NanoscopeSection& list, std::string_view end) const {
        for (const auto& [key, entry] : list.entries) {
            const std::optional<CiaoValue> value =
                key.ends_with(end) ? parseCiaoValue(entry.value) : std::nullopt;
            if (!value || !value->number) {
                continue;
            }
            ForceScale scale;
            if (const auto hard = parseLeadingNumber(value->hardScale)) {
                scale.hardScale = hard->value * perVolt(hard->rest);
            }
            scale.value = *value->number * perVolt(value->unit);
            scale.sensitivity = sensitivityOf(value->bracket);
            return scale;
        }
        return {};
    }

    /// "V/LSB", "mV": the factor to volts; other units stay as they are.
    static double perVolt(std::string_view unit) {
        return parseUnit(trimmed(unit.substr(0, unit.find('/')))).factor;
    }

    /// "Sens. DeflSens" -> the entry "@Sens. DeflSens: V 27.39 nm/V", whose unit may be missing.
    [[nodiscard]] double sensitivityOf(const std::string& name) const {
        constexpr double kNanometer = 1e-9;
        const std::string* const entry =
            name.empty() ? nullptr : nanoscopeEntry(sections_, "@" + name);
        const std::optional<CiaoValue> value =
            entry == nullptr ? std::nullopt : parseCiaoValue(*entry);
        if (!value || !value->number) {
            return 0.0;
        }
        return *value->number * (value->unit.empty() ? kNanometer : parseUnit(value->unit).factor);
    }

    void readScales(const NanoscopeSection& list) {
        const ForceScale deflection = scaleAt(list, "z scale");
        const ForceScale ramp = scaleAt(list, "ramp size");
        perCount_ = deflection.hardScale;
        if (!(std::abs(perCount_) > 0.0) || !std::isfinite(perCount_)) {
            fail("expected the volts of a count in the parenthesis of '@4:Z scale'");
        }
        rampLength_ = std::abs(ramp.value * ramp.sensitivity);
        if (!(rampLength_ > 0.0) || !std::isfinite(rampLength_)) {
            fail("expected the length of the ramp at '@4:Ramp size', with its sensitivity");
        }
        invols_ = std::max(deflection.sensitivity, 0.0);
        const std::string* const own = list.find("Spring Constant");
        const double stiffness =
            own == nullptr ? number("Spring Constant") : parseNumber(*own).value_or(0.0);
        stiffness_ = stiffness > 0.0 && std::isfinite(stiffness) ? stiffness : 0.0;
        approachSpeed_ = std::abs(number("Forward vel.") * ramp.sensitivity);
        retractSpeed_ = std::abs(number("Reverse vel.") * ramp.sensitivity);
    }

    void readData(const NanoscopeSection& list) {
        const auto integer = [&](const char* key) {
            const std::string* const value = list.find(key);
            const std::optional<long long> parsed =
                value == nullptr ? std::nullopt : parseInteger(*value);
            return parsed && *parsed > 0 ? static_cast<std::uint64_t>(*parsed) : 0;
        };
        offset_ = integer("Data offset");
        const std::uint64_t length = integer("Data length");
        width_ = integer("Bytes/pixel") == sizeof(std::int32_t)
                     ? static_cast<int>(sizeof(std::int32_t))
                     : nanoscopeSampleBytes(text("Version"));
        if (length == 0 || length % curveBytes() != 0) {
            fail("'Data length' " + std::to_string(length) + " is no multiple of " +
                 std::to_string(curveBytes()) + ", the bytes of a curve");
        }
        const std::uint64_t there = bytes_.size() - std::min(offset_, bytes_.size());
        curves_ = static_cast<std::size_t>(std::min(length, there) / curveBytes());
        if (curves_ == 0) {
            fail("its data end before the first curve; the file is truncated");
        }
        if (there < length) {
            notes_.push_back("the file is truncated: it holds " + std::to_string(curves_) +
                             " whole curves of " + std::to_string(length / curveBytes()));
        }
        hasFraction_ = hasVolumeCounts();
    }

    [[nodiscard]] std::uint64_t curveBytes() const {
        return (approachPoints_ + retractPoints_) * static_cast<std::uint64_t>(width_);
    }

    [[nodiscard]] std::string storedCurve(std::size_t index) const {
        return bytesOf(bytes_, {offset_ + index * curveBytes(), curveBytes()});
    }

    /// Samples of a force volume of 32 bits are 16 bits, then 8 behind the point: their low byte is
    /// 00 or FF throughout, which no curve of real counts is.
    [[nodiscard]] bool hasVolumeCounts() const {
        if (width_ != static_cast<int>(sizeof(std::int32_t))) {
            return false;
        }
        const std::string stored = storedCurve(0);
        for (std::size_t i = 0; i < stored.size(); i += sizeof(std::int32_t)) {
            if (stored[i] != '\0' && stored[i] != '\xFF') {
                return false;
            }
        }
        return true;
    }

    /// Volumes name the curves of a line.
    void readGrid() {
        const double columns = number("force/line");
        const bool isVolume = text("Start context") == "FVOL" && columns >= 1.0 &&
                              columns <= static_cast<double>(curves_);
        if (isVolume) {
            const auto side = static_cast<std::size_t>(columns);
            grid_ = {static_cast<int>(side), static_cast<int>((curves_ + side - 1) / side)};
        }
    }

    /// The signal [V].
    [[nodiscard]] std::vector<double> samplesOf(std::size_t index) const {
        const std::string stored = storedCurve(index);
        std::vector<double> samples(approachPoints_ + retractPoints_);
        convertSamples(width_ == 2 ? SampleType::Int16 : SampleType::Int32, ByteOrder::Little,
                       stored.data(), samples);
        const double factor = perCount_ / (hasFraction_ ? kVolumeUnit : 1.0);
        std::ranges::transform(samples, samples.begin(),
                               [factor](double count) { return factor * count; });
        return samples;
    }

    void addApproach(MeasuredForceCurve& curve, const std::vector<double>& samples) const {
        CurveSegment segment;
        segment.kind = CurveSegmentKind::Approach;
        const auto end = samples.begin() + static_cast<std::ptrdiff_t>(approachPoints_);
        segment.signal.assign(std::make_reverse_iterator(end), samples.rend());
        segment.base.resize(approachPoints_);
        const double step = rampLength_ / static_cast<double>(approachPoints_);
        for (std::size_t i = 0; i < approachPoints_; ++i) {
            segment.base[i] = static_cast<double>(i) * step;
        }
        setTimes(segment, 0.0, approachSpeed_);
        curve.segments.push_back(std::move(segment));
    }

    void addRetract(MeasuredForceCurve& curve, const std::vector<double>& samples) const {
        CurveSegment segment;
        segment.kind = CurveSegmentKind::Retract;
        segment.signal.assign(samples.begin() + static_cast<std::ptrdiff_t>(approachPoints_),
                              samples.end());
        segment.base.resize(retractPoints_);
        const double step = rampLength_ / static_cast<double>(retractPoints_);
        for (std::size_t i = 0; i < retractPoints_; ++i) {
            segment.base[i] = rampLength_ - static_cast<double>(i) * step;
        }
        const bool known = approachSpeed_ > 0.0;
        setTimes(segment, known ? rampLength_ / approachSpeed_ : 0.0, known ? retractSpeed_ : 0.0);
        curve.segments.push_back(std::move(segment));
    }

    void setTimes(CurveSegment& segment, double begin, double speed) const {
        if (speed > 0.0 && std::isfinite(rampLength_ / speed) && !segment.base.empty()) {
            setUniformTimes(segment, begin, rampLength_ / speed, segment.base.size());
        }
    }

    const ByteSource& bytes_;
    std::vector<NanoscopeSection> sections_;
    std::vector<std::string> heights_;
    std::string height_;
    std::size_t approachPoints_ = 0;
    std::size_t retractPoints_ = 0;
    double perCount_ = 0.0;       ///< [V]
    double rampLength_ = 0.0;     ///< [m]
    double invols_ = 0.0;         ///< [m/V]
    double stiffness_ = 0.0;      ///< [N/m]
    double approachSpeed_ = 0.0;  ///< [m/s]
    double retractSpeed_ = 0.0;   ///< [m/s]
    std::uint64_t offset_ = 0;
    int width_ = 2;  ///< of a sample [bytes]
    bool hasFraction_ = false;
    std::size_t curves_ = 0;
    CurveGrid grid_;
    bool hasImage_ = false;
};

bool recognizesNanoscopeCurves(const ByteSource& bytes) {
    return bytes.startsWith("\\*Force file list");
}

}  // namespace

const CurveFormat kNanoscopeCurveFormat = {
    .name = "Bruker NanoScope force curves",
    .recognizes = recognizesNanoscopeCurves,
    .open = [](const ByteSource& bytes,
               const CurveReadOptions& options) -> std::unique_ptr<StoredCurves> {
        return std::make_unique<NanoscopeCurves>(bytes, options);
    }};

}  // namespace asperity
