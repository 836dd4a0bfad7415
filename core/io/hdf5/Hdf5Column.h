#pragma once

#include <cstddef>
#include <string>

namespace asperity {

/// A column of a table in an HDF5 file.
struct Hdf5Column {
    enum class Type {
        Double,
        Single,  ///< numbers in single precision
        Text,    ///< UTF-8, filled up with zero bytes
    };

    std::string name;
    std::string unit;  ///< its attribute `unit`, written only; empty: it has none
    Type type = Type::Double;
    std::size_t width = 1;  ///< of a text's cells [byte]
    std::string sameAs;     ///< the path of a dataset that holds these values; empty: its own
};

}  // namespace asperity
