// SPDX-License-Identifier: Apache-2.0
// Writes the functions that visit all values in the carrier of a type. Quantifiers and comprehensions use them.
#include "cpp_emit/code/carriers.hpp"

#include <fmt/format.h>

#include "cpp_emit/plan/types.hpp"
#include "semantics/evaluate/carrier.hpp"

namespace robochart::cpp_emit {

void write_carriers(const Generation& generation, CodeWriter& out) {
    for (const CarrierUse& use : generation.component.carriers) {
        std::vector<std::string> values;
        for (const ir::Value& value : ir::carrier_values(generation.system, generation.inst, use.type))
            values.push_back(cpp_value(generation.system, generation.inst, use.type, value));
        const std::string type = cpp_type(generation.system, use.type);
        out.gap();
        out.doc(fmt::format("Visits the values of {}, as the model was made finite, until one is accepted.",
                            generation.system.type(use.type).name));
        out.line("template <class Visit>");
        out.open(fmt::format("static bool {}(Visit visit) noexcept {{", use.method));
        out.open(fmt::format("const {} values[] = {{", type));
        for (const std::string& value : values) out.line(value + ",");
        out.close("};");
        out.line(fmt::format("for (const {}& value : values)", type));
        out.line("    if (visit(value)) return true;");
        out.line("return false;");
        out.close();
    }
}

}  // namespace robochart::cpp_emit
