# Writes the C++ file that holds the page's files, as raw string literals.
#   cmake -DOUT=page_files.cpp -DFOLDER=page -DD3=d3.min.js -DSCRIPTS=a.js,b.js -P embed_page.cmake

function(literal out file)
    file(READ "${file}" text)
    string(FIND "${text}" ")__ink__\"" place)
    if(NOT place EQUAL -1)
        message(FATAL_ERROR "${file} holds the end mark of the literal")
    endif()
    set(${out} "R\"__ink__(${text})__ink__\"" PARENT_SCOPE)
endfunction()

literal(index "${FOLDER}/index.html")
literal(style "${FOLDER}/style.css")
literal(d3 "${D3}")
string(REPLACE "," ";" scripts "${SCRIPTS}")
set(all "")
foreach(script IN LISTS scripts)
    literal(text "${FOLDER}/${script}")
    string(APPEND all "        ${text}\n")
endforeach()

file(WRITE "${OUT}" "#include \"report/page_files.h\"

namespace ink::report {

const PageFiles& page_files() {
    static const PageFiles kFiles = {
        .index = ${index},
        .style = ${style},
        .scripts =
${all},
        .d3 = ${d3}};
    return kFiles;
}

}  // namespace ink::report
")
