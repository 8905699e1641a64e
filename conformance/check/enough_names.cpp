// SPDX-License-Identifier: Apache-2.0
// Tries increasing numbers of names. The conditions are from Lazić 1999 (a normalised specification without tests for
// equality). If the specification chooses between values, there must be one name more than values that are live at the
// same time.
#include "conformance/check/enough_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "conformance/check/live_names.hpp"
#include "conformance/check/open_choice.hpp"
#include "conformance/model/cyclic_model.hpp"
#include "conformance/model/representatives.hpp"
#include "cpp_emit/plan/exploration_ports.hpp"

namespace robochart::conformance {

namespace {

/// Returns, for each output, whether each argument has a represented type.
std::vector<std::vector<bool>> represented_arguments(const ir::System& system, const Representatives& few,
                                                     const cpp_emit::Component& component) {
    std::vector<std::vector<bool>> result;
    for (const cpp_emit::Output& output : cpp_emit::exploration_outputs(component)) {
        std::vector<bool>& arguments = result.emplace_back();
        for (const ir::TypeId type : output.types) arguments.push_back(is_represented(system, few, type));
    }
    return result;
}

/// Returns true if each type has more names than can be live after a trace.
bool names_suffice(CyclicModel& model, const Representatives& few, const refine::Limits& limits) {
    const std::vector<std::size_t> live = most_live_names(model, few, limits);
    bool enough = true;
    for (std::size_t type = 0; type < live.size(); ++type) enough = enough && live[type] < few.types[type].names.size();
    return enough;
}

class NameCount {
public:
    NameCount(const RenamedSystem& model, const ir::ComponentRef& component, const cpp_emit::Component& resolved,
              const Options& options, diagnostics::SourceManager& sources)
        : model_(model), component_(component), resolved_(resolved), options_(options), sources_(sources) {}

    EnoughNames find() {
        std::optional<OpenChoice> choice;
        for (std::size_t names = least_names; names <= most_names; ++names) {
            const Representatives few =
                choose_representatives(model_.system, model_.instantiation, resolved_, names, model_.list_bounds);
            std::string error;
            const auto model = load(few, error);
            if (!model) return {std::nullopt, std::move(error)};
            if (names == least_names) {
                choice = open_choice(model->normal_form(), model->alphabet(),
                                     represented_arguments(model_.system, few, resolved_), options_.limits);
                if (!choice) return {names, {}};
            }
            if (few.types.empty() || few.types.size() * names > most_bits)
                return not_all(*choice, fmt::format("its types have too few values to name {}", names));
            if (names_suffice(*model, few, options_.limits)) return {names, {}};
        }
        return not_all(*choice, fmt::format("{} values that it has read may still be written", most_names));
    }

private:
    std::unique_ptr<CyclicModel> load(const Representatives& few, std::string& error) {
        diagnostics::Diagnostics apart;  // discarded, because the emission of the script reports the same findings
        return CyclicModel::load(model_.system, few.instantiation, component_, options_.cycle_length, options_.limits,
                                 sources_, apart, error, options_.generator.order);
    }

    static EnoughNames not_all(const OpenChoice& choice, const std::string& cause) {
        return {std::nullopt, reason_of(choice) + ", and " + cause};
    }

    const RenamedSystem& model_;
    const ir::ComponentRef& component_;
    const cpp_emit::Component& resolved_;
    const Options& options_;
    diagnostics::SourceManager& sources_;
};

}  // namespace

EnoughNames enough_names(const RenamedSystem& model, const ir::ComponentRef& component,
                         const cpp_emit::Component& resolved, const Options& options,
                         diagnostics::SourceManager& sources) {
    const auto undecided = [](const std::exception& cause) -> EnoughNames {
        return {std::nullopt,
                fmt::format("it was not decided whether few values represent all values: {}", cause.what())};
    };
    try {
        return NameCount(model, component, resolved, options, sources).find();
    } catch (const process::Interrupted& limit) {
        return undecided(limit);
    } catch (const std::length_error& limit) {
        return undecided(limit);
    } catch (const cspm::EvaluationError& failed) {
        return undecided(failed);
    }
}

}  // namespace robochart::conformance
