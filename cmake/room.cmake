# ink_room(NAME [COLD] [HOT] SOURCES ... [ALONE ...] LINKS ... PRIVATE_LINKS ...): a room is a folder, a static library and an alias ink::NAME.
# Includes are by path from src/ ("raster/pass/pass.h") or from the root ("method/method.h").
# The sources of HOT rooms, whose times are measured, and those ALONE are compiled one by one, others in units.
function(ink_room name)
    cmake_parse_arguments(ROOM "COLD;HOT" "" "SOURCES;ALONE;LINKS;PRIVATE_LINKS" ${ARGN})
    add_library(ink_${name} STATIC ${ROOM_SOURCES} ${ROOM_ALONE})
    add_library(ink::${name} ALIAS ink_${name})
    target_include_directories(ink_${name} PUBLIC ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR})
    target_link_libraries(ink_${name} PUBLIC ${ROOM_LINKS} PRIVATE ${ROOM_PRIVATE_LINKS})
    if(ROOM_COLD)
        ink_use_precompiled(ink_${name} cold)
    else()
        ink_use_precompiled(ink_${name} room)
    endif()
    if(ROOM_COLD)
        ink_use_units(ink_${name} 20)
    elseif(NOT ROOM_HOT)
        ink_use_units(ink_${name} 10)
    endif()
    set_source_files_properties(${ROOM_ALONE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# Compiles the sources of TARGET so many at a time: headers are read, and templates made, once for all of them.
# Preset `dev` compiles each by itself, where a missing include is an error. So names without linkage differ within a room.
function(ink_use_units target count)
    if(CMAKE_DISABLE_PRECOMPILE_HEADERS)
        return()
    endif()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${count})
endfunction()

# ink_kernels(ROOM NAME SOURCES...): sources that include themselves again for each kind of processor. They are one unit NAME,
# since most of the work is to read Highway's headers, once for each kind. In preset `dev` each stands alone.
function(ink_kernels room name)
    set(sources ${ARGN})
    if(NOT CMAKE_DISABLE_PRECOMPILE_HEADERS)
        set(unit ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
        list(TRANSFORM sources REPLACE "(.+)" "#include \"${CMAKE_CURRENT_SOURCE_DIR}/\\1\"\n")
        list(JOIN sources "" includes)
        set(again "#undef HWY_TARGET_INCLUDE\n#define HWY_TARGET_INCLUDE \"${unit}\"\n")
        file(CONFIGURE OUTPUT ${unit} CONTENT "${again}#include <hwy/foreach_target.h>\n${includes}${again}" @ONLY)
        set(sources ${unit})
    endif()
    target_sources(ink_${room} PRIVATE ${sources})
    set_source_files_properties(${sources} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# ink_test(ROOM SOURCES ... [ALONE ...] LINKS ... [SLOW NAME=FILTER...] [NIGHTLY NAME=FILTER...]): the tests of one room,
# one program. All but those that the filters (gtest's) name run in one process, the case ROOM/quick; a failure names
# its TEST. Each filter is a case beside it, ROOM/NAME, with the label `slow`, or `nightly-NAME` for those that not every
# change must pass: NAME is a part of .ci/night. Those of SOURCES that are ALONE, too, are compiled one by one.
function(ink_test room)
    cmake_parse_arguments(TEST "" "" "SOURCES;ALONE;LINKS;SLOW;NIGHTLY" ${ARGN})
    add_executable(test_${room} ${TEST_SOURCES})
    target_include_directories(test_${room} PRIVATE ${PROJECT_SOURCE_DIR})
    target_compile_definitions(test_${room} PRIVATE
        INK_SOURCE_DIR="${PROJECT_SOURCE_DIR}" INK_BINARY_DIR="${CMAKE_BINARY_DIR}")
    target_link_libraries(test_${room} PRIVATE ${TEST_LINKS} GTest::gmock GTest::gtest_main)
    ink_use_precompiled(test_${room} test)
    ink_use_units(test_${room} 8)
    set_source_files_properties(${TEST_ALONE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)

    set(apart "-")
    foreach(label slow nightly)
        string(TOUPPER ${label} list)
        foreach(case IN LISTS TEST_${list})
            string(REGEX MATCH "^([^=]*)=(([^-]*).*)$" is_case ${case})
            set(name ${CMAKE_MATCH_1})
            string(APPEND apart ${CMAKE_MATCH_3} ":")
            ink_test_case(${room}/${name} test_${room} ${CMAKE_MATCH_2})
            if(label STREQUAL nightly)
                set(label nightly-${name})
            endif()
            set_tests_properties(${room}/${name} PROPERTIES LABELS ${label})
        endforeach()
    endforeach()
    ink_test_case(${room}/quick test_${room} ${apart})
endfunction()

function(ink_test_case name program filter)
    add_test(NAME ${name} COMMAND ${program} --gtest_brief=1 "--gtest_filter=${filter}")
    set_tests_properties(${name} PROPERTIES TIMEOUT 1200)
endfunction()
