#include "ui/view/ViewNotes.h"

#include "core/SiFormat.h"
#include "core/words/SceneWords.h"
#include "vtkplugins/pictures/Ticks.h"

#include <QObject>

namespace asperity {

namespace {

/// Words with values in place of %1, %2.
std::string filled(QString words, const std::vector<std::string>& values) {
    for (const std::string& value : values) {
        words = words.arg(QString::fromStdString(value));
    }
    return words.toStdString();
}

}  // namespace

std::vector<std::string> viewNotes(const ViewNoteFacts& facts) {
    std::vector<std::string> notes;
    if (facts.hasPerspective) {
        notes.push_back(filled(QObject::tr("perspective: lengths not to scale"), {}));
    }
    if (facts.isFromBelow) {
        notes.push_back(filled(QObject::tr("from below: hills are hollows"), {}));
    }
    if (facts.heightScale > 1.0) {
        notes.push_back(filled(QObject::tr("heights ×%1"), tickLabels({facts.heightScale})));
    }
    if (facts.missesTrueTip) {
        notes.push_back(filled(QObject::tr("true tip: the instrument does not know it"), {}));
    }
    if (facts.hidesDeformation) {
        notes.push_back(filled(QObject::tr("deformation is not drawn"), {}));
    }
    if (facts.showsLever) {
        notes.push_back(filled(QObject::tr("lever not to scale"), {}));
    }
    if (facts.showsCap) {
        notes.push_back(filled(QObject::tr("tip radius %1: only its lowest part is drawn"),
                               {formatSi(facts.tipRadius, "m")}));
    }
    if (facts.pixel > kWidePixel * facts.tipRadius) {
        notes.push_back(filled(QObject::tr("Scan pixel %1: coarse for a tip radius of %2"),
                               {formatSi(facts.pixel, "m"), formatSi(facts.tipRadius, "m")}));
    } else if (facts.pixel > kWidePixel * facts.width) {
        notes.push_back(filled(QObject::tr("Scan pixel %1: coarse for this view"),
                               {formatSi(facts.pixel, "m")}));
    }
    return notes;
}

std::string tipAboveNote(double gap) {
    return filled(QObject::tr("tip %1 above the surface"), {formatSi(gap, "m")});
}

}  // namespace asperity
