#pragma once

#include "core/io/hdf5/Hdf5Object.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace asperity {

/// A file in the HDF5 format that is written.
class Hdf5Output {
public:
    /// @param path the file may be there, and is emptied @throw Error
    explicit Hdf5Output(const std::filesystem::path& path);

    [[nodiscard]] hid_t id() const noexcept { return file_.id(); }
    [[nodiscard]] const std::string& name() const noexcept { return name_; }
    /// An attribute of the whole file. @throw Error
    void setAttribute(const char* attribute, const std::string& text);
    /// A list of numbers. @throw Error
    void addList(const char* list, std::span<const std::uint32_t> numbers);
    /// Hands everything to the system, and seals it. @throw Error where not all could be written
    void close();

private:
    std::string name_;
    Hdf5Object file_;
};

/// The type of a text of so many bytes: UTF-8, filled up with zeros.
[[nodiscard]] Hdf5Object textType(std::size_t bytes);
/// Adds an attribute of text. @return false: it could not be written
bool setText(hid_t object, const char* attribute, const std::string& text);
/// Adds one for other programs, which read it as a word and not as bytes.
/// @return false: it could not be written
bool setWord(hid_t object, const char* attribute, const std::string& word);

}  // namespace asperity
