// SPDX-License-Identifier: Apache-2.0
// Finds the events of a component's script that a claim distinguishes.
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "checker/cspm/syntax/syntax.hpp"
#include "claims/monitor/monitor.hpp"
#include "csp_emit/base/emission.hpp"
#include "csp_emit/base/shown.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::claims {

/// Thrown if a claim cannot be decided; the text contains the reason.
struct NotDecided : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Maps the paths of machines to the facts that they show, in the order of the values of `shown__`.
using ShownFacts = std::map<std::string, std::vector<Fact>>;

/// Adds the facts of the claim.
void add_facts(const CheckedClaim& claim, ShownFacts& shown);
/// Throws NotDecided if the script has no expression for a fact.
void require_facts(const CheckedClaim& claim, const ir::System& system, const ir::Instantiation& instantiation);
/// Returns the facts in the form that the emission of the script needs.
[[nodiscard]] csp_emit::Shown emitted_facts(const ShownFacts& shown, const ir::System& system,
                                            const ir::Instantiation& instantiation);

/// A class of events that the claim does not distinguish. They are the events of one channel with some or all values,
/// or the events by which a machine shows the same truth values of the claim's facts.
struct Letter {
    Occurrence occurrence;
    std::vector<FactValue> facts;     ///< if not empty, a machine shows these facts instead of an event
    std::vector<std::string> events;  ///< "P::M::goToCall.3"; events of the script are equal or continue it with '.'
    std::vector<cspm::ExprPtr> prefixes;  ///< the same events as expressions
    std::string name;                     ///< name of the event in the model
};

/// Returns the reason why the events of a run do not show whether the run breaks the claim; "" if they do.
[[nodiscard]] std::string why_not_followed(const CheckedClaim& claim);
/// Like why_not_followed, but for monitors, which do not decide claims about control cycles.
[[nodiscard]] std::string why_not_monitored(const CheckedClaim& claim);

/// Returns the letters of the channels that the claim names, sorted by channel and values, and the letters of its
/// facts. Throws NotDecided if a condition is about values that the instantiation does not list.
[[nodiscard]] std::vector<Letter> letters_of(const CheckedClaim& claim, const ir::System& system,
                                             const ir::Instantiation& instantiation, const ShownFacts& shown);
/// Returns the channel by which a machine shows facts.
[[nodiscard]] std::string shown_channel(const std::string& machine);
/// Returns the channels by which the machines of the component show facts.
[[nodiscard]] std::vector<cspm::ExprPtr> channels_of_facts(const CheckedClaim& claim);

/// Throws NotDecided if the script does not have the channel of a letter.
void require_channels(const CheckedClaim& claim, const std::vector<Letter>& letters,
                      const csp_emit::Provenance& provenance);

/// Returns the letter of an event of the script; null if the claim does not name the event.
[[nodiscard]] const Letter* find_letter(const std::vector<Letter>& letters, const std::string& event);
/// Returns the event as readable text: "goTo(3)".
[[nodiscard]] std::string text_of(const Letter& letter, const CheckedClaim& claim, const std::string& event);

/// Returns the parts of the claim whose conditions no value of the instantiation satisfies. Ignores conditions on last
/// values.
[[nodiscard]] std::vector<const EventMatch*> matches_without_value(const CheckedClaim& claim,
                                                                   const std::vector<Letter>& letters);

/// Returns all sets of events of the claim.
[[nodiscard]] std::vector<const Events*> sets_of(const CheckedClaim& claim);

}  // namespace robochart::claims
