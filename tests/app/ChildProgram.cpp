#include "tests/app/ChildProgram.h"

#include "tests/support/Places.h"

#include <fcntl.h>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace asperity::test {

namespace {

constexpr long kKibibyte = 1024;  // the unit of ru_maxrss on Linux

[[noreturn]] void become(std::vector<char*> arguments, void (*onInterrupt)(int)) {
    std::signal(SIGINT, onInterrupt);
    std::signal(SIGTERM, SIG_DFL);
    std::signal(SIGHUP, SIG_DFL);
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    execv(arguments.front(), arguments.data());
    _exit(127);
}

}  // namespace

ChildProgram::ChildProgram(const std::vector<std::string>& arguments, void (*onInterrupt)(int)) {
    std::vector<std::string> words = {programOfBuild("asperity").string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) {
        pointers.push_back(word.data());
    }
    pointers.push_back(nullptr);
    id_ = fork();
    if (id_ < 0) {
        throw std::runtime_error("no child can be started");
    }
    if (id_ == 0) {
        become(pointers, onInterrupt);
    }
}

void ChildProgram::send(int signal) const { kill(id_, signal); }

bool ChildProgram::hasEnded() {
    reap(WNOHANG);
    return ended_;
}

ChildEnd ChildProgram::wait() {
    reap(0);
    return end_;
}

void ChildProgram::reap(int options) {
    int status = 0;
    rusage usage{};
    if (!ended_ && wait4(id_, &status, options, &usage) == id_) {
        ended_ = true;
        end_ = {.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1,
                .peakMemory = usage.ru_maxrss * kKibibyte};
    }
}

}  // namespace asperity::test
