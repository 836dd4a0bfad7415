#pragma once

#include "core/PrintableText.h"

#include <stdexcept>
#include <string>

namespace asperity {

/// Something failed while loading, configuring or writing. The message is one sentence that a user
/// can act on; the program prints it and exits with 1. What it quotes from outside is made
/// printable.
class Error : public std::runtime_error {
public:
    explicit Error(const std::string& message) : std::runtime_error(printable(message)) {}
};

/// A file or folder that cannot be read, or cannot be made where it is asked for. The program
/// prints it and exits with 3.
class FileError : public Error {
public:
    /// @param file path as the user gave it
    /// @param what is wrong with it
    FileError(const std::string& file, const std::string& what) : Error(file + ": " + what) {}
};

/// An input that cannot be read: names the file, the location in it and what was expected there.
class InputError : public FileError {
public:
    /// @param file  path as the user gave it
    /// @param location "line 12", "[sample] youngs_modulus_pa", "byte 4096"; may be empty
    /// @param what  what was found and what was expected instead
    InputError(const std::string& file, const std::string& location, const std::string& what)
        : FileError(file, (location.empty() ? "" : location + ": ") + what) {}
};

}  // namespace asperity
