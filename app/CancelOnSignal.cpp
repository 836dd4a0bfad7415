#include "app/CancelOnSignal.h"

namespace asperity {

namespace {

volatile std::sig_atomic_t arrived = 0;  // all that a signal handler may write

void note(int /*signal*/) { arrived = 1; }

}  // namespace

CancelOnSignal::CancelOnSignal() : signals_(note) {}

bool CancelOnSignal::hasArrived() { return arrived != 0; }

}  // namespace asperity
