#include "bench/contact/SciPyPeer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iomanip>
#include <memory>
#include <sstream>

namespace asperity {

namespace {

/// Debian's own interpreter: the one that its package python3-scipy is for.
constexpr const char* kPython = "/usr/bin/python3";

std::string commandFor(const std::string& style, const std::vector<ContactCase>& cases) {
    std::ostringstream command;
    command << std::setprecision(17) << kPython << " '" << ASPERITY_SCIPY_SCRIPT << "' " << style;
    for (const ContactCase& one : cases) {
        command << ' ' << one.lambda << ' ' << one.lowContactRadius << ' ' << one.indentation;
    }
    command << " 2>/dev/null";
    return command.str();
}

}  // namespace

std::optional<PeerTiming> timeSciPy(const std::string& style,
                                    const std::vector<ContactCase>& cases) {
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(commandFor(style, cases).c_str(), "r"),
                                                     pclose);
    if (!pipe) {
        return std::nullopt;
    }
    PeerTiming timing;
    std::vector<double> times;
    std::array<char, 128> line{};
    for (const ContactCase& one : cases) {
        if (std::fgets(line.data(), static_cast<int>(line.size()), pipe.get()) == nullptr) {
            return std::nullopt;
        }
        char* next = nullptr;
        times.push_back(std::strtod(line.data(), &next));
        const double force = std::strtod(next, nullptr);
        timing.error = std::max(timing.error,
                                std::abs(force - one.force) / std::max(std::abs(one.force), 1.0));
    }
    std::sort(times.begin(), times.end());
    timing.nanoseconds = times[times.size() / 2];
    return timing;
}

}  // namespace asperity
