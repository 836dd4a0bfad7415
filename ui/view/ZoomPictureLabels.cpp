// What is written over the large view.
#include "core/scene/Scene.h"
#include "ui/view/ForceScale.h"
#include "ui/view/ViewNotes.h"
#include "ui/view/ZoomPicture.h"

namespace asperity {

void ZoomPicture::showLabels(const ViewCamera& camera, double height, double pixelRatio) {
    if (!frame_) {
        labels_.hide();
        return;
    }
    labels_.setPixelRatio(pixelRatio);
    LabelContent content{.scaleBars = options_.scaleBars && !camera.hasPerspective(),
                         .metersPerPixel = metersPerPixel(height),
                         .heightPerPixel =
                             metersPerPixel(height) / (options_.heightScale * camera.heightSeen())};
    if (options_.labels) {
        content.notes = notes(camera);
        content.tipAbove = tipAbove(height, pixelRatio);
        content.force = writtenForce();
        content.forceEnd = force_.end();
        content.names = ghosts_.names();
        if (const auto target = target_.name()) {
            content.names.push_back(*target);
        }
        content.markers = markers_.names();
        content.reading = crossHair_ ? reading_.toStdString() : std::string();
        content.caption = caption_;
    }
    if (options_.axes) {
        content.axes = FrameAxes{.window = terrain_.place().window,
                                 .bottom = options_.heightScale * terrain_.bottom(),
                                 .toEye = camera.out()};
    }
    labels_.show(content);
}

std::string ZoomPicture::writtenForce() const {
    if (!writtenForce_.empty() || !sample_) {
        return writtenForce_;
    }
    return magnitudeText(sample_->output.estimate.force);
}

std::vector<std::string> ZoomPicture::notes(const ViewCamera& camera) const {
    return viewNotes({.heightScale = options_.heightScale,
                      .hasPerspective = camera.hasPerspective(),
                      .isFromBelow = camera.out().z() < 0.0,
                      .missesTrueTip = options_.trueTip && sample_ && !trueTip_,
                      .hidesDeformation = !options_.deformation,
                      .showsLever = gear().showsLever(),
                      .showsCap = gear().isCap(),
                      .tipRadius = scene_->belief.tipRadius(),
                      .pixel = scale_.pixel,
                      .width = 2.0 * frame_->halfWidth()});
}

std::string ZoomPicture::tipAbove(double height, double pixelRatio) const {
    if (shape_ == nullptr || drawnPlace(apexOf(shape_->contact())).y() < pixelRatio * height) {
        return {};
    }
    return tipAboveNote(-sample_->output.model.contact.indentation);
}

}  // namespace asperity
