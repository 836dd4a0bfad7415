#include "tests/core/io/heightmap/InstrumentFiles.h"

#include "core/io/ByteReader.h"

#include <algorithm>

namespace asperity::test {

namespace {

template <typename Number>
void append(std::string& bytes, ByteOrder order, Number value) {
    std::string one;
    appendLittleEndian(one, value);
    if (order == ByteOrder::Big) {
        std::ranges::reverse(one);
    }
    bytes += one;
}

template <typename Number>
void put(std::string& bytes, std::size_t offset, ByteOrder order, Number value) {
    std::string one;
    append(one, order, value);
    bytes.replace(offset, one.size(), one);
}

void put(std::string& bytes, std::size_t offset, const std::string& text) {
    bytes.replace(offset, text.size(), text);
}

/// The least that makes the numbers of 16 bits in the first 384 bytes add up to 0.
std::uint16_t igorChecksum(const std::string& bytes, ByteOrder order) {
    unsigned sum = 0;
    for (std::size_t offset = 0; offset < 384; offset += 2) {
        sum += order == ByteOrder::Little ? littleEndian<std::uint16_t>(bytes.data() + offset)
                                          : bigEndian<std::uint16_t>(bytes.data() + offset);
    }
    return static_cast<std::uint16_t>(0x10000U - (sum & 0xFFFFU));
}

std::string paddedLabels(const std::vector<std::string>& labels) {
    std::string text;
    for (const std::string& label : labels) {
        text += label + std::string(32 - label.size(), '\0');
    }
    return text;
}

}  // namespace

std::string samples(SampleType type, ByteOrder order, const std::vector<double>& numbers) {
    std::string bytes;
    for (const double number : numbers) {
        switch (type) {
        case SampleType::Int8:
            append(bytes, order, static_cast<std::int8_t>(number));
            break;
        case SampleType::UInt8:
            append(bytes, order, static_cast<std::uint8_t>(number));
            break;
        case SampleType::Int16:
            append(bytes, order, static_cast<std::int16_t>(number));
            break;
        case SampleType::UInt16:
            append(bytes, order, static_cast<std::uint16_t>(number));
            break;
        case SampleType::Int32:
            append(bytes, order, static_cast<std::int32_t>(number));
            break;
        case SampleType::UInt32:
            append(bytes, order, static_cast<std::uint32_t>(number));
            break;
        case SampleType::Int64:
            append(bytes, order, static_cast<std::int64_t>(number));
            break;
        case SampleType::UInt64:
            append(bytes, order, static_cast<std::uint64_t>(number));
            break;
        case SampleType::Float32:
            append(bytes, order, static_cast<float>(number));
            break;
        case SampleType::Float64:
            append(bytes, order, number);
            break;
        }
    }
    return bytes;
}

std::string igorFile(const IgorWaveText& wave) {
    const ByteOrder order = wave.order;
    const std::string data = samples(wave.stored, order, wave.numbers);
    const std::string columns = paddedLabels(wave.columnLabels);
    const std::string layers = paddedLabels(wave.layerLabels);
    const auto size = [](const std::string& text) {
        return static_cast<std::int32_t>(text.size());
    };
    std::string bytes(384, '\0');
    put(bytes, 0, order, static_cast<std::int16_t>(wave.version));
    put(bytes, 4, order, 320 + size(data));
    put(bytes, 12, order, size(wave.note));
    put(bytes, 40, order, size(columns));
    put(bytes, 44, order, size(layers));
    const bool given = wave.numberOfNumbers >= 0;
    put(bytes, 76, order,
        given ? wave.numberOfNumbers : static_cast<std::int32_t>(wave.numbers.size()));
    put(bytes, 80, order, static_cast<std::int16_t>(wave.type));
    put(bytes, 92, "wave0");
    for (std::size_t i = 0; i < 4; ++i) {
        put(bytes, 132 + 4 * i, order, wave.counts[i]);
        put(bytes, 148 + 8 * i, order, wave.steps[i]);
    }
    put(bytes, 212, wave.unit);
    put(bytes, 216, wave.dimensionUnit);
    put(bytes, 220, wave.dimensionUnit);
    put(bytes, 2, order, igorChecksum(bytes, order));
    return bytes + data + wave.note + columns + layers + wave.footer;
}

std::string nanonisFile(const NanonisText& text, const std::vector<double>& numbers) {
    return ":NANONIS_VERSION:\n" + text.version + "\n:SCANIT_TYPE:\n              " + text.type +
           "\n:ACQ_TIME:\n       " + text.time + "\n:SCAN_PIXELS:\n       " + text.pixels +
           "\n:SCAN_RANGE:\n           " + text.range +
           "\n:SCAN_OFFSET:\n    -5.280251E-7   1.130423E-8\n:SCAN_DIR:\n" + text.direction +
           "\n:COMMENT:\n" + text.comment + "\n:DATA_INFO:\n" + text.table +
           "\n:SCANIT_END:\n\n\n" + text.mark +
           samples(SampleType::Float32, ByteOrder::Big, numbers);
}

std::string nanosurfFile(const std::vector<NanosurfChannel>& channels) {
    std::string list =
        "[DataSet]\r\nVersion=2\r\nGroupCount=" + std::to_string(channels.size()) + "\r\n";
    std::string sections =
        "\r\n[DataSet-Info]\r\n-- Scan --=--------\r\nImage size=50\xC2\xB5m\r\n";
    std::string data;
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const NanosurfChannel& channel = channels[i];
        const std::string number = std::to_string(i);
        list += "Gr" + number + "-Count=16\r\nGr" + number + "-Ch1=DataSet-" + number + ":1\r\n";
        sections += "\r\n[DataSet-" + number + ":1]\r\nPoints=" + channel.points +
                    "\r\nLines=" + channel.lines + "\r\nFrame=" + channel.frame +
                    "\r\nDim0Unit=m\r\nDim0Range=" + channel.sizeX +
                    "\r\nDim0Min=0\r\nDim1Unit=m\r\nDim1Range=2e-08\r\nDim1Min=0\r\nDim2Name=" +
                    channel.name + "\r\nDim2Unit=" + channel.unit +
                    "\r\nDim2Range=" + channel.range + "\r\nDim2Min=" + channel.minimum +
                    "\r\nSaveMode=Binary\r\nSaveBits=" + channel.bits +
                    "\r\nSaveSign=Signed\r\nSaveOrder=" + channel.order + "\r\n";
        data += samples(channel.stored, ByteOrder::Little, channel.numbers);
    }
    return list + sections + "\r\n\r\n#!" + data;
}

