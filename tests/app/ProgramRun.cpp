#include "tests/app/ProgramRun.h"

#include "tests/support/Places.h"

#include <array>
#include <cstdio>
#include <sstream>
#include <sys/wait.h>

namespace asperity::test {

long ProgramRun::lines() const {
    std::istringstream text(output);
    long count = 0;
    for (std::string line; std::getline(text, line);) {
        count += line.ends_with(" left") && line.find(" %, about ") != std::string::npos ? 0 : 1;
    }
    return count;
}

ProgramRun runCommand(const std::string& command) {
    // NOLINTNEXTLINE(cert-env33-c): that is the test
    std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
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

ProgramRun runProgram(const std::string& arguments, const std::string& environment) {
    return runCommand(environment + " " + programOfBuild("asperity").string() + " " + arguments);
}

}  // namespace asperity::test
