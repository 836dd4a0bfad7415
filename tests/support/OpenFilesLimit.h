#pragma once

#include <sys/resource.h>
#include <unistd.h>

namespace asperity::test {

/// While one lives, this process can open no files, or a few more than it has open.
class OpenFilesLimit {
public:
    explicit OpenFilesLimit(rlim_t more = 0) {
        getrlimit(RLIMIT_NOFILE, &before_);
        const int next = dup(STDERR_FILENO);
        close(next);
        const rlimit limit{static_cast<rlim_t>(next) + more, before_.rlim_max};
        setrlimit(RLIMIT_NOFILE, &limit);
    }
    ~OpenFilesLimit() { setrlimit(RLIMIT_NOFILE, &before_); }
    OpenFilesLimit(const OpenFilesLimit&) = delete;
    OpenFilesLimit& operator=(const OpenFilesLimit&) = delete;

private:
    rlimit before_{};
};

}  // namespace asperity::test
