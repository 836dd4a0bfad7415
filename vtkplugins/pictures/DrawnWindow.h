#pragma once

#include "vtkplugins/pictures/RasterImage.h"

class vtkRenderWindow;

namespace asperity {

/// Resolution and background of a picture that is drawn for a file.
struct PictureLook {
    /// Pixels of the picture per pixel of its letters and lines, which are sized for 96 dots an
    /// inch: 300 / 96 for a picture of 300 dots an inch.
    double pixelRatio = 1.0;
    bool transparent = false;  ///< nothing is behind what is drawn
};

/// @throw Error where no picture of this size can be drawn
void requireDrawable(PictureSize size);

/// Sizes a window that nobody sees for a picture that is drawn larger and averaged down.
/// @throw Error when there is no X display to draw with or too little memory, or the size is
/// unreasonable
void prepareOffscreen(vtkRenderWindow* window, PictureSize size, int oversampling);

/// Draws the window and averages it down. Lines are `lineScale` times as wide as their actors say.
/// With transparency the lowest layer's background is black and clear: what is read is multiplied
/// by alpha then, and is divided by it again.
/// @throw Error when OpenGL cannot draw it
[[nodiscard]] RasterImage drawnImage(vtkRenderWindow* window, int oversampling, bool transparent,
                                     double lineScale);

}  // namespace asperity
