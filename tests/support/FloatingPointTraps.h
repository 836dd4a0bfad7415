#pragma once

namespace asperity::test {

/// While it lives, an invalid operation, a division by zero or an overflow stops the program at the
/// place where it happens (glibc; elsewhere nothing changes).
class FloatingPointTraps {
public:
    FloatingPointTraps();
    ~FloatingPointTraps();
    FloatingPointTraps(const FloatingPointTraps&) = delete;
    FloatingPointTraps& operator=(const FloatingPointTraps&) = delete;

private:
    int before_;
};

}  // namespace asperity::test

/// Once in one source file of a test program: traps are on in all of its tests.
#define ASPERITY_TRAP_FLOATING_POINT()                                                             \
    static const asperity::test::FloatingPointTraps kFloatingPointTraps {}
