// The struct of a machine's state and its enumerations, as data.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "diagnostics/escape.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

struct Enumerator {
    std::string name;
    diagnostics::ForeignText comment;
    ir::NodeId state;        ///< places of a machine: the state it shows to be in
    bool rests = false;      ///< it is at rest there
    ir::NodeId target = {};  ///< where the transition leads whose action is in progress, if one is
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
    bool timed = false;   ///< something in it changes with time
    bool prompt = false;  ///< its threads have prompt steps, or those of operations in it
    bool holds = false;   ///< its threads may hold up what is propagated to the machine, or those of operations in it
};

/// By Unit::number.
using Layouts = std::map<std::size_t, FrameLayout>;

/// Sorts fields by alignment and fills the struct up to a multiple of its alignment.
[[nodiscard]] FrameLayout arrange(std::vector<Field> fields, bool timed);

}  // namespace robochart::cpp_emit
