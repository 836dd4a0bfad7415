#pragma once

#include <QPainter>
#include <QPointF>

#include <functional>
#include <memory>
#include <vector>

namespace asperity {

/// Something on a sheet that is never cut. Lengths are those of the device.
struct PdfPiece {
    double space = 0.0;  ///< to what is above it, but not at the top of a sheet
    double height = 0.0;
    bool keepsNext = false;  ///< the next one is on the same sheet
    std::function<void(QPainter& painter, const QPointF& corner)> draw;
    std::shared_ptr<const PdfPiece> head = nullptr;  ///< drawn above it at the top of a sheet
};

/// A piece with its place on a sheet.
struct PlacedPiece {
    double y = 0.0;  ///< of its upper edge, below the margin
    const PdfPiece* piece = nullptr;
};

/// The sheets that the pieces fill, in order. @param height of a sheet between its margins
[[nodiscard]] std::vector<std::vector<PlacedPiece>> onSheets(const std::vector<PdfPiece>& pieces,
                                                             double height);

}  // namespace asperity
