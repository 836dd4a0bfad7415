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

/// A file in the HDF5 format that is read.
class Hdf5Input {
public:
    /// @throw InputError when it cannot be read, or is no file of an Hdf5Output, or not as that
    ///        left it
    explicit Hdf5Input(const std::filesystem::path& path);

    [[nodiscard]] hid_t id() const noexcept { return file_.id(); }
    [[nodiscard]] const std::string& name() const noexcept { return name_; }
    /// Bytes of all cells of a table that a file of this size may hold: it may promise more.
    [[nodiscard]] std::uint64_t mostBytes() const noexcept { return mostBytes_; }
    /// Whether it holds a table or a list of this name.
    [[nodiscard]] bool has(const std::string& what) const;
    /// @return empty: it has no such attribute of text
    [[nodiscard]] std::string attribute(const char* attribute) const;
    /// @throw InputError
    [[nodiscard]] std::vector<std::uint32_t> list(const char* list) const;
    /// @throw InputError naming a place in the file, always
    [[noreturn]] void fail(const std::string& place, const std::string& what) const;

private:
    std::string name_;
    std::uint64_t mostBytes_;
    Hdf5Object file_;
};

/// The type of a text of so many bytes: UTF-8, filled up with zeros.
[[nodiscard]] Hdf5Object textType(std::size_t bytes);
/// Adds an attribute of text that is read here. @return false: it could not be written
bool setText(hid_t object, const char* attribute, const std::string& text);
/// Adds one for other programs, which read it as a word and not as bytes. It is never read here:
/// HDF5 1.10 does not return from a damaged one. @return false: it could not be written
bool setWord(hid_t object, const char* attribute, const std::string& word);
/// @return empty: it has no such attribute
[[nodiscard]] std::string textOf(hid_t object, const char* attribute);

}  // namespace asperity
