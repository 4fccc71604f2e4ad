# Where ccache is installed, what was compiled here once is not compiled again; a launcher that was chosen
# stays. ccache takes precompiled headers only with this sloppiness, and GCC must name them in what it preprocesses.
find_program(INK_CCACHE ccache)
if(INK_CCACHE AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
        CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${INK_CCACHE})
    add_compile_options($<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
endif()
