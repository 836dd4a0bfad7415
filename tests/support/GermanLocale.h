#pragma once

#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace asperity::test {

/// A locale with a decimal comma for programs that a test starts, made where the system has none.
class GermanLocale {
public:
    GermanLocale();

    /// Whether there is one: it takes localedef and its sources (Debian package locales).
    [[nodiscard]] bool exists() const;
    /// What the program's environment needs: "LC_ALL=... LOCPATH=...".
    [[nodiscard]] std::string environment() const;

private:
    ScratchFolder folder_;
};

}  // namespace asperity::test

// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): it returns from the test
#define ASPERITY_NEEDS_GERMAN(german)                                                              \
    if (!(german).exists()) {                                                                      \
        const char* ci = std::getenv("CI"); /* NOLINT(concurrency-mt-unsafe) */                    \
        if (ci != nullptr && std::string(ci) == "true") {                                          \
            FAIL() << "CI=true, but localedef makes no de_DE (Debian package locales)";            \
        }                                                                                          \
        GTEST_SKIP() << "SKIPPED: localedef makes no de_DE (Debian package locales)";              \
    }
