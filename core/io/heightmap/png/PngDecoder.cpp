#include "core/io/heightmap/png/PngDecoder.h"

#include "core/Error.h"
#include "core/io/ByteReader.h"

#include <csetjmp>
#include <exception>
#include <png.h>
#include <vector>

namespace asperity {

namespace {

/// What the PNG library reads from, and what went wrong on the way.
struct PngSource {
    ByteReader reader;
    std::string message;         ///< the library's own
    std::exception_ptr failure;  ///< of reading the bytes

    /// Keeps an exception: none may pass through the library, which is written in C.
    bool read(png_bytep target, std::size_t count) {
        try {
            reader.copy({reinterpret_cast<char*>(target), count}, "a chunk");
            return true;
        } catch (...) {
            failure = std::current_exception();
            return false;
        }
    }
};

void readBytes(png_structp png, png_bytep target, std::size_t count) {
    if (!static_cast<PngSource*>(png_get_io_ptr(png))->read(target, count)) {
        png_error(png, "the file cannot be read");
    }
}

/// The library comes back to where its jump buffer was set.
[[noreturn]] void jumpOut(png_structp png, png_const_charp message) {
    static_cast<PngSource*>(png_get_error_ptr(png))->message = message;
    png_longjmp(png, 1);
}

void ignoreReadWarning(png_structp /*png*/, png_const_charp /*message*/) {}

/// The library's two structures of a file being read.
class PngInput {
public:
    explicit PngInput(PngSource& source)
        : png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, &source, jumpOut, ignoreReadWarning))
        , info_(png_ == nullptr ? nullptr : png_create_info_struct(png_)) {
        if (info_ == nullptr) {
            png_destroy_read_struct(&png_, nullptr, nullptr);
            throw Error("the PNG library cannot start");
        }
        png_set_read_fn(png_, &source, readBytes);
        png_set_crc_action(png_, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
        // All but the pixels is checked and left out.
        png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
    }
    ~PngInput() { png_destroy_read_struct(&png_, &info_, nullptr); }
    PngInput(const PngInput&) = delete;
    PngInput& operator=(const PngInput&) = delete;

    /// The only function into which the library jumps back: nothing in it has a destructor.
    /// @return whether all was read
    bool readImage(png_bytepp rows, png_size_t rowBytes) {
        if (setjmp(png_jmpbuf(png_)) !=
            0) {  // NOLINT(cert-err52-cpp): the library has no other way
            return false;
        }
        png_read_info(png_, info_);
        png_set_strip_alpha(png_);
        (void)png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
        if (png_get_rowbytes(png_, info_) != rowBytes) {
            png_error(png_, "rows of another length than the header says");
        }
        png_read_image(png_, rows);
        png_read_end(png_, nullptr);
        return true;
    }

private:
    png_structp png_;
    png_infop info_;
};

}  // namespace

std::string decodePng(const ByteSource& bytes, const PngHeader& header) {
    constexpr std::size_t kSampleBytes = 2;
    const std::size_t rowBytes = static_cast<std::size_t>(header.size.columns) * kSampleBytes;
    std::string samples(static_cast<std::size_t>(header.size.rows) * rowBytes, '\0');
    std::vector<png_bytep> rows(static_cast<std::size_t>(header.size.rows));
    for (std::size_t row = 0; row < rows.size(); ++row) {
        rows[row] = reinterpret_cast<png_bytep>(samples.data() + row * rowBytes);
    }
    PngSource source{.reader = ByteReader(bytes)};
    PngInput file(source);
    if (!file.readImage(rows.data(), rowBytes)) {
        if (source.failure) {
            std::rethrow_exception(source.failure);
        }
        throw InputError(bytes.name(), "byte " + std::to_string(source.reader.place()),
                         "the PNG library cannot decode it: " + source.message);
    }
    return samples;
}

}  // namespace asperity
