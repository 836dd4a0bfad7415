#pragma once

#include "core/Progress.h"
#include "core/io/ByteReader.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/ScanImage.h"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <utility>

namespace asperity {

enum class SampleType : std::uint8_t {
    Int8,
    UInt8,
    Int16,
    UInt16,
    Int32,
    UInt32,
    Int64,
    UInt64,
    Float32,
    Float64
};

[[nodiscard]] std::size_t sizeOf(SampleType type);  ///< [bytes]

enum class ByteOrder : std::uint8_t { Little, Big };

/// Converts stored samples to numbers. @param stored sizeOf(type) bytes for each of them
void convertSamples(SampleType type, ByteOrder order, const char* stored,
                    std::span<double> numbers);

/// Layout of the samples of an image in a file: row after row without gaps.
struct SampleLayout {
    ImageSize size;
    SampleType type = SampleType::Float32;
    ByteOrder order = ByteOrder::Little;
    std::uint64_t offset = 0;  ///< of the first sample [bytes]
    bool bottomFirst = false;  ///< the first stored row is the lowest of the image
    bool rightFirst = false;   ///< the first stored sample of a row is its rightmost

    [[nodiscard]] std::uint64_t rowBytes() const {
        return static_cast<std::uint64_t>(size.columns) * sizeOf(type);
    }
    [[nodiscard]] std::uint64_t bytes() const {
        return static_cast<std::uint64_t>(size.rows) * rowBytes();
    }
};

/// @param owner for the message: what the samples belong to
/// @throw InputError when the file does not hold all of them
void requireSamples(const ByteSource& bytes, const SampleLayout& layout, const std::string& owner);

using ReadRow = decltype(StoredChannel::readRow);

/// Reads rows of samples as they lie. @param bytes must outlive the result
[[nodiscard]] ReadRow rowsOf(const ByteSource& bytes, const SampleLayout& layout);

/// Keeps the samples that were decoded last, for the next image that is decoded with them.
struct LatestSamples {
    std::mutex mutex;
    std::shared_ptr<const ByteSource> bytes;
};

/// Samples of one or several images that are decoded together when they are needed, once for all
/// threads that read them together.
class DecodedSamples {
public:
    /// @param latest keeps them until others are decoded; null: they stay while somebody reads them
    explicit DecodedSamples(std::function<std::string()> decode,
                            std::shared_ptr<LatestSamples> latest = nullptr)
        : decode_(std::move(decode)), latest_(std::move(latest)) {}

    /// Decodes them if nobody has them. Any threads. @throw whatever decoding throws
    [[nodiscard]] std::shared_ptr<const ByteSource> bytes();

private:
    void keep(std::shared_ptr<const ByteSource> samples);

    std::function<std::string()> decode_;
    std::shared_ptr<LatestSamples> latest_;
    std::mutex mutex_;
    std::weak_ptr<const ByteSource> samples_;
};

/// Reads rows of samples that have to be decoded first: all at once, when the first row is asked
/// for. They stay as long as a room that a row was read with.
/// @param decode gives the samples of the layout, which begins at its byte 0 or later; it is called
///        again where it threw, or when no room has its samples any more
/// @param file for messages
/// @throw InputError when they and the heights need more memory than an input may
[[nodiscard]] ReadRow rowsOfDecoded(std::function<std::string()> decode, const SampleLayout& layout,
                                    const std::string& file);
/// The same of samples that several images may share.
[[nodiscard]] ReadRow rowsOfDecoded(std::shared_ptr<DecodedSamples> samples,
                                    const SampleLayout& layout, const std::string& file);

/// Reads rows of numbers that are in memory, one row after the other from the top.
[[nodiscard]] ReadRow rowsOfNumbers(std::deque<double> numbers, int columns);

/// Returns whether a mask's value says that its pixel holds no data.
[[nodiscard]] constexpr bool isMarked(double value) { return value > 0.0; }
/// The same rows without the numbers that a mask of the same size marks.
[[nodiscard]] ReadRow masked(ReadRow rows, int columns, ReadRow mask);

/// The same rows with each number replaced, as of a marker for pixels without data.
/// @param replace (double) -> double
template <class Replace>
[[nodiscard]] ReadRow replaced(ReadRow rows, int columns, Replace replace) {
    return [rows = std::move(rows), columns, replace = std::move(replace)](int row, RowRoom& room,
                                                                           double* numbers) {
        rows(row, room, numbers);
        std::transform(numbers, numbers + columns, numbers, replace);
    };
}

/// The same rows, which keep alive what they are read from.
[[nodiscard]] ReadRow keeping(ReadRow rows, std::shared_ptr<const ByteSource> bytes);

/// Finds whether a channel is a mask, and notes it there. Values of a mask have no unit; they are
/// shares from 0 to 1, at least half of them 0 or 1, or all of them 0 or the highest number of 8 or
/// 16 bits. Of heights without unit, few are exactly the lowest or the highest one.
void noteMask(StoredChannel& stored);

/// All rows of an image.
/// @param bytes where the image lies
/// @throw InputError as ChannelRows; Canceled
[[nodiscard]] HeightMap readHeightMap(const StoredChannel& stored, const ByteSource& bytes,
                                      Progress* progress = nullptr);

/// All rows of an image in single precision, about its first height.
/// @throw as readHeightMap()
[[nodiscard]] ScanMap readScanMap(const StoredChannel& stored, const ByteSource& bytes,
                                  Progress* progress = nullptr);

}  // namespace asperity
