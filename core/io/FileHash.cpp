#include "core/io/FileHash.h"

#include "core/Error.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <openssl/evp.h>
#include <vector>

namespace asperity {

namespace {

constexpr std::uint64_t kBlockBytes = 65536;

using Context = std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)>;

Context newContext() { return {EVP_MD_CTX_new(), EVP_MD_CTX_free}; }

void require(int succeeded) {
    if (succeeded != 1) {
        throw Error("a hash cannot be computed by the OpenSSL library");
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

std::string digitsOf(EVP_MD_CTX& context) {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned length = 0;
    require(EVP_DigestFinal_ex(&context, digest.data(), &length));
    return hexadecimal(digest.data(), length);
}

std::string digestOf(const ByteSource& source, EVP_MD_CTX& context, Progress* progress) {
    std::vector<char> block(kBlockBytes);
    const std::uint64_t size = source.size();
    const std::uint64_t step = (size / kBlockBytes / 32 + 1) * kBlockBytes;
    for (std::uint64_t place = 0; place < size; place += block.size()) {
        if (place % step == 0) {
            reportTo(progress, static_cast<double>(place) / static_cast<double>(size));
        }
        block.resize(static_cast<std::size_t>(std::min(kBlockBytes, size - place)));
        source.read(place, block);
        require(EVP_DigestUpdate(&context, block.data(), block.size()));
    }
    source.requireUnchanged();
    return digitsOf(context);
}

}  // namespace

Sha256::Sha256() : context_(newContext()) {
    require(EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr));
}

void Sha256::add(std::span<const char> bytes) {
    require(EVP_DigestUpdate(context_.get(), bytes.data(), bytes.size()));
}

std::string Sha256::digits() { return digitsOf(*context_); }

std::string sha256Of(const ByteSource& source, Progress* progress) {
    const Context context = newContext();
    require(EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr));
    return digestOf(source, *context, progress);
}

std::string md5Of(const ByteSource& source) {
    const Context context = newContext();
    if (EVP_DigestInit_ex(context.get(), EVP_md5(), nullptr) != 1) {
        return {};
    }
    return digestOf(source, *context, nullptr);
}

}  // namespace asperity
