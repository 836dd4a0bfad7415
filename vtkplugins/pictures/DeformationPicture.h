#pragma once

#include "core/Vector.h"
#include "core/surface/deformation/SurfaceDeformation.h"
#include "vtkplugins/pictures/RasterImage.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace asperity {

/// One moment of a contact, as one panel shows it. World frame, SI units.
struct DeformationView {
    std::string title;
    std::string caption;                      ///< below the panel; wrapped
    SurfacePatch patch;                       ///< its grid runs along x and y
    Vector3 tipCenter = Vector3::Zero();      ///< center of the tip's sphere [m]
    double tipRadius = 0.0;                   ///< [m]
    double shankHalfAngle = kShankHalfAngle;  ///< between the tip's shank and its axis [rad]
    /// Above 0: the tip is a paraboloid to this distance from its axis, see vtkAspTipSource [m].
    double paraboloidReach = 0.0;
    /// Displacement of the tip's own surface, at a distance from the contact's axis [m -> m];
    /// empty: the tip is rigid.
    RadialDisplacement tipDisplacement = {};
    Vector3 contactPoint = Vector3::Zero();  ///< middle of the contact, on the surface [m]
    Vector3 force = Vector3::Zero();         ///< of the sample on the tip [N]
    double contactRadius = 0.0;              ///< 0: no contact circle is drawn [m]
    std::optional<double> heightScale = {};  ///< factor of all heights; none: one that suits
};

class OffscreenPicture;

/// Puts the deformed surface of each view into a picture, as writeDeformationPicture() does. The
/// views live until the picture is drawn.
/// @throw Error when a patch is not whole or a value not finite
void drawDeformation(OffscreenPicture& picture, std::span<const DeformationView> views,
                     const PictureParts& parts = {});

/// Draws the deformed surface of each view in 3-D, side by side, four and more in rows of two:
/// colored by displacement, with the edge of the contact, the tip and the force. True to scale;
/// where the displacement would then not be seen all heights, the tip's too, are multiplied by one
/// factor, which the picture states. The same views give the same bytes.
/// @throw Error when a patch is not whole or a value not finite, no display answers, or the file
/// cannot be written
void writeDeformationPicture(const std::filesystem::path& path,
                             std::span<const DeformationView> views, PictureSize size = {});

}  // namespace asperity
