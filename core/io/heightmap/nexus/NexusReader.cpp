#include "core/io/heightmap/nexus/NexusReader.h"

#include "core/Error.h"
#include "core/io/ByteReader.h"
#include "core/io/TextValue.h"
#include "core/io/hdf5/Hdf5Program.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "core/io/heightmap/SampleRows.h"
#include "core/io/heightmap/ScanImage.h"
#include "core/io/heightmap/UnreadFormats.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <set>
#include <utility>

// Scans in NeXus files (HDF5) by the definitions NXafm, NXstm and NXspm. Each NXdata whose signal
// has two dimensions is a channel. Source: docs/formats.md 18.

namespace asperity {

namespace {

using Kind = Hdf5Item::Kind;

constexpr ByteOrder kNative =
    std::endian::native == std::endian::little ? ByteOrder::Little : ByteOrder::Big;

constexpr std::array<std::string_view, 3> kDefinitions{"NXafm", "NXstm", "NXspm"};

std::string_view parentOf(std::string_view path) { return path.substr(0, path.rfind('/')); }
std::string_view nameOf(std::string_view path) { return path.substr(path.rfind('/') + 1); }

/// One axis of the images.
struct NexusAxis {
    std::string path;
    double first = 0.0;  ///< [m]
    double last = 0.0;   ///< [m]
    bool isKnown = false;
    bool isLength = false;  ///< else first and last have no unit that is one

    [[nodiscard]] bool falls() const { return isKnown && last < first; }
    /// Returns the size of all pixels, whose middles the axis names [m].
    [[nodiscard]] double size(std::uint64_t pixels) const {
        const auto count = static_cast<double>(pixels);
        return isLength && pixels > 1 ? std::abs(last - first) * count / (count - 1.0) : 0.0;
    }
};

class NexusReader {
public:
    NexusReader(std::string file, ReadHdf5Content readContent)
        : file_(std::move(file))
        , readContent_(std::move(readContent))
        , content_(readContent_({})) {}

    StoredScan read() {
        const std::vector<std::string> images = imagesOfAll();
        requireImages(images.size(), file_, "NXdata");
        readAxes(images);
        for (const std::string& group : images) {
            addImage(group);
        }
        if (scan_.channels.empty()) {
            content_.fail("NXentry", noImage());
        }
        scan_.provenance.push_back({"format", definition_, "NXentry, definition"});
        return std::move(scan_);
    }

private:
    [[nodiscard]] const Hdf5Item* attribute(const std::string& path,
                                            const std::string& name) const {
        return content_.find(Kind::Attribute, path + "@" + name);
    }
    [[nodiscard]] std::string textOf(const std::string& path, const std::string& name) const {
        return content_.text(Kind::Attribute, path + "@" + name);
    }

    /// The groups of NXdata with an image, of all entries of these definitions.
    [[nodiscard]] std::vector<std::string> imagesOfAll() {
        std::vector<std::string> groups;
        for (const Hdf5Item& item : content_.items()) {
            if (item.kind != Kind::Group || textOf(item.path, "NX_class") != "NXdata" ||
                !isInEntry(item.path)) {
                continue;
            }
            const Hdf5Item* const signal = signalOf(item.path);
            if (signal == nullptr) {
                withoutSignal_ = item.path;
            }
            if (signal != nullptr && signal->shape.size() == 2) {
                groups.push_back(item.path);
            }
        }
        // HDF5 has them in the order of their names, "backward" first.
        std::ranges::stable_sort(groups, {}, [&](const std::string& group) {
            const std::string entry = entryOf(group);
            const std::string shown = entry + "/" + textOf(entry, "default");
            const bool isBackward = directionFromName(nameOf(group)) == "backward";
            return group == shown ? 0 : (isBackward ? 2 : 1);
        });
        return groups;
    }

    [[nodiscard]] std::string noImage() const {
        return withoutSignal_.empty()
                   ? "it holds no NXdata whose signal is an image"
                   : "the signal of its NXdata " + withoutSignal_ +
                         " is not in this file; a link to another file is not followed";
    }

    [[nodiscard]] static std::string entryOf(const std::string& path) {
        return path.substr(0, path.find('/', 1));
    }

    /// Returns whether a group lies in an entry of one of the definitions.
    [[nodiscard]] bool isInEntry(const std::string& path) {
        const std::string definition(
            trimmed(content_.text(Kind::Dataset, entryOf(path) + "/definition")));
        if (std::ranges::count(kDefinitions, definition) == 0) {
            return false;
        }
        definition_ = definition;
        return true;
    }

