#include "tests/hardware/woodenhaptics/CoupledTipChild.h"

#include "core/Error.h"

#include <array>
#include <csignal>
#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace asperity::test {

namespace {

/// Starts a program whose standard output is this. @return its id, 0: it could not be started
pid_t spawned(std::string path, int output) {
    posix_spawn_file_actions_t actions{};
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
    const std::array<char*, 2> arguments = {path.data(), nullptr};
    pid_t id = 0;
    const int failure =
        posix_spawn(&id, path.c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return failure == 0 ? id : 0;
}

}  // namespace

CoupledTipChild::CoupledTipChild(const std::string& path) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) {
        throw Error(path + ": no pipe for its output");
    }
    output_ = ends[0];
    id_ = spawned(path, ends[1]);
    close(ends[1]);
    if (id_ == 0) {
        close(output_);
        throw Error(path + ": cannot be started");
    }
}

CoupledTipChild::~CoupledTipChild() {
    if (id_ != 0) {
        (void)end(SIGKILL);
    }
    close(output_);
}

std::string CoupledTipChild::readLine() const {
    std::string line;
    for (char letter = 0; ::read(output_, &letter, 1) == 1 && letter != '\n';) {
        line += letter;
    }
    return line;
}

std::string CoupledTipChild::end(int signal) {
    kill(id_, signal);
    int status = 0;
    waitpid(id_, &status, 0);
    id_ = 0;
    return WIFSIGNALED(status) ? "killed by signal " + std::to_string(WTERMSIG(status))
                               : "exited with " + std::to_string(WEXITSTATUS(status));
}

}  // namespace asperity::test
