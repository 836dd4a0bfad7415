#include "core/Error.h"
#include "core/io/tables/CsvTable.h"

#include <cstdint>

// A CSV table: every cell as a number, or an InputError.

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        const asperity::CsvTable table({reinterpret_cast<const char*>(data), size}, "fuzz");
        for (const std::string& column : table.columns()) {
            (void)table.numbers(column);
        }
    } catch (const asperity::InputError&) {
        return 0;
    }
    return 0;
}
