// SPDX-License-Identifier: Apache-2.0
// Encodes a state machine with its operations as one module of PRISM (R2 to R11, R14).
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "prism/emit/channels.hpp"
#include "prism/emit/chart.hpp"
#include "prism/emit/expressions.hpp"

namespace robochart::prism_emit {

/// The top level of a machine, or a composite state. A variable of the region contains its current place.
struct Region {
    std::optional<std::size_t> owner;  ///< the composite state
    std::string stem;                  ///< prefix of its names: "modUVC_ctrlUVC_stm_ref0"
    std::string pc, exit;              ///< variables: the current place, and the stage of its exit
    std::string inactive;
    unsigned points = 0;  ///< number of program points, which are numbered from 1; 0 is `inactive`
};

/// A machine, or an operation that it calls. Each part has a lock.
struct Part {
    const ir::Machine* machine = nullptr;
    std::string stem;     ///< prefix of its names
    std::string element;  ///< its name in the model, as "modUVC::ctrlUVC::stm_ref0"
    Chart chart;
    std::vector<Region> regions;                                  ///< the first is the top level
    std::map<std::optional<std::size_t>, std::size_t> region_of;  ///< by owner
    std::vector<std::string> points, entering;                    ///< program points of places; "" if there is none
    std::vector<std::string> variables;                           ///< names of the machine's variables
    std::vector<std::string> constants;                           ///< names of the machine's constants
    std::string lock, free, terminated;
    unsigned locks = 0;
};

class MachineEmitter {
public:
    /// `globals` contains the names of the platform's variables. `constants` contains the names of all constants found
    /// so far, by the source of their values.
    MachineEmitter(Context& context, Channels& channels, const std::map<std::string, std::string>& globals,
                   std::map<std::string, std::string>& constants, Seat seat);

    /// Adds the module to the model.
    void operator()();

private:
    using Assignments = std::vector<prism::Assignment>;

    // names and variables
    Part& part_of(ir::MachineId machine, const std::string& name, bool operation);
    void name_variables(Part& part);
    void name_constants(Part& part);
    [[nodiscard]] std::string constant_name(Part& part, ir::ConstantId id);
    [[nodiscard]] std::string name_in_controller(const Part& part) const;
    void name_places(Part& part);
    Region make_region(Part& part, std::optional<std::size_t> owner);
    std::string add_point(Region& region, const std::string& name);
    std::string add_lock(Part& part, const Step& step);
    void declare_variables(Part& part);
    void declare_counters(const Part& part);
    [[nodiscard]] Scope make_scope(const Part& part, const std::string& where) const;

    // places
    [[nodiscard]] Region& region_at(Part& part, std::size_t place);
    [[nodiscard]] std::vector<prism::ExprPtr> active_conditions(const Part& part,
                                                                std::optional<std::size_t> composite) const;
    [[nodiscard]] prism::ExprPtr at_point(Part& part, std::size_t place, const std::string& point) const;
    [[nodiscard]] Assignments arrive_at(Part& part, std::size_t place);
    [[nodiscard]] Assignments enter_place(Part& part, std::size_t place);

    // rules
    void emit_part(Part& part);
    void emit_entries(Part& part);
    void emit_exits(Part& part);
    void emit_composite_exit(Part& part, std::size_t place);
    void emit_steps(Part& part);
    void from_initial(Part& part, const Step& step);
    void from_state(Part& part, const Step& step);
    void from_simple(Part& part, const Step& step, const std::string& lock, Channel* channel,
                     std::vector<prism::ExprPtr> guard);
    void from_composite(Part& part, const Step& step, const std::string& lock, Channel* channel,
                        std::vector<prism::ExprPtr> guard);
    void from_junction(Part& part, const Step& step);
    void from_probabilistic(Part& part, std::size_t junction);
    [[nodiscard]] std::vector<prism::ExprPtr> step_guards(Part& part, const Step& step, const std::string& received);
    [[nodiscard]] bool trigger_fits(const Part& part, const Step& step, const Channel& channel);
    [[nodiscard]] Assignments go_on(Part& part, const Step& step);
    [[nodiscard]] bool releases_lock(const Part& part, const Assignments& assignments) const;

    // actions
    void run_statements(Part& part, std::size_t place, std::string point, const std::vector<ir::StmtPtr>& statements,
                        const Assignments& then, const std::string& where);
    void emit_statement(Part& part, std::size_t place, const std::string& point, const ir::Stmt& stmt, Assignments then,
                        const std::string& where);
    void emit_communication(Part& part, std::size_t place, const std::string& point, const ir::Stmt& stmt,
                            Assignments then, const std::string& where);
    void emit_send(Part& part, std::size_t place, const std::string& point, const Channel& channel,
                   const ir::Expr* value, Assignments then, const std::string& where);
    void emit_receive(Part& part, std::size_t place, const std::string& point, const Channel& channel,
                      ir::VariableId variable, const Assignments& then);
    void emit_call(Part& part, std::size_t place, const std::string& point, const ir::Stmt& stmt, Assignments then,
                   const std::string& where);
    [[nodiscard]] Part* called_operation(const Part& caller, const ir::Stmt& stmt);
    [[nodiscard]] Channel* channel_of(const Part& part, ir::EventId event, Direction direction, diagnostics::Span span);
    void declare_value(const Channel& channel, Direction direction);
    void add_command(prism::Command command) { module_.commands.push_back(std::move(command)); }

    Context& context_;
    Channels& channels_;
    const std::map<std::string, std::string>& globals_;
    std::map<std::string, std::string>& constants_;
    Seat seat_;
    const ir::Controller& controller_;
    const ir::MachineInstance& instance_;
    prism::Module module_;
    std::map<std::uint32_t, std::unique_ptr<Part>> parts_;  ///< by machine; includes the machine itself and its
                                                            ///< operations
    std::set<std::uint32_t> open_;                          ///< operations being encoded; a call of one is a recursion
    std::set<std::string> declared_;                        ///< EVT__ and FIN__ variables
};

}  // namespace robochart::prism_emit
