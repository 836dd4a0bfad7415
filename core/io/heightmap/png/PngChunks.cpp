#include "core/io/heightmap/png/PngChunks.h"

#include "core/Error.h"
#include "core/io/ByteReader.h"
#include "core/io/TextValue.h"

namespace asperity {

namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1A\n";
/// A scale is a short text.
constexpr std::uint64_t kPngMaxText = 65536;

class ChunkWalk {
public:
    explicit ChunkWalk(const ByteSource& bytes)
        : bytes_(bytes), reader_(bytes, {kSignature.size(), bytes.size() - kSignature.size()}) {}

    PngHeader read() {
        if (next() != "IHDR") {
            fail("expected the header chunk IHDR");
        }
        takeHeader();
        for (std::string type = next(); type != "IEND"; type = next()) {
            if (type == "IDAT") {
                header_.packedBytes += length_;
            } else if (type == "tEXt") {
                takeText();
            } else if (type == "iTXt") {
                takeInternationalText();
            }
        }
        return std::move(header_);
    }

private:
    static constexpr std::uint64_t kLengthBytes = 4;
    static constexpr std::uint64_t kTypeBytes = 4;
    static constexpr std::uint64_t kSumBytes = 4;
    static constexpr std::uint64_t kFrameBytes = kLengthBytes + kTypeBytes + kSumBytes;

    /// The type of the next chunk, whose content is `length_` bytes long.
    std::string next() {
        (void)reader_.take(rest_, "a chunk");
        if (reader_.remaining() < kFrameBytes) {
            fail("expected a chunk; the file is truncated");
        }
        const std::uint64_t left = reader_.remaining() - kFrameBytes;
        const std::uint64_t place = reader_.place();
        std::string start(kLengthBytes + kTypeBytes, '\0');
        reader_.copy(start, "a chunk");
        length_ = bigEndian<std::uint32_t>(start.data());
        if (length_ > left) {
            failAt(place, "a chunk of " + std::to_string(length_) +
                              " bytes is longer than the file, which is truncated or damaged");
        }
        rest_ = length_ + kSumBytes;
        return start.substr(kLengthBytes);
    }

    void takeHeader() {
        constexpr std::uint64_t kHeaderBytes = 13;
        constexpr std::size_t kPngRows = 4;
        constexpr std::size_t kPngBits = 8;
        constexpr std::size_t kColor = 9;
        if (length_ != kHeaderBytes) {
            fail("expected a header of " + std::to_string(kHeaderBytes) + " bytes");
        }
        const std::string data = content();
        header_.size = checkedImageSize(bigEndian<std::uint32_t>(data.data()),
                                        bigEndian<std::uint32_t>(data.data() + kPngRows),
                                        bytes_.name(), "IHDR");
        header_.bits = static_cast<unsigned char>(data[kPngBits]);
        header_.color = static_cast<unsigned char>(data[kColor]);
    }

    /// Keyword, NUL, text in Latin-1; some write UTF-8.
    void takeText() {
        const std::string data = shortContent();
        const std::size_t end = data.find('\0');
        if (end != std::string::npos) {
            header_.texts.add(data.substr(0, end), toUtf8(data.substr(end + 1)));
        }
    }

    /// Keyword, NUL, whether it is compressed, method, language, NUL, translated keyword, NUL, text
    /// in UTF-8.
    void takeInternationalText() {
        const std::string data = shortContent();
        const std::size_t keyword = data.find('\0');
        const std::size_t language =
            keyword == std::string::npos ? std::string::npos : data.find('\0', keyword + 3);
        const std::size_t translated =
            language == std::string::npos ? std::string::npos : data.find('\0', language + 1);
        if (translated != std::string::npos && data[keyword + 1] == '\0') {
            header_.texts.add(data.substr(0, keyword), toUtf8(data.substr(translated + 1)));
        }
    }

    /// The chunk's content, once.
    std::string content() {
        std::string data(static_cast<std::size_t>(length_), '\0');
        reader_.copy(data, "a chunk");
        rest_ -= length_;
        return data;
    }
    /// The same; nothing of one that is too long for a scale.
    std::string shortContent() { return length_ <= kPngMaxText ? content() : std::string(); }

    [[noreturn]] void fail(const std::string& what) const { failAt(reader_.place(), what); }
    [[noreturn]] void failAt(std::uint64_t place, const std::string& what) const {
        throw InputError(bytes_.name(), "byte " + std::to_string(place), what);
    }

    const ByteSource& bytes_;
    ByteReader reader_;
    std::uint64_t length_ = 0;  ///< of the chunk's content
    std::uint64_t rest_ = 0;    ///< bytes up to the next chunk
    PngHeader header_;
};

}  // namespace

bool isPng(const ByteSource& bytes) { return bytes.startsWith(kSignature); }

PngHeader readPngChunks(const ByteSource& bytes) {
    if (!isPng(bytes)) {
        throw InputError(bytes.name(), "", "this is no PNG");
    }
    return ChunkWalk(bytes).read();
}

}  // namespace asperity
