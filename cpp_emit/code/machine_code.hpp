// The code of one machine: enumerations of its places, the struct of its state, and its functions
// (control, during actions, transitions, time), as text to be assembled by core_file.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "cpp_emit/code/machine_plan.hpp"
#include "cpp_emit/code/resumable_code.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

struct Enumerator {
    std::string name;
    diagnostics::ForeignText comment;
    ir::NodeId state;  ///< places of a machine: the state it shows to be in
};

struct Enumeration {
    std::string name;
    diagnostics::ForeignText comment;
    std::vector<Enumerator> values;
};

/// A member of a state struct. Structs have no padding: members are sorted by alignment, the rest is filled.
struct Field {
    std::string type;
    std::string name;
    std::string initial;
    diagnostics::ForeignText comment;
    std::size_t size = 1;
    std::size_t alignment = 1;
};

struct FrameLayout {
    std::vector<Field> fields;  ///< sorted, filler included
    std::size_t size = 0;
    std::size_t alignment = 1;
    bool timed = false;  ///< something in it changes with time
};

struct MachineCode {
    std::vector<Enumeration> enumerations;
    FrameLayout layout;
    std::string methods;           ///< members of Step
    std::string dispatch;          ///< Step::dispatch of a machine whose programs never wait; "" for others
    std::vector<SendSite> sites;   ///< where its threads wait to send
    std::vector<CallFrame> calls;  ///< operations its threads run
};

/// By Unit::number.
using Layouts = std::map<std::size_t, FrameLayout>;

/// `done` holds the layouts of the operations that the unit calls, `type_names` is the scope of the core's namespace,
/// `more` are further members of the state.
[[nodiscard]] MachineCode generate(const Generation&, const Unit&, const Layouts& done, NameScope& type_names,
                                   const std::vector<Field>& more);

/// Sorts fields by alignment and fills the struct up to a multiple of its alignment.
[[nodiscard]] FrameLayout arrange(std::vector<Field> fields, bool timed);

}  // namespace robochart::cpp_emit
