#pragma once

#include <string>
#include <vector>

namespace asperity {

/// A library that the program is built with.
struct LibraryPart {
    std::string name;
    std::string version;  ///< at the build
    std::string license;  ///< its name
    std::string package;  ///< Debian's that holds the text, in /usr/share/doc/PACKAGE/copyright
};

/// In the order of their weight.
[[nodiscard]] const std::vector<LibraryPart>& libraryParts();

/// "g++ 12.2.0"
[[nodiscard]] std::string compilerName();

/// The version, with the commit where the build knows it: "0.1.0 (1a2b3c4d5e6f)".
[[nodiscard]] std::string versionWithCommit();

/// The text of Asperity's license.
[[nodiscard]] std::string licenseText();

}  // namespace asperity
