#pragma once

#include "core/Vector.h"
#include "core/surface/closest/BoundsWindow.h"
#include "core/surface/closest/Box.h"
#include "core/surface/closest/PartFacts.h"

#include <array>
#include <bit>
#include <boost/container/static_vector.hpp>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace asperity {

/// Some cells around a position.
class CellSet {
public:
    static constexpr int kSide = BoundsWindow::kMaxBlocks;  ///< no more rows or columns

    /// @param first the lowest row and column there can be
    explicit CellSet(const CellIndex& first) noexcept : first_(first) {}

    void add(const CellIndex& cell) noexcept { rows_[rowOf(cell)] |= bitOf(cell); }
    void remove(const CellIndex& cell) noexcept { rows_[rowOf(cell)] &= ~bitOf(cell); }
    [[nodiscard]] bool holds(const CellIndex& cell) const noexcept {
        return inRange(cell.row - first_.row) && inRange(cell.column - first_.column) &&
               (rows_[rowOf(cell)] & bitOf(cell)) != 0;
    }
    /// Calls take(CellIndex) for each.
    template <class Take>
    void forEach(const Take& take) const {
        for (int row = 0; row < kSide; ++row) {
            for (BoundsWindow::Bits left = rows_[static_cast<std::size_t>(row)]; left != 0;
                 left &= left - 1) {
                take(CellIndex{.row = first_.row + row,
                               .column = first_.column + std::countr_zero(left)});
            }
        }
    }

private:
    static bool inRange(int offset) noexcept { return offset >= 0 && offset < kSide; }
    [[nodiscard]] std::size_t rowOf(const CellIndex& cell) const noexcept {
        return static_cast<std::size_t>(cell.row - first_.row);
    }
    [[nodiscard]] BoundsWindow::Bits bitOf(const CellIndex& cell) const noexcept {
        return BoundsWindow::Bits{1} << static_cast<unsigned>(cell.column - first_.column);
    }

    CellIndex first_;
    std::array<BoundsWindow::Bits, kSide> rows_{};
};

/// Parts of cells in which queries may have closest points, and for how far around a query that was
/// asked each of them surely holds none: by how much the query may move until it is to be looked at
/// again. Allocation-free.
class KnownParts {
public:
    /// Around a tip of 17 pixels on a measured sample 600 are kept.
    static constexpr std::size_t kMaxParts = 1024;
    /// Parts that are asked at a time: as many as there are lanes.
    static constexpr std::size_t kGroup = PartBatch::kLanes;
    using Quarters = std::array<std::size_t, kGroup>;

    /// Keeps the parts of these cells and of no others, with what is known of them. @return whether
    /// there was space for all
    /// @param near some position near the queries [m]
    bool keepCells(CellSet cells, const Vector3& near) noexcept;

    [[nodiscard]] std::size_t size() const noexcept { return parts_.size(); }
    [[nodiscard]] bool empty() const noexcept { return parts_.empty(); }
    [[nodiscard]] const CellPart& at(std::size_t part) const noexcept { return parts_[part].part; }

    using Indices = boost::container::static_vector<std::uint16_t, kMaxParts>;
    /// Returns the parts that may hold a closest point of a query within a distance [m].
    [[nodiscard]] Indices due(const Vector3& query, double distance) const noexcept;
    /// Returns whether a part surely holds no more than one minimum of a query's distance.
    [[nodiscard]] bool isConvex(std::size_t part, const Vector3& query) const noexcept;

    /// Notes the facts that a look at a part found, those in a lane.
    void note(std::size_t part, const Vector3& query, const PartFacts& facts, int lane) noexcept;
    /// Puts the quarters of a part in its place. @return where; none: no room
    [[nodiscard]] std::optional<Quarters> split(std::size_t part) noexcept;

private:
    /// Planes beyond which four parts lie: no nearer to a query than `offset` less the product of
    /// `way`, a unit vector, and the query's position.
    struct Planes {
        std::array<double, kGroup> wayX{};
        std::array<double, kGroup> wayY{};
        std::array<double, kGroup> wayZ{};
        std::array<double, kGroup> offset{};  ///< [m]

        void set(std::size_t lane, const Vector3& way, double at) noexcept;
        void copy(std::size_t lane, const Planes& from, std::size_t fromLane) noexcept;
    };
    /// Further facts known of a part.
    struct Known {
        CellPart part;
        Vector3 query = Vector3::Zero();  ///< that was asked
        double distance = 0.0;            ///< no position is nearer to it [m]
        double calm = 0.0;                ///< how far it may move with no minimum in the part [m]
        double convexFor = 0.0;           ///< how far it may move with one at most [m]
    };

    /// Bits of each group, one for each part.
    using Lanes = std::array<std::uint8_t, kMaxParts / kGroup>;
    /// Finds the parts that do not lie beyond their planes.
    static void findNear(std::span<const Planes> planes, const Vector3& point, double distance,
                         Lanes& near) noexcept;

    void push(const Known& known) noexcept;
    void copy(std::size_t to, std::size_t from) noexcept;
    void shrink(std::size_t size) noexcept;
    [[nodiscard]] Planes& planesOf(std::size_t part) noexcept { return planes_[part / kGroup]; }

    Vector3 origin_ = Vector3::Zero();  ///< of the planes' positions, world [m]
    int turn_ = 0;                      ///< whose cells are started again
    boost::container::static_vector<Planes, kMaxParts / kGroup> planes_;
    boost::container::static_vector<Known, kMaxParts> parts_;
};

}  // namespace asperity
