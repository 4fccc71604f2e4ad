# cmake -DSOURCE=<src folder> -DFILES=<paths below it, joined by |> -DOUTPUT=<header> -P this: writes
# one hash over the named files, so that a cached truth never outlives the code that traced it.
cmake_minimum_required(VERSION 3.25)
string(REPLACE "|" ";" files "${FILES}")
set(all "")
foreach(file ${files})
    file(SHA256 "${SOURCE}/${file}" hash)
    string(APPEND all "${file} ${hash}\n")
endforeach()
string(SHA256 sources "${all}")
file(CONFIGURE OUTPUT "${OUTPUT}" CONTENT "#pragma once

namespace ink::truth {

inline constexpr char kSourcesHash[] = \"@sources@\";

}  // namespace ink::truth
" @ONLY)
