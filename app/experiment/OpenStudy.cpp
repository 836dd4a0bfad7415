#include "app/experiment/OpenStudy.h"

#include "core/Error.h"

#include <utility>

namespace asperity {

namespace {

Study requireForPeople(Study study) {
    if (!study.aids.coupling) {
        throw Error("[aids] coupling = false: without a coupling a study is for the operator model "
                    "only, see asperity experiment");
    }
    return study;
}

}  // namespace

OpenStudy::OpenStudy(Study wanted, const std::filesystem::path& out, int participant,
                     Progress* progress)
    : study(requireForPeople(std::move(wanted)))
    , scenes(study, progress)
    , folder(out, study, holdsStudy(out) ? FolderUse::Resume : FolderUse::New)
    , person(folder, participant) {}

}  // namespace asperity