    [[nodiscard]] const Hdf5Item* signalOf(const std::string& group) const {
        const std::string signal = textOf(group, "signal");
        return content_.find(Kind::Dataset, group + "/" + (signal.empty() ? "data" : signal));
    }

    /// Names of the axes, the slow one first.
    [[nodiscard]] std::array<std::string, 2> axesOf(const std::string& group) const {
        std::array<std::string, 2> axes{"y", "x"};
        const Hdf5Item* const item = attribute(group, "axes");
        if (item != nullptr && item->type == Hdf5Type::Text && item->count == 2 && item->offset) {
            std::string texts(2 * static_cast<std::size_t>(item->bytes), '\0');
            content_.read(*item, 0, std::span<char>(texts));
            for (std::size_t i = 0; i < 2; ++i) {
                const std::string one = texts.substr(i * item->bytes, item->bytes);
                axes[i] = toUtf8(trimmed(one.substr(0, one.find('\0'))));
            }
        }
        return axes;
    }

    /// Long axes are no part of what was read first: all of them are read at once.
    void readAxes(const std::vector<std::string>& groups) {
        std::set<std::string> paths;
        for (const std::string& group : groups) {
            for (const std::string& axis : axesOf(group)) {
                if (content_.find(Kind::Dataset, group + "/" + axis) != nullptr) {
                    paths.insert(group + "/" + axis);
                }
            }
        }
        if (paths.empty()) {
            return;
        }
        const Hdf5Content content = readContent_({paths.begin(), paths.end()});
        for (const std::string& path : paths) {
            const Hdf5Item* const item = content.find(Kind::Dataset, path);
            if (item == nullptr || !item->offset || item->shape.size() != 1 || item->count == 0) {
                continue;
            }
            const PhysicalUnit unit = parseUnit(textOf(path, "units"));
            NexusAxis axis{.path = path};
            content.read(*item, 0, std::span<double>(&axis.first, 1));
            content.read(*item, item->count - 1, std::span<double>(&axis.last, 1));
            axis.first *= unit.factor;
            axis.last *= unit.factor;
            axis.isKnown = std::isfinite(axis.first) && std::isfinite(axis.last);
            axis.isLength = axis.isKnown && unit.base == "m";
            axes_[path] = axis;
        }
    }

    /// A number of an entry's scan, by the end of its path, in this unit or one of its kind; empty:
    /// there is none.
    [[nodiscard]] std::optional<double>
    scanNumber(const std::string& entry, const std::string& name, std::string_view base) const {
        for (const Hdf5Item& item : content_.items()) {
            if (item.kind == Kind::Dataset && item.path.starts_with(entry + "/") &&
                nameOf(item.path) == name && nameOf(parentOf(item.path)) == "scan_region" &&
                item.count == 1 && item.offset) {
                double value = 0.0;
                content_.read(item, 0, std::span<double>(&value, 1));
                const PhysicalUnit unit = parseUnit(textOf(item.path, "units"));
                return std::isfinite(value) && unit.base == base
                           ? std::optional(value * unit.factor)
                           : std::nullopt;
            }
        }
        return std::nullopt;
    }

    void addImage(const std::string& group) {
        const Hdf5Item& signal = *signalOf(group);
        const auto [slow, fast] = axesOf(group);
        NexusAxis y = axes_[group + "/" + slow];
        NexusAxis x = axes_[group + "/" + fast];
        const bool isTurned = runsAlongX(slow, fast);
        if (isTurned) {
            std::swap(x, y);
        }
        const std::uint64_t rows = signal.shape[isTurned ? 1 : 0];
        const std::uint64_t columns = signal.shape[isTurned ? 0 : 1];
        const ImageSize size =
            checkedImageSize(toSigned(columns), toSigned(rows), file_, signal.path);
        const std::string entry = entryOf(group);
        const auto length = [&](const char* name) { return scanNumber(entry, name, "m"); };
        const double width = length("scan_range_x").value_or(x.size(columns));
        const double height = length("scan_range_y").value_or(y.size(rows));
        const PhysicalUnit unit = parseUnit(textOf(signal.path, "units"));
        ScanChannel channel;
        channel.name = nameOf(signal.path);
        channel.unit = unit.base;
        channel.lateralUnit = "m";
        channel.direction = directionFromName(nameOf(group));
        channel.map = emptyMap(size, std::abs(width), std::abs(height));
        setOrigin(channel, length("scan_offset_value_x").value_or(0.0),
                  length("scan_offset_value_y").value_or(0.0), GivenPoint::Center);
        noteRotation(scan_.notes, scanNumber(entry, "scan_angle_n", "deg").value_or(0.0));
        channel.metadata["NXdata"] = group;
        settleSize(channel, length("scan_range_x") ? "scan_region, scan_range" : "axes");
        channel.provenance.push_back(
            {"orientation",
             y.falls() ? "the top row is stored first" : "the bottom row is stored first",
             y.isKnown ? "axis " + y.path : "no axis in the file"});
        channel.provenance.push_back(scaleProvenance(unit.factor, unit.base, signal.path));
        scan_.channels.push_back({.channel = std::move(channel),
                                  .factor = unit.factor,
                                  .readRow = rowsOfSignal(signal, size, x, y, isTurned)});
    }

