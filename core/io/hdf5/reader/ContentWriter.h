#pragma once

#include "core/io/hdf5/Hdf5Type.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <vector>

namespace asperity {

/// Of values: what they are and how many.
struct ValueShape {
    Hdf5Type type = Hdf5Type::Other;
    std::uint32_t bytes = 0;  ///< of a value
    std::vector<std::uint64_t> dimensions;

    /// @throw std::length_error where nothing is as large
    [[nodiscard]] std::uint64_t count() const;
};

/// Writes what Hdf5Content reads. Each function throws std::runtime_error.
class ContentWriter {
public:
    explicit ContentWriter(const std::filesystem::path& path);

    void addGroup(const std::string& path);
    /// @param hasValues all of them follow, by add()
    void addDataset(const std::string& path, const ValueShape& shape, bool hasValues);
    void addAttribute(const std::string& path, const ValueShape& shape, bool hasValues);
    void add(std::span<const char> values);
    void close();

private:
    void requireWritten() const;  ///< with the system's reason
    template <class Number>
    void put(Number number);
    void begin(char record, const std::string& path);
    void addShape(const ValueShape& shape, bool hasValues);

    std::ofstream stream_;
    std::uint64_t items_ = 0;
    std::uint64_t pathBytes_ = 0;
};

}  // namespace asperity
