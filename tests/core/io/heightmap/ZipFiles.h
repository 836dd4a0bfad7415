#pragma once

#include <string>
#include <vector>

namespace asperity::test {

/// A file to be put into a zip archive.
struct ZippedFile {
    std::string name;
    std::string content;
    bool compressed = true;
};

/// The bytes of a zip archive with these files, made by libzip.
[[nodiscard]] std::string zipFile(const std::vector<ZippedFile>& files);

}  // namespace asperity::test
