#pragma once

#include <string>
#include <sys/types.h>
#include <vector>

namespace asperity::test {

/// How a child ended and what it took.
struct ChildEnd {
    int exitCode = -1;    ///< -1 when a signal ended it
    long peakMemory = 0;  ///< largest resident size [bytes]
};

/// `asperity` as a child of this process, without output, for what a shell would hide.
class ChildProgram {
public:
    explicit ChildProgram(const std::vector<std::string>& arguments);

    void send(int signal) const;
    [[nodiscard]] bool hasEnded();
    ChildEnd wait();

private:
    void reap(int options);

    pid_t id_;
    bool ended_ = false;
    ChildEnd end_;
};

}  // namespace asperity::test
