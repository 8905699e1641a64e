// SPDX-License-Identifier: Apache-2.0
// Rules about names.
#include "frontend/rules/rules.hpp"

namespace robochart::frontend::rules {

using enum diagnostics::Severity;

const Rule unknown_name{
    "RC-N01", error, "there is no {} `{}` {}",
    "Names are looked up in the declarations of the machine and the interfaces that it uses or requires, then in the "
    "package, its imports, and unnamed packages. The declarations of a controller are not visible in its machines."};
const Rule ambiguous_kind{"RC-N02", error, "`{}` is a {}, but a {} is needed here",
                          "The name is declared, but as a kind of element that cannot be used here."};
const Rule not_unique{"RC-N03", warning, "`{}` is declared more than once",
                      "If two declarations of the same kind share a name, a reference means the first. The published "
                      "rules call this RP3, I3, C5, STM5 and O1."};
const Rule unknown_import{"RC-N04", warning, "the import of `{}` has no effect: there is {}",
                          "An import names a package of the project, a toolkit, or one declaration of either. A "
                          "missing package causes an error only when one of its names is used. Often the name is "
                          "misspelt, or the files of the package are in another folder."};
const Rule robosim_unread{
    "RC-N05", note, "`{}` is declared in {}, but RoboSim files are not read",
    "A RoboTool folder may contain RoboSim models (`.rst`) in addition to RoboChart models. This tool does not read "
    "them, so it does not know their declarations. Declare the element in a `.rct` file."};

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
