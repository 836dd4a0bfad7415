#pragma once

#include <cstdio>
#include <exception>

namespace asperity {

/// The main function of a program of measurements: says why one fails. @return the exit status
inline int benchMain(int argc, char** argv, int (*run)(int argc, char** argv)) {
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}

}  // namespace asperity
