#pragma once

#include "core/io/hdf5/Hdf5Content.h"
#include "core/io/hdf5/Hdf5Output.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace asperity {

/// Type and number of values.
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

/// Hands over what an HDF5 file holds.
class Hdf5Walk {
public:
    /// @param most  bytes of values that the file can hold
    /// @param paths that are wanted, as of readHdf5()
    Hdf5Walk(ContentWriter& writer, std::uint64_t most, std::vector<std::string> paths)
        : writer_(writer), most_(most), paths_(std::move(paths)) {}

    /// @throw std::runtime_error
    void add(hid_t file);

private:
    void addGroup(hid_t group, const std::string& path);
    void addLink(hid_t group, const std::string& name, const std::string& path);
    void addAttributes(hid_t object, const std::string& path);
    [[nodiscard]] bool isWanted(const std::string& path) const;
    [[nodiscard]] bool leadsToWanted(const std::string& path) const;

    ContentWriter& writer_;
    std::uint64_t most_;
    std::vector<std::string> paths_;
    std::set<haddr_t> groups_;  ///< that were visited: a group may be in itself
};

/// Shape and storage of the values of a dataset or an attribute, and the type to read them as.
struct Hdf5Values {
    ValueShape shape;
    Hdf5Object memory{-1, H5Tclose};  ///< type that they are read as
    bool hasPointers = false;         ///< texts of any length, which the library makes room for
};

/// Hands over a dataset. Values in other files, of compound types and the like stay away.
/// @param most     bytes of values that the file can hold
/// @param isWanted false: values only where they are few
/// @throw std::runtime_error with the path
void addDataset(ContentWriter& writer, const std::string& path, hid_t dataset, std::uint64_t most,
                bool isWanted);
/// Hands over an attribute. @throw as addDataset()
void addAttribute(ContentWriter& writer, const std::string& path, hid_t attribute);

}  // namespace asperity
