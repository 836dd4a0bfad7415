#include "app/program/ToldError.h"

#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/Utf8.h"

#include <iostream>
#include <new>

namespace asperity {

std::string messageOf(const std::exception& error) {
    constexpr std::size_t kMaxBytes = 1000;
    return shortened(printable(error.what()), kMaxBytes);
}

int tellError(const std::exception_ptr& error) {
    try {
        std::rethrow_exception(error);
    } catch (const FileError& file) {
        std::cerr << "asperity: " << messageOf(file) << '\n';
        return kFileError;
    } catch (const std::bad_alloc&) {
        std::cerr << "asperity: out of memory\n";
    } catch (const std::exception& other) {
        std::cerr << "asperity: " << messageOf(other) << '\n';
    }
    return kFailed;
}

}  // namespace asperity
