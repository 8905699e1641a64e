// SPDX-License-Identifier: Apache-2.0
// The library robochart::driver: loads RoboChart models, decides their claims in the CSP semantics, and explains the
// answers with runs of the model. The command `robochart-verify check` uses the same pipeline.
//
// The functions return errors and warnings about a model or a setting as findings. They print nothing, never end the
// program, and throw no exception except std::bad_alloc. This header needs only the standard library. docs/library.md
// has an example.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace robochart::verify {

/// A range in a file: lines and columns from 1, columns in Unicode code points, the end exclusive.
struct Place {
    std::string file;
    std::uint32_t line = 0, column = 0;
    std::uint32_t end_line = 0, end_column = 0;
};

/// The severity of a finding. A model with errors cannot be checked.
enum class Severity { note, warning, error };

/// An error, a warning or a note about a model or a setting.
struct Finding {
    Severity severity = Severity::error;
    std::string code;            ///< the code of the rule, such as "STM6"; see `robochart-verify explain CODE`
    std::string message;         ///< one sentence
    std::optional<Place> place;  ///< no value if the finding has no place in a text
};

/// A file whose text the caller gives, so that it is not read.
struct Text {
    std::string path;  ///< for messages; ends in .rct for a model, in .assertions for claims
    std::string text;
};

/// The options for loading a model and making it finite.
struct LoadOptions {
    std::map<std::string, std::string> constants;  ///< values of constants by name; literals as in the model
    /// The least and the greatest value of `nat`, `int` and `real`. The names `Seq`, `clock` and `given` set the bounds
    /// of lengths of sequences, times of clocks and elements of given types.
    std::map<std::string, std::pair<std::int64_t, std::int64_t>> ranges;
    std::vector<std::string> allowed_warnings;  ///< codes of warnings that are not reported
    bool deny_warnings = false;                 ///< a model with warnings cannot be checked
};

/// The semantics in which claims are decided. A claim may be restricted to one semantics.
enum class Semantics { both, untimed, timed };

/// The limits of one check. If a limit ends the decision of a claim, the claim is inconclusive.
struct Limits {
    double seconds = 0;                  ///< limit of the whole check; 0: no limit
    double seconds_of_claim = 0;         ///< limit of each claim; 0: no limit, and claims take turns
    std::uint64_t memory_bytes = 0;      ///< limit; 0: three quarters of the machine's memory, at most 16 GiB
    std::uint64_t states = 500'000'000;  ///< limit of each search
    unsigned threads = 0;                ///< threads of each search; 0: one for each core
};

/// Selects the claims to decide, and sets the limits.
struct CheckOptions {
    Semantics semantics = Semantics::both;
    /// Also decides the core properties of every component, such as freedom from deadlock. If the model makes no
    /// claims, the core properties are always decided.
    bool core_properties = false;
    Limits limits;
    std::function<bool()> interrupted;  ///< polled by the checking thread; the result true ends the check. May be empty
};

/// The answer to a claim.
enum class Verdict {
    holds,
    fails,
    inconclusive,  ///< a limit was reached, or the question cannot be decided; the reason says why
    no_check,      ///< the claim has no check in this semantics
    error,         ///< the claim cannot be evaluated
    not_checked,   ///< this library does not decide claims of this kind
    value,         ///< the claim asks for a value, and it was computed
};

/// A value of a machine at one moment.
struct Variable {
    std::string name;
    std::string value;
};

/// A machine at one moment.
struct Machine {
    std::string component;            ///< the instance, "P::M::ctrl_ref0::stm_ref0"
    std::string text;                 ///< "in S1"
    std::vector<std::string> states;  ///< the active states, outermost first
    std::vector<Variable> variables;  ///< the variables that may change and may still be read
};

/// One step of a run.
struct Step {
    std::string text;                  ///< "input a with 3", "t0: i -> S1", "time passes"
    std::string component;             ///< the instance that performs the step; "" if no instance does
    std::string element;               ///< the transition, statement or event of the model; "" if unknown
    std::vector<std::string> values;   ///< the communicated values
    bool hidden = false;               ///< true if the environment cannot observe the step
    bool notable = true;               ///< false if Answer::text omits the step, for example the entry of a state
    std::optional<std::int64_t> time;  ///< the time units that have passed before the step; only in the timed semantics
    std::optional<Place> place;
    std::vector<Machine> machines;  ///< all machines after the step
};

