#pragma once

#include <csignal>
#include <string>
#include <sys/types.h>
#include <vector>

namespace asperity::test {

/// End of a child and the resources that it used.
struct ChildEnd {
    int exitCode = -1;    ///< -1 when a signal ended it
    long peakMemory = 0;  ///< largest resident size [bytes]
};

/// `asperity` as a child of this process, without output, for what a shell would hide.
class ChildProgram {
public:
    /// @param onInterrupt what SIGINT does before the program says otherwise: SIG_DFL or, as in a
    ///        shell's background job, SIG_IGN
    explicit ChildProgram(const std::vector<std::string>& arguments,
                          void (*onInterrupt)(int) = SIG_DFL);

    void send(int signal) const;
    [[nodiscard]] bool hasEnded();
    [[nodiscard]] pid_t id() const { return id_; }
    ChildEnd wait();

private:
    void reap(int options);

    pid_t id_;
    bool ended_ = false;
    ChildEnd end_;
};

}  // namespace asperity::test
