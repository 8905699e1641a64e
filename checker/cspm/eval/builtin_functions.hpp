// SPDX-License-Identifier: Apache-2.0
// Implements predefined functions (FDR manual, chapter CSPM, Built-In Definitions). ByNeed::call implements the others,
// which evaluate an argument only as far as they need it (takes_by_need).
#pragma once

#include "checker/cspm/eval/process_terms.hpp"
#include "checker/cspm/types/builtins.hpp"

namespace robochart::cspm {

/// Calls predefined functions with evaluated arguments. This class has no state.
class BuiltinFunctions {
public:
    BuiltinFunctions(const Program& program, ValueStore& store, process::EventTable& events, process::TermStore& terms,
                     const Work& work, Domains& domains, ProcessTerms& processes)
        : store_(store),
          events_(events),
          terms_(terms),
          work_(work),
          domains_(domains),
          processes_(processes),
          text_(program) {}

    /// Returns the value of a predefined name. `timed`: the timed section in which it occurs, or null.
    Value value(Builtin which, const TimedSection* timed);
    Value call(Value builtin, Values arguments, Span span);
    void check_arity(Builtin which, std::size_t arguments, Span span) const;

private:
    const Values& items(Value sequence, Span span) const;
    Value with_text(Value value, Span span);
    Value set_builtin(Builtin which, const Values& arguments, Span span);
    Value process_builtin(Builtin which, Value builtin, const Values& arguments, Span span);
    process::RenamingId partial_order(const Values& arguments, Span span);
    process::TermId buffer(const Values& arguments, Span span);
    Value representatives(Value relation, Value set, Span span);
    Value relation_builtin(Builtin which, const Values& arguments, Span span);

    ValueStore& store_;
    process::EventTable& events_;
    process::TermStore& terms_;
    const Work& work_;
    Domains& domains_;
    ProcessTerms& processes_;
    ValueText text_;
};

}  // namespace robochart::cspm
