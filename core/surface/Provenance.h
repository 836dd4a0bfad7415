#pragma once

#include <string>

namespace asperity {

/// Something that the numbers of an image depend on, and where it comes from: "scale", "1.31e-10 m
/// per count", "image list 2, @2:Z scale".
struct Provenance {
    std::string what;
    std::string value;
    std::string source;  ///< position in the file, or what decided where the file does not say
};

}  // namespace asperity