std::string picoviewFile(const PicoviewText& text, SampleType stored,
                         const std::vector<double>& numbers) {
    return text.firstLine + "version       PicoView 0x10c04\nxPixels       3\nyPixels       2\n" +
           "xOffset       1.0e-009\n" + text.size + text.image + "data          " + text.data +
           "\n" + samples(stored, ByteOrder::Little, numbers);
}

std::string wsxmFile(const WsxmText& text, const std::vector<double>& numbers) {
    return "WSxM file copyright UAM\r\n" + text.kind + "\r\nImage header size: " + text.headerSize +
           "\r\n\r\n[Control]\r\n\r\n    X Amplitude: " + text.amplitudeX +
           "\r\n    X Offset: -712.919 nm\r\n    Y Amplitude: 20 nm\r\n\r\n[General Info]\r\n\r\n"
           "    Acquisition channel: Topography\r\n" +
           text.typeLine +
           "    Number of columns: 3\r\n    Number of rows: 2\r\n"
           "    X scanning direction: Backward\r\n    Z Amplitude: " +
           text.amplitudeZ + "\r\n\r\n[Header end]\r\n" +
           samples(text.stored, ByteOrder::Little, numbers);
}

std::string digitalSurfFile(const DigitalSurfText& text, const std::vector<double>& numbers) {
    constexpr ByteOrder kLittle = ByteOrder::Little;
    const auto word = [](int value) { return static_cast<std::int16_t>(value); };
    std::string bytes(512, '\0');
    put(bytes, 0, text.magic);
    put(bytes, 18, kLittle, word(text.object));
    put(bytes, 20, "steps                         ");
    put(bytes, 86, kLittle, word(text.specialPoints));
    put(bytes, 98, kLittle, word(text.bits));
    put(bytes, 100, kLittle, text.lowest);
    put(bytes, 108, kLittle, 3);
    put(bytes, 112, kLittle, text.rows);
    put(bytes, 120, kLittle, 10.0F);
    put(bytes, 124, kLittle, 10.0F);
    put(bytes, 128, kLittle, 0.5F);
    put(bytes, 164, "Height          ");
    put(bytes, 180, "nm              ");
    put(bytes, 196, "nm");
    put(bytes, 212, text.unit);
    put(bytes, 290, kLittle, word(text.inversion));
    put(bytes, 334, kLittle, word(text.commentSize));
    put(bytes, 336, kLittle, word(text.privateSize));
    put(bytes, 474, kLittle, text.offset);
    return bytes + "notesown" + samples(text.stored, kLittle, numbers);
}

}  // namespace asperity::test
