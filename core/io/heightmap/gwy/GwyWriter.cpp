#include "core/io/heightmap/gwy/GwyWriter.h"

#include "core/Error.h"
#include "core/io/ByteReader.h"
#include "core/io/heightmap/HeightMapWriter.h"

#include <fstream>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

// Gwyddion's own files; see GwyReader.cpp.

namespace asperity {

namespace {

/// Writes serialized objects into a file, keeping none in memory. An object's size
/// is written before its content, and is put there when the object ends.
class GwyStream {
public:
    explicit GwyStream(std::ofstream& stream) : stream_(stream) {}

    void begin(std::string_view className) {
        text(className);
        begins_.push_back(stream_.tellp());
        put(std::uint32_t{0});
    }
    void begin(std::string_view name, std::string_view className) {
        component(name, 'o');
        begin(className);
    }
    /// Ends the object that began last.
    void end() {
        const std::streampos here = stream_.tellp();
        const auto size = here - begins_.back() - std::streamoff{sizeof(std::uint32_t)};
        if (size > std::numeric_limits<std::uint32_t>::max()) {
            throw Error("a .gwy file holds at most 4 GiB");
        }
        stream_.seekp(begins_.back());
        put(static_cast<std::uint32_t>(size));
        stream_.seekp(here);
        begins_.pop_back();
    }

    void boolean(std::string_view name, bool value) {
        component(name, 'b');
        stream_ << (value ? '\1' : '\0');
    }
    void integer(std::string_view name, std::int32_t value) {
        component(name, 'i');
        put(value);
    }
    void number(std::string_view name, double value) {
        component(name, 'd');
        put(value);
    }
    void text(std::string_view name, std::string_view value) {
        component(name, 's');
        text(value);
    }
    /// valueOf(height) of each pixel.
    template <class ValueOf>
    void numbers(std::string_view name, const HeightRows& map, Progress* progress,
                 const ValueOf& valueOf) {
        component(name, 'D');
        const auto count =
            static_cast<std::uint64_t>(map.columns) * static_cast<std::uint64_t>(map.rows);
        put(static_cast<std::uint32_t>(count));
        std::string bytes;
        forEachRow(map, progress, [&](int, const std::vector<double>& heights) {
            bytes.clear();
            for (const double height : heights) {
                appendLittleEndian(bytes, valueOf(height));
            }
            stream_ << bytes;
        });
    }

private:
    void component(std::string_view name, char type) {
        text(name);
        stream_ << type;
    }
    /// NUL ends a text, so what follows one is cut off.
    void text(std::string_view text) { stream_ << text.substr(0, text.find('\0')) << '\0'; }
    template <class Number>
    void put(Number number) {
        std::string bytes;
        appendLittleEndian(bytes, number);
        stream_ << bytes;
    }

    std::ofstream& stream_;
    std::vector<std::streampos> begins_;  ///< offsets of the sizes of objects that have not ended
};

/// @param unit empty: none
void writeUnit(GwyStream& stream, std::string_view name, std::string_view unit) {
    stream.begin(name, "GwySIUnit");
    stream.text("unitstr", unit);
    stream.end();
}

/// Writes a field's size before its values; none where it is not known.
void writeGeometry(GwyStream& stream, const WrittenImage& image) {
    stream.integer("xres", image.rows.columns);
    stream.integer("yres", image.rows.rows);
    if (image.rows.pitchX > 0.0 && image.rows.pitchY > 0.0) {
        stream.number("xreal", image.rows.sizeX());
        stream.number("yreal", image.rows.sizeY());
    }
    stream.number("xoff", image.meta.originX);
    stream.number("yoff", image.meta.originY);
    writeUnit(stream, "si_unit_xy", image.lateralUnit);
}

/// An image for the container, as number N.
class ImageWriter {
public:
    ImageWriter(GwyStream& stream, const WrittenImage& image, std::size_t number)
        : stream_(stream), image_(image), prefix_("/" + std::to_string(number) + "/") {}

    void write(Progress* progress) {
        ProgressPart ranging(progress, 0.0, 0.1);
        const HeightRange range = heightRange(image_.rows, &ranging);
        ProgressPart writing(progress, 0.1, range.missing > 0 ? 0.5 : 1.0);
        writeHeights(range.lowest, &writing);
        stream_.text(prefix_ + "data/title", image_.meta.title);
        stream_.boolean(prefix_ + "data/visible", true);
        if (!image_.meta.metadata.empty()) {
            writeMetadata();
        }
        if (range.missing > 0) {
            ProgressPart marking(progress, 0.5, 1.0);
            writeMask(&marking);
        }
    }

private:
    /// The format forbids NaN: pixels without data hold what was filled in, or the lowest height,
    /// and the mask marks them.
    void writeHeights(double filling, Progress* progress) {
        HeightRows rows = image_.rows;
        if (rows.readFilledRow) {
            rows.readRow = rows.readFilledRow;
        }
        stream_.begin(prefix_ + "data", "GwyDataField");
        writeGeometry(stream_, image_);
        stream_.numbers("data", rows, progress, [filling](double height) {
            return isFiniteHeight(height) ? height : filling;
        });
        writeUnit(stream_, "si_unit_z", image_.meta.unit);
        stream_.end();
    }

    void writeMask(Progress* progress) {
        stream_.begin(prefix_ + "mask", "GwyDataField");
        writeGeometry(stream_, image_);
        stream_.numbers("data", image_.rows, progress,
                        [](double height) { return isFiniteHeight(height) ? 0.0 : 1.0; });
        stream_.end();
    }

    void writeMetadata() {
        stream_.begin(prefix_ + "meta", "GwyContainer");
        for (const auto& [name, value] : image_.meta.metadata) {
            if (!name.empty()) {
                stream_.text(name, value);
            }
        }
        stream_.end();
    }

    GwyStream& stream_;
    const WrittenImage& image_;
    std::string prefix_;  ///< of the keys of its parts
};

/// Checks the size before anything is written.
void requireFit(std::span<const WrittenImage> images) {
    double bytes = 0.0;
    for (const WrittenImage& image : images) {
        bytes += static_cast<double>(sizeof(double)) * image.rows.columns * image.rows.rows;
    }
    if (bytes > std::numeric_limits<std::uint32_t>::max()) {
        throw Error("a .gwy file holds at most 4 GiB");
    }
}

}  // namespace

void writeGwyImages(const std::filesystem::path& target, std::span<const WrittenImage> images,
                    Progress* progress) {
    requireFit(images);
    std::ofstream file(target, std::ios::binary);
    file << "GWYP";
    GwyStream stream(file);
    stream.begin("GwyContainer");
    const auto count = static_cast<double>(images.size());
    for (std::size_t i = 0; i < images.size(); ++i) {
        const auto number = static_cast<double>(i);
        ProgressPart part(progress, number / count, (number + 1.0) / count);
        ImageWriter(stream, images[i], i).write(&part);
    }
    stream.end();
    finish(file);
}

void writeGwy(const std::filesystem::path& target, const HeightRows& map, const HeightMapMeta& meta,
              Progress* progress) {
    const WrittenImage image{map, meta};
    writeGwyImages(target, {&image, 1}, progress);
}

}  // namespace asperity
