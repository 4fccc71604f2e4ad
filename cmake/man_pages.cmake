# cmake -DPROGRAM=inkbench -DHELP2MAN=help2man -DVERSION=0.1.0 -DOUT=man1 -P man_pages.cmake
# The manual page of the program and of each subcommand, from its own --help. Made only where the program is newer
# than the pages.
if(EXISTS ${OUT}/inkbench.1 AND NOT ${PROGRAM} IS_NEWER_THAN ${OUT}/inkbench.1)
    return()
endif()
file(REMOVE_RECURSE ${OUT})  # a subcommand that went leaves no page
file(MAKE_DIRECTORY ${OUT})

# page(NAME COMMAND...): NAME.1 from the --help of COMMAND, whose first line says what it does.
function(page name)
    execute_process(COMMAND ${ARGN} --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
    string(REGEX MATCH "^[^\n]*" summary "${help}")
    string(REPLACE ";" " " command "${ARGN}")
    if(ARGC GREATER 2)  # of a command all; of the program that would be all of all
        set(whole --help-option=--help-all)
    endif()
    execute_process(
        COMMAND ${HELP2MAN} --no-info ${whole} "--name=${summary}" --version-string=${VERSION} "${command}"
        OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
    string(TOUPPER ${name} heading)
    string(REGEX REPLACE "\n\\.TH [^\n]*" "\n.TH ${heading} \"1\" \"\" \"Inkbench ${VERSION}\" \"User Commands\"" text "${text}")
    string(REGEX REPLACE "(\n\\.SH NAME\n)[^\n]*" "\\1${name} \\\\- ${summary}" text "${text}")
    file(WRITE ${OUT}/${name}.1 "${text}")
endfunction()

execute_process(COMMAND ${PROGRAM} --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "(^|\n)  [a-z][a-z-]*  " lines "${help}")
foreach(line ${lines})
    string(STRIP ${line} subcommand)
    page(inkbench-${subcommand} ${PROGRAM} ${subcommand})
endforeach()
page(inkbench ${PROGRAM})
