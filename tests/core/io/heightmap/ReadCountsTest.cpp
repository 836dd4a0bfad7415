#include "core/io/heightmap/HeightMapWriter.h"
#include "core/io/heightmap/SampleRows.h"
#include "tests/core/io/heightmap/BumpyMap.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <tiffio.h>
#include <vector>
#include <zlib.h>

// Number of reads of a file: its small parts cost no call each, and packed pixels are unpacked
// once.

namespace asperity::test {

namespace {

/// Bytes in memory that count how they are read, from one thread.
class CountedBytes final : public ByteSource {
public:
    explicit CountedBytes(std::string_view bytes) : ByteSource("counted"), bytes_(bytes, name()) {}

    [[nodiscard]] std::uint64_t size() const override { return bytes_.size(); }
    void read(std::uint64_t offset, std::span<char> bytes) const override {
        ++calls_;
        count_ += bytes.size();
        bytes_.read(offset, bytes);
    }
    void requireUnchanged() const override {}

    [[nodiscard]] std::uint64_t calls() const { return calls_; }
    [[nodiscard]] std::uint64_t count() const { return count_; }  ///< bytes that were read

private:
    MemoryBytes bytes_;
    mutable std::uint64_t calls_ = 0;
    mutable std::uint64_t count_ = 0;
};

/// Reads for the pixels of all images, one image after the other.
struct PixelReads {
    std::vector<HeightMap> maps;
    std::uint64_t calls = 0;
    std::uint64_t count = 0;  ///< of bytes
};

PixelReads readPixels(const CountedBytes& bytes) {
    const HeightMapContents contents = contentsOf(bytes, {});
    const std::uint64_t calls = bytes.calls();
    const std::uint64_t count = bytes.count();
    PixelReads reads;
    for (const StoredChannel& stored : contents.stored) {
        reads.maps.push_back(readHeightMap(stored, bytes));
    }
    reads.calls = bytes.calls() - calls;
    reads.count = bytes.count() - count;
    return reads;
}

std::string chunkWithoutContent() {
    const std::string type = "prVt";
    const auto sum = crc32(0, reinterpret_cast<const Bytef*>(type.data()), 4);
    std::string chunk(4, '\0');
    chunk += type;
    for (const unsigned shift : {24U, 16U, 8U, 0U}) {
        chunk += static_cast<char>((sum >> shift) & 0xffU);
    }
    return chunk;
}

/// @param side of each image [pixels]
std::string exrOfZeros(int channels, int side) {
    Imf::Header header(side, side);
    header.compression() = Imf::ZIP_COMPRESSION;
    const std::vector<float> zeros(static_cast<std::size_t>(side), 0.0F);
    Imf::FrameBuffer frame;
    for (int i = 0; i < channels; ++i) {
        const std::string name = "c" + std::to_string(i);
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
        // Every row is the same.
        frame.insert(name,
                     Imf::Slice(Imf::FLOAT,
                                const_cast<char*>(reinterpret_cast<const char*>(zeros.data())),
                                sizeof(float), 0));
    }
    const ScratchFolder folder;
    {
        Imf::OutputFile output(folder.file("zeros.exr").c_str(), header);
        output.setFrameBuffer(frame);
        output.writePixels(side);
    }
    return contentOf(folder.file("zeros.exr"));
}

std::string deflatedTiff(int pages, const char* mode) {
    const ScratchFolder folder;
    TIFF* const tiff = TIFFOpen(folder.file("pages.tif").c_str(), mode);
    for (int page = 0; page < pages; ++page) {
        TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, 2);
        TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, 1);
        TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 16);
        TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
        TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, 1);
        TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
        TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
        std::uint16_t row[2] = {static_cast<std::uint16_t>(page), 7};
        TIFFWriteScanline(tiff, row, 0, 0);
        TIFFWriteDirectory(tiff);
    }
    TIFFClose(tiff);
    return contentOf(folder.file("pages.tif"));
}

}  // namespace

/// 2 million chunks of a small file took 28 s where a call is slow.
TEST(ReadCounts, ChunksOfAPngCostNoCallEach) {
    constexpr int kChunks = 20'000;
    const ScratchFolder folder;
    writeHeightMap(folder.file("map.png"), bumpyMap(5, 4), {});
    std::string png = contentOf(folder.file("map.png"));
    const std::string chunk = chunkWithoutContent();
    std::string chunks;
    for (int i = 0; i < kChunks; ++i) {
        chunks += chunk;
    }
    png.insert(png.find("IDAT") - 4, chunks);
    const CountedBytes bytes(png);
    EXPECT_EQ(readPixels(bytes).maps.size(), 1U);
    EXPECT_LT(bytes.calls(), kChunks / 50);
}

/// To unpack one channel means to unpack all.
TEST(ReadCounts, AnExrIsUnpackedOnceForAllItsChannels) {
    constexpr int kChannels = 20;
    const std::string exr = exrOfZeros(kChannels, 1024);
    const CountedBytes bytes(exr);
    const PixelReads reads = readPixels(bytes);
    EXPECT_EQ(reads.maps.size(), static_cast<std::size_t>(kChannels));
    EXPECT_LT(reads.count, exr.size() * 3 / 2);
}

/// The TIFF library walks from the first page to the one that it is asked for.
TEST(ReadCounts, APageOfATiffIsFoundWithoutThoseBeforeIt) {
    constexpr int kPages = 200;
    for (const char* const mode : {"wl", "wb", "w8l", "w8b"}) {
        const std::string tiff = deflatedTiff(kPages, mode);
        const CountedBytes bytes(tiff);
        const PixelReads reads = readPixels(bytes);
        ASSERT_EQ(reads.maps.size(), static_cast<std::size_t>(kPages)) << mode;
        for (int page = 0; page < kPages; ++page) {
            const std::vector<double> heights = {static_cast<double>(page), 7.0};
            ASSERT_EQ(reads.maps[static_cast<std::size_t>(page)].heights, heights) << mode;
        }
        EXPECT_LT(reads.calls, 60U * kPages) << mode;
    }
}

}  // namespace asperity::test
