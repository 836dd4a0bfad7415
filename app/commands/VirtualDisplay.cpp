#include "app/commands/VirtualDisplay.h"

#include "core/Error.h"
#include "vtkplugins/pictures/Display.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <string>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace asperity {

namespace {

constexpr int kNotFound = 42;  // exit code of a child that found no Xvfb; the loader's is 127

[[noreturn]] void refuse(const std::string& why) {
    throw Error("no display: none answers at DISPLAY and Xvfb " + why);
}

/// @param error of the system
[[noreturn]] void refuseStart(int error) {
    refuse("cannot be started: " + std::generic_category().message(error));
}

/// Runs Xvfb in place of this (forked) process; it writes its display number to `reply` and ends
/// with the program, however that ends.
[[noreturn]] void becomeServer(int reply, pid_t program) {
    setsid();  // Ctrl+C is for the program, which still draws while it ends
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != program) {
        _exit(1);  // it ended before we asked to be told
    }
    const int null = open("/dev/null", O_RDWR | O_CLOEXEC);
    if (null < 0) {
        _exit(1);
    }
    dup2(null, STDOUT_FILENO);
    dup2(null, STDERR_FILENO);
    const std::string replyText = std::to_string(reply);
    execlp("Xvfb", "Xvfb", "-displayfd", replyText.c_str(), "-screen", "0", "1600x1000x24",
           "-nolisten", "tcp", "-noreset", nullptr);
    _exit(errno == ENOENT ? kNotFound : 1);
}

/// The display number that the server announces; empty when it ends without one.
std::string readDisplayNumber(int from) {
    std::string number;
    std::array<char, 16> buffer{};
    while (number.find('\n') == std::string::npos) {
        const ssize_t count = read(from, buffer.data(), buffer.size());
        if (count <= 0) {
            return {};
        }
        number.append(buffer.data(), static_cast<std::size_t>(count));
    }
    number.resize(number.find('\n'));
    return number;
}

}  // namespace

VirtualDisplay::VirtualDisplay() {
    const char* display = std::getenv("DISPLAY");  // NOLINT(concurrency-mt-unsafe): at start
    before_ = display == nullptr ? "" : display;
    if (!before_.empty() && haveDisplay()) {
        return;
    }
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) {
        refuseStart(errno);
    }
    const pid_t program = getpid();
    server_ = fork();
    if (server_ == 0) {
        becomeServer(ends[1], program);
    }
    const int error = errno;
    close(ends[1]);
    const std::string number = server_ > 0 ? readDisplayNumber(ends[0]) : "";
    close(ends[0]);
    if (server_ < 0) {
        refuseStart(error);
    }
    if (number.empty()) {
        int status = 0;
        waitpid(server_, &status, 0);
        refuse(WIFEXITED(status) && WEXITSTATUS(status) == kNotFound
                   ? "is not installed (Debian package xvfb)"
                   : "ended as soon as it was started");
    }
    setenv("DISPLAY", (":" + number).c_str(), 1);  // NOLINT(concurrency-mt-unsafe): at start
}

VirtualDisplay::~VirtualDisplay() {
    if (server_ <= 0) {
        return;
    }
    kill(server_, SIGTERM);
    waitpid(server_, nullptr, 0);
    before_.empty() ? unsetenv("DISPLAY")                     // NOLINT(concurrency-mt-unsafe)
                    : setenv("DISPLAY", before_.c_str(), 1);  // NOLINT(concurrency-mt-unsafe)
}

}  // namespace asperity
