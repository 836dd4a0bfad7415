#include "tests/app/TracedProgram.h"

#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

// runTraced() for scripts. Usage: asperity_traced BYTES MADE PROGRAM [ARGUMENT...]
// kills the program before it has written more bytes than that, or makes what ends in MADE; an
// empty word means no such limit. Prints whether it came to that, the program's exit code and
// the bytes that it has written.

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() < 3) {
        std::cerr << "usage: asperity_traced BYTES MADE PROGRAM [ARGUMENT...]\n";
        return 2;
    }
    asperity::test::SignalPoint point{.made = words[1]};
    if (!words[0].empty()) {
        point.bytes = std::stoull(words[0]);
    }
    const auto end = asperity::test::runTraced({words.begin() + 2, words.end()}, {}, point);
    std::cout << end.wasSignaled << ' ' << end.exitCode << ' ' << end.progress.bytes << '\n';
    return 0;
}
