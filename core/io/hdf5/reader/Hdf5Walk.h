#pragma once

#include "core/io/hdf5/Hdf5Object.h"
#include "core/io/hdf5/reader/ContentWriter.h"

#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace asperity {

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
    std::set<haddr_t> groups_;  ///< that were gone through: a group may be in itself
};

}  // namespace asperity
