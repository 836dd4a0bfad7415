#include "tests/app/window/study/ShortStudy.h"

#include "core/Units.h"
#include "core/io/experiment/StudyFile.h"
#include "tests/core/experiment/SmallStudy.h"

namespace asperity::test {

Study shortStudy() {
    Study study = smallStudy();
    study.materials = {study.materials.at(1)};
    study.tasks = {{TaskKind::On, 0.0, 0.0, {0}}};
    study.targets = {{20.0_nm, 10.0_nm}};
    study.training = 0.0;
    return study;
}

std::filesystem::path writtenStudy(ScratchFolder& folder, const Study& study) {
    const std::filesystem::path position = folder.path() / "study";
    std::filesystem::create_directories(position);
    writeStudy(study, position);
    return position / "study.toml";
}

}  // namespace asperity::test
