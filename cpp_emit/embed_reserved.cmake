# SPDX-License-Identifier: Apache-2.0
# Builds the lists of cpp_emit/reserved into the program: one sorted table of names for each list.
set(text "// Lists of cpp_emit/reserved, built in by embed_reserved.cmake.\n#include \"cpp_emit/plan/reserved.hpp\"\n\nnamespace robochart::cpp_emit {\n\n")
foreach(list macros globals own_types own_members)
  file(STRINGS ${RESERVED_DIR}/${list}.txt names REGEX "^[A-Za-z]")
  list(SORT names)
  list(REMOVE_DUPLICATES names)
  string(JOIN "\",\n    \"" joined ${names})
  string(APPEND text "std::span<const std::string_view> reserved_${list}() {\n    static constexpr std::string_view names[] = {\n    \"${joined}\"};\n    return names;\n}\n\n")
endforeach()
string(APPEND text "}  // namespace robochart::cpp_emit\n")
file(WRITE ${OUTPUT} "${text}")
