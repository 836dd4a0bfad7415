#include "core/io/heightmap/SampleRows.h"

#include "core/Error.h"
#include "core/io/ByteReader.h"
#include "core/io/MemoryLimit.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace asperity {

namespace {

template <typename Number>
void convert(const char* stored, ByteOrder order, std::span<double> numbers) {
    for (double& number : numbers) {
        number = static_cast<double>(order == ByteOrder::Little ? littleEndian<Number>(stored)
                                                                : bigEndian<Number>(stored));
        stored += sizeof(Number);
    }
}

void convert(SampleType type, ByteOrder order, const char* stored, std::span<double> numbers) {
    switch (type) {
    case SampleType::Int8:
        return convert<std::int8_t>(stored, order, numbers);
    case SampleType::UInt8:
        return convert<std::uint8_t>(stored, order, numbers);
    case SampleType::Int16:
        return convert<std::int16_t>(stored, order, numbers);
    case SampleType::UInt16:
        return convert<std::uint16_t>(stored, order, numbers);
    case SampleType::Int32:
        return convert<std::int32_t>(stored, order, numbers);
    case SampleType::UInt32:
        return convert<std::uint32_t>(stored, order, numbers);
    case SampleType::Int64:
        return convert<std::int64_t>(stored, order, numbers);
    case SampleType::UInt64:
        return convert<std::uint64_t>(stored, order, numbers);
    case SampleType::Float32:
        return convert<float>(stored, order, numbers);
    case SampleType::Float64:
        return convert<double>(stored, order, numbers);
    }
}

void readSamples(const ByteSource& bytes, const SampleLayout& layout, int row, RowRoom& room,
                 double* numbers) {
    const int stored = layout.bottomFirst ? layout.size.rows - 1 - row : row;
    room.bytes.resize(layout.rowBytes());
    bytes.read(layout.place + static_cast<std::uint64_t>(stored) * layout.rowBytes(), room.bytes);
    const std::span<double> whole(numbers, static_cast<std::size_t>(layout.size.columns));
    convert(layout.type, layout.order, room.bytes.data(), whole);
    if (layout.rightFirst) {
        std::ranges::reverse(whole);
    }
}

}  // namespace

std::size_t sizeOf(SampleType type) {
    switch (type) {
    case SampleType::Int8:
    case SampleType::UInt8:
        return 1;
    case SampleType::Int16:
    case SampleType::UInt16:
        return 2;
    case SampleType::Int32:
    case SampleType::UInt32:
    case SampleType::Float32:
        return 4;
    case SampleType::Int64:
    case SampleType::UInt64:
    case SampleType::Float64:
        return 8;
    }
    return 0;
}

void requireSamples(const ByteSource& bytes, const SampleLayout& layout, const std::string& place) {
    if (layout.place > bytes.size() || layout.bytes() > bytes.size() - layout.place) {
        throw InputError(bytes.name(), place,
                         "its data end at byte " + std::to_string(layout.place + layout.bytes()) +
                             ", but the file has " + std::to_string(bytes.size()) +
                             "; it is truncated");
    }
}

ReadRow rowsOf(const ByteSource& bytes, const SampleLayout& layout) {
    return [&bytes, layout](int row, RowRoom& room, double* numbers) {
        readSamples(bytes, layout, row, room, numbers);
    };
}

std::shared_ptr<const ByteSource> DecodedSamples::bytes() {
    const std::lock_guard lock(mutex_);
    std::shared_ptr<const ByteSource> samples = samples_.lock();
    if (!samples) {
        keep(nullptr);  // they need no memory while others are decoded
        samples = std::make_shared<OwnedBytes>(decode_(), "decoded samples");
        samples_ = samples;
        keep(samples);
    }
    return samples;
}

void DecodedSamples::keep(std::shared_ptr<const ByteSource> samples) {
    if (latest_) {
        const std::lock_guard lock(latest_->mutex);
        latest_->bytes = std::move(samples);
    }
}

ReadRow rowsOfDecoded(std::function<std::string()> decode, const SampleLayout& layout,
                      const std::string& file) {
    return rowsOfDecoded(std::make_shared<DecodedSamples>(std::move(decode)), layout, file);
}

ReadRow rowsOfDecoded(std::shared_ptr<DecodedSamples> samples, const SampleLayout& layout,
                      const std::string& file) {
    requireMemory(layout.place + layout.bytes() + layout.size.pixels() * sizeof(double), file, "");
    return [samples = std::move(samples), layout](int row, RowRoom& room, double* numbers) {
        std::shared_ptr<const ByteSource>& bytes = room.decoded[samples];
        if (!bytes) {
            bytes = samples->bytes();
        }
        readSamples(*bytes, layout, row, room, numbers);
    };
}

ReadRow rowsOfNumbers(std::deque<double> numbers, int columns) {
    return [kept = std::make_shared<const std::deque<double>>(std::move(numbers)),
            columns](int row, RowRoom&, double* target) {
        std::copy_n(kept->begin() + static_cast<std::ptrdiff_t>(row) * columns, columns, target);
    };
}

ReadRow masked(ReadRow rows, int columns, ReadRow mask) {
    return [rows = std::move(rows), columns, mask = std::move(mask)](int row, RowRoom& room,
                                                                     double* numbers) {
        rows(row, room, numbers);
        std::vector<double> marks(static_cast<std::size_t>(columns));
        mask(row, room, marks.data());
        for (std::size_t i = 0; i < marks.size(); ++i) {
            if (isMarked(marks[i])) {
                numbers[i] = std::numeric_limits<double>::quiet_NaN();
            }
        }
    };
}

ReadRow keeping(ReadRow rows, std::shared_ptr<const ByteSource> bytes) {
    return [rows = std::move(rows), bytes = std::move(bytes)](
               int row, RowRoom& room, double* numbers) { rows(row, room, numbers); };
}

}  // namespace asperity
