#pragma once

#include "core/contact/laws/ContactModel.h"
#include "core/scene/SceneDescription.h"

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace asperity {

/// What a user asks `asperity curve` for; empty or zero: as the scene, or the default scene,
/// says.
struct CurveRequest {
    std::string scene;
    std::vector<std::string> materials;  ///< files, or names of files in the data folder
    std::string law;
    double radius = 0.0;     ///< [m]
    double stiffness = 0.0;  ///< along the normal [N/m]
    double modulus = 0.0;    ///< reduced, of tip and sample [Pa]
};

/// One curve to be made.
struct CurveCase {
    SceneDescription scene;  ///< with the material
    SampleMaterial material;
    ContactModel model;
    double compliance = 0.0;  ///< along the normal [m/N]
    std::string why;          ///< why this law
};

/// The options that make up a request.
void addCurveRequest(CLI::App& command, CurveRequest& request);

/// One case a material. Where `auto` takes another law than Maugis-Dugdale with its tail, that one
/// follows for comparison. @throw InputError for files that cannot be read, Error for values out of
/// range
[[nodiscard]] std::vector<CurveCase> curveCases(const CurveRequest& request);

}  // namespace asperity
