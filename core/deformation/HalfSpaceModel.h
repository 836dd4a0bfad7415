#pragma once

#include "core/EnumTable.h"
#include "core/contact/halfspace/HalfSpaceSolver.h"
#include "core/probe/TipEquilibrium.h"
#include "core/surface/BSplineSurface.h"
#include "core/surface/deformation/DisplacementField.h"

#include <cmath>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <vector>

namespace asperity {

class HalfSpaceField;
class PixelField;
struct Scene;

/// Verdict on an answer of the half-space: usable, or why not.
enum class HalfSpaceVerdict : std::uint8_t {
    Valid,
    NotBonded,      ///< no contact: nothing to solve
    Film,           ///< the sample is a film, not a half-space
    NoZone,         ///< the contact law adheres without a cohesive zone (DMT, JKR)
    LargeContact,   ///< contact radius > 0.3 effective radii
    ReachesBorder,  ///< the contact is larger than the largest patch
    TooCoarse,      ///< contact or cohesive zone a few pixels wide
    Separate,       ///< on the real topography the tip has no contact where the law has one
    NotConverged,
    Canceled,
};

/// Texts for people: why an answer is used or not.
template <>
inline constexpr auto kEnumTable<HalfSpaceVerdict> = std::to_array<NamedRow<HalfSpaceVerdict>>(
    {{HalfSpaceVerdict::Valid, "it is used"},
     {HalfSpaceVerdict::NotBonded, "no contact"},
     {HalfSpaceVerdict::Film, "the sample is a film"},
     {HalfSpaceVerdict::NoZone, "the contact law's adhesion has no cohesive zone"},
     {HalfSpaceVerdict::LargeContact, "contact radius above 0.3 effective radii"},
     {HalfSpaceVerdict::ReachesBorder, "the contact reaches the patch's border"},
     {HalfSpaceVerdict::TooCoarse, "contact or cohesive zone too narrow for its grid"},
     {HalfSpaceVerdict::Separate, "no contact on the real topography"},
     {HalfSpaceVerdict::NotConverged, "did not converge"},
     {HalfSpaceVerdict::Canceled, "canceled"}});

/// The half-space's own view of one state of the tip.
struct HalfSpaceAnswer {
    HalfSpaceVerdict verdict = HalfSpaceVerdict::NotBonded;
    TipState state;              ///< that was asked about
    double force = 0.0;          ///< on the tip along the closest point's normal, > 0 repulsive [N]
    double contactRadius = 0.0;  ///< of the circle of the contact's area [m]
    int iterations = 0;
    std::shared_ptr<const HalfSpaceField> field;  ///< of both bodies together; null unless valid
    /// On the sample, over the same pixels with their corner at 0 [Pa]; null unless valid.
    std::shared_ptr<const PixelField> pressure = nullptr;

    [[nodiscard]] bool valid() const noexcept { return verdict == HalfSpaceVerdict::Valid; }
};

/// Returns whether a valid answer still describes the surface at a later state: the same branch, a
/// contact of about the same width and position.
[[nodiscard]] bool stillHolds(const HalfSpaceAnswer& answer, const TipState& now);

/// Solves for the deformed surface around the tip, on the scan's own topography in the tangent
/// plane at the closest point and with the exact sphere as tip, at the indentation of the tick's
/// state. Each answer starts from the one before where that fits, else from the closed form. The
/// cohesive zone is the contact law's; of a law that adheres without one (DMT, JKR) nothing is
/// solved, since with any zone of finite range the half-space would answer for another law. One
/// object a thread; off the tick: allocates, takes milliseconds. Source: docs/theory.md 2, 3.4, 4.
class HalfSpaceModel {
public:
    static constexpr int kSamples = 128;  ///< pixels per side of a patch

    /// @param samples per side of the patches
    explicit HalfSpaceModel(int samples = kSamples, HalfSpaceLimits limits = {});

