#pragma once

#include <complex>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace asperity {

/// Convolution of real square fields (row-major) with one kernel that is even along both axes, by
/// fast Fourier transforms. Its work space makes it for one thread at a time.
class FieldConvolution {
public:
    /// Even function of offsets (rows, columns) >= 0 or of wave numbers, as the factory's name
    /// says.
    using EvenFunction = std::function<double(int, int)>;

    /// Fields that are zero outside of their `size` x `size` samples.
    /// @param size a fieldSize()  @param kernel at offsets 0 .. size
    [[nodiscard]] static FieldConvolution padded(int size, const EvenFunction& kernel);

    /// Periodic fields. @param size a fieldSize()
    /// @param symbol the kernel's transform at wave numbers 0 .. size / 2 per period
    [[nodiscard]] static FieldConvolution periodic(int size, const EvenFunction& symbol);

    FieldConvolution(FieldConvolution&&) noexcept;
    FieldConvolution& operator=(FieldConvolution&&) noexcept;
    FieldConvolution(const FieldConvolution&) = delete;
    FieldConvolution& operator=(const FieldConvolution&) = delete;
    ~FieldConvolution();

    /// Samples per side of the fields.
    [[nodiscard]] int size() const noexcept { return size_; }
    /// `result` may be `field`.
    void apply(std::span<const double> field, std::span<double> result);

private:
    struct Transform;
    FieldConvolution(int size, int period);

    void setKernel(const EvenFunction& kernel);
    void setSymbol(const EvenFunction& symbol);
    void forwardRows(std::span<const double> field, int rows);
    void inverseRows(std::span<double> result);
    [[nodiscard]] std::complex<double>* column(int wave);

    int size_;
    int period_;          ///< of the transforms, >= 2 size_ - 1 for fields that do not repeat
    std::size_t stride_;  ///< from one column of the spectrum to the next
    std::unique_ptr<Transform> transform_;
    std::vector<double> symbol_;                  ///< (period / 2 + 1) columns, scaled
    std::vector<std::complex<double>> spectrum_;  ///< same
    std::vector<std::complex<double>> line_;      ///< one row's or column's transform
    std::vector<double> row_;                     ///< one row, padded
};

/// The smallest size of a field that is at least `samples` and quick to transform.
[[nodiscard]] int fieldSize(int samples) noexcept;

/// Displacement of an elastic half-space of unit modulus E* at the middle of one square of a unit
/// grid by unit pressure on another that lies `rows` and `columns` away. Times pitch / E* in SI.
/// Source: Love (1929); Johnson, Contact Mechanics (1985), 3.25.
[[nodiscard]] double loveInfluence(int rows, int columns) noexcept;

}  // namespace asperity
