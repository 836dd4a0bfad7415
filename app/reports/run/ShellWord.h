#pragma once

#include <string>

namespace asperity {

/// A text as one word of a POSIX shell's command line, quoted where that is needed.
[[nodiscard]] std::string shellWord(const std::string& text);

}  // namespace asperity
