#pragma once

#include "app/exports/Film.h"
#include "app/session/PiecesHere.h"

#include <functional>
#include <memory>

namespace asperity {

/// Draws for a thread in the background, but on the window's thread, a piece in an event.
class WindowArtist : public FilmArtist {
public:
    using Make = std::function<std::unique_ptr<FilmArtist>()>;

    /// @param make called on the window's thread; what it holds lives as long as what it makes
    /// @throw what `make` throws; Canceled
    WindowArtist(Make make, PiecesHere& pieces, const Progress& progress);
    ~WindowArtist() override;
    WindowArtist(const WindowArtist&) = delete;
    WindowArtist& operator=(const WindowArtist&) = delete;

    void foresee(const TickSample& sample) override;
    void keepScales() override;
    [[nodiscard]] RasterImage draw(const TickSample& sample, const std::string& caption) override;

private:
    /// What lives on the window's thread.
    struct Drawing {
        Make make;
        std::unique_ptr<FilmArtist> artist;
    };

    PiecesHere& pieces_;
    const Progress& progress_;
    std::shared_ptr<Drawing> drawing_;
};

}  // namespace asperity
