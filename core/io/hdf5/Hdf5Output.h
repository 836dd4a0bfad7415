#pragma once

#include <cstdint>
#include <filesystem>
#include <hdf5.h>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace asperity {

/// An open object of the HDF5 library, closed with its owner.
class Hdf5Object {
public:
    using Close = herr_t (*)(hid_t);

    /// @param id negative: there is none
    Hdf5Object(hid_t id, Close close) noexcept : id_(id), close_(close) {}
    ~Hdf5Object() {
        if (id_ >= 0) {
            close_(id_);
        }
    }
    Hdf5Object(Hdf5Object&& other) noexcept
        : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
    Hdf5Object& operator=(Hdf5Object&& other) noexcept {
        std::swap(id_, other.id_);
        std::swap(close_, other.close_);
        return *this;
    }
    Hdf5Object(const Hdf5Object&) = delete;
    Hdf5Object& operator=(const Hdf5Object&) = delete;

    [[nodiscard]] bool isOpen() const noexcept { return id_ >= 0; }
    [[nodiscard]] hid_t id() const noexcept { return id_; }

private:
    hid_t id_;
    Close close_;
};

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

/// The type of a text of this many bytes: UTF-8, filled up with zeros.
[[nodiscard]] Hdf5Object textType(std::size_t bytes);
/// Adds an attribute of text. @return false: it could not be written
bool setText(hid_t object, const char* attribute, const std::string& text);
/// Adds one for other programs, which read it as a word and not as bytes.
/// @return false: it could not be written
bool setWord(hid_t object, const char* attribute, const std::string& word);

}  // namespace asperity
