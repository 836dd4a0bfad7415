#pragma once

#include <QImage>

#include <cstdlib>

namespace asperity::test {

/// How many pixels of a picture are nearly of this color.
inline int pixelsLike(const QImage& image, const QColor& color) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor pixel = image.pixelColor(x, y);
            const int difference = std::abs(pixel.red() - color.red()) +
                                   std::abs(pixel.green() - color.green()) +
                                   std::abs(pixel.blue() - color.blue());
            count += difference < 24 ? 1 : 0;
        }
    }
    return count;
}

}  // namespace asperity::test
