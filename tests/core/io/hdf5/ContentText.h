#pragma once

#include "core/io/hdf5/Hdf5Content.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace asperity::test {

/// A content as the program that reads HDF5 writes it.
class ContentText {
public:
    ContentText& start(char record, const std::string& path) {
        ++items_;
        return put(record).put(static_cast<std::uint32_t>(path.size())).add(path);
    }
    ContentText& values(Hdf5Type type, std::uint32_t bytes, const std::vector<std::uint64_t>& shape,
                        bool areThere) {
        put(type).put(bytes).put(static_cast<std::uint8_t>(shape.size()));
        for (const std::uint64_t size : shape) {
            put(size);
        }
        return put(static_cast<std::uint8_t>(areThere ? 1 : 0));
    }
    template <class Number>
    ContentText& put(Number number) {
        return add({reinterpret_cast<const char*>(&number), sizeof number});
    }
    ContentText& add(std::string_view bytes) {
        text_ += bytes;
        return *this;
    }
    [[nodiscard]] std::string ended() const {
        ContentText all = *this;
        all.put(hdf5_content::kEnd).put(items_);
        return all.text_;
    }

private:
    std::string text_{hdf5_content::kStart};
    std::uint64_t items_ = 0;
};

}  // namespace asperity::test
