#include "core/io/recording/RowChecks.h"

namespace asperity {

void RowChecks::add(std::string_view cell) {
    crc_.process_bytes(cell.data(), cell.size());
    crc_.process_byte(',');
}

void RowChecks::endRow() {
    crc_.process_byte('\n');
    if (++rows_ == kRows) {
        checks_.push_back(crc_.checksum());
        crc_.reset();
        rows_ = 0;
    }
}

std::vector<std::uint32_t> RowChecks::checks() const {
    std::vector<std::uint32_t> all = checks_;
    if (rows_ > 0) {
        all.push_back(crc_.checksum());
    }
    return all;
}

}  // namespace asperity
