// SPDX-License-Identifier: Apache-2.0
// Declares the struct of a machine's state and its enumerations, as data.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "base/diagnostics/escape.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

struct Enumerator {
    std::string name;
    diagnostics::ForeignText comment;
    ir::NodeId state;        ///< the state that a machine shows at this place
    bool rests = false;      ///< whether the machine rests there
    ir::NodeId target = {};  ///< the target of the transition whose action is in progress, if any
};

struct Enumeration {
    std::string name;
    diagnostics::ForeignText comment;
    std::vector<Enumerator> values;
};

/// A member of a state struct. Structs have no padding, because members are sorted by alignment and filler members are
/// added.
struct Field {
    std::string type;
    std::string name;
    std::string initial;
    diagnostics::ForeignText comment;
    std::size_t size = 1;
    std::size_t alignment = 1;
    bool varies = false;  ///< see Extent
};

struct FrameLayout {
    std::vector<Field> fields;  ///< sorted, including filler
    std::size_t size = 0;
    std::size_t alignment = 1;
    bool varies = false;  ///< see Extent
    bool timed = false;   ///< whether some member changes with time
    bool prompt = false;  ///< whether its threads, or those of called operations, have prompt steps
    bool holds = false;  ///< whether its threads, or those of called operations, may hold up propagation to the machine
};

/// The layouts of frames by Unit::number.
using Layouts = std::map<std::size_t, FrameLayout>;

/// Sorts fields by alignment, and fills the struct up to a multiple of its alignment.
[[nodiscard]] FrameLayout arrange_fields(std::vector<Field> fields, bool timed);

}  // namespace robochart::cpp_emit
