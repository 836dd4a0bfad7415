#pragma once

#include <string>
#include <sys/types.h>

namespace asperity::test {

/// A program run as a child of the test; it is killed when the test forgets it.
class CoupledTipChild {
public:
    /// @throw Error when it cannot be started
    explicit CoupledTipChild(const std::string& path);
    ~CoupledTipChild();
    CoupledTipChild(const CoupledTipChild&) = delete;
    CoupledTipChild& operator=(const CoupledTipChild&) = delete;

    /// The next line of its standard output; what there is when it ends before.
    [[nodiscard]] std::string readLine() const;

    /// Sends the signal and waits until the program is gone. @return how it ended
    std::string end(int signal);

private:
    pid_t id_ = 0;     ///< 0: it is gone
    int output_ = -1;  ///< of it
};

}  // namespace asperity::test
