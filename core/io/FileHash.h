#pragma once

#include "core/Progress.h"
#include "core/io/ByteSource.h"

#include <memory>
#include <openssl/types.h>
#include <span>
#include <string>

namespace asperity {

/// SHA-256 of a content that comes piece by piece.
class Sha256 {
public:
    Sha256();

    void add(std::span<const char> bytes);
    /// 64 lower-case hexadecimal digits; nothing can be added after it.
    [[nodiscard]] std::string digits();

private:
    std::unique_ptr<EVP_MD_CTX, void (*)(EVP_MD_CTX*)> context_;
};

/// SHA-256 of a content. @throw InputError when it cannot be read or changes meanwhile; Canceled
[[nodiscard]] std::string sha256Of(const ByteSource& source, Progress* progress = nullptr);

/// MD5 of a content, 32 lower-case hexadecimal digits: file formats carry it against damage, it
/// proves no origin. Empty where the OpenSSL library is set up to refuse it.
/// @throw InputError as sha256Of()
[[nodiscard]] std::string md5Of(const ByteSource& source);

}  // namespace asperity
