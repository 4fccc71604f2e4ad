# The heavy headers from outside, read by the compiler once instead of once a source. Every source names
# what it uses all the same: preset `dev` compiles without these, and there a missing include is an error.

set(INK_PRECOMPILED_HEADERS
    <algorithm> <array> <charconv> <chrono> <cmath> <cstdint> <cstring> <filesystem> <fstream>
    <functional> <limits> <map> <memory> <numbers> <numeric> <optional> <random> <set> <span>
    <sstream> <string> <string_view> <unordered_map> <utility> <variant> <vector>
    <fmt/format.h> <glm/glm.hpp> <glm/gtc/matrix_transform.hpp>)

# ink_precompile(NAME LINKS ... HEADERS ... OPTIONS ...): headers that targets share. The compiler takes them
# only where flags and definitions agree, so targets get OPTIONS, and the definitions of LINKS without
# being linked to them.
function(ink_precompile name)
    cmake_parse_arguments(PRE "" "" "LINKS;HEADERS;OPTIONS" ${ARGN})
    set(shared ink_precompiled_${name})
    add_library(${shared} OBJECT ${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp)
    target_link_libraries(${shared} PRIVATE ${PRE_LINKS})
    target_precompile_headers(${shared} PRIVATE ${PRE_HEADERS})
    target_compile_options(${shared} PUBLIC ${PRE_OPTIONS})
    foreach(link IN LISTS PRE_LINKS)
        target_compile_definitions(${shared} INTERFACE
            $<TARGET_PROPERTY:${link},INTERFACE_COMPILE_DEFINITIONS>)
    endforeach()
endfunction()

function(ink_use_precompiled target name)
    set(shared ink_precompiled_${name})
    target_precompile_headers(${target} REUSE_FROM ${shared})
    target_compile_definitions(${target} PRIVATE
        $<TARGET_PROPERTY:${shared},INTERFACE_COMPILE_DEFINITIONS>)
    target_compile_options(${target} PRIVATE
        $<TARGET_PROPERTY:${shared},INTERFACE_COMPILE_OPTIONS>)
endfunction()

ink_precompile(room LINKS fmt::fmt HEADERS ${INK_PRECOMPILED_HEADERS})

# COLD rooms plan, read and write, and measure nothing: the first level of optimisation is enough for them
# and compiles faster.
ink_precompile(cold LINKS fmt::fmt HEADERS ${INK_PRECOMPILED_HEADERS} OPTIONS $<$<CONFIG:Release>:-O1>)
