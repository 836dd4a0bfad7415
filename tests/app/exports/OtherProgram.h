#pragma once

#include <array>
#include <cstdio>
#include <string>

namespace asperity::test {

/// Returns the standard output of a shell command.
inline std::string outputOf(const std::string& command) {
    std::FILE* pipe = popen(command.c_str(), "r");  // NOLINT(cert-env33-c): that is the test
    std::string output;
    std::array<char, 4096> buffer{};
    while (pipe != nullptr &&
           std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) {
        output += buffer.data();
    }
    if (pipe != nullptr) {
        pclose(pipe);
    }
    return output;
}

}  // namespace asperity::test
