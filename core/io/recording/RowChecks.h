#pragma once

#include <boost/crc.hpp>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace asperity {

/// Checks of a table's rows as text: a CRC-32 of each block of rows, which shows whether a row that
/// was computed again is the same to the last digit, where the table itself keeps fewer digits.
class RowChecks {
public:
    /// Rows of a check.
    static constexpr std::size_t kRows = 256;

    /// The next cell of the row.
    void add(std::string_view cell);
    void endRow();
    /// Returns the checks of all whole rows so far; the last one may be of fewer.
    [[nodiscard]] std::vector<std::uint32_t> checks() const;

private:
    boost::crc_32_type crc_;
    std::size_t rows_ = 0;  ///< of the present check
    std::vector<std::uint32_t> checks_;
};

}  // namespace asperity
