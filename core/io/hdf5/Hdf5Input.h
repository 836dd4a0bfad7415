#pragma once

#include "core/io/hdf5/Hdf5Program.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace asperity {

/// A file that an Hdf5Output left, as far as it is wanted.
class Hdf5Input {
public:
    /// @param wanted tables and lists; the others are as if they were not there
    /// @throw InputError when it cannot be read, or is no file of an Hdf5Output, or not as that
    ///        left it; Error
    Hdf5Input(const std::filesystem::path& path, const std::vector<std::string>& wanted);

    [[nodiscard]] const Hdf5Content& content() const noexcept { return content_; }
    [[nodiscard]] const std::string& name() const noexcept { return content_.file(); }
    /// Whether it holds a table or a list of this name.
    [[nodiscard]] bool has(const std::string& what) const;
    /// @return empty: it has no such attribute of text
    [[nodiscard]] std::string attribute(const std::string& attribute) const;
    /// @throw InputError
    [[nodiscard]] std::vector<std::uint32_t> list(const std::string& list) const;
    /// @throw InputError naming a place in the file, always
    [[noreturn]] void fail(const std::string& place, const std::string& what) const {
        content_.fail(place, what);
    }

private:
    Hdf5Content content_;
};

}  // namespace asperity
