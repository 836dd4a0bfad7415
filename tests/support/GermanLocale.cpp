#include "tests/support/GermanLocale.h"

#include <cstdlib>
#include <filesystem>
#include <stdexcept>

namespace asperity::test {

GermanLocale::GermanLocale() {
    const std::string command =
        "localedef -i de_DE -f UTF-8 '" + folder_.file("de_DE.UTF-8").string() + "' 2>/dev/null";
    (void)std::system(command.c_str());  // NOLINT(cert-env33-c,concurrency-mt-unsafe)
    if (!std::filesystem::exists(folder_.file("de_DE.UTF-8") / "LC_NUMERIC")) {
        throw std::runtime_error("localedef makes no de_DE (Debian package locales)");
    }
}

std::string GermanLocale::environment() const {
    return "LC_ALL=de_DE.UTF-8 LOCPATH='" + folder_.path().string() + "'";
}

}  // namespace asperity::test
