#pragma once

#include <hdf5.h>
#include <utility>

namespace asperity {

/// An open object of the HDF5 library, closed with its owner.
class Hdf5Object {
public:
    using Close = herr_t (*)(hid_t);

    /// @param id negative: there is none
    Hdf5Object(hid_t id, Close close) noexcept : id_(id), close_(close) {}
    ~Hdf5Object() {
        if (id_ >= 0) {
            close_(id_);
        }
    }
    Hdf5Object(Hdf5Object&& other) noexcept
        : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
    Hdf5Object& operator=(Hdf5Object&& other) noexcept {
        std::swap(id_, other.id_);
        std::swap(close_, other.close_);
        return *this;
    }
    Hdf5Object(const Hdf5Object&) = delete;
    Hdf5Object& operator=(const Hdf5Object&) = delete;

    [[nodiscard]] bool isOpen() const noexcept { return id_ >= 0; }
    [[nodiscard]] hid_t id() const noexcept { return id_; }

private:
    hid_t id_;
    Close close_;
};

}  // namespace asperity
