// SPDX-License-Identifier: Apache-2.0
// Rules about names.
#include "frontend/rules/rules.hpp"

namespace robochart::frontend::rules {

using enum diagnostics::Severity;

const Rule unknown_name{
    "RC-N01", error, "there is no {} `{}` {}",
    "Names are looked up in the machine's own declarations and the interfaces it uses or requires, then in the "
    "package, its imports, and unnamed packages. A machine does not see what its controller declares."};
const Rule ambiguous_kind{"RC-N02", error, "`{}` is a {}, but a {} is needed here",
                          "The name exists but stands for something that cannot be used at this place."};
const Rule not_unique{
    "RC-N03", warning, "`{}` is declared more than once",
    "Two declarations of the same kind share one name; a reference to it means the first. Published as RP3, I3, "
    "C5, STM5 and O1."};
const Rule unknown_import{
    "RC-N04", warning, "the import of `{}` has no effect: there is {}",
    "An import names a package of the project or a toolkit, or one declaration of these. What is not there is not "
    "missed before one of its names is used; often the package is misspelt, or its files lie in another folder."};
const Rule robosim_unread{
    "RC-N05", note, "`{}` is declared in {}, and files of RoboSim are not read",
    "A folder of RoboTool may hold models in RoboSim (`.rst`) beside those in RoboChart. They are not read, so that "
    "what only they declare is unknown here. Declare it in a `.rct` file."};

const std::vector<const Rule*>& of_names() {
    static const std::vector<const Rule*> rules = {&unknown_name, &ambiguous_kind, &not_unique, &unknown_import,
                                                   &robosim_unread};
    return rules;
}

std::vector<const Rule*> all() {
    std::vector<const Rule*> result;
    for (const auto* group : {&of_names(), &of_nodes(), &of_components(), &of_connections(), &of_time(), &of_types(),
                              &of_assertions(), &of_lints()})
        result.insert(result.end(), group->begin(), group->end());
    return result;
}

}  // namespace robochart::frontend::rules
