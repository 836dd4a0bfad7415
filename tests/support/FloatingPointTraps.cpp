#include "tests/support/FloatingPointTraps.h"

#include <cfenv>

namespace asperity::test {

#ifdef __GLIBC__

FloatingPointTraps::FloatingPointTraps()
    : before_(feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW)) {}

FloatingPointTraps::~FloatingPointTraps() {
    fedisableexcept(FE_ALL_EXCEPT);
    feenableexcept(before_);
}

#else

FloatingPointTraps::FloatingPointTraps() : before_(0) {}
FloatingPointTraps::~FloatingPointTraps() = default;

#endif

}  // namespace asperity::test