    [[nodiscard]] static bool runsAlongX(const std::string& slow, const std::string& fast) {
        return lowerCase(slow).starts_with('x') && lowerCase(fast).starts_with('y');
    }

    [[nodiscard]] static long long toSigned(std::uint64_t count) {
        return static_cast<long long>(std::min<std::uint64_t>(count, 1U << 30U));
    }

    /// The values are read when they are asked for.
    [[nodiscard]] ReadRow rowsOfSignal(const Hdf5Item& signal, ImageSize size, const NexusAxis& x,
                                       const NexusAxis& y, bool isTurned) const {
        const SampleLayout layout{.size = size,
                                  .type = SampleType::Float64,
                                  .order = kNative,
                                  .bottomFirst = !y.falls(),
                                  .rightFirst = x.falls()};
        return rowsOfDecoded(
            [readContent = readContent_, path = signal.path, size, isTurned] {
                const Hdf5Content content = readContent({path});
                const Hdf5Item* const item = content.find(Kind::Dataset, path);
                if (item == nullptr || !item->offset || item->count != size.pixels()) {
                    content.fail(path, "its values cannot be read");
                }
                return samplesOf(content, *item, size, isTurned);
            },
            layout, file_);
    }

    /// @param isTurned stored column after column
    [[nodiscard]] static std::string samplesOf(const Hdf5Content& content, const Hdf5Item& item,
                                               ImageSize size, bool isTurned) {
        const auto columns = static_cast<std::size_t>(size.columns);
        const auto lines = static_cast<std::size_t>(isTurned ? size.columns : size.rows);
        std::vector<double> line(isTurned ? static_cast<std::size_t>(size.rows) : columns);
        std::string samples(size.pixels() * sizeof(double), '\0');
        for (std::size_t i = 0; i < lines; ++i) {
            content.read(item, i * line.size(), line);
            for (std::size_t j = 0; j < line.size(); ++j) {
                const std::size_t pixel = isTurned ? j * columns + i : i * columns + j;
                std::memcpy(samples.data() + pixel * sizeof(double), &line[j], sizeof(double));
            }
        }
        return samples;
    }

    std::string file_;
    ReadHdf5Content readContent_;
    Hdf5Content content_;
    std::string definition_;
    std::string withoutSignal_;  ///< an NXdata whose signal is not there
    std::map<std::string, NexusAxis> axes_;
    StoredScan scan_;
};

/// Returns whether an HDF5 file names one of the definitions.
bool isNexusScan(const ByteSource& bytes) {
    return isHdf5(bytes) && std::ranges::any_of(kDefinitions, [&](std::string_view name) {
               return holdsName(bytes, name);
           });
}

constexpr std::array<std::string_view, 1> kNexusExtensions{".nxs"};

}  // namespace

StoredScan readNexus(const std::string& file, const ReadHdf5Content& readContent) {
    return NexusReader(file, readContent).read();
}

const HeightMapFormat kNexusFormat = {
    .name = "NeXus NXafm/NXstm .nxs",
    .extensions = kNexusExtensions,
    .recognizes = isNexusScan,
    .read = [](const ByteSource& bytes) {
        return readNexus(bytes.name(), [&bytes](const std::vector<std::string>& paths) {
            return readHdf5(bytes, paths);
        });
    }};

}  // namespace asperity
