#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace asperity::test {

/// A written image as an independent library reads it, top row first.
struct PlainImage {
    int columns = 0;
    int rows = 0;
    std::vector<double> values;               ///< raw: float heights or 16-bit grays
    std::map<std::string, std::string> text;  ///< text keys, attributes or tags
};

[[nodiscard]] PlainImage readExr(const std::filesystem::path& path);
[[nodiscard]] PlainImage readTiff(const std::filesystem::path& path);
[[nodiscard]] PlainImage readPng(const std::filesystem::path& path);

}  // namespace asperity::test
