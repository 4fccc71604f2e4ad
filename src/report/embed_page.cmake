# Writes the C++ file that holds a page's files, as raw string literals.
#   cmake -DOUT=page_files.cpp -DFUNCTION=page_files -DINDEX=index.html -DSTYLES=a.css,b.css -DSCRIPTS=a.js,b.js
#         [-DD3=d3.min.js] [-DSHADERS=a.glsl,b.glsl] -P embed_page.cmake

function(literal out file)
    file(READ "${file}" text)
    string(FIND "${text}" ")__ink__\"" place)
    if(NOT place EQUAL -1)
        message(FATAL_ERROR "${file} holds the end mark of the literal")
    endif()
    set(${out} "R\"__ink__(${text})__ink__\"" PARENT_SCOPE)
endfunction()

# The files of a list by commas as literals in a row; with a heading, that and the file's name before each.
function(literals out files heading)
    string(REPLACE "," ";" files "${files}")
    set(all "\"\"")
    foreach(file IN LISTS files)
        literal(text "${file}")
        if(heading)
            cmake_path(GET file STEM name)
            string(APPEND all "\n        \"${heading} ${name}\\n\"")
        endif()
        string(APPEND all "\n        ${text}")
    endforeach()
    set(${out} "${all}" PARENT_SCOPE)
endfunction()

literals(index "${INDEX}" "")
literals(styles "${STYLES}" "")
literals(scripts "${SCRIPTS}" "")
literals(shaders "${SHADERS}" "//// method")
literals(d3 "${D3}" "")

file(WRITE "${OUT}" "#include \"report/page_template.h\"

namespace ink::report {

const PageFiles& ${FUNCTION}() {
    static const PageFiles kFiles = {
        .index = ${index},
        .style = ${styles},
        .scripts = ${scripts},
        .shaders = ${shaders},
        .d3 = ${d3}};
    return kFiles;
}

}  // namespace ink::report
")
