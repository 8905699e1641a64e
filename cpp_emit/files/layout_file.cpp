// SPDX-License-Identifier: Apache-2.0
// Writes information about a generated controller for tools: a table with the layout of its state, and the names of
// places. For compilers that support concepts, also writes the platform as a concept.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cassert>

#include "cpp_emit/files/files.hpp"
#include "cpp_emit/plan/types.hpp"

namespace robochart::cpp_emit {

namespace {

class LayoutWriter {
public:
    LayoutWriter(const Generation& generation, const Core& core) : generation_(generation), core_(core) {}

    std::string write() {
        file_comment(generation_, out_, "Layout of the state");
        out_.comment("For printing, hashing and tools; the controller does not need it.");
        out_.line("#pragma once");
        out_.gap();
        out_.line("#include <cstddef>");
        out_.line("#include <type_traits>");
        out_.gap();
        out_.line(fmt::format("#include \"{}\"", core_.header));
        out_.line("#include \"robochart/layout.hpp\"");
        out_.gap();
        out_.line(fmt::format("namespace {} {{", core_.name_space));
        out_.gap();
        write_table();
        for (const MachineCode& machine : core_.machines)
            for (const Enumeration& enumeration : machine.enumerations) write_names(enumeration);
        out_.gap();
        out_.line(fmt::format("}}  // namespace {}", core_.name_space));
        return out_.text();
    }

private:
    void write_table() {
        out_.doc("Every member of State, with those of the frames in it.");
        out_.line("template <class Types>");
        out_.open("inline constexpr robochart::Field layout[] = {");
        write_rows("", "", "State<Types>", core_.layout);
        out_.close("};");
        out_.gap();
        out_.line("static_assert(std::is_trivially_copyable<State<robochart::Deployment>>::value &&");
        out_.line("                  std::is_standard_layout<State<robochart::Deployment>>::value,");
        out_.line("              \"a value\");");
        out_.line(
            "static_assert(robochart::covers(layout<robochart::Deployment>, sizeof(State<robochart::Deployment>)), "
            "\"no padding\");");
    }

    /// Returns the layout of the frame with this type, or null if the type is not a frame.
    [[nodiscard]] const FrameLayout* find_layout(const std::string& type) const {
        const auto& units = generation_.component.units;
        assert(core_.machines.size() == units.size());
        for (std::size_t i = 0; i < units.size(); ++i)
            if (units[i].frame + "<Types>" == type) return &core_.machines[i].layout;
        return nullptr;
    }

    void write_rows(const std::string& path, const std::string& offset, const std::string& owner,
                    const FrameLayout& layout) {
        for (const Field& field : layout.fields) {
            const std::string name = field.name.substr(0, field.name.find('['));
            const std::string place = fmt::format("{}offsetof({}, {})", offset, owner, name);
            if (name == "filler") {
                out_.line(fmt::format("robochart::filler({}, sizeof({}::filler)),", place, owner));
                continue;
            }
            if (const FrameLayout* const inner = find_layout(field.type)) {
                write_rows(path + name + ".", place + " + ", field.type, *inner);
                continue;
            }
            const std::size_t values = values_of(field.type);
            out_.line(fmt::format("robochart::field<decltype({}::{})>(\"{}\", {}{}),", owner, name, path + name, place,
                                  values == 0 ? "" : fmt::format(", {}", values)));
        }
    }

    /// Returns the number of values of the type, or 0 if the type is not an enumeration of the core.
    [[nodiscard]] std::size_t values_of(const std::string& type) const {
        for (const MachineCode& machine : core_.machines)
            for (const Enumeration& enumeration : machine.enumerations)
                if (enumeration.name == type) return enumeration.values.size();
        for (const ir::TypeId id : generation_.component.enumerations) {
            const ir::Type& declared = generation_.system.type(id);
            if (declared.kind == ir::TypeKind::enumeration && declared_name(declared) == type)
                return declared.labels.size();
        }
        return 0;
    }

    void write_names(const Enumeration& enumeration) {
        out_.gap();
        out_.doc("The place as it is called in the code, and what it is in the model.");
        two_names("name", enumeration, [](const Enumerator& value) { return diagnostics::cpp_string(value.name); });
        out_.gap();
        two_names("element", enumeration,
                  [](const Enumerator& value) { return diagnostics::cpp_string(value.comment); });
    }

    template <class Text>
    void two_names(const char* function, const Enumeration& enumeration, const Text& text) {
        out_.open(
            fmt::format("[[nodiscard]] constexpr const char* {}({} place) noexcept {{", function, enumeration.name));
        out_.open("switch (place) {");
        for (const Enumerator& value : enumeration.values)
            out_.line(fmt::format("case {}::{}: return {};", enumeration.name, value.name, text(value)));
        out_.close();
        out_.line("return \"\";");
        out_.close();
    }

    const Generation& generation_;
    const Core& core_;
    CodeWriter out_;
};

}  // namespace

std::string layout_header(const Generation& generation, const Core& core) {
    return LayoutWriter(generation, core).write();
}

void write_platform_concept(const std::vector<std::string>& calls, CodeWriter& out) {
    out.line("#if defined(__cpp_concepts) && __cpp_concepts >= 201907L");
    out.doc("The same for compilers that have concepts; step() asks for it.");
    out.line("template <class Types, class P>");
    out.open("struct PlatformCheck {");
    out.line("using Real = typename Types::Real;");
    out.line("using Nat = typename Types::Nat;");
    out.line("using Int = typename Types::Int;");
    out.gap();
    out.open("static constexpr bool complete = requires([[maybe_unused]] P& platform) {");
    for (const std::string& call : calls) out.line(fmt::format("{{ platform.{} }} noexcept;", call));
    if (calls.empty()) out.line("requires true;");
    out.close("};");
    out.close("};");
    out.line("template <class P, class Types>");
    out.line("concept PlatformOf = PlatformCheck<Types, P>::complete;");
    out.line("#endif");
}

}  // namespace robochart::cpp_emit