/// A run of the model that refutes a claim, or an example run that a claim asks for.
struct Run {
    bool timed = false;
    std::vector<Machine> initial;  ///< before the first step
    std::vector<Step> steps;
    std::optional<std::size_t> loop_start;  ///< index of the first step that repeats forever; no value: the run ends
    std::string end;                        ///< one sentence about the violation at the end
};

/// A fact on which a verdict depends in addition to the model, for example a bound of the finite instantiation.
struct Ground {
    std::string text;
    std::optional<Place> place;
    std::string remedy;  ///< how to avoid this dependence; "" if there is no remedy
};

/// The value that a probabilistic claim asks for, or the truth value of the bound in the claim.
struct Value {
    std::map<std::string, std::string> constants;  ///< the values of the claim's constants
    std::optional<bool> truth;                     ///< truth of a bound; no value if the claim asks for a number
    double low = 0, high = 0;                      ///< bounds of the number
    bool sampled = false;                          ///< estimated by random paths, so it is not certain
    std::string unknown;                           ///< why the value is not known; "" if it is known
};

/// The answer to one claim in one semantics.
struct Answer {
    std::string title;  ///< "A1 [timed] Pump is deadlock-free"
    std::optional<Place> place;
    Verdict verdict = Verdict::inconclusive;
    std::string reason;         ///< the reason, for verdicts that need one; "" otherwise
    std::vector<Ground> basis;  ///< facts on which the verdict depends besides the model
    std::optional<Run> run;     ///< the counterexample of a claim that fails
    std::string text;           ///< the same run as readable lines; "" if there is no run
    std::vector<Value> values;  ///< the values that a probabilistic claim asks for
    bool information = false;   ///< true for an informative core property: none of its answers indicates a problem
    std::uint64_t states = 0, transitions = 0;
    double seconds = 0;
};

/// The result of a check.
struct CheckResult {
    std::vector<Answer> answers;
    std::vector<Finding> findings;  ///< findings about the check itself, for example about unknown claims
    std::string limit;              ///< why the check ended early; "" if it did not

    /// Returns true if three conditions hold: at least one claim holds or has a value; every other claim holds, has a
    /// value or has no check in this semantics; and no finding is an error. Informative answers are ignored.
    [[nodiscard]] bool all_hold() const;
};

/// A claim of a model.
struct Claim {
    std::string name;
    std::optional<Place> place;
};

struct LoadResult;

/// A loaded model. Moving a Model is cheap. Several threads must not use one object at the same time.
class Model {
public:
    Model(Model&&) noexcept;
    Model& operator=(Model&&) noexcept;
    ~Model();

    /// Returns the claims in the order of the assertion files, including claims with errors.
    [[nodiscard]] const std::vector<Claim>& claims() const;
    /// Decides all claims.
    [[nodiscard]] CheckResult check(const CheckOptions& = {});
    /// Decides the claims that the words select: a name, a number (from 1), a range of numbers (`3..5`) or a pattern
    /// (`Safe*`). If a word selects no claim, the result contains a finding and no claim is decided.
    [[nodiscard]] CheckResult check(const std::vector<std::string>& words, const CheckOptions& = {});

private:
    struct Impl;
    friend struct Loader;
    explicit Model(std::unique_ptr<Impl>);
    std::unique_ptr<Impl> impl_;
};

/// A model, and the findings of loading it.
struct LoadResult {
    std::optional<Model> model;     ///< no value if errors prevent every check
    std::vector<Finding> findings;  ///< errors and warnings, by file and place
    std::string text;               ///< the findings as readable text, with excerpts of the files; "" if there are none
};

/// Loads files or folders in the same way as the command. If a file is a model, also loads the files in the same folder
/// that this model needs. Files that do not belong together are checked as separate models.
[[nodiscard]] LoadResult load_files(const std::vector<std::string>& paths, const LoadOptions& = {});
/// Loads a model from the given texts. Reads no files except the files of SLEEC rules that a claim names.
[[nodiscard]] LoadResult load_texts(const std::vector<Text>& texts, const LoadOptions& = {});

/// Returns "holds", "fails", "inconclusive", "no check", "error", "not checked" or "value".
[[nodiscard]] std::string_view name_of(Verdict);
/// Returns the version of the library, "0.1.0".
[[nodiscard]] std::string_view version();

}  // namespace robochart::verify
