#include "app/program/ProgramParts.h"

#include "core/Version.h"

namespace asperity {

/// Made by the build: cmake/SourceFacts.cmake.
extern const char* const kSourceCommit;  // empty: unknown
extern const char* const kSourceLicense;

const std::vector<LibraryPart>& libraryParts() {
    // Versions are those that CMake found: app/CMakeLists.txt.
    static const std::vector<LibraryPart> kParts{
        {"VTK", ASPERITY_VTK, "BSD-3-Clause", "libvtk9.1"},
        {"Qt", ASPERITY_QT, "LGPL-3.0", "libqt5core5a"},
        {"Qwt", ASPERITY_QWT, "Qwt License 1.0 (LGPL-2.1 with exceptions)", "libqwt-qt5-6"},
        {"Eigen", ASPERITY_EIGEN, "MPL-2.0", "libeigen3-dev"},
        {"Boost", ASPERITY_BOOST, "BSL-1.0", "libboost-dev"},
        {"OpenEXR", ASPERITY_OPENEXR, "BSD-3-Clause", "libopenexr-3-1-30"},
        {"hidapi", ASPERITY_HIDAPI, "BSD-3-Clause", "libhidapi-hidraw0"},
        {"libtiff", ASPERITY_TIFF, "libtiff", "libtiff6"},
        {"libzip", ASPERITY_LIBZIP, "BSD-3-Clause", "libzip4"},
        {"pugixml", ASPERITY_PUGIXML, "MIT", "libpugixml1v5"},
        {"libpng", ASPERITY_PNG, "libpng-2.0", "libpng16-16"},
        {"OpenSSL", ASPERITY_OPENSSL, "Apache-2.0", "libssl3"},
        {"toml++", ASPERITY_TOMLPLUSPLUS, "MIT", "libtomlplusplus-dev"},
        {"nlohmann-json", ASPERITY_JSON, "MIT", "nlohmann-json3-dev"},
        {"CLI11", ASPERITY_CLI11, "BSD-3-Clause", "libcli11-dev"}};
    return kParts;
}

std::string compilerName() {
#ifdef __clang__
    return std::string("clang++ ") + __clang_version__;
#else
    return std::string("g++ ") + __VERSION__;
#endif
}

std::string versionWithCommit() {
    const std::string commit = kSourceCommit;
    return commit.empty() ? kVersion : std::string(kVersion) + " (" + commit + ")";
}

std::string licenseText() { return kSourceLicense; }

}  // namespace asperity
