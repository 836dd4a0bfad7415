#include "tests/core/io/heightmap/TiffFiles.h"

#include "core/io/ByteReader.h"

#include <algorithm>
#include <map>

namespace asperity::test {

namespace {

template <typename Number>
void append(std::string& bytes, double value, ByteOrder order) {
    std::string number;
    appendLittleEndian(number, static_cast<Number>(value));
    if (order == ByteOrder::Big) {
        std::ranges::reverse(number);
    }
    bytes += number;
}

void appendSample(std::string& bytes, double value, SampleType type, ByteOrder order) {
    switch (type) {
    case SampleType::Int8:
        return append<std::int8_t>(bytes, value, order);
    case SampleType::UInt8:
        return append<std::uint8_t>(bytes, value, order);
    case SampleType::Int16:
        return append<std::int16_t>(bytes, value, order);
    case SampleType::UInt16:
        return append<std::uint16_t>(bytes, value, order);
    case SampleType::Int32:
        return append<std::int32_t>(bytes, value, order);
    case SampleType::UInt32:
        return append<std::uint32_t>(bytes, value, order);
    case SampleType::Int64:
        return append<std::int64_t>(bytes, value, order);
    case SampleType::UInt64:
        return append<std::uint64_t>(bytes, value, order);
    case SampleType::Float32:
        return append<float>(bytes, value, order);
    case SampleType::Float64:
        return append<double>(bytes, value, order);
    }
}

/// A number of a TIFF type; a rational is the value over 1.
void appendValue(std::string& bytes, double value, std::uint16_t type, ByteOrder order) {
    switch (type) {
    case 1:
        return append<std::uint8_t>(bytes, value, order);
    case 8:
        return append<std::int16_t>(bytes, value, order);
    case 4:
        return append<std::uint32_t>(bytes, value, order);
    case 5:
        append<std::uint32_t>(bytes, value, order);
        return append<std::uint32_t>(bytes, 1, order);
    case 9:
        return append<std::int32_t>(bytes, value, order);
    case 12:
        return append<double>(bytes, value, order);
    case 16:
        return append<std::uint64_t>(bytes, value, order);
    default:
        return append<std::uint16_t>(bytes, value, order);
    }
}

int formatOf(SampleType type) {
    switch (type) {
    case SampleType::Float32:
    case SampleType::Float64:
        return 3;
    case SampleType::Int8:
    case SampleType::Int16:
    case SampleType::Int32:
        return 2;
    default:
        return 1;
    }
}

/// Writes directories behind the strips of their images.
class TiffBuilder {
public:
    TiffBuilder(ByteOrder order, bool big) : order_(order), big_(big) {
        bytes_ = order == ByteOrder::Little ? "II" : "MM";
        append<std::uint16_t>(bytes_, big ? 43 : 42, order);
        if (big) {
            append<std::uint16_t>(bytes_, 8, order);
            append<std::uint16_t>(bytes_, 0, order);
        }
        next_ = bytes_.size();
        appendOffset(bytes_, 0);
    }

    void add(const TiffTestImage& image) {
        std::map<std::uint16_t, TiffTestField> fields = standardFields(image);
        for (const TiffTestField& field : image.extra) {
            fields[field.tag] = field;
        }
        std::string table;
        for (const auto& [tag, field] : fields) {
            table += entryOf(field);
        }
        std::string offset;
        appendOffset(offset, static_cast<double>(bytes_.size()));
        bytes_.replace(next_, offset.size(), offset);
        if (big_) {
            append<std::uint64_t>(bytes_, static_cast<double>(fields.size()), order_);
        } else {
            append<std::uint16_t>(bytes_, static_cast<double>(fields.size()), order_);
        }
        bytes_ += table;
        next_ = bytes_.size();
        appendOffset(bytes_, 0);
    }

    [[nodiscard]] const std::string& bytes() const { return bytes_; }

private:
    void appendOffset(std::string& bytes, double value) const {
        if (big_) {
            append<std::uint64_t>(bytes, value, order_);
        } else {
            append<std::uint32_t>(bytes, value, order_);
        }
    }

