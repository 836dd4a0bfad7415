#include "bench/contact/SciPyPeer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
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
    for (const ContactCase& one : cases) {
        double nanoseconds = 0.0;
        double force = 0.0;
        if (std::fscanf(pipe.get(), "%lf %lf", &nanoseconds, &force) != 2) {
            return std::nullopt;
        }
        times.push_back(nanoseconds);
        timing.error = std::max(timing.error,
                                std::abs(force - one.force) / std::max(std::abs(one.force), 1.0));
    }
    std::sort(times.begin(), times.end());
    timing.nanoseconds = times[times.size() / 2];
    return timing;
}

}  // namespace asperity
