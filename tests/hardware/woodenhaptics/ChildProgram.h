#pragma once

#include <string>
#include <sys/types.h>

namespace asperity::test {

/// A program run as a child of the test; it is killed when the test forgets it.
class ChildProgram {
public:
    /// @throw Error when it cannot be started
    explicit ChildProgram(const std::string& path);
    ~ChildProgram();
    ChildProgram(const ChildProgram&) = delete;
    ChildProgram& operator=(const ChildProgram&) = delete;

    /// The next line of its standard output; what there is when it ends before.
    [[nodiscard]] std::string readLine() const;

    /// Sends the signal and waits until the program is gone. @return how it ended
    std::string end(int signal);

private:
    pid_t id_ = 0;     ///< 0: it is gone
    int output_ = -1;  ///< of it
};

}  // namespace asperity::test
