#pragma once

#include "core/EnumTable.h"
#include "core/contact/laws/ContactOptions.h"
#include "core/contact/laws/FilmTable.h"
#include "core/contact/laws/HertzLaw.h"
#include "core/identify/AreaPunch.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace asperity {

/// Shape of the tip that a curve was measured with.
enum class TipKind : std::uint8_t {
    Sphere,      ///< exact, to its equator
    Paraboloid,  ///< of this radius of curvature at its apex
    ConeSphere,  ///< a sphere that goes on as a cone, the tip of a scene
    Cone,
    Pyramid3,  ///< of three sides
    Pyramid4,  ///< of four sides
    Area,      ///< known by its area function
};

template <>
inline constexpr auto
    kEnumTable<TipKind> = std::to_array<EnumRow<TipKind>>({{TipKind::Sphere, "sphere"},
                                                           {TipKind::Paraboloid, "paraboloid"},
                                                           {TipKind::ConeSphere, "conesphere"},
                                                           {TipKind::Cone, "cone"},
                                                           {TipKind::Pyramid3, "pyramid3"},
                                                           {TipKind::Pyramid4, "pyramid4"},
                                                           {TipKind::Area, "area"}});

[[nodiscard]] constexpr bool hasRadius(TipKind kind) noexcept {
    return kind == TipKind::Sphere || kind == TipKind::Paraboloid || kind == TipKind::ConeSphere;
}
[[nodiscard]] constexpr bool hasAngle(TipKind kind) noexcept {
    return kind == TipKind::ConeSphere || kind == TipKind::Cone || kind == TipKind::Pyramid3 ||
           kind == TipKind::Pyramid4;
}

struct TipForm {
    TipKind kind = TipKind::Paraboloid;
    double radius = 0.0;  ///< where the kind has one [m]
    double angle = 0.0;   ///< of cone or face to the axis, where the kind has one [rad]
    std::vector<AreaSample> area = {};  ///< of an area function
};

/// Exponent of force over indentation of a small contact: 1.5 or 2; none: it varies.
[[nodiscard]] std::optional<double> exponentOf(const TipForm& tip) noexcept;

/// A film of the sample on a rigid base.
struct SampleFilm {
    double thickness = 0.0;  ///< [m]; 0: a half-space
    double poissonRatio = 0.5;
};

/// Elastic contact of a tip with a sample, over E*, tabulated where it has no closed form: the fit
/// of a curve asks for it some 10^5 times. Constant after construction.
///
/// Cone: F = (2/pi) tan(alpha) d^2 (Sneddon 1965). Pyramids with an angle alpha between face and
/// axis: F = 0.7453 tan(alpha) d^2 with four sides (Bilodeau 1992), 0.887 with three.
/// Spheres: docs/theory.md 4.4, 4.8; film: 2.10.
class TipLaw {
public:
    /// @param largest indentation that the table covers [m]; beyond it a call takes longer
    /// @throw Error for a radius or an angle out of range, and for a film under another tip than a
    ///        paraboloid: its law is of that
    TipLaw(const TipForm& tip, const SampleFilm& film, double largest);

    [[nodiscard]] const TipForm& tip() const noexcept { return tip_; }
    /// Force and stiffness at an indentation > 0; from the table, without the contact radius.
    [[nodiscard]] IndentationPoint at(double indentation) const noexcept {
        if (exponent_ == 2.0) {
            return {.force = factor_ * indentation * indentation,
                    .stiffness = 2.0 * factor_ * indentation,
                    .indentation = indentation};
        }
        const double root = std::sqrt(indentation);
        if (exponent_ == 1.5) {
            return {.force = factor_ * indentation * root,
                    .stiffness = 1.5 * factor_ * root,
                    .indentation = indentation};
        }
        return tabulated(indentation, root);
    }
    /// The same without the table, with the contact radius.
    [[nodiscard]] IndentationPoint exact(double indentation) const noexcept;

private:
    /// At one of equally spaced roots of the indentation.
    struct Node {
        double force = 0.0;
        double rate = 0.0;  ///< of the force, by the root in nodes
    };

    [[nodiscard]] IndentationPoint tabulated(double indentation, double root) const noexcept;
    void tabulate(double largest);

    TipForm tip_;
    double filmThickness_ = 0.0;
    std::shared_ptr<const FilmTable> filmTable_;
    std::optional<AreaPunch> area_;
    double exponent_ = 0.0;  ///< 0: tabulated
    double factor_ = 0.0;    ///< force over the power of the indentation
    double nodesPerRoot_ = 0.0;
    std::vector<Node> nodes_;
};

}  // namespace asperity
