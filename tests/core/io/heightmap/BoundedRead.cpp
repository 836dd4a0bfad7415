#include "tests/core/io/heightmap/BoundedRead.h"

#include "core/Error.h"
#include "core/io/heightmap/HeightMapFormat.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <functional>
#include <malloc.h>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace asperity::test {

namespace {

/// Processor time after which a process that still reads is ended [s].
constexpr unsigned kPatience = 20;
/// Likewise by the clock, for one that waits; on a machine under load that comes later.
constexpr unsigned kLongestWait = 120;

/// The code that the reading process exits with.
enum class Answer : int {
    Read = 0,
    Refused = 1,
    RefusedWithoutReason = 2,
    NoMemory = 3,
    Other = 4
};

Answer answerTo(std::string_view bytes, const ReadDamaged& read) {
    try {
        read(bytes);
        return Answer::Read;
    } catch (const InputError& error) {
        constexpr std::string_view kName = "damaged: ";
        const std::string_view text = error.what();
        return text.starts_with(kName) && text.size() > kName.size() ? Answer::Refused
                                                                     : Answer::RefusedWithoutReason;
    } catch (const std::bad_alloc&) {
        return Answer::NoMemory;
    } catch (...) {
        return Answer::Other;
    }
}

std::uint64_t addressSpace() {
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

/// End of a process, and the resources that it used.
struct Ended {
    int status = 0;
    rusage used{};

    [[nodiscard]] std::uint64_t mostMemory() const {
        return static_cast<std::uint64_t>(used.ru_maxrss) * 1024;
    }
    [[nodiscard]] double seconds() const {
        const auto of = [](const timeval& time) {
            return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
        };
        return of(used.ru_utime) + of(used.ru_stime);
    }
};

Ended inProcess(const std::function<Answer()>& step) {
    const pid_t process = fork();
    if (process < 0) {
        throw std::runtime_error("no process can be started");
    }
    if (process == 0) {
        const rlimit time{.rlim_cur = kPatience, .rlim_max = kPatience + 1};
        setrlimit(RLIMIT_CPU, &time);
        alarm(kLongestWait);
        _exit(static_cast<int>(step()));
    }
    Ended ended;
    if (wait4(process, &ended.status, 0, &ended.used) != process) {
        throw std::runtime_error("a process was lost");
    }
    return ended;
}

std::string failureOf(int status) {
    if (WIFSIGNALED(status)) {
        const int signal = WTERMSIG(status);
        return signal == SIGALRM || signal == SIGXCPU ? "it reads on and on" : strsignal(signal);
    }
    switch (static_cast<Answer>(WEXITSTATUS(status))) {
    case Answer::Read:
    case Answer::Refused:
        return "";
    case Answer::RefusedWithoutReason:
        return "refused without name and reason";
    case Answer::NoMemory:
        return "asked for more memory than the bound";
    case Answer::Other:
        break;
    }
    return "another exception than an InputError";
}

}  // namespace

BoundedRead readBounded(std::string_view bytes, std::uint64_t most) {
    return readBounded(bytes, most, [](std::string_view content) {
        (void)readHeightMapBytes(content, "damaged");
    });
}

BoundedRead readBounded(std::string_view bytes, std::uint64_t most, const ReadDamaged& read) {
    malloc_trim(0);  // what is free here would hide what the process uses of it
    const Ended idle = inProcess([] { return Answer::Read; });
    const rlim_t limit = addressSpace() + most;
    const Ended ended = inProcess([&] {
        const rlimit room{limit, limit};
        setrlimit(RLIMIT_AS, &room);
        return answerTo(bytes, read);
    });
    return {.isRead = WIFEXITED(ended.status) && WEXITSTATUS(ended.status) == 0,
            .failure = failureOf(ended.status),
            .seconds = ended.seconds(),
            .memory = ended.mostMemory() - std::min(idle.mostMemory(), ended.mostMemory())};
}

}  // namespace asperity::test
