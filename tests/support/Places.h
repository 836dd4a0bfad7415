#pragma once

#include <filesystem>
#include <string>

/// Where tests find files and programs.
namespace asperity::test {

/// The checkout that the tests were built from.
[[nodiscard]] std::filesystem::path checkout();
/// What ships with the program: checkout()/data.
[[nodiscard]] std::filesystem::path dataFolder();
/// Tables, pictures and recordings that tests compare with: checkout()/tests/reference.
[[nodiscard]] std::filesystem::path referenceFolder();
/// A program of this build, by its name ("asperity").
[[nodiscard]] std::filesystem::path programOfBuild(const std::string& name);

}  // namespace asperity::test
