// SPDX-License-Identifier: Apache-2.0
// Defines the answers to the claims of a model or a script, as data.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "checker/refine/verdict/check.hpp"
#include "counterexample/run.hpp"
#include "driver/results/basis.hpp"
#include "prism/assertions/experiments/experiment.hpp"
#include "semantics/data/class_model.hpp"

namespace robochart::driver {

/// The answer to one assertion.
enum class Answer {
    holds,
    fails,
    inconclusive,
    no_check,   ///< the claim has no check in this semantics, so the report does not call it true
    error,      ///< the claim could not be evaluated because of wrong input
    unchecked,  ///< the program does not decide claims of this kind
    computed,   ///< a value was requested and computed
};

/// Returns the answer for data formats: "holds", "fails".
[[nodiscard]] std::string_view name_of(Answer);
/// Returns the answer for readable reports: "holds", "FAILS".
[[nodiscard]] std::string_view answer_word(Answer);

/// The reason for claims that were not yet examined when a limit was reached.
inline constexpr const char* undecided_at_limit = "it was not decided before the limit";

/// Additional data of an assertion that is a core property, which is checked for every component.
struct CoreReport {
    std::string component;     ///< "state machine P::S"
    std::string property;      ///< "deadlock-free"
    bool information = false;  ///< informative only: neither a false nor an unknown answer is a problem
    /// For properties about elements that runs exercise: the transitions or states of the resolved model that the
    /// property covers.
    std::vector<std::string> elements = {};
    std::vector<std::string> unexercised = {};  ///< the elements that no run exercises
};

/// A text that is printed with a counterexample if the counterexample may not be a shortest one.
inline constexpr const char* not_shortest = "the run may not be a shortest one: a limit ended the search for it";

/// The model that decided a probabilistic assertion, and the result for each combination of values of its constants.
struct ProbabilityReport {
    std::string encoding;   ///< "robotool"
    std::string scheduler;  ///< "any", "urgent", "uniform"; "" if the encoding has no choices
    std::vector<probability::Row> rows;
};

/// The result of robochart-certify for certificates.
enum class Certification {
    unchecked,  ///< robochart-certify was not run, or did not decide
    certified,
    refused,
};

/// The certificates of a claim that holds (docs/certificates.md). A claim may consist of several assertions.
struct CertificateReport {
    std::vector<std::string> folders;
    std::string reason;   ///< why there is no certificate, or why the certificates are not certified
    bool failed = false;  ///< a certificate could not be written, or is refused
    Certification certification = Certification::unchecked;
    std::uint64_t pairs = 0;       ///< the pairs that robochart-certify has checked
    std::uint64_t components = 0;  ///< the number of components of the implementations
    std::string level{};           ///< "term", or "product" if one of the certificates is at the product level
    std::string why_product{};     ///< why a certificate is not at the term level; "" if all of them are
    std::string reduction{};       ///< "confluent taus", "symmetry", both joined by "and"; "" if unreduced
};

/// One assertion with its answer.
struct AssertionReport {
    std::string title;  ///< "A1 [timed] AggregationFSM is deadlock-free"
    std::string name;   ///< the name for --assertion: "A1", "P::S: deadlock-free"; "" if it has none
    std::string place;  ///< "aggregation.assertions:12"
    /// The place with its end. For a core property without a place, the declaration of the component.
    std::optional<runs::Place> region;
    std::optional<CoreReport> core;                ///< no value: an assertion of the model or the script
    std::optional<ProbabilityReport> probability;  ///< for probabilistic assertions
    Answer answer = Answer::inconclusive;
    std::string reason;  ///< set for inconclusive, no_check and error
    Basis basis;         ///< the basis of the answer, apart from the model
    refine::Statistics statistics;
    /// True if this run computed at least a part of the answer. False if the whole answer comes from the cache.
    bool searched = false;
    std::optional<CertificateReport> certificate;  ///< no value if none was requested, or if the claim does not hold
    std::optional<runs::Run> run;                  ///< the counterexample of a model
    std::string counterexample;                    ///< the counterexample of a script, as text
};

/// Sets the place of a claim.
void set_place(const diagnostics::SourceManager&, diagnostics::Span, AssertionReport&);

/// A place where the finite instantiation limited a value while assertions were checked.
struct BoundReport {
    std::string element;  ///< "P::S::t1", preceded by the name of the part if there are several parts
    std::string place;    ///< "model.rct:12"
    std::string text;     ///< the expression and how it was limited
    std::string time;     ///< "untimed", "timed", or both
};

/// The sizes of a component's processes. If a limit ended the exploration, these are the sizes of the explored parts.
struct SizeReport {
    struct Size {
        std::size_t states = 0;
        std::size_t transitions = 0;
        bool whole = true;
    };
    std::string component;  ///< "P::C::stm_ref0"
    std::string time;       ///< "untimed", "timed"
    Size process;           ///< D__
    Size compressed;        ///< O__
};

/// Data that keep the carriers of the finite instantiation.
struct KeptDataReport {
    std::vector<std::string> places;  ///< names of variables, events and parameters, ascending
    std::string reason;               ///< why the data keep their carriers, without a place
    std::string place;                ///< place of the reason, "model.rct:12"; "" if it has none
};

/// The answers to the claims, and further data found by the check.
struct ClaimResults {
    std::vector<AssertionReport> assertions;
    std::vector<BoundReport> bounds;
    std::vector<SizeReport> sizes;
    std::vector<std::string> remarks;
    std::vector<ir::ReplacedData> data;  ///< data that classes replace in the claims
    std::vector<KeptDataReport> kept_data;
};

}  // namespace robochart::driver
