#pragma once

#include <QColor>
#include <QFont>

class QPaintDevice;

namespace asperity {

struct Color;

/// What the blocks of a page are set in, for one device. Lengths are those of the device.
class PdfStyle {
public:
    explicit PdfStyle(QPaintDevice& device, double width);

    [[nodiscard]] QPaintDevice& device() const { return device_; }
    [[nodiscard]] double width() const { return width_; }  ///< of the text
    [[nodiscard]] double points(double count) const { return count * point_; }

    [[nodiscard]] static QFont text(double size, bool bold = false);  ///< @param size [pt]
    [[nodiscard]] static QFont code(double size);                     ///< @param size [pt]

private:
    QPaintDevice& device_;
    double width_;
    double point_;  ///< in lengths of the device
};

[[nodiscard]] QColor colorForQt(const Color& color);

}  // namespace asperity
