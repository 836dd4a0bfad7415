#include "tests/support/AllocationCounter.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::size_t> allocations{0};

void* counted(void* memory) {
    ++allocations;
    return memory;
}

void* countedOrThrow(void* memory) {
    if (memory == nullptr) {
        throw std::bad_alloc();
    }
    return counted(memory);
}

}  // namespace

// The linker sends every malloc, calloc, realloc, aligned_alloc and posix_memalign of this
// program's own objects here (--wrap, see CMakeLists.txt). NOLINTBEGIN
extern "C" {
void* __real_malloc(std::size_t size);
void* __real_calloc(std::size_t count, std::size_t size);
void* __real_realloc(void* memory, std::size_t size);
void* __real_aligned_alloc(std::size_t alignment, std::size_t size);
int __real_posix_memalign(void** memory, std::size_t alignment, std::size_t size);

void* __wrap_malloc(std::size_t size) { return counted(__real_malloc(size)); }
void* __wrap_calloc(std::size_t count, std::size_t size) {
    return counted(__real_calloc(count, size));
}
void* __wrap_realloc(void* memory, std::size_t size) {
    return counted(__real_realloc(memory, size));
}
void* __wrap_aligned_alloc(std::size_t alignment, std::size_t size) {
    return counted(__real_aligned_alloc(alignment, size));
}
int __wrap_posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
    counted(nullptr);
    return __real_posix_memalign(memory, alignment, size);
}
}

void* operator new(std::size_t size) { return countedOrThrow(__real_malloc(size == 0 ? 1 : size)); }

void* operator new(std::size_t size, std::align_val_t alignment) {
    const auto step = static_cast<std::size_t>(alignment);
    return countedOrThrow(__real_aligned_alloc(step, (size + step - 1) / step * step));
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
// NOLINTEND

namespace asperity::test {

std::size_t allocationCount() noexcept { return allocations; }

}  // namespace asperity::test
