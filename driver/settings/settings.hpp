// SPDX-License-Identifier: Apache-2.0
// Defines the settings for processing a model, with one struct for each phase. Each phase gets only the settings that
// it needs. services.hpp defines the services that a run provides to all phases (budget, cache, progress).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace robochart::driver {

/// The use that a command makes of a model's claims.
enum class ClaimUse {
    decide,  ///< claims are decided; without claims, the core properties are decided
    write,   ///< claims are written to scripts
    read,    ///< claims are only read with the model
    ignore,  ///< claims are not used, so assertion files with errors are ignored
};

/// A file whose text is given, so that it is not read.
struct TextInput {
    std::string path;  ///< for messages; its ending distinguishes models (.rct) from assertions (.assertions)
    std::string text;
};

/// Settings for reading files: the files, and the findings that reject them.
struct LoadSettings {
    std::vector<std::string> inputs;   ///< files or folders
    std::vector<TextInput> texts;      ///< texts of the project; if there are any, `inputs` only names the project
    std::vector<std::string> allowed;  ///< codes of warnings to suppress
    bool deny_warnings = false;        ///< treats warnings as errors
    std::string component;             ///< the only module, controller or machine that is used; "": all components
    ClaimUse claims = ClaimUse::decide;
    bool robosim = false;             ///< the command also handles components of RoboSim
    bool split_broken_claims = true;  ///< claims are decided even if other claims have errors
};

/// Settings for the finite instantiation.
struct InstantiationSettings {
    std::vector<std::string> constants;  ///< NAME=VALUE
    /// NAME=VALUE from a scenario, a swarm or a log. These values apply to constants that `constants` does not set.
    std::vector<std::string> weaker_constants;
    std::vector<std::string> ranges;  ///< TYPE=LOW..HIGH
};

/// A swarm whose claims replace those of the model.
struct SwarmSettings {
    std::string file;          ///< "": no swarm
    std::uint32_t robots = 0;  ///< number of robots; 0: the number in the file
    std::string grid;          ///< WIDTHxHEIGHT, overrides the file unless ""
};

/// The semantics that are checked.
enum class Times { both, timed, untimed };

/// Settings for the selection of claims.
struct ClaimSettings {
    std::vector<std::string> names;  ///< selected claims (claim_selection.hpp); if empty: all, or only `core_names`
    /// Selected core properties (core_name()). If the list is empty and `core` is true, all core properties are
    /// selected.
    std::vector<std::string> core_names;
    Times times = Times::both;
    bool core = false;      ///< also checks the core properties of every component
    bool sizes = false;     ///< also counts the states of the components' processes
    bool concrete = false;  ///< decides claims in the finite instantiation; otherwise, classes of values replace data
    std::string certificates;  ///< folder for certificates of claims that hold; "": none
};

/// The Markov models on which probabilistic claims are decided.
enum class Encoding {
    csp,      ///< decision processes from the timed CSP semantics
    robotool  ///< RoboTool's Markov chains
};

/// The scheduler that resolves the choices of a decision process.
enum class Scheduler {
    any,     ///< best and worst case
    urgent,  ///< internal steps before inputs and time
    uniform  ///< all choices are equally likely
};

/// Settings for probabilistic claims.
struct ProbabilitySettings {
    Encoding encoding = Encoding::csp;
    Scheduler scheduler = Scheduler::any;
    bool exact = false;       ///< computes exact fractions instead of intervals
    double epsilon = 1e-6;    ///< relative width of intervals
    std::uint64_t seed = 0;   ///< seed of random paths
    std::string preferences;  ///< RoboTool's file with ranges; if "": --range, or the defaults
};

/// The limits of a run, and of each claim in it.
struct LimitSettings {
    std::uint64_t memory_bytes = 0;  ///< 0: `default_memory`
    double timeout_seconds = 0;      ///< limit of the whole run; 0: no limit
    double assertion_seconds = 0;    ///< limit of each claim; 0: no limit
    std::uint64_t max_states = 500'000'000;
    bool reduction = true;  ///< skips states whose only steps are confluent taus
    unsigned threads = 0;   ///< 0: one per core
    bool progress = true;   ///< the progress of searches is reported
};

/// The settings of all phases.
struct Settings {
    LoadSettings load;
    InstantiationSettings instantiation;
    SwarmSettings swarm;
    ClaimSettings claims;
    ProbabilitySettings probability;
    LimitSettings limits;
};

}  // namespace robochart::driver
