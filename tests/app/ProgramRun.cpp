#include "tests/app/ProgramRun.h"

#include <array>
#include <cstdio>
#include <sys/wait.h>

namespace asperity::test {

ProgramRun runProgram(const std::string& arguments, const std::string& environment) {
    const std::string command =
        environment + " " + std::string(ASPERITY_PROGRAM) + " " + arguments + " 2>&1";
    std::FILE* pipe = popen(command.c_str(), "r");  // NOLINT(cert-env33-c): that is the test
    ProgramRun run;
    if (pipe == nullptr) {
        return run;
    }
    std::array<char, 4096> buffer{};
    while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) {
        run.output += buffer.data();
    }
    const int status = pclose(pipe);
    run.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return run;
}

}  // namespace asperity::test
