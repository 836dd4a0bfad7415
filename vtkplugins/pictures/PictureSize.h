#pragma once

namespace asperity {

/// Size of a picture file [pixel].
struct PictureSize {
    int width = 1600;
    int height = 1000;
};

}  // namespace asperity