    /// @param stop ends the search early
    [[nodiscard]] HalfSpaceAnswer solve(const Scene& scene, const TipState& state,
                                        const std::stop_token& stop = {});

private:
    /// A solution to start the next one from.
    struct Kept {
        double halfWidth = 0.0;  ///< of its patch [m]
        SurfaceTraction traction;
    };
    [[nodiscard]] double halfWidthFor(const TipState& state, double tipRadius) const;

    int samples_;
    HalfSpaceSolver solver_;
    std::optional<Kept> kept_;
};

/// A square patch of pixels around the closest point, in its tangent plane.
struct HalfSpacePatch {
    int samples = 0;         ///< per side
    double halfWidth = 0.0;  ///< [m]

    [[nodiscard]] double pitch() const noexcept { return 2.0 * halfWidth / samples; }
    /// Returns the position of the middle of a pixel, from the patch's [m].
    [[nodiscard]] double position(int index) const noexcept {
        return (index - 0.5 * (samples - 1)) * pitch();
    }
    /// Calls visit(distance of a pixel from the middle [m]) for each pixel, row-major.
    template <class Visit>
    void forEachDistance(const Visit& visit) const {
        for (int row = 0; row < samples; ++row) {
            for (int column = 0; column < samples; ++column) {
                visit(std::hypot(position(column), position(row)));
            }
        }
    }
};

/// Tip and topography at a state of the believed contact law, which is bonded.
[[nodiscard]] HalfSpaceContact halfSpaceContact(const Scene& scene, const TipState& state,
                                                const HalfSpacePatch& patch);

/// Returns the traction there by the contact law.
[[nodiscard]] SurfaceTraction closedFormTraction(const Scene& scene, const TipState& state,
                                                 const HalfSpacePatch& patch);

/// Returns the force of bonded bodies by the law beyond the pressure in contact and cohesive zone:
/// the tail of the split law, a water bridge [N].
[[nodiscard]] double forceBeyondZone(const Scene& scene, const TipState& state);

struct Scene;

/// Solves the half-space for the newest state that it was asked about, on a thread of its own: who
/// asks, once a frame, never waits for a solution. For one asking thread.
class HalfSpaceWorker {
public:
    /// @param scene outlives the worker
    explicit HalfSpaceWorker(const Scene& scene);
    /// Cancels what is being solved.
    ~HalfSpaceWorker();
    HalfSpaceWorker(const HalfSpaceWorker&) = delete;
    HalfSpaceWorker& operator=(const HalfSpaceWorker&) = delete;

    /// Takes the place of what was asked before and is not begun; a state that was asked about
    /// last is not solved again.
    void ask(const TipState& state);
    /// The newest answer; null until there is one.
    [[nodiscard]] std::shared_ptr<const HalfSpaceAnswer> newest() const;

private:
    void work(const std::stop_token& stop);

    const Scene& scene_;
    TipState asked_;  ///< last; of the asking thread
    mutable std::mutex mutex_;
    std::condition_variable_any waiting_;
    std::optional<TipState> next_;                   ///< guarded by mutex_
    std::shared_ptr<const HalfSpaceAnswer> newest_;  ///< guarded by mutex_
    std::jthread thread_;                            ///< last: it uses all of the above
};

/// Displacement of a half-space's surface around a contact, smooth between the pixels that it was
/// solved at; beyond them it falls off with the distance, as under a point force.
class HalfSpaceField {
public:
    /// @param displacement of samples x samples pixels, row-major, into the sample [m]
    HalfSpaceField(const std::vector<double>& displacement, int samples, double pitch);

    /// At a position in the tangent plane, from the contact's axis [m].
    [[nodiscard]] double at(double along, double across) const;

private:
    double halfWidth_;  ///< to the middle of the outermost pixels [m]
    double middle_;     ///< of the grid, from its corner [m]
    BSplineSurface displacement_;
};

/// Every point moves by its part `share` of the field against the normal of a contact, around its
/// closest point.
[[nodiscard]] DisplacementField halfSpaceField(const TipContact& contact,
                                               std::shared_ptr<const HalfSpaceField> field,
                                               double share);

}  // namespace asperity
