#include "checker/cspm/types/type_check.hpp"

#include "checker/cspm/types/builtin_types.hpp"
#include "checker/cspm/types/deep_stack.hpp"
#include "checker/cspm/types/infer.hpp"
#include "checker/cspm/types/names.hpp"

namespace robochart::cspm {

namespace {

std::vector<NamedType> named_types(const types::ResolvedScript& script, types::TypeStore& store) {
    std::vector<NamedType> result;
    for (const types::Symbol* each : script.shown) {
        if (each->failed) continue;
        types::TypeWriter writer(store);
        result.push_back({each->name, each->span, writer.with_constraints(each->scheme.type)});
    }
    return result;
}

}  // namespace

std::vector<NamedType> check_types(const Script& script, diagnostics::Diagnostics& diagnostics) {
    std::vector<NamedType> result;
    on_deep_stack([&] {
        types::TypeStore store;
        types::BuiltinTypes builtins(store);
        try {
            const auto resolved = types::NameResolver(store, builtins, diagnostics).run(script);
            types::Inference(*resolved, store, diagnostics).run();
            result = named_types(*resolved, store);
        } catch (const types::TypeOverflow&) {  // reported where it was found
        }
    });
    return result;
}

}  // namespace robochart::cspm
