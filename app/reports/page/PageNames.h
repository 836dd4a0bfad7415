#pragma once

#include <filesystem>
#include <set>
#include <string>

namespace asperity {

/// Gives pages names of files, without suffix, that differ on every file system, also where it
/// takes large and small letters as the same.
class PageNames {
public:
    /// @param reserved a name that no page gets
    explicit PageNames(const std::string& reserved) { taken_.insert(reserved); }

    /// A name like that of the folder: "run", then "run_2". Letters, digits, '.', '-' and '_' stay.
    [[nodiscard]] std::string nameFor(const std::filesystem::path& folder);

private:
    std::set<std::string> taken_;  ///< in small letters
};

}  // namespace asperity
