// SPDX-License-Identifier: Apache-2.0
// Emits one component: resolves it, rejects what is not supported, and writes its files.
#include "cpp_emit/emit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "cpp_emit/api/class_api.hpp"
#include "cpp_emit/api/console_class.hpp"
#include "cpp_emit/faults/faulty_model.hpp"
#include "cpp_emit/files/files.hpp"
#include "cpp_emit/files/shipped_headers.hpp"
#include "cpp_emit/plan/list_capacities.hpp"
#include "cpp_emit/plan/resolve_component.hpp"
#include "cpp_emit/plan/rules.hpp"
#include "cpp_emit/plan/types.hpp"
#include "cpp_emit/plan/unsupported.hpp"
#include "cpp_emit/project.hpp"
#include "cpp_emit/ros2/mapping.hpp"
#include "cpp_emit/ros2/mapping_draft.hpp"
#include "semantics/instantiate/instantiate.hpp"

namespace robochart::cpp_emit {

namespace {

constexpr std::size_t max_state_bytes = 64U << 10U;

/// Returns true if the exploration interface can be written. Reports an error if it is required but cannot be written.
bool check_explorable(const Generation& generation, diagnostics::Diagnostics& diagnostics) {
    const Component& component = generation.component;
    if (generation.options.tracked_scale > 0) return true;  // its numbers have no carriers
    const auto beyond = beyond_exploration(generation.system, generation.inst, component);
    for (const BeyondExploration& part : beyond) {
        if (generation.options.explored)
            diagnostics.report(rules::too_large, component.origin.span, {part.name, part.limit});
        else if (generation.options.target == Target::sources)
            diagnostics.report(rules::not_explored, component.origin.span, {component.name, part.name, part.limit});
    }
    return beyond.empty();
}

void add_exploration(const Generation& generation, const Core& core, Emission& emission) {
    emission.shim = generation.component.cpp_name + "_explore.cpp";
    const OutputFile files[] = {
        {emission.shim, shim_source(generation, core)}, {"robochart/finite.hpp", finite_header()},
        {"robochart/explore.hpp", explore_helpers()},   {"robochart/explore_values.hpp", explore_values()},
        {"robochart/explore_abi.h", explore_header()},  {"robochart/probes.hpp", probes_header()},
    };
    if (generation.options.tracked_scale > 0) {
        emission.files.push_back({"robochart/tracked.hpp", tracked_header()});
        emission.files.push_back({"robochart/deployed.hpp", deployed_header()});
    }
    if (tracks_sequences(generation)) {
        emission.files.push_back({"robochart/tracked_sequences.hpp", tracked_sequences()});
        if (!generation.component.views) emission.files.push_back({"robochart/views.hpp", views_header()});
        if (!generation.component.toolkit) emission.files.push_back({"robochart/toolkit.hpp", toolkit_header()});
        if (!generation.component.matrices) emission.files.push_back({"robochart/matrix.hpp", matrix_header()});
    }
    emission.files.insert(emission.files.end(), std::begin(files), std::end(files));
}

}  // namespace

diagnostics::ForeignText Generation::place_text(std::string_view element, diagnostics::Span span) const {
    const diagnostics::ForeignText known = line_text(span);
    return known.empty() ? diagnostics::ForeignText(element) : element + (" (" + known + ")");
}

diagnostics::ForeignText Generation::line_text(diagnostics::Span span) const {
    if (options.sources == nullptr || !span.is_known()) return {};
    return file_text(span) + ":" + std::to_string(options.sources->position(span.source, span.begin).line);
}

diagnostics::ForeignText Generation::file_text(diagnostics::Span span) const {
    if (options.sources == nullptr || !span.is_known()) return {};
    const std::string& path = options.sources->path(span.source);
    return path.substr(path.rfind('/') + 1);
}

std::string Generation::bound_test() const {
    return mutation.is_seeded(Fault::loop_never_ends) ? "" : "!exhausted() && ";
}

std::string Generation::round_test() const {
    return mutation.is_seeded(Fault::loop_never_ends) ? "" : "next_round() && ";
}

namespace {

/// Reports a state of more than max_state_bytes. Names its largest list and the option that limits this list.
void report_large_state(const Generation& generation, diagnostics::Diagnostics& diagnostics) {
    const Component& component = generation.component;
    const auto size_of = [&](const StoredVariable& stored) {
        return cpp_extent(generation.system, generation.inst, stored.variable->type).size;
    };
    const StoredVariable* largest = nullptr;
    for (const StoredVariable& stored : component.variables) {
        if (!stored.in_state() || !has_lists(generation.system, stored.variable->type)) continue;
        if (largest == nullptr || size_of(stored) > size_of(*largest)) largest = &stored;
    }
    std::string text = "its state takes more than 64 KiB (long lists, or operations that call operations)";
    if (largest != nullptr)
        text += fmt::format("; the lists of '{0}' take {1} bytes: --capacity {0}=N sets a smaller capacity",
                            largest->name(), size_of(*largest));
    diagnostics.report(rules::too_large, largest == nullptr ? component.origin.span : largest->variable->origin.span,
                       {component.name, text});
}

/// Returns the options with the capacities from the mapping. If both specify a capacity, uses the greater one.
Options with_mapped_capacities(const Options& options) {
    Options result = options;
    if (options.mapping == nullptr) return result;
    for (const ros2::Item& item : options.mapping->items)
        for (const ros2::Assignment& assignment : item.assignments) {
            if (!assignment.capacity) continue;
            std::size_t& capacity = result.capacities[item.element.text];
            capacity = std::max(capacity, assignment.capacity->items);
        }
    return result;
}

}  // namespace

Emission emit(const ir::System& system, const ir::Instantiation& inst, const ir::ComponentRef& ref,
              const Options& given, diagnostics::Diagnostics& diagnostics) {
    Options options = with_mapped_capacities(given);
    Emission emission;
    const std::optional<Component> component = resolve_component(system, inst, ref, diagnostics);
    if (component && component->robosim)
        options.cycle_length = static_cast<std::uint32_t>(ir::cycle_of(system, inst, ref));
    if (!component || !check_support(system, inst, *component, diagnostics)) return emission;
    Mutation mutation(options.fault, options.fault_site);
    const std::optional<ir::System> sized = with_capacities(system, *component, options);
    const FaultyModel model(sized ? *sized : system, inst, *component, mutation);
    const Generation generation{model.system(), inst, options, model.component(), mutation};
    if (!options.explored) report_capacities(system, *component, options, diagnostics);
    for (const auto& [name, capacity] : given.capacities)
        if (has_capacity(system, *component, name)) emission.sized_names.push_back(name);
    const bool explored = check_explorable(generation, diagnostics);
    if (!explored && options.explored) return emission;
    const Core core = make_core(generation);
    if (core.layout.size > max_state_bytes) {
        report_large_state(generation, diagnostics);
        return emission;
    }
    const ClassApi api = make_class_api(generation);
    if (options.mapping_draft) {
        emission.files.push_back({component->cpp_name + ".ros2", ros2::mapping_draft(generation, api), true});
        return emission;
    }
    for (const ApiClass& base : api.bases)
        emission.files.push_back({base.cpp_name + ".hpp", interface_header(generation, core, api, base)});
    const OutputFile rest[] = {
        {api.cpp_name + ".hpp", machine_header(generation, core, api)},
        {api.cpp_name + ".cpp", machine_source(generation, core, api)},
        {core.header, core_header(generation, core)},
        {component->cpp_name + "_layout.hpp", layout_header(generation, core)},
        {trace_header_name(generation), trace_header(generation, core)},
        {"main.cpp", console_source(generation, core, api)},
        {"CMakeLists.txt", build_file(api)},
        {"robochart/runtime.hpp", runtime_header()},
        {"robochart/timer.hpp", timer_header()},
        {"robochart/layout.hpp", layout_helpers()},
        {"robochart/trace.hpp", trace_helpers()},
        {"robochart/trace_file.hpp", trace_files()},
        {"robochart/mcap_writer.hpp", mcap_writer()},
    };
    emission.files.insert(emission.files.end(), std::begin(rest), std::end(rest));
    if (explored) add_exploration(generation, core, emission);
    if (options.target == Target::sources || options.target == Target::main) {
        emission.files.push_back({"robochart/console_values.hpp", console_values()});
        if (console_asks(generation)) emission.files.push_back({"robochart/console_choices.hpp", console_choices()});
    }
    const std::vector<OutputFile> values = value_headers(*component);
    emission.files.insert(emission.files.end(), values.begin(), values.end());
    if (options.target != Target::sources) {
        emission.files = project_files(generation, core, api, emission.files, diagnostics);
        emission.shim.clear();
    }
    emission.fault_sites = mutation.site_count();
    emission.event_places = event_places(generation, core);
    return emission;
}

std::vector<ViolationPlace> violation_places(const ir::System& system, const ir::Instantiation& inst,
                                             const ir::ComponentRef& ref, const Options& options) {
    std::vector<ViolationPlace> places;
    diagnostics::Diagnostics ignored;  // `emit` reports the same findings
    const std::optional<Component> component = resolve_component(system, inst, ref, ignored);
    if (!component) return places;
    Mutation mutation(options.fault, options.fault_site);
    const FaultyModel model(system, inst, *component, mutation);
    const Generation generation{model.system(), inst, options, model.component(), mutation};
    for (const MachineCode& machine : make_core(generation).machines)
        places.insert(places.end(), machine.violations.begin(), machine.violations.end());
    return places;
}

}  // namespace robochart::cpp_emit
