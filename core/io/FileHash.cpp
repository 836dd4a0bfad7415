#include "core/io/FileHash.h"

#include "core/Error.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <memory>
#include <openssl/evp.h>
#include <system_error>
#include <vector>

namespace asperity {

namespace {

constexpr std::size_t kBlockBytes = 65536;

struct FreeContext {
    void operator()(EVP_MD_CTX* context) const { EVP_MD_CTX_free(context); }
};

void require(int succeeded) {
    if (succeeded != 1) {
        throw Error("SHA-256 cannot be computed by the OpenSSL library");
    }
}

std::string hexadecimal(const unsigned char* bytes, std::size_t count) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text;
    for (std::size_t i = 0; i < count; ++i) {
        text += kDigits[bytes[i] >> 4U];
        text += kDigits[bytes[i] & 0xFU];
    }
    return text;
}

}  // namespace

std::string sha256OfFile(const std::filesystem::path& path, Progress* progress) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream || std::filesystem::is_directory(path)) {
        throw InputError(path.string(), "", "the file cannot be opened for reading");
    }
    const std::unique_ptr<EVP_MD_CTX, FreeContext> context(EVP_MD_CTX_new());
    require(EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr));
    std::vector<char> block(kBlockBytes);
    std::error_code unknown;  // of a pipe, say: then the size reads as huge
    const std::uintmax_t blocks = std::filesystem::file_size(path, unknown) / kBlockBytes + 1;
    const std::uintmax_t blocksPerStep = blocks / 32 + 1;
    for (std::uintmax_t i = 0; stream; ++i) {
        if (i % blocksPerStep == 0) {
            reportTo(progress, std::min(1.0, static_cast<double>(i) / static_cast<double>(blocks)));
        }
        stream.read(block.data(), static_cast<std::streamsize>(block.size()));
        require(EVP_DigestUpdate(context.get(), block.data(),
                                 static_cast<std::size_t>(stream.gcount())));
    }
    if (stream.bad()) {
        throw InputError(path.string(), "", "the file cannot be read to its end");
    }
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned length = 0;
    require(EVP_DigestFinal_ex(context.get(), digest.data(), &length));
    return hexadecimal(digest.data(), length);
}

}  // namespace asperity
