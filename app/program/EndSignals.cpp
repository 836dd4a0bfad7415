#include "app/program/EndSignals.h"

#include "core/Error.h"
#include "core/PrintableText.h"

#include <atomic>
#include <cerrno>
#include <fcntl.h>
#include <initializer_list>
#include <iostream>
#include <new>
#include <unistd.h>

namespace asperity {

namespace {

/// @return the former action
struct sigaction replaced(int signal, void (*handler)(int)) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler == SIG_IGN) {
        return before;
    }
    struct sigaction ours {};
    ours.sa_handler = handler;
    ours.sa_flags = SA_RESTART;
    sigaction(signal, &ours, nullptr);
    return before;
}

std::atomic<bool> arrived = false;
static_assert(std::atomic<bool>::is_always_lock_free);  // else no signal handler may write it

void note(int /*signal*/) { arrived = true; }

}  // namespace

EndSignals::EndSignals(void (*handler)(int))
    : interrupt_(replaced(SIGINT, handler))
    , terminate_(replaced(SIGTERM, handler))
    , hangUp_(replaced(SIGHUP, handler)) {}

EndSignals::~EndSignals() {
    sigaction(SIGINT, &interrupt_, nullptr);
    sigaction(SIGTERM, &terminate_, nullptr);
    sigaction(SIGHUP, &hangUp_, nullptr);
}

CancelOnSignal::CancelOnSignal() : signals_(note) {}

bool CancelOnSignal::hasArrived() { return arrived; }

std::string messageOf(const std::exception& error) {
    return shortened(printable(error.what()), kMaxMessage);
}

int reportError(const std::exception_ptr& error) {
    try {
        std::rethrow_exception(error);
    } catch (const FileError& file) {
        std::cerr << "asperity: " << messageOf(file) << '\n';
        return kFileError;
    } catch (const std::bad_alloc&) {
        std::cerr << "asperity: out of memory\n";
    } catch (const std::exception& other) {
        std::cerr << "asperity: " << messageOf(other) << '\n';
    }
    return kFailed;
}

void openClosedStandardStreams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(stream, F_GETFD) == -1 && errno == EBADF) {
            // The wrong way round: its use fails. It gets the lowest number free, this one.
            open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
        }
    }
}

}  // namespace asperity
