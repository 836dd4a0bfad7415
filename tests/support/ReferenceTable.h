#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace asperity::test {

/// A CSV table with a header line and `#` comments; cells are looked up by column name.
class ReferenceTable {
public:
    /// Reads the file; a missing file or a ragged row ends the test program with a message.
    explicit ReferenceTable(const std::filesystem::path& path);

    [[nodiscard]] std::size_t rows() const { return cells_.size(); }
    [[nodiscard]] const std::string& text(std::size_t row, const std::string& column) const;
    /// The cell as a double, correctly rounded; "nan" and "inf" are accepted.
    [[nodiscard]] double number(std::size_t row, const std::string& column) const;

private:
    std::map<std::string, std::size_t> columns_;
    std::vector<std::vector<std::string>> cells_;
};

/// A physics table that the repository carries, by its file name ("T01_md_curve.csv").
[[nodiscard]] ReferenceTable referenceTable(const std::string& name);

/// Path below the real AFM data that lies beside the repository, e.g. "afm/MANIFEST.csv".
[[nodiscard]] std::filesystem::path sharedData(const std::string& relative);

/// Whether that data is there. With CI=true a missing folder fails the calling test.
[[nodiscard]] bool haveSharedData();

}  // namespace asperity::test

/// Skips the calling test, saying why, where the real AFM data are not beside the repository.
#define ASPERITY_NEEDS_SHARED_DATA()                                                               \
    if (!asperity::test::haveSharedData())                                                         \
    GTEST_SKIP() << "../shared/data is not beside this checkout"
