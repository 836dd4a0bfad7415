#include "app/program/CancelOnSignal.h"

#include <atomic>

namespace asperity {

namespace {

std::atomic<bool> arrived = false;
static_assert(std::atomic<bool>::is_always_lock_free);  // else no signal handler may write it

void note(int /*signal*/) { arrived = true; }

}  // namespace

CancelOnSignal::CancelOnSignal() : signals_(note) {}

bool CancelOnSignal::hasArrived() { return arrived; }

}  // namespace asperity
