#pragma once

#include "tests/support/ScratchFolder.h"

#include <string>

namespace asperity::test {

/// A locale with a decimal comma for programs that a test starts, made where the system has none.
class GermanLocale {
public:
    /// @throw std::runtime_error where localedef makes none (Debian package locales)
    GermanLocale();

    /// What the program's environment needs: "LC_ALL=... LOCPATH=...".
    [[nodiscard]] std::string environment() const;

private:
    ScratchFolder folder_;
};

}  // namespace asperity::test
