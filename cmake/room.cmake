# ink_room(NAME [COLD] SOURCES ... LINKS ... PRIVATE_LINKS ...): a room is a folder, a static library and an alias ink::NAME.
# Includes are by path from src/ ("raster/pass/pass.h") or from the root ("method/method.h").
function(ink_room name)
    cmake_parse_arguments(ROOM "COLD" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
    add_library(ink_${name} STATIC ${ROOM_SOURCES})
    add_library(ink::${name} ALIAS ink_${name})
    target_include_directories(ink_${name} PUBLIC ${PROJECT_SOURCE_DIR}/src ${PROJECT_SOURCE_DIR})
    target_link_libraries(ink_${name} PUBLIC ${ROOM_LINKS} PRIVATE ${ROOM_PRIVATE_LINKS})
    if(ROOM_COLD)
        ink_use_precompiled(ink_${name} cold)
    else()
        ink_use_precompiled(ink_${name} room)
    endif()
endfunction()

# ink_test(ROOM SOURCES ... LINKS ...): the tests of one room, one program; each TEST is a ctest case.
function(ink_test room)
    cmake_parse_arguments(TEST "" "" "SOURCES;LINKS" ${ARGN})
    add_executable(test_${room} ${TEST_SOURCES})
    target_include_directories(test_${room} PRIVATE ${PROJECT_SOURCE_DIR})
    target_compile_definitions(test_${room} PRIVATE
        INK_SOURCE_DIR="${PROJECT_SOURCE_DIR}" INK_BINARY_DIR="${CMAKE_BINARY_DIR}"
        INK_SHARED_DIR="${PROJECT_SOURCE_DIR}/../shared")
    target_link_libraries(test_${room} PRIVATE ${TEST_LINKS} GTest::gmock GTest::gtest_main)
    ink_use_precompiled(test_${room} test)
    # On a busy machine a program may take longer to load than the 5 s that CMake gives it to name its tests.
    gtest_discover_tests(test_${room} TEST_PREFIX ${room}/ DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 120
        PROPERTIES TIMEOUT 300)
endfunction()
