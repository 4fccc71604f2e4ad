# A shader's section that another method's file has stands there alone: `//// screen of surface8` takes the one of
# surface8.glsl, and `//-- walks of surface_lookup` in a section what stands there from `//-- walks` to `//-- end`.
# Whole shaders are in ${INK_SHADERS}, from where pages and bench/gpu_cost take them.
set(INK_SHADERS ${CMAKE_BINARY_DIR}/generated/shaders)

# From the head of a section or part to that of the next, or to the end.
function(ink_section out text mark name)
    string(FIND "${text}" "${mark} ${name}\n" begin)
    if(begin EQUAL -1)
        message(FATAL_ERROR "a shader has no ${mark} ${name}")
    endif()
    string(SUBSTRING "${text}" ${begin} -1 text)
    string(SUBSTRING "${text}" 5 -1 rest)
    string(FIND "${rest}" "${mark} " length)
    if(NOT length EQUAL -1)
        math(EXPR length "${length} + 5")
    endif()
    string(SUBSTRING "${text}" 0 ${length} text)
    set(${out} "${text}" PARENT_SCOPE)
endfunction()

# ink_whole_shader(OUT FILE): writes it with the sections that it takes from others, and says where.
function(ink_whole_shader out file)
    file(READ "${file}" text)
    cmake_path(GET file FILENAME name)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
    while(text MATCHES "//(//|--) ([a-z]+) of ([a-z0-9_]+)\n")
        set(head "${CMAKE_MATCH_0}")
        set(mark "//${CMAKE_MATCH_1}")
        set(wanted "${CMAKE_MATCH_2}")
        file(READ "${PROJECT_SOURCE_DIR}/methods/${CMAKE_MATCH_3}/${CMAKE_MATCH_3}.glsl" other)
        ink_section(section "${other}" "${mark}" "${wanted}")
        string(REPLACE "${head}" "${section}" text "${text}")
    endwhile()
    string(REGEX REPLACE "//-- [a-z]+\n" "" text "${text}")
    file(CONFIGURE OUTPUT "${INK_SHADERS}/${name}" CONTENT "${text}" @ONLY)
    set(${out} "${INK_SHADERS}/${name}" PARENT_SCOPE)
endfunction()
