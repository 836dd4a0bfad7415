#pragma once

#include "core/Error.h"

#include <string>

namespace asperity::test {

/// The message with which an action refuses its input; empty when it does not.
template <typename Action>
std::string refusalOf(const Action& action) {
    try {
        action();
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace asperity::test
