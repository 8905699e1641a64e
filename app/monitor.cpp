// `emit monitor` and `simulate --monitor`.
#include "app/monitor.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "app/interrupt.hpp"
#include "app/rules.hpp"
#include "app/verbs.hpp"
#include "checker/cspm/evaluation_error.hpp"
#include "checker/process/term.hpp"

namespace robochart::app {
namespace {

/// The tables of one component; null with a diagnostic.
std::unique_ptr<conformance::MonitorBuild> build(Project& project, const Options& options, const ir::ComponentRef& component,
                                                 std::uint32_t cycle_length) {
    const auto refuse = [&](const std::string& why) {
        project.diagnostics.report(rules::no_monitor, {}, {component.path, why});
        return nullptr;
    };
    const refine::Limits bounds = limits(options, "monitor of " + component.path);
    try {
        std::string error;
        const auto model = conformance::CyclicModel::load(project.system, project.instantiation, component, cycle_length, bounds,
                                                          project.sources, project.diagnostics, error);
        if (model == nullptr) return refuse(error);
        return conformance::MonitorBuild::make(*model, bounds, project.sources);
    } catch (const std::length_error& large) {
        return refuse(large.what());
    } catch (const process::Interrupted& limit) {
        return refuse(limit.what());
    } catch (const cspm::EvaluationError& failed) {
        return refuse(failed.what());
    } catch (const conformance::AlphabetError& mismatch) {
        return refuse(mismatch.what());
    }
}

/// Letters, digits and underscores.
std::string identifier(const std::string& path) {
    std::string name;
    for (const char c : path) name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    return name;
}

}  // namespace

/// The monitors of one trial.
class Monitors::Watch final : public simulation::Trace {
public:
    Watch(Monitors& all, std::unique_ptr<simulation::Trace> other) : all_(all), other_(std::move(other)) {
        for (const cpp_emit::Port& port : all.emission_.inputs)
            inputs_.push_back(port.arguments.empty() ? Kind::none : kind(port.arguments.front()));
        for (const cpp_emit::Port& port : all.emission_.outputs)
            for (std::size_t k = 0; k < ROBOCHART_DRIVE_MAX_ARGUMENTS; ++k)
                outputs_.push_back(k < port.arguments.size() ? kind(port.arguments[k]) : Kind::none);
    }
    ~Watch() override {
        all_.robots_ += monitors_.size();
        for (const Monitor& monitor : monitors_)
            if (monitor.verdict() == MonitorVerdict::unknown) ++all_.lost_;
    }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

    void cycle(std::size_t robot, std::uint64_t step, const rc_signal* inputs, const rc_actions& outputs, rc_drive_result result) override {
        if (other_ != nullptr) other_->cycle(robot, step, inputs, outputs, result);
        while (monitors_.size() <= robot) {
            monitors_.emplace_back(all_.build_->tables());
            ended_.push_back(0);
        }
        if (ended_[robot] != 0) return;
        Monitor& monitor = monitors_[robot];
        read(monitor, inputs);
        for (std::uint32_t a = 0; a < outputs.count; ++a) wrote(monitor, outputs.action[a]);
        if (result == RC_DRIVE_QUIESCENT) monitor.end_of_cycle();
        if (result == RC_DRIVE_TERMINATED) monitor.terminated();
        ended_[robot] = result != RC_DRIVE_QUIESCENT ? 1 : 0;
        if (monitor.verdict() == MonitorVerdict::violated) object(monitor);
    }

    [[nodiscard]] const simulation::Objection* objection() const override { return objection_.cause.empty() ? nullptr : &objection_; }

private:
    void read(Monitor& monitor, const rc_signal* inputs) const {
        for (std::uint32_t i = 0; i < inputs_.size(); ++i) {
            if (inputs[i].present == 0) monitor.absent(i);
            else if (inputs_[i] == Kind::none) monitor.read(i);
            else if (inputs_[i] == Kind::real) monitor.read(i, inputs[i].value.real);
            else monitor.read(i, inputs[i].value.whole);
        }
    }

    void wrote(Monitor& monitor, const rc_action& action) const {
        std::uint32_t place = Monitor::start();
        const Kind* const kinds = outputs_.data() + std::size_t{action.output} * ROBOCHART_DRIVE_MAX_ARGUMENTS;
        for (std::uint32_t k = 0; k < action.count; ++k)
            place = kinds[k] == Kind::real ? monitor.argument(place, action.output, k, action.argument[k].real)
                                           : monitor.argument(place, action.output, k, action.argument[k].whole);
        monitor.wrote_at(action.output, place);
    }

    void object(const Monitor& monitor) {
        const std::string where = monitor.where();
        const std::string element = monitor.element();
        objection_.cause = fmt::format("its model does not allow {} here", monitor.event());
        objection_.place = element.empty() ? where : where.empty() ? element : fmt::format("{}; {}", where, element);
    }

    enum class Kind : std::uint8_t { none, real, whole };
    static Kind kind(cpp_emit::Carried carried) { return carried == cpp_emit::Carried::real ? Kind::real : Kind::whole; }

    Monitors& all_;
    std::unique_ptr<simulation::Trace> other_;
    std::vector<Kind> inputs_;   ///< what each carries
    std::vector<Kind> outputs_;  ///< of each output, of each argument it may have
    std::vector<Monitor> monitors_;
    std::vector<std::uint8_t> ended_;
    simulation::Objection objection_;
};

Monitors::Maker Monitors::beside(Maker other) {
    return [this, other = std::move(other)](std::uint32_t trial) { return std::make_unique<Watch>(*this, other ? other(trial) : nullptr); };
}

std::string Monitors::note() const {
    const auto& tables = build_->tables();
    std::string text = fmt::format("  monitors: {} states, {} columns; {} robots watched", tables.states, tables.columns, robots_.load());
    if (lost_ > 0) text += fmt::format(", {} of them not to the end: they left the finite reading of the model", lost_.load());
    return text + "\n";
}

std::unique_ptr<Monitors> make_monitors(Simulation& simulation, const Options& options) {
    const auto components = code_components(simulation.project->system, simulation.scenario.component.text);
    auto made = build(*simulation.project, options, components.front(), simulation.scenario.units_per_step);
    return made == nullptr ? nullptr : std::make_unique<Monitors>(std::move(made), simulation.emission);
}

Exit emit_monitors(Project& project, const Options& options) {
    const auto components = code_components(project.system, options.component);
    if (components.empty()) project.diagnostics.report(rules::no_component, {}, {options.component.empty() ? "the model" : options.component});
    const InterruptScope scope;
    std::string written;
    for (const ir::ComponentRef& component : components) {
        const auto made = build(project, options, component, options.cycle);
        if (made == nullptr) break;
        for (const auto& file : conformance::monitor_files(made->tables(), identifier(component.path))) {
            const std::string path = fmt::format("{}/monitor/{}/{}", options.out, identifier(component.path), file.path);
            const std::string error = write_file(path, file.text);
            if (!error.empty()) project.diagnostics.report(rules::unwritable, {}, {error});
            written += fmt::format("  {:<70} {:>9} bytes\n", path, with_commas(file.text.size()));
        }
        written += fmt::format("  {}: {} states, {} columns, {} bytes of table\n", component.path, made->tables().states,
                               made->tables().columns, with_commas(made->bytes()));
    }
    if (!show_diagnostics(project, options)) return Exit::bad_input;
    if (!options.quiet) fmt::print("{}", written);
    return Exit::success;
}

}  // namespace robochart::app
