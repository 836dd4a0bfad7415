#pragma once

#include <exception>
#include <iostream>
#include <span>

namespace asperity {

/// The main function of a tool that makes pictures: as many arguments as its usage names,
/// exceptions told in one line.
/// @param arguments of the program, its name first
/// @param run       makes the pictures; gives the exit status
template <class Run>
int runPictureTool(std::span<char*> arguments, std::size_t wanted, const char* usage,
                   const Run& run) {
    if (arguments.size() != wanted + 1) {
        std::cerr << "usage: " << usage << '\n';
        return 2;
    }
    try {
        return run(arguments.data());
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
}

}  // namespace asperity
