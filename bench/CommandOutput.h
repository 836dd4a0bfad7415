#pragma once

#include <array>
#include <cstdio>
#include <memory>
#include <string>

namespace asperity {

/// The standard output of a command.
inline std::string outputOf(const std::string& command) {
    // NOLINTNEXTLINE(cert-env33-c): a program of a benchmark's own, run on purpose
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    std::string output;
    std::array<char, 4096> buffer{};
    while (pipe && std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe.get())) {
        output += buffer.data();
    }
    return output;
}

/// The first line that a command prints; empty when it prints none.
inline std::string firstLineOf(const std::string& command) {
    const std::string output = outputOf(command);
    return output.substr(0, output.find('\n'));
}

}  // namespace asperity
