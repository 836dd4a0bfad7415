#include "app/program/ToldError.h"

#include "core/Error.h"
#include "core/PrintableText.h"

#include <iostream>
#include <new>

namespace asperity {

int tellError(const std::exception_ptr& error) {
    try {
        std::rethrow_exception(error);
    } catch (const FileError& file) {
        std::cerr << "asperity: " << file.what() << '\n';
        return kFileError;
    } catch (const std::bad_alloc&) {
        std::cerr << "asperity: out of memory\n";
    } catch (const std::exception& other) {
        std::cerr << "asperity: " << printable(other.what()) << '\n';
    }
    return kFailed;
}

}  // namespace asperity
