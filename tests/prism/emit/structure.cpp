// SPDX-License-Identifier: Apache-2.0
#include "tests/prism/emit/structure.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <regex>
#include <set>

#include "prism/syntax/printer.hpp"

namespace robochart::prism_emit::testing {
namespace {

using prism::ExprPtr;
using prism::Op;
using Writer = std::function<std::string(const std::string&)>;

/// Returns a name such as "odsTick_18" or "BUF_odsTick_18_f" without its numbers.
std::string name_stem(const std::string& name) {
    static const std::regex numbers("_[0-9]+(?=_|$)");
    return std::regex_replace(name, numbers, "");
}

std::string join_sorted(std::vector<std::string> parts, const std::string& between) {
    std::ranges::sort(parts);
    std::string result;
    for (const std::string& part : parts) result += (result.empty() ? "" : between) + part;
    return result;
}

void operands_of(const ExprPtr& expr, Op op, const Writer& write, std::vector<std::string>& result);

std::string expression_text(const ExprPtr& expr, const Writer& write) {
    if (!expr) return "";
    if (expr->op == Op::name) return write(expr->text);
    if (expr->op == Op::conjunction || expr->op == Op::disjunction) {
        std::vector<std::string> operands;
        operands_of(expr, expr->op, write, operands);
        return "(" + join_sorted(operands, expr->op == Op::conjunction ? "&" : "|") + ")";
    }
    std::string result = "(" + std::to_string(static_cast<int>(expr->op)) + expr->text;
    for (const ExprPtr& part : expr->parts) result += " " + expression_text(part, write);
    return result + ")";
}

/// Adds the operands of a conjunction or disjunction at any depth. `true` in a conjunction is omitted.
void operands_of(const ExprPtr& expr, Op op, const Writer& write, std::vector<std::string>& result) {
    if (expr->op == op) {
        for (const ExprPtr& part : expr->parts) operands_of(part, op, write, result);
    } else if (op != Op::conjunction || expr->op != Op::boolean || expr->text != "true") {
        result.push_back(expression_text(expr, write));
    }
}

/// A declaration or a command, with its text as a function of a renaming, and the names in it.
struct Item {
    std::function<std::string(const Writer&)> text;
    std::set<std::string> names;
};

class Structure {
public:
    explicit Structure(const prism::ModelFile& model) {
        for (const prism::Constant& constant : model.constants) add(constant);
        for (const prism::Variable& variable : model.globals) add(variable, "");
        for (const prism::Module& module : model.modules) {
            modules_.insert(module.name.text);
            for (const prism::Variable& variable : module.variables) add(variable, module.name.text);
            for (const prism::Command& command : module.commands) add(command, module.name.text);
        }
        for (const Item& item : items_)
            for (const std::string& name : item.names)
                colours_[name] = modules_.contains(name) ? "module" : name_stem(name);
    }

    /// Refines the colour of each name by its occurrences and the colours of the other names in them.
    void refine_colours() {
        std::map<std::string, std::vector<std::string>> places;
        for (const Item& item : items_)
            for (const std::string& name : item.names)
                places[name].push_back(
                    item.text([&](const std::string& other) { return other == name ? "@" : colours_.at(other); }));
        std::map<std::string, std::string> finer;
        for (const auto& [name, texts] : places)
            finer[name] = std::to_string(std::hash<std::string>()(colours_.at(name) + ":" + join_sorted(texts, "\n")));
        colours_ = std::move(finer);
    }

    [[nodiscard]] std::size_t class_count() const {
        std::set<std::string> different;
        for (const auto& [name, colour] : colours_) different.insert(colour);
        return different.size();
    }

    /// Maps the text of each item with colours for names to its readable text.
    [[nodiscard]] std::multimap<std::string, std::string> items() const {
        std::multimap<std::string, std::string> result;
        for (const Item& item : items_)
            result.emplace(item.text([&](const std::string& name) { return colours_.at(name); }),
                           item.text([](const std::string& name) { return name; }));
        return result;
    }

private:
    void add(std::function<std::string(const Writer&)> text) {
        Item item{std::move(text), {}};
        (void)item.text([&](const std::string& name) {
            item.names.insert(name);
            return name;
        });
        items_.push_back(std::move(item));
    }

    void add(const prism::Constant& constant) {
        add([constant](const Writer& write) {
            const bool number = constant.value && constant.value->op == Op::integer;
            return "const " + std::to_string(static_cast<int>(constant.type)) + write(constant.name.text) + "=" +
                   (number ? "number" : expression_text(constant.value, write));
        });
    }

    void add(const prism::Variable& variable, const std::string& module) {
        add([variable, module](const Writer& write) {
            const bool point = variable.name.text.find("_scpc_") != std::string::npos;
            return "var " + (module.empty() ? "" : write(module)) + " " + write(variable.name.text) + " " +
                   expression_text(variable.low, write) + ".." + (point ? "" : expression_text(variable.high, write)) +
                   " " + expression_text(variable.initial, write);
        });
    }

    void add(const prism::Command& command, const std::string& module) {
        add([command, module](const Writer& write) {
            std::vector<std::string> branches;
            for (const prism::Branch& branch : command.branches) {
                std::vector<std::string> assignments;
                for (const prism::Assignment& assignment : branch.assignments)
                    assignments.push_back(write(assignment.variable.text) +
                                          "'=" + expression_text(assignment.value, write));
                branches.push_back(expression_text(branch.probability, write) + ":" + join_sorted(assignments, "&"));
            }
            return write(module) + "[" + (command.action.text.empty() ? "" : write("[" + command.action.text)) + "]" +
                   join_sorted({expression_text(command.guard, write)}, "") + "->" + join_sorted(branches, "+");
        });
    }

    std::vector<Item> items_;
    std::set<std::string> modules_;
    std::map<std::string, std::string> colours_;
};

}  // namespace

std::vector<std::string> find_differences(const prism::ModelFile& first, const prism::ModelFile& second) {
    Structure a(first);
    Structure b(second);
    for (std::size_t classes = 0; a.class_count() + b.class_count() > classes;) {
        classes = a.class_count() + b.class_count();
        a.refine_colours();
        b.refine_colours();
    }
    auto left = a.items();
    auto right = b.items();
    for (auto entry = left.begin(); entry != left.end();) {
        const auto same = right.find(entry->first);
        if (same == right.end()) {
            ++entry;
            continue;
        }
        right.erase(same);
        entry = left.erase(entry);
    }
    std::vector<std::string> result;
    for (const auto& [colour, readable] : left) result.push_back("- " + readable);
    for (const auto& [colour, readable] : right) result.push_back("+ " + readable);
    return result;
}

}  // namespace robochart::prism_emit::testing
