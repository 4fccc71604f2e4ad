# Run at every build (cmake -P): writes OUTPUT if commit or dirty flag changed, so that provenance is
# the truth of this build and an unchanged tree recompiles nothing.
execute_process(COMMAND git -C ${SOURCE} rev-parse --short=12 HEAD
                OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT commit)
    set(commit unknown)
endif()
execute_process(COMMAND git -C ${SOURCE} status --porcelain --untracked-files=no
                OUTPUT_VARIABLE changes OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
set(dirty false)
if(changes)
    set(dirty true)
endif()
configure_file(${SOURCE}/src/core/build_info.h.in ${OUTPUT} @ONLY)
