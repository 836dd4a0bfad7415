#pragma once

#include <map>
#include <string>

namespace asperity {

/// What the note of an Asylum Research wave says, by key.
/// @param note `key: value` lines that end with CR; of several with one key the first one counts
[[nodiscard]] std::map<std::string, std::string> parseAsylumNote(const std::string& note);

/// Whether a label names an image of an Asylum instrument: "HeightTrace", "PhaseRetraceMod1".
[[nodiscard]] bool isAsylumLabel(const std::string& label);

/// The unit of a channel, whose numbers are in SI units: what the note says ("UserIn0Unit"), else
/// by its name; empty when neither is known.
/// @param label "HeightTrace", "NapPhase2Retrace", "UserIn0TraceMod1"
[[nodiscard]] std::string asylumUnit(const std::string& label,
                                     const std::map<std::string, std::string>& note);

}  // namespace asperity
