#include "app/session/WindowArtist.h"

#include <utility>

namespace asperity {

WindowArtist::WindowArtist(Make make, PiecesHere& pieces, const Progress& progress)
    : pieces_(pieces)
    , progress_(progress)
    , drawing_(std::make_shared<Drawing>(Drawing{std::move(make), nullptr})) {
    pieces_.run([this] { drawing_->artist = drawing_->make(); }, progress_);
}

WindowArtist::~WindowArtist() {
    pieces_.later([drawing = std::move(drawing_)] {});
}

void WindowArtist::foresee(const TickSample& sample) {
    pieces_.run([&] { drawing_->artist->foresee(sample); }, progress_);
}

void WindowArtist::keepScales() {
    pieces_.run([this] { drawing_->artist->keepScales(); }, progress_);
}

RasterImage WindowArtist::draw(const TickSample& sample, const std::string& caption) {
    RasterImage image;
    pieces_.run([&] { image = drawing_->artist->draw(sample, caption); }, progress_);
    return image;
}

}  // namespace asperity