    std::map<std::uint16_t, TiffTestField> standardFields(const TiffTestImage& image) {
        const double bits = 8.0 * static_cast<double>(sizeOf(image.type));
        std::map<std::uint16_t, TiffTestField> fields;
        const auto set = [&fields](std::uint16_t tag, double value) {
            fields[tag] = tiffInteger(tag, value);
        };
        set(256, image.columns);
        set(257, image.rows);
        set(258, bits);
        set(259, 1);
        set(262, image.photometric);
        set(277, image.samplesPerPixel);
        set(278, image.rowsPerStrip);
        set(339, formatOf(image.type));
        addStrips(fields, image);
        return fields;
    }

    void addStrips(std::map<std::uint16_t, TiffTestField>& fields, const TiffTestImage& image) {
        const auto stride =
            static_cast<std::size_t>(image.columns * image.rowsPerStrip * image.samplesPerPixel);
        std::vector<std::vector<double>> strips;
        for (std::size_t i = 0; i < image.values.size(); i += stride) {
            const auto first = image.values.begin() + static_cast<std::ptrdiff_t>(i);
            strips.emplace_back(first, first + static_cast<std::ptrdiff_t>(
                                                   std::min(stride, image.values.size() - i)));
        }
        TiffTestField offsets{.tag = 273, .type = 4, .numbers = {}, .bytes = {}};
        TiffTestField counts{.tag = 279, .type = 4, .numbers = {}, .bytes = {}};
        offsets.numbers.resize(strips.size());
        for (std::size_t i = 0; i < strips.size(); ++i) {
            const std::size_t strip = image.lastStripFirst ? strips.size() - 1 - i : i;
            offsets.numbers[strip] = static_cast<double>(bytes_.size());
            bytes_ += sampleBytes(strips[strip], image.type, order_);
        }
        for (const std::vector<double>& strip : strips) {
            counts.numbers.push_back(static_cast<double>(strip.size() * sizeOf(image.type)));
        }
        fields[273] = offsets;
        fields[279] = counts;
    }

    /// An entry of the directory; values that have no room in it are appended to the file.
    std::string entryOf(const TiffTestField& field) {
        std::string values = field.bytes;
        for (const double number : field.numbers) {
            appendValue(values, number, field.type, order_);
        }
        std::string entry;
        append<std::uint16_t>(entry, field.tag, order_);
        append<std::uint16_t>(entry, field.type, order_);
        appendOffset(entry, static_cast<double>(field.numbers.empty() ? field.bytes.size()
                                                                      : field.numbers.size()));
        const std::size_t room = big_ ? 8 : 4;
        if (values.size() > room) {
            appendOffset(entry, static_cast<double>(bytes_.size()));
            bytes_ += values;
        } else {
            values.resize(room, '\0');
            entry += values;
        }
        return entry;
    }

    ByteOrder order_;
    bool big_;
    std::string bytes_;
    std::size_t next_ = 0;  ///< location of the offset of the next directory
};

}  // namespace

TiffTestField tiffText(std::uint16_t tag, const std::string& text) {
    return {.tag = tag, .type = 2, .numbers = {}, .bytes = text + '\0'};
}

TiffTestField tiffDouble(std::uint16_t tag, double value) {
    return {.tag = tag, .type = 12, .numbers = {value}, .bytes = {}};
}

TiffTestField tiffInteger(std::uint16_t tag, double value) {
    return {.tag = tag, .type = 4, .numbers = {value}, .bytes = {}};
}

std::string tiffFile(const std::vector<TiffTestImage>& images, ByteOrder order, bool big) {
    TiffBuilder builder(order, big);
    for (const TiffTestImage& image : images) {
        builder.add(image);
    }
    return builder.bytes();
}

std::string sampleBytes(const std::vector<double>& values, SampleType type, ByteOrder order) {
    std::string bytes;
    for (const double value : values) {
        appendSample(bytes, value, type, order);
    }
    return bytes;
}

}  // namespace asperity::test
