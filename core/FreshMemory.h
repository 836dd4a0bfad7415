#pragma once

#include <cstddef>

namespace asperity {

/// Asks for the pages of memory that is about to be filled, all at once: a fault for each costs
/// more than to fill it. Advice only; the content is not changed.
void requestPages(void* memory, std::size_t bytes) noexcept;

}  // namespace asperity
