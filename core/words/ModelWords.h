#pragma once

#include "core/contact/laws/ContactModel.h"
#include "core/deformation/HalfSpaceModel.h"
#include "core/fidelity/RequiredTerms.h"

#include <string>

namespace asperity {

/// Returns the name of a model of the force: "Maugis-Dugdale, table, certified closest points,
/// without friction".
[[nodiscard]] std::string nameOf(const ForceModelOptions& options);

/// Returns why a contact law was taken, in one clause.
[[nodiscard]] std::string whyOf(const LawChoice& choice);

/// The scene's contact law, why it was taken, and how well its table has it.
[[nodiscard]] std::string lawNote(const Scene& scene);

/// The half-space's own force beside the law's, or why its answer is not used, in one sentence.
[[nodiscard]] std::string sentenceOf(const HalfSpaceAnswer& answer);

/// Returns why a term of a scene's model is worth what it is, in one clause with the quantity that
/// decides; of one that matters and is not in also what took its place. @param need one of the
/// scene's
[[nodiscard]] std::string whyOf(const TermNeed& need, const RequiredTerms& needs);

/// Returns why a term cannot be in at all, see TermNeed::possible, in one clause.
[[nodiscard]] const char* whyImpossible(ModelTerm term) noexcept;

/// The error of what a user reads, by the quantity that is worst, and what makes it up, in one
/// clause: "within 5.4 % (pull-off force): 0.2 % by omitted terms, 5.2 % by terms that no contact
/// law combines (sphere correction)".
[[nodiscard]] std::string modelErrorText(const RequiredTerms& needs);

/// The same with the terms that the model leaves out, but for those its law has no room for: they
/// are told with the error.
[[nodiscard]] std::string modelNote(const RequiredTerms& needs);

}  // namespace asperity
